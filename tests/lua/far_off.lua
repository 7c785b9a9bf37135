-- Scenes far from the origin, where coordinates of small facets have few digits left: contact and ties as at the origin.
local test, equal, _, shared = ...
local stiction = require "stiction"
local u = stiction.units
local mm, s = u.mm, u.s

local run = shared("runs").quasi_static "far_off_runs"

local function solid(mesh)
  return stiction.body { mesh = mesh, density = 1000*u.kg/u.m^3,
    material = stiction.material.neo_hookean { young = 1*u.MPa, poisson = 0.4 } }
end

--- A block on a larger one whose mesh does not match, pressed and dragged where a pair holds them apart; all as far off as `far`.
local function scene(far, pair, tied)
  local times = { 0*s, 1*s, 2*s }
  return stiction.scene { kinematics = "three_dimensional",
    bodies = {
      a = solid(stiction.mesh.box { origin = { far, far, far - 2*mm }, size = { 4*mm, 3*mm, 2*mm }, cells = { 4, 3, 2 } }),
      b = solid(stiction.mesh.box { origin = { far + 1*mm, far + 0.7*mm, far }, size = { 1.8*mm, 1.5*mm, 1.2*mm }, cells = { 3, 3, 2 } }),
    },
    motions = { stiction.motion.fix { set = "a.bottom" }, stiction.motion.drive { set = "b.top", times = times,
      x = { 0*mm, 0.02*mm, 0.3*mm }, y = { 0*mm, 0.01*mm, 0.2*mm }, z = { 0*mm, -0.15*mm, -0.15*mm } } },
    pairs = pair and { c = stiction.pair { secondary = "b.bottom", primary = "a.top", discretisation = pair,
      friction = stiction.friction.coulomb { mu = 0.4 } } } or {},
    constraints = tied and { stiction.constraint.tied { set = "b.bottom", to = "a.top" } } or {},
    schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = 4 }, stiction.stage { to = 2*s, steps = 6 } } },
    probes = { f = stiction.probe.force { set = "b.top" } } }
end

local function forces(...)
  local case = run(scene(...))
  return case:last("f", "force_x"), case:last("f", "force_z")
end

for name, what in pairs { points = { "node_to_segment" }, mortar = { "mortar" }, ties = { nil, true } } do
  test(("%s of facets of half a millimetre hold a kilometre off"):format(name), function()
    local x, z = forces(0*mm, table.unpack(what, 1, 2))
    local far_x, far_z = forces(1000*u.m, table.unpack(what, 1, 2))
    assert(math.abs(far_x / x - 1) < 1e-5 and math.abs(far_z / z - 1) < 1e-5, ("%.9g %.9g for %.9g %.9g"):format(far_x, far_z, x, z))
  end)
end

test("a profile in the plane is followed a kilometre off", function()
  local function force(far)
    local case = run(stiction.scene {
      bodies = {
        a = solid(stiction.mesh.block { origin = { far, far - 2*mm }, size = { 4*mm, 2*mm }, cells = { 9, 4 } }),
        b = solid(stiction.mesh.block { origin = { far + 1*mm, far }, size = { 1.8*mm, 1*mm }, cells = { 5, 2 } }),
      },
      motions = { stiction.motion.fix { set = "a.bottom" }, stiction.motion.drive { set = "b.top", times = { 0*s, 1*s, 2*s },
        x = { 0*mm, 0*mm, 0.3*mm }, y = { 0*mm, -0.1*mm, -0.1*mm } } },
      pairs = { c = stiction.pair { secondary = "b.bottom", primary = "a.top", friction = stiction.friction.coulomb { mu = 0.3 } } },
      schedule = stiction.schedule { stages = { stiction.stage { to = 2*s, steps = 12 } } },
      probes = { f = stiction.probe.force { set = "b.top" } } })
    return case:last("f", "force_y")
  end
  local near, far = force(0*mm), force(1000*u.m)
  assert(math.abs(far / near - 1) < 1e-5, far / near)
  equal(near < 0, true)
end)
