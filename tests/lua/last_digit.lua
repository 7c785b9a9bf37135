-- Nodes that motions hold on their counterpart to the last digit: rounding presses no force out of them, on either side.
local test, equal, _, shared = ...
local stiction = require "stiction"
local u = stiction.units
local mm, s = u.mm, u.s

local run = shared("runs").quasi_static "last_digit_runs"

local function held(bottom, floor, law)
  return stiction.scene {
    bodies = { d = stiction.body { density = 1000*u.kg/u.m^3,
      mesh = stiction.mesh.block { origin = { 0*mm, bottom*mm }, size = { 10*mm, 1*mm }, cells = { 10, 2 } },
      material = stiction.material.neo_hookean { young = 1*u.MPa, poisson = 0.3 } } },
    obstacles = { f = stiction.obstacle { shape = stiction.rigid.plane { point = { 0*mm, floor*mm } } } },
    pairs = { c = stiction.pair { secondary = "d.bottom", primary = "f", friction = law.friction } },
    motions = { stiction.motion.fix { set = "d.all", x = false }, stiction.motion.fix { set = "d.left", y = false },
      stiction.motion.drive { set = "d.right", times = { 0*s, 1*s }, x = { 0*mm, 0.1*mm } } },
    scheme = stiction.scheme.quasi_static {},
    schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = 5 } } },
    probes = { c = stiction.probe.contact { pair = "c" } } }
end

test("0.3 mm and 0.1 mm + 0.2 mm are one place", function()
  for _, law in ipairs { {}, { friction = stiction.friction.coulomb { mu = 0.3 } } } do
    for _, places in ipairs { { 0.3, 0.1 + 0.2 }, { 0.1 + 0.2, 0.3 } } do
      local own = run(held(places[1], places[2], law))
      equal(own:last("c", "force_y"), 0)
      equal(own:last("c", "force_x"), 0)
    end
  end
end)

test("weight acts however small gravity is", function()
  for _, g in ipairs { 9.81, 1e-13 } do
    local m = u.m
    local case = run(stiction.scene { gravity = { 0*m/s^2, -g*m/s^2 },
      bodies = { b = stiction.body { mesh = stiction.mesh.block { size = { 1*m, 1*m }, cells = { 2, 2 } },
        material = stiction.material.linear_elastic { young = 1*u.MPa, poisson = 0 }, density = 1e3 / g * (1*u.kg/m^3) } },
      motions = { stiction.motion.fix { set = "b.top" } }, scheme = stiction.scheme.quasi_static {},
      schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = 1 } } },
      probes = { f = stiction.probe.force { set = "b.top" } } })
    assert(math.abs(case:last("f", "force_y") / 1000 - 1) < 1e-9, case:last("f", "force_y"))
  end
end)
