-- A ring squeezed between two plates: a quarter of it, read from ring.msh, a file as gmsh writes them (format 2.2 or
-- 4.1). Its physical groups are the sets: "ring.outside" touches the plate, "ring.waist" and "ring.crown" lie on the
-- planes of symmetry. Its unit is the millimetre: scale = 1*mm.
local stiction = require "stiction"
local units = stiction.units
local mm, s, kg, m, MPa = units.mm, units.s, units.kg, units.m, units.MPa
local R, h = 10e-3, 0.5e-3 -- of the ring in the file: radius to its middle, thickness, m

local function stiffness(p) -- of a thin ring under two forces: bending alone, E / (1 - nu^2) in plane strain
  return p.young.si / (1 - p.poisson ^ 2) * h ^ 3 / 12 / R ^ 3 / (math.pi / 4 - 2 / math.pi)
end

return stiction.study {
  title = "A ring of one's own mesh", question = "Is a ring from a file as stiff as theory says?",
  given = { young = 10*MPa },
  chosen = { squeeze = { 4*mm, "of the radius" }, steps = { 80, "the first is a two hundredth of the radius" } },
  sweep = { poisson = { 0, 0.45 } },
  quick = { set = { squeeze = 2*mm, steps = 40 } },
  scene = function(p)
    local plane = stiction.rigid.plane { point = { 0*mm, 10.25*mm }, normal = { 0, -1 } }
    return stiction.scene {
      bodies = { ring = stiction.body { mesh = stiction.mesh.msh_file { path = "ring.msh", scale = 1*mm },
        material = stiction.material.neo_hookean { young = p.young, poisson = p.poisson }, density = 1000*kg/m^3 } },
      obstacles = { plate = stiction.obstacle { shape = plane, times = { 0*s, 1*s }, y = { 0*mm, -p.squeeze } } },
      pairs = { touch = stiction.pair { secondary = "ring.outside", primary = "plate" } },
      motions = { stiction.motion.fix { set = "ring.waist", y = true },
        stiction.motion.fix { set = "ring.crown", x = true } },
      scheme = stiction.scheme.quasi_static {},
      schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = p.steps } } },
      probes = { plate = stiction.probe.rigid { obstacle = "plate" } },
    }
  end,
  results = { { name = "stiffness", unit = "Pa", meaning = "force over squeeze, in the first step", function(run)
    return -run:series("plate", "force_y")[2] / run:series("plate", "u_y")[2] end } },
  check = function(cases, check)
    for _, case in ipairs(cases) do
      check.close("a thin ring's stiffness, " .. case.id, case.results.stiffness, stiffness(case.p), 0.01)
    end
  end,
  figures = function(cases)
    local function curve(case)
      return { label = "ν = " .. case.p.poisson, case = case, x = "plate/u_y", x_sign = -1, y = "plate/force_y" }
    end
    return { stiction.figure.lines { name = "force", title = "Squeezed between two plates",
        x = { label = "way of the plate", unit = "mm" }, y = { label = "force on half the ring", unit = "N/m" },
        curves = stiction.numeric.map(cases, curve) },
      stiction.figure.field { name = "ring", case = cases[#cases], array = "von_mises", unit = "kPa",
        label = "von Mises stress", title = "At the end", deformed = true, mesh = true, mirror = { "x", "y" },
        scale_bar = 5*mm } }
  end,
}
