-- A rubber block pressed onto a rigid plane and dragged: the smallest study that uses every part of the program.
local stiction = require "stiction"
local units = stiction.units
local mm, s, MPa, kg, m = units.mm, units.s, units.MPa, units.kg, units.m
local block = require "block"

return stiction.study {
  title = "A block on a plane",
  question = "Do script, sweep, run, checks and figures work together?",
  given = { side = 1*mm, descent = 0.02*mm },
  chosen = {
    young = { 1*MPa, "soft rubber" },
    density = { 1000*kg/m^3, "rubber" },
    cells = { 4, "enough for the plumbing" },
    steps = { 10, "enough for the plumbing" },
  },
  sweep = { mu = { 0, 0.2, 0.4 } },
  scene = function(p)
    return stiction.scene {
      bodies = { block = block(p) },
      obstacles = { floor = stiction.obstacle { shape = stiction.rigid.plane { point = { 0*mm, 0*mm }, normal = { 0, 1 } } } },
      pairs = { sole = stiction.pair { secondary = "block.bottom", primary = "floor",
        friction = stiction.friction.coulomb { mu = p.mu } } },
      motions = { stiction.motion.drive { set = "block.top", times = { 0*s, 1*s, 2*s }, x = { 0*mm, 0*mm, p.descent },
        y = { 0*mm, -p.descent, -p.descent } } },
      scheme = stiction.scheme.quasi_static {},
      schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = p.steps },
        stiction.stage { to = 2*s, steps = p.steps } } },
      probes = { sole = stiction.probe.contact { pair = "sole" }, energy = stiction.probe.energy {} },
    }
  end,
  results = {
    { name = "force_y", unit = "N/m", meaning = "Normal force at the end of the descent",
      function(run) return run:at(1*s, "sole", "force_y") end },
    { name = "force_x", unit = "N/m", meaning = "Friction at the end of the drag",
      function(run) return math.abs(run:at(2*s, "sole", "force_x")) end },
  },
  quick = { sweep = { mu = { 0.2 } }, set = { steps = 5 } },
  check = function(cases, check)
    for _, case in ipairs(cases) do
      check.holds(case.id .. ": the plane pushes back", case.results.force_y > 0)
      check.within(case.id .. ": friction within the cone", case.results.force_x, 0,
        case.p.mu*case.results.force_y*1.5 + 1e-6)
    end
  end,
  figures = function(cases)
    local curves = {}
    for i, case in ipairs(cases) do
      curves[i] = { label = case.id, case = case, y = "sole/force_y", colour = i - 1 }
    end
    return { stiction.figure.lines { name = "force", x = { label = "time", unit = "s" },
      y = { label = "force", unit = "N/m" }, curves = curves } }
  end,
}
