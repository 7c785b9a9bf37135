-- Derivatives of forces with respect to parameters, against closed forms.
--
--   bar     stretched in plane strain: F = E w u / (h (1 - nu^2))
--   ball    rigid, pressed into a half space: F = 4/3 E* sqrt(R) d^(3/2) (Hertz)
--   joint   that ball drawn off with viscous bonds: F is homogeneous in E, w, C_n and b together, so that
--           the sum of its powers of these is 1
--   jkr     the formula of short bonds, drawn off: the largest pull is 3/2 pi w R, whatever the modulus (Johnson, Kendall and Roberts)
--   block   pressed by N, resting and dragged: beta = w t / b as it rests, F = mu N as it slides
--
--     ./stiction run studies/proofs/sensitivity
local stiction = require "stiction"
local units, numeric = stiction.units, stiction.numeric
local mm, um, s, kg, m, N, J, MPa = units.mm, units.um, units.s, units.kg, units.m, units.N, units.J, units.MPa

local function elastic(p, poisson)
  return stiction.material.linear_elastic { young = p.young, poisson = poisson }
end

local function scene_of(t)
  t.output, t.scheme = stiction.output { frames = 0 }, stiction.scheme.quasi_static {}
  t.schedule = stiction.schedule { stages = numeric.map(t.schedule, function(stage)
    return stiction.stage { to = stage[1], steps = stage[2] } end) }
  for _, body in pairs(t.bodies) do
    body.density = 1000*kg/m^3
  end
  t.bodies = { body = stiction.body(t.bodies.body) }
  return stiction.scene(t)
end

local scenes = {}

function scenes.bar(p)
  return scene_of({
    bodies = { body = { mesh = stiction.mesh.block { size = { p.width, p.height }, cells = { p.cells, 2 * p.cells } },
      material = elastic(p, p.poisson) } },
    motions = { stiction.motion.fix { set = "body.left", y = false }, stiction.motion.fix { set = "body.bottom", x = false },
      stiction.motion.drive { set = "body.top", times = { 0*s, 1*s }, y = { 0*mm, p.stretch } } },
    schedule = { { 1*s, 2 } },
    probes = { force = stiction.probe.force { set = "body.top" } },
  })
end

local function half_space(p, finest, above)
  local cell = finest / p.cells
  return {
    kinematics = "axisymmetric",
    bodies = { body = { mesh = stiction.mesh.graded_block { origin = { 0*mm, -p.reach }, size = { p.reach, p.reach },
      fine = { 0.8*mm, 6 * cell }, fine_size = cell, coarse_size = 0.5*mm, growth = 1.3 }, interpolation = "mean_dilatation",
      material = elastic(p, p.poisson) } },
    obstacles = { ball = stiction.obstacle { shape = stiction.rigid.sphere { centre = { 0*mm, p.radius }, radius = p.radius },
      times = { 0*s, 1*s, 2*s }, y = { 0*mm, -p.depth, above } } },
    motions = { stiction.motion.fix { set = "body.bottom" }, stiction.motion.fix { set = "body.left", y = false } },
    probes = { force = stiction.probe.contact { pair = "touch" } },
  }
end

function scenes.ball(p)
  local t = half_space(p, p.ball_cell, -p.depth)
  t.pairs = { touch = stiction.pair { secondary = "body.top", primary = "ball" } }
  t.schedule = { { 1*s, 8 } }
  return scene_of(t)
end

function scenes.joint(p)
  local t = half_space(p, p.joint_cell, p.above)
  t.pairs = { touch = stiction.pair { secondary = "body.top", primary = "ball",
    adhesion = stiction.adhesion.rcc { w = p.w, C_n = p.stiffness, C_t = 0*N/m^3, b = p.b } } }
  t.schedule = { { 1*s, 8 }, { 2*s, 100 * p.cells } }
  return scene_of(t)
end

function scenes.block(p)
  return scene_of({
    bodies = { body = { mesh = stiction.mesh.block { size = { p.width, p.width }, cells = { p.cells, p.cells } },
      material = elastic(p, 0) } },
    obstacles = { floor = stiction.obstacle { shape = stiction.rigid.plane {} } },
    pairs = { touch = stiction.pair { secondary = "body.bottom", primary = "floor", friction = stiction.friction.coulomb { mu = p.mu },
      adhesion = stiction.adhesion.rcc { w = p.w, C_n = p.weak, C_t = p.weak, b = p.b } } },
    motions = { stiction.motion.drive { set = "body.top", times = { 0*s, 1*s, 3*s }, x = { 0*mm, 0*mm, 40*um },
      y = { -p.pressed, -p.pressed, -p.pressed } } },
    schedule = { { 1*s, 4 }, { 3*s, 40 } },
    probes = { force = stiction.probe.contact { pair = "touch" }, line = stiction.probe.contact_line { pair = "touch" } },
  })
end

