-- What a scene gives and what does nothing in it: explain says so, and is silent where it does.
local test, equal, _, shared = ...
local stiction = require "stiction"
local units = stiction.units
local m, s, kg, N, J, Pa = units.m, units.s, units.kg, units.N, units.J, units.Pa

local scenes = shared "scenes"
local with, warned = scenes.with, scenes.warned

local function scene_of(pair, change)
  return with({ bodies = { block = stiction.body { mesh = stiction.mesh.block { size = { 1*m, 1*m }, cells = { 1, 1 } },
      density = 1000*kg/m^3, material = stiction.material.linear_elastic { young = 1e9*Pa, poisson = 0 } } },
    obstacles = { floor = stiction.obstacle { shape = stiction.rigid.plane {} } },
    pairs = { glue = stiction.pair { secondary = "block.bottom", primary = "floor", adhesion = pair.adhesion, friction = pair.friction } },
    motions = { stiction.motion.fix { set = "block.top" } },
    schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = 1 } } }, probes = {},
    scheme = stiction.scheme.quasi_static {}, output = stiction.output { frames = 0 } }, change)
end

local adhesion = stiction.adhesion
local function bilinear(more)
  return adhesion.bilinear(with({ K = 1e6*N/m^3, sigma_n = 900*Pa, sigma_t = 900*Pa, G_I = 1.9*J/m^2, G_II = 1.9*J/m^2 }, more))
end
local function rcc(more)
  return adhesion.rcc(with({ w = 1*J/m^2, C_n = 1e6*N/m^3, C_t = 1e6*N/m^3, b = 0*N*s/m, beta0 = 1 }, more))
end
local function exponential(more)
  return adhesion.exponential(with({ phi_n = 1*J/m^2, sigma_max = 900*Pa, delta_t = 1e-3*m }, more))
end
local coulomb = stiction.friction.coulomb { mu = 0.3 }

for _, case in ipairs {
  { "exponent of bilinear acts only where mix", idle = bilinear { mix = "linear", exponent = 3 }, acts = bilinear { exponent = 3 } },
  { "r of exponential acts only where memory", idle = exponential { r = 0.5, q = 0.5 },
    acts = exponential { r = 0.5, q = 0.5, memory = "reversible" } },
  { "beta0 of exponential acts only where memory", idle = exponential { beta0 = 0.5, memory = "reversible" },
    acts = exponential { beta0 = 0.5 } },
  { "beta0 of dugdale acts only where memory", idle = adhesion.dugdale { sigma0 = 1*Pa, h0 = 1*m, beta0 = 0.5 },
    acts = adhesion.dugdale { sigma0 = 1*Pa, h0 = 1*m, beta0 = 0.5, memory = "irreversible" } },
  { "damage_power of rcc acts only where friction", idle = rcc { damage_power = 2 },
    acts = rcc { damage_power = 2, friction = "damage" } },
  { "C_t2 of rcc acts only in space", idle = rcc { C_t2 = 2e6*N/m^3 }, acts = rcc { C_t2 = 1e6*N/m^3 } },
} do
  test("an option that does nothing is warned of: " .. case[1], function()
    equal(warned(scene_of { adhesion = case.idle, friction = coulomb }, case[1]), true)
    equal(warned(scene_of { adhesion = case.acts, friction = coulomb }, "acts only"), false)
  end)
end

test("friction that a bond takes away is missed where there is none", function()
  local words = "has no friction to take away"
  equal(warned(scene_of { adhesion = bilinear { friction = "damage" } }, words), true)
  equal(warned(scene_of { adhesion = bilinear { friction = "damage" }, friction = coulomb }, words), false)
end)

test("the weight of contact forces acts with the inertia of contact nodes alone", function()
  local function of(inertia)
    return scene_of({ friction = coulomb }, { scheme = stiction.scheme.theta_xi { contact_weight = 0.6, contact_inertia = inertia } })
  end
  equal(warned(of("implicit"), "contact_weight of theta_xi acts only where contact_inertia"), true)
  equal(warned(of("full"), "contact_weight"), false)
end)

