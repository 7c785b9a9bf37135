-- Bodies that turn. A stub bonded to a base: a bond joins two material points, whose way apart is a chord, however the two turn.
local test, equal, _, shared = ...
local stiction = require "stiction"
local u = stiction.units
local mm, s, N, m, J = u.mm, u.s, u.N, u.m, u.J

local run = shared("runs").quasi_static "twisted_runs"

--- Turned by an angle in so many steps, one of "stub" and "base" or both of them.
local function scene(angle, steps, turning)
  local function body(corner, size, cells)
    return stiction.body { mesh = stiction.mesh.box { origin = corner, size = size, cells = cells }, density = 1000*u.kg/m^3,
      material = stiction.material.neo_hookean { young = 1000*u.MPa, poisson = 0.3 } }
  end
  local function turn(set, name, way)
    local turns = turning == name or turning == "both"
    return stiction.motion.turn { set = set, times = { 0*s, 1*s }, angle = { 0, turns and way * angle or 0 },
      centre = { 0*mm, 0*mm, 0*mm } }
  end
  return stiction.scene { kinematics = "three_dimensional",
    bodies = { stub = body({ -1*mm, -1*mm, 0*mm }, { 2*mm, 2*mm, 1*mm }, { 6, 6, 1 }),
      base = body({ -1.9*mm, -2*mm, -1*mm }, { 4*mm, 4*mm, 1*mm }, { 5, 5, 1 }) },
    pairs = { glue = stiction.pair { secondary = "stub.bottom", primary = "base.top", discretisation = "mortar",
      adhesion = stiction.adhesion.rcc { w = 1e5*J/m^2, C_n = 1e8*N/m^3, C_t = 1e8*N/m^3, b = 0*N*s/m, beta0 = 1,
        bonding = "never" } } },
    motions = { turn("stub.top", "stub", 1), turn("base.bottom", "base", turning == "both" and 1 or -1) },
    schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = steps } } },
    probes = { top = stiction.probe.force { set = "stub.top", about = { 0*mm, 0*mm, 0*mm } },
      energy = stiction.probe.energy { audit = true } } }
end

test("the moment of bonds follows the sine of the angle, whichever side turns, and is gone after a whole turn", function()
  local whole = 1e8 * 2e-3 ^ 4 / 6 -- C_t s^4 / 6, N m
  for _, turning in ipairs { "stub", "base" } do
    local case = run(scene(math.pi / 2, 9, turning))
    local moment, energy = case:series("top", "moment_z"), case:series("energy", "bond")
    local last = moment[#moment]
    assert(math.abs(last / whole - 1) < 0.06, last / whole) -- means over cells of a sixth of it
    for i, t in ipairs(case.time) do
      assert(math.abs(moment[i] / last - math.sin(t * math.pi / 2)) < 1e-3, moment[i] / last)
      assert(math.abs((energy[i] - energy[1]) / last - 1 + math.cos(t * math.pi / 2)) < 1e-3, energy[i] / last)
    end
    for _, open in ipairs((case:series("energy", "unaccounted"))) do
      assert(math.abs(open) < 1e-6 * last, open)
    end
  end
  local round = run(scene(2 * math.pi, 24, "stub"))
  local energy = round:series("energy", "bond")
  assert(math.abs(round:last("top", "moment_z")) < 1e-3 * whole)
  assert(energy[#energy] - energy[1] < 1e-3 * whole, energy[#energy] - energy[1])
  assert(energy[13] - energy[1] > 1.8 * whole, energy[13] - energy[1])
end)

test("bonds of two that turn together feel nothing", function()
  local case = run(scene(math.pi / 2, 9, "both"))
  local energy = case:series("energy", "bond")
  assert(energy[#energy] - energy[1] < 1e-9, energy[#energy] - energy[1])
end)

test("a body that is carried about an axis is not stretched by the way, however long the steps", function()
  for _, dim in ipairs { 2, 3 } do
    local corner, size = { 1*mm, 2*mm, dim == 3 and 3*mm or nil }, { 2*mm, 3*mm, dim == 3 and 2*mm or nil }
    local mesh = dim == 3 and stiction.mesh.box { origin = corner, size = size, cells = { 2, 2, 2 }, kind = "hex20" }
      or stiction.mesh.block { origin = corner, size = size, cells = { 2, 3 }, kind = "quad8" }
    local case = run(stiction.scene { kinematics = dim == 3 and "three_dimensional" or nil,
      bodies = { b = stiction.body { mesh = mesh, density = 1000*u.kg/u.m^3,
        material = stiction.material.neo_hookean { young = 1*u.MPa, poisson = 0.4995 } } },
      motions = { stiction.motion.turn { set = "b.bottom", times = { 0*s, 1*s }, angle = { 0, 2 },
        axis = dim == 3 and { 1, 2, -0.7 } or nil, centre = { 10*mm, -3*mm, dim == 3 and 4*mm or nil },
        x = { 0*mm, 5*mm }, y = { 0*mm, 1*mm } } },
      schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = 8 } } },
      probes = { e = stiction.probe.energy {} } })
    equal(case.result.steps, 8)
    assert(case.result.iterations <= 40, case.result.iterations)
    assert(case:max("e", "strain") < 1e-12, case:max("e", "strain")) -- of 1e6 Pa 1e-8 m^3
  end
end)
