-- Pull-off curves of a sphere at three speeds, from which modulus, work of adhesion and viscosity of the bonds are to be told.
--
-- The curves are ours: computed by data.lua with E = 0.8 MPa, w = 0.6 J/m^2, b = 0.03 N s/m on these very cells, with noise
-- of 0.3 mN added. A fit should find these values again, within its intervals; how far the cells are to be trusted it says itself.
--
--     ./stiction fit studies/fit/pull_off
--     ./stiction sample studies/fit/pull_off     # how sure a pull-off force is where such parameters are uncertain
local stiction = require "stiction"
local u = stiction.units
local mm, um, s, mN = u.mm, u.um, u.s, u.mN

--- Force that pulls on the sphere over its height, on the way up.
local function way_up(run, p)
  local force, height, pull = run:series("joint", "force_y"), {}, {}
  local down = (p.depth / p.speed + p.dwell).si
  for i, t in ipairs(run.time) do
    if t >= down then
      height[#height + 1], pull[#pull + 1] = p.speed.si * (t - down) - p.depth.si, force[i]
    end
  end
  return height, pull
end

local function pulled(file, speed)
  return { file = file, x = "height", y = "pull", sigma = 0.3*mN, case = { speed = speed }, against = way_up }
end

return stiction.study {
  title = "Pull-off of a sphere at three speeds: what the curves tell",
  question = "Which modulus, which work of adhesion and which viscosity of the bonds do three pull-off curves say, and how surely?",
  given = { radius = { 5*mm, "sphere" }, poisson = { 0.48, "rubber" } },
  chosen = {
    young = { 1*u.MPa, "where the search begins" }, w = { 1*u.J/u.m^2, "where the search begins" },
    b = { 0.01*u.N*s/u.m, "where the search begins" },
    stiffness = { 1e9*u.N/u.m^3, "cohesive length E*/C of some 1 mm" },
    cell = { 0.05*mm, "twenty in the cohesive length; fit.finer halves it" },
    depth = { 30*um, "contact a twelfth of the radius wide" }, above = { 90*um, "beyond the end of contact" },
    dwell = { 1*s, "many bonding times b/w" },
    steps = { 150, "way up; fit.finer doubles it" },
  },
  sweep = { speed = { 10*um/s, 100*um/s, 1000*um/s } },
  scene = function(p)
    local down = p.depth / p.speed
    local held = down + p.dwell
    local over = held + (p.depth + p.above) / p.speed
    return stiction.scene {
      kinematics = "axisymmetric", output = stiction.output { frames = 0 },
      bodies = { block = stiction.body {
        mesh = stiction.mesh.graded_block { origin = { 0*mm, -4*mm }, size = { 4*mm, 4*mm }, growth = 1.4,
          fine = { 0.8*mm, 3 * p.cell }, fine_size = p.cell, coarse_size = 0.6*mm },
        material = stiction.material.neo_hookean { young = p.young, poisson = p.poisson },
        interpolation = "mean_dilatation", density = 1000*u.kg/u.m^3 } },
      obstacles = { sphere = stiction.obstacle {
        shape = stiction.rigid.sphere { centre = { 0*mm, p.radius }, radius = p.radius },
        times = { 0*s, down, held, over }, y = { 0*mm, -p.depth, -p.depth, p.above } } },
      pairs = { joint = stiction.pair { secondary = "block.top", primary = "sphere",
        adhesion = stiction.adhesion.rcc { w = p.w, C_n = p.stiffness, C_t = 0*u.N/u.m^3, b = p.b } } },
      motions = { stiction.motion.fix { set = "block.bottom" }, stiction.motion.fix { set = "block.left", y = false } },
      scheme = stiction.scheme.quasi_static {},
      schedule = stiction.schedule { stages = { stiction.stage { to = down, steps = 12 },
        stiction.stage { to = held, steps = 8 }, stiction.stage { to = over, steps = p.steps } } },
      probes = { joint = stiction.probe.contact { pair = "joint" } },
    }
  end,
  results = {
    { name = "pull_off", unit = "mN", meaning = "largest force that pulls on the sphere",
      function(run) return run:max("joint", "force_y") end },
  },
  check = function(cases, check)
    check.increasing("the quicker the more it holds", cases:values("pull_off"))
  end,
  fit = {
    parameters = {
      young = { 0.2*u.MPa, 5*u.MPa, scale = "log" },
      w = { 0.1*u.J/u.m^2, 10*u.J/u.m^2, scale = "log" },
      b = { 1e-3*u.N*s/u.m, 1*u.N*s/u.m, scale = "log" },
    },
    data = {
      slow = pulled("slow.csv", 10*um/s),
      middle = pulled("middle.csv", 100*um/s),
      quick = pulled("quick.csv", 1000*um/s),
    },
    finer = { cell = 0.025*mm, steps = 300 },
    quick = { profiles = false },
  },
  sample = {
    of = { young = { log_normal = { 0.8*u.MPa, 0.1 } }, w = { log_normal = { 0.6*u.J/u.m^2, 0.2 } },
      b = { log_uniform = { 0.01*u.N*s/u.m, 0.1*u.N*s/u.m } } },
    set = { speed = 100*um/s }, count = 64, quick = { count = 24 },
  },
}