function scenes.jkr(p)
  return stiction.scene {
    model = "formula", kinematics = "three_dimensional", output = stiction.output { frames = 0 },
    bodies = { base = stiction.body.half_space { young = p.young, poisson = p.poisson, size = { p.reach, p.reach }, points = { 16, 16 },
      boundary = "free" } },
    obstacles = { ball = stiction.obstacle.height_map { surface = stiction.surface.sphere { radius = p.radius },
      times = { 0*s, 1*s, 2*s }, z = { 0*mm, -p.depth, p.above } } },
    pairs = { touch = stiction.pair { secondary = "base.surface", primary = "ball",
      adhesion = stiction.adhesion.dugdale { sigma0 = p.strength, h0 = p.w / p.strength } } },
    scheme = stiction.scheme.quasi_static {},
    schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = 4 }, stiction.stage { to = 2*s, steps = 50 * p.cells } } },
    probes = { force = stiction.probe.contact { pair = "touch" } },
  }
end

local function force(run)
  local kind = run.p.kind
  if kind == "bar" then
    return run:last("force", "force_y")
  elseif kind == "block" then
    return -run:last("force", "force_x")
  elseif kind == "jkr" then
    return run:max("force", "force_z")
  end
  return kind == "joint" and run:max("force", "force_y") or math.abs(run:last("force", "force_y"))
end

local function bonded(run)
  return run:at(1*s, "line", "beta", 1)
end

local function si(x)
  return type(x) == "number" and x or x.si
end

--- d ln f / d ln p, summed over these parameters
local function power(names, f)
  return function(c)
    local sum = 0
    for name in names:gmatch("%S+") do
      sum = sum + c:derivative(name, f) * si(c.p[name]) / f(c)
    end
    return sum
  end
end

local function proof(cases, check, t)
  local of = cases:where { kind = t.kind }
  local values = numeric.map(of, function(c) return { 1 / c.p.cells, t.value(c) } end)
  check.proof { case = "Derivatives", quantity = t.quantity, unit = t.unit, kind = "exact", source = t.source,
    reference = t.reference, scale = t.reference == 0 and 1 or nil, values = values,
    resolution = "1 / cells", tolerance = t.tolerance, run = of[#of] }
end

local sweep = {}
for _, kind in ipairs { "bar", "ball", "joint", "block", "jkr" } do
  for _, cells in ipairs { 1, 2, 4 } do
    sweep[#sweep + 1] = { kind = kind, cells = cells }
  end
end

return stiction.study {
  title = "Derivatives of forces with respect to parameters",
  question = "Are the derivatives that run beside a case those of closed forms?",
  given = {
    young = { 5*MPa, "" }, poisson = { 0.48, "" }, width = { 10*mm, "bar and block" }, height = { 20*mm, "bar" }, stretch = { 0.1*mm, "" },
    radius = { 5*mm, "ball" }, depth = { 16*um, "contact 0.28 mm wide" }, w = { 1*J/m^2, "" }, mu = { 0.3, "" },
    b = { 4*N*s/m, "a quarter bonded after 1 s" }, pressed = { 1*um, "block, 5 N/m in all" },
  },
  chosen = { reach = { 6*mm, "twenty widths of the contact" }, above = { 40*um, "beyond the largest pull" },
    strength = { 1e9*units.Pa, "bonds of 1 nm: Maugis' lambda 5500" },
    stiffness = { 5e9*N/m^3, "bonds of 14 um, cohesive length 1.3 mm" }, weak = { 1*N/m^3, "bonds that bear nothing" },
    ball_cell = { 50*um, "a sixth of the contact, over `cells`" },
    joint_cell = { 100*um, "a thirteenth of the cohesive length, over `cells`" } },
  sweep = sweep,
  quick = { sweep = numeric.map({ 1, 2, 4, 5, 7, 8, 10, 11, 13, 14, 15 }, function(i) return sweep[i] end) },
  case_id = function(p) return ("%s_%d"):format(p.kind, p.cells) end,
  derivatives = { "young", "poisson", "height", "radius", "depth", "w", "stiffness", "mu", "b" },
  scene = function(p) return scenes[p.kind](p) end,
  results = {
    { name = "force", unit = "N", meaning = "at the end; of the joint the largest pull (per metre of depth: bar, block)", force },
  },
  check = function(cases, check)
    local nu = cases[1].p.poisson
    local bar, hertz, johnson = "homogeneous strain", "Hertz 1882", "Johnson, Kendall and Roberts 1971"
    for _, t in ipairs {
      { "bar", "young", 1, 1e-5, bar }, { "bar", "height", -1, 1e-4, bar },
      { "bar", "poisson", 2 * nu ^ 2 / (1 - nu ^ 2), 1e-4, bar },
      { "ball", "young", 1, 1e-5, hertz }, { "ball", "radius", 0.5, 0.1, hertz }, { "ball", "depth", 1.5, 0.03, hertz },
      { "joint", "young w stiffness b", 1, 1e-4, "homogeneous in these" },
      { "jkr", "w", 1, 0.02, johnson }, { "jkr", "radius", 1, 0.02, johnson }, { "jkr", "young", 0, 0.02, johnson },
      { "block", "mu", 1, 1e-5, "Coulomb" },
    } do
      proof(cases, check, { kind = t[1], quantity = ("d ln F / d ln %s of the %s"):format(t[2], t[1]), unit = "1", source = t[5],
        value = power(t[2], force), reference = t[3], tolerance = t[4] })
    end
    for name, reference in pairs { w = 1, b = -1 } do
      proof(cases, check, { kind = "block", quantity = ("d ln beta / d ln %s of the block"):format(name), unit = "1",
        source = "beta = w t / b", value = power(name, bonded), reference = reference, tolerance = 1e-4 })
    end
  end,
}
