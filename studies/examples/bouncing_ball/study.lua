-- A rubber ball thrown onto a sticky plane: bonds take of its energy what it costs to tear them, or hold it.
-- Where the energy went is told by the ledger (probe.energy), the momentum and its impulses by probe.momentum.
local stiction = require "stiction"
local units, numeric = stiction.units, stiction.numeric
local mm, m, s, ms, kg, J, N, MPa = units.mm, units.m, units.s, units.ms, units.kg, units.J, units.N, units.MPa

local function ball(p) -- half a disc beside the axis, from pole to pole; finer where it touches
  local edge, R, zero = stiction.edge, p.radius, 0*mm
  return stiction.mesh.gmsh { size = 4 * p.cell, start = { zero, zero }, edges = {
    edge { to = { R, R }, centre = { zero, R }, name = "skin" }, edge { to = { zero, 2 * R }, centre = { zero, R } },
    edge { to = { zero, zero }, name = "axis" } }, sizes = { zero, zero, p.cell, R / 2, 0.13 * R, p.cell } }
end

return stiction.study {
  title = "A sticky ball bouncing", question = "How much of its speed does a ball keep?",
  given = { radius = 5*mm, young = 1*MPa, density = 1000*kg/m^3, speed = 0.2*m/s },
  chosen = { cell = { 0.05*mm, "finer ones change what is kept by up to 5 %" }, C = { 1e9*N/m^3, "bonds" },
    b = { 5e-4*N*s/m, "bonds take b / w" }, steps = { 500, "two and more while a bond grows" } },
  sweep = { w = { 0*J/m^2, 0.5*J/m^2, 2*J/m^2, 10*J/m^2 } },
  quick = { sweep = { w = { 0*J/m^2, 10*J/m^2 } }, set = { steps = 250 } },
  scene = function(p)
    return stiction.scene {
      kinematics = "axisymmetric",
      bodies = { ball = stiction.body { mesh = ball(p), density = p.density, velocity = { 0*m/s, -p.speed },
        material = stiction.material.neo_hookean { young = p.young, poisson = 0.4 } } },
      obstacles = { plane = stiction.obstacle { shape = stiction.rigid.plane {} } },
      pairs = { touch = stiction.pair { secondary = "ball.skin", primary = "plane",
        adhesion = stiction.adhesion.rcc { w = p.w, C_n = p.C, C_t = 0*N/m^3, b = p.b } } },
      motions = { stiction.motion.fix { set = "ball.axis", x = true } },
      schedule = stiction.schedule { stages = { stiction.stage { to = 10*ms, steps = p.steps } } },
      output = stiction.output { frames = 40 },
      probes = { touch = stiction.probe.contact { pair = "touch" }, energy = stiction.probe.energy { audit = true },
        momentum = stiction.probe.momentum {} },
    }
  end,
  results = { { name = "kept", unit = "1", meaning = "mean momentum of the last half over the first", function(run)
    local p = run:series("momentum", "p_y")
    return numeric.mean(table.move(p, #p // 2, #p, 1, {})) / -p[1] end } },
  check = function(cases, check)
    for _, case in ipairs(cases) do
      local p = case:series("momentum", "p_y")
      check.ledger(case) -- all energies sum up
      check.close(case.id .. ": the plane's impulse is the change of momentum",
        numeric.integral(case.time, case:series("touch", "force_y")), p[#p] - p[1], 0.01)
    end
    check.non_increasing("the stickier the slower", cases:values("kept"))
  end,
  figures = function(cases)
    local function curve(case)
      return { label = ("w = %g J/m²"):format(case.p.w.si), case = case, y = "momentum/p_y" }
    end
    local last, _, pulled = cases[#cases], cases[#cases]:min("touch", "force_y")
    return { stiction.figure.lines { name = "momentum", title = "Momentum of the ball", legend = "below",
        x = { label = "time", unit = "ms" }, y = { label = "upwards", unit = "N s" },
        curves = numeric.map(cases, curve) },
      stiction.figure.field { name = "held", title = "Where the bonds pull most", case = last, time = pulled,
        array = "von_mises", unit = "kPa", label = "von Mises stress", deformed = true, mesh = true, mirror = { "x" },
        scale_bar = 2*mm } }
  end,
}
