-- A thin tape peeled off a plane by its end: the force per width comes to the energy of the bond, w (Kendall 1975).
--     ^ P        once the arm stands upright:  P + P^2 / (2 E h) = w
--     |________
--   ---------------
local stiction = require "stiction"
local units = stiction.units
local mm, m, s, kg, J, N, MPa = units.mm, units.m, units.s, units.kg, units.J, units.N, units.MPa

local function kendall(p)
  local stiffness = p.young.si * p.thickness.si
  return stiffness * (math.sqrt(1 + 2 * p.w.si / stiffness) - 1)
end

return stiction.study {
  title = "A tape peeled off a plane", question = "Is the peel force the energy of the bond?",
  given = { young = 100*MPa, thickness = 0.1*mm, C = { 1e9*N/m^3, "bond" }, b = { 1e-4*N*s/m, "slow beside it" } },
  chosen = { length = { 6.4*mm, "some is still bonded at the end" }, cell = { 0.2*mm, "of quad8: they bend" },
    lift = { 4*mm, "more than four sqrt(E h^3 / (12 w))" }, steps = { 200, "front moves less than a cell a step" } },
  sweep = { w = { 10*J/m^2, 20*J/m^2 } },
  quick = { sweep = { w = { 10*J/m^2 } } },
  scene = function(p)
    local corner = { 0*mm, p.thickness }
    return stiction.scene {
      bodies = { tape = stiction.body { density = 1000*kg/m^3, mesh = stiction.mesh.block { kind = "quad8",
        size = { p.length, p.thickness }, cells = { math.floor(p.length / p.cell + 0.5), 1 } },
        material = stiction.material.st_venant_kirchhoff { young = p.young, poisson = 0 } } },
      obstacles = { plane = stiction.obstacle { shape = stiction.rigid.plane {} } },
      pairs = { bond = stiction.pair { secondary = "tape.bottom", primary = "plane",
        adhesion = stiction.adhesion.rcc { w = p.w, C_n = p.C, C_t = p.C, b = p.b, beta0 = 1, bonding = "never" } } },
      motions = { stiction.motion.fix { set = "tape.right" }, stiction.motion.drive { set = "tape.left", near = corner,
        times = { 0*s, 1*s }, y = { 0*mm, p.lift } } },
      scheme = stiction.scheme.quasi_static {},
      schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = p.steps } } },
      probes = { pull = stiction.probe.force { set = "tape.left", near = corner },
        tip = stiction.probe.node { set = "tape.left", near = corner } },
    }
  end,
  results = { { name = "force", unit = "N/m", meaning = "mean over the last quarter of the way", function(run)
    local force = run:series("pull", "force_y")
    return stiction.numeric.mean(table.move(force, 3 * #force // 4, #force, 1, {}))
  end } },
  check = function(cases, check)
    for _, case in ipairs(cases) do
      check.close("Kendall's force, " .. case.id, case.results.force, kendall(case.p), 0.03)
    end
  end,
  figures = function(cases)
    local figure, curves = stiction.figure, {}
    for i, case in ipairs(cases) do
      local label, way, exact = ("w = %g J/m²"):format(case.p.w.si), { 0, case.p.lift.si }, kendall(case.p)
      curves[i] = { label = label, case = case, x = "tip/u_y", y = "pull/force_y", colour = i }
      curves[#cases + i] = { label = "Kendall", x = way, y = { exact, exact }, style = "dash", colour = i }
    end
    return { figure.lines { name = "force", title = "Peeled: the force", curves = curves, legend = "below",
        x = { label = "way of the end", unit = "mm" }, y = { label = "force per width", unit = "N/m" } },
      figure.field { name = "tape", title = "At the end", case = cases[#cases], array = "von_mises", deformed = true,
        label = "von Mises stress", unit = "MPa", scale_bar = 1*mm } }
  end,
}
