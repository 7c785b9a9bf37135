-- A pad of soft pillars on a backing, pulled off a plane: the same tips hold more the finer they are split.
--    _____________
--   |__  ___  ___|   backing, lifted along its top     a wide tip breaks from its edges inwards,
--     |_|   |_|      pillars, bonded at their tips     a narrow one bears sqrt(w C) everywhere at once
local stiction = require "stiction"
local units = stiction.units
local mm, m, s, kg, J, N, MPa = units.mm, units.m, units.s, units.kg, units.J, units.N, units.MPa

local function pad(p) -- outline, from the lower left: up and down around each gap between two pillars
  local pitch, edges, zero, top = p.width / p.pillars, {}, 0*mm, p.length + p.backing
  local function edge(x, y, name) edges[#edges + 1] = stiction.edge { to = { x, y }, name = name } end
  for k = 1, p.pillars do
    local left = (k - 0.75) * pitch
    if k > 1 then edge(left, p.length); edge(left, zero) end
    edge(left + pitch / 2, zero, "tips"); edge(left + pitch / 2, p.length)
  end
  edge(p.width, p.length); edge(p.width, top); edge(zero, top, "back")
  edge(zero, p.length); edge(pitch / 4, p.length); edge(pitch / 4, zero)
  return stiction.mesh.gmsh { size = 3 * p.cell, start = { pitch / 4, zero }, edges = edges,
    refine = { stiction.refinement { near = "tips", size = p.cell, beyond = 1*mm } } }
end

return stiction.study {
  title = "A fibrillar pad", question = "Does a pad hold more when its contact is split?",
  given = { width = 8*mm, length = 2*mm, backing = 1*mm, young = 1*MPa, w = 1*J/m^2, C = { 2e9*N/m^3, "stiff bonds" } },
  chosen = { cell = { 0.08*mm, "at the tips, a sixth of E / C" }, b = { 0.005*N*s/m, "lets bonds snap" },
    lift = { 0.2*mm, "all tips are off" }, steps = { 150, "the peak is met within 1 %" } },
  sweep = { pillars = { 1, 2, 4, 8 } },
  quick = { sweep = { pillars = { 2, 4 } }, set = { steps = 100 } },
  scene = function(p)
    return stiction.scene {
      bodies = { pad = stiction.body { mesh = pad(p), density = 1000*kg/m^3,
        material = stiction.material.neo_hookean { young = p.young, poisson = 0.3 } } },
      obstacles = { plane = stiction.obstacle { shape = stiction.rigid.plane {} } },
      pairs = { tips = stiction.pair { secondary = "pad.tips", primary = "plane",
        adhesion = stiction.adhesion.rcc { w = p.w, C_n = p.C, C_t = p.C, b = p.b, beta0 = 1, bonding = "never" } } },
      motions = { stiction.motion.drive { set = "pad.back", times = { 0*s, 1*s },
        x = { 0*mm, 0*mm }, y = { 0*mm, p.lift } } },
      scheme = stiction.scheme.quasi_static {},
      schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = p.steps } } },
      output = stiction.output { frames = 50 }, probes = { back = stiction.probe.force { set = "pad.back" } },
    }
  end,
  results = { { name = "share", unit = "1", meaning = "pull-off force over sqrt(w C) times the area of all tips",
    function(run, p) return run:max("back", "force_y") / (math.sqrt(p.w.si * p.C.si) * p.width.si / 2) end } },
  check = function(cases, check)
    check.increasing("finer holds more", cases:values("share"))
    check.within("never more than all bonds at once", cases[#cases].results.share, 0, 1)
  end,
  figures = function(cases)
    local function curve(case) return { label = "pillars: " .. case.p.pillars, case = case, y = "back/force_y" } end
    local last, _, peak = cases[#cases], cases[#cases]:max("back", "force_y")
    return { stiction.figure.lines { name = "force", title = "Lifted evenly: the force",
        x = { label = "time", unit = "s" }, y = { label = "force per depth", unit = "N/m" },
        curves = stiction.numeric.map(cases, curve) },
      stiction.figure.field { name = "pad", case = last, time = 0.97 * peak, array = "cauchy_stress", component = "yy",
        unit = "kPa", label = "vertical stress", title = "Just before it comes off", deformed = true, mesh = true,
        scale_bar = 1*mm } }
  end,
}