test("a probe of the force on what nothing holds is warned of", function()
  local function on(set)
    return scene_of({ friction = coulomb }, { probes = { force = stiction.probe.force { set = set } } })
  end
  equal(warned(on("block.bottom"), "nothing moves or holds block.bottom"), true)
  equal(warned(on("block.top"), "nothing moves or holds"), false)
end)

test("turns beyond what a law of small rotations knows are warned of", function()
  local function turned(angle)
    local own = scene_of({ friction = coulomb }, { motions = { stiction.motion.turn { set = "block.top", times = { 0*s, 1*s },
      angle = { 0, angle }, centre = { 0*m, 1*m } } } })
    return scenes.warning(own, "and linear_elastic knows small strains and rotations only: of that it makes a strain of ")
  end
  equal(turned(0.1), nil)
  assert(turned(-0.6).text:find("turned by 0.6 rad", 1, true) and turned(-0.6).text:find("a strain of 17 %", 1, true))
end)

test("half spaces are told of options that do nothing, too", function()
  local function under(law)
    return { kinematics = "plane_strain",
      bodies = { block = stiction.body.half_space { young = 1e6*Pa, poisson = 0.3, size = { 1*m }, points = { 4 } } },
      obstacles = { tip = stiction.obstacle.height_map { surface = stiction.surface.map { heights = { 0, 0, 0, 0 } },
        times = { 0*s, 1*s }, y = { 0*m, 1e-3*m } } },
      pairs = { glue = stiction.pair { secondary = "block.surface", primary = "tip", adhesion = law } },
      schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = 1 } } }, probes = {},
      scheme = stiction.scheme.quasi_static {}, output = stiction.output { frames = 0 } }
  end
  equal(warned(under(bilinear { mix = "linear", exponent = 3 }), "exponent of bilinear acts only where mix"), true)
  equal(warned(under(bilinear { exponent = 3 }), "acts only"), false)
end)

test("matching meshes of quadratic cells are not told to swap sides, coarser ones are", function()
  local function half(y, cells)
    return stiction.body { mesh = stiction.mesh.block { origin = { 0*m, y }, size = { 1*m, 0.5*m }, cells = { cells, 2 }, kind = "quad8" },
      density = 1000*kg/m^3, material = stiction.material.linear_elastic { young = 1e9*Pa, poisson = 0 } }
  end
  for cells, coarse in pairs { [8] = false, [2] = true } do
    local scene = scene_of({}, { bodies = { low = half(0*m, 8), up = half(0.5*m, cells) },
      pairs = { joint = stiction.pair { secondary = "up.bottom", primary = "low.top", friction = coulomb } },
      motions = { stiction.motion.fix { set = "low.bottom" }, stiction.motion.fix { set = "up.top" } } })
    scene.obstacles = nil
    equal(warned(scene, "steps in which it slides may find no balance"), coarse)
  end
end)

test("a set that holds nodes of the axis of a section is not to be moved off it", function()
  local function of(x, kinematics)
    return with(scene_of({ friction = coulomb }), { kinematics = kinematics,
      motions = { stiction.motion.drive { set = "block.top", times = { 0*s, 1*s }, x = { 0*m, x*m }, y = { 0*m, -0.1*m } } } })
  end
  local words = "block.top: nodes on the axis are moved off it in x, by up to 10 mm"
  equal(warned(of(0.01, "axisymmetric"), words), true)
  equal(warned(of(0, "axisymmetric"), "moved off it"), false)
  equal(warned(of(0.01, "plane_strain"), "moved off it"), false)
end)

test("paths that begin when the run has ended are told", function()
  for _, late in ipairs { true, false } do
    local times = late and { 1*s, 2*s } or { 0*s, 2*s }
    local scene = scene_of({}, { motions = { stiction.motion.fix { set = "block.top", x = false },
      stiction.motion.drive { set = "block.right", times = times, x = { 0*m, 0.1*m } } },
      obstacles = { floor = stiction.obstacle { shape = stiction.rigid.plane {}, times = times, y = { 0*m, 0.1*m } } } })
    equal(warned(scene, "motions[2] of block.right: its path begins at 1 s, the run ends at 1 s"), late)
    equal(warned(scene, "obstacle floor: its path begins at 1 s"), late)
  end
end)
