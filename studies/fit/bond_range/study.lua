-- A sphere drawn off a soft half space: does the force tell how far the bonds reach, or only their work?
--
--          .-'''-.      up by displacement
--         |   R   |     bonds pull with sigma0 up to w / sigma0 (Dugdale)
--     _____'-._.-'_____
--
-- Maugis' formula answers each case in milliseconds. The curves are ours: computed by data.lua with w = 0.05 J/m^2 and, for this study,
-- sigma0 = 10 kPa (Maugis' lambda 0.33, Tabor's number 0.29, bonds of 5 um), for short.lua 500 kPa (lambda 17, bonds of 0.1 um), with
-- noise of 0.05 mN added, a hundredth of the largest force. Of long bonds both are told. Of short ones the force is JKR's, which knows w
-- alone: a fit has to say that sigma0 is not determined, whatever least squares it finds.
--
--     ./stiction fit studies/fit/bond_range              # long bonds
--     ./stiction fit studies/fit/bond_range/short.lua    # short bonds
local stiction = require "stiction"
local u = stiction.units
local um, mm, s, mN, kPa, J = u.um, u.mm, u.s, u.mN, u.kPa, u.J

--- Force that pulls on the sphere over its height, on the way up.
local function way_up(run, p)
  local force, height, pull = run:series("touch", "force_z"), {}, {}
  for i, t in ipairs(run.time) do
    if t >= 1 then
      height[#height + 1], pull[#pull + 1] = (t - 1) * (p.down + p.up).si - p.down.si, force[i]
    end
  end
  return height, pull
end

return stiction.study {
  title = "How far bonds reach: what the pull-off of a sphere tells",
  question = "Which work of adhesion and which strength of the bonds does a pull-off curve say, and which of them not at all?",
  given = { radius = { 20*mm, "sphere" }, young = { 3*u.MPa, "rubber" }, poisson = { 0.5, "rubber" } },
  chosen = {
    w = { 0.03*J/u.m^2, "where the search begins" },
    down = { 2*um, "before it is drawn off" }, up = { 8*um, "beyond the end of contact" },
    steps = { 100, "way up" },
  },
  sweep = { sigma0 = { 10*kPa, 40*kPa, 500*kPa } },
  scene = function(p)
    return stiction.scene {
      model = "formula", kinematics = "three_dimensional", output = stiction.output { frames = 0 },
      bodies = { base = stiction.body.half_space { young = p.young, poisson = p.poisson, size = { 3*mm, 3*mm }, points = { 16, 16 },
        boundary = "free" } },
      obstacles = { sphere = stiction.obstacle.height_map { surface = stiction.surface.sphere { radius = p.radius },
        times = { 0*s, 1*s, 2*s }, z = { 0*mm, -p.down, p.up } } },
      pairs = { touch = stiction.pair { secondary = "base.surface", primary = "sphere",
        adhesion = stiction.adhesion.dugdale { sigma0 = p.sigma0, h0 = p.w / p.sigma0 } } },
      scheme = stiction.scheme.quasi_static {},
      schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = 4 }, stiction.stage { to = 2*s, steps = p.steps } } },
      probes = { touch = stiction.probe.contact { pair = "touch" } },
    }
  end,
  results = {
    { name = "pull_off", unit = "mN", meaning = "largest force that pulls on the sphere",
      function(run) return run:max("touch", "force_z") end },
  },
  check = function(cases, check)
    for _, case in ipairs(cases) do
      local over = case.results.pull_off / (math.pi * (case.p.w * case.p.radius).si)
      check.within(("sigma0 = %s: between JKR's and DMT's pull-off"):format(case.p.sigma0), over, 1.49, 2)
    end
    check.non_increasing("the shorter bonds are the less they hold", cases:values("pull_off"))
  end,
  fit = {
    parameters = { w = { 0.005*J/u.m^2, 0.5*J/u.m^2, scale = "log" }, sigma0 = { 1*kPa, 2e3*kPa, start = 40*kPa, scale = "log" } },
    data = { pull = { file = "long.csv", x = "height", y = "pull", sigma = 0.05*mN, against = way_up } },
    finer = { steps = 200 },
  },
}
