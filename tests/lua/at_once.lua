-- Weight and loads that act at once, without inertia: where a slender body cannot take them in one step, cut steps bring them on.
local test, equal, _, shared = ...
local stiction = require "stiction"
local u = stiction.units
local mm, s, m = u.mm, u.s, u.m

local run = shared("runs").quasi_static "at_once_runs"

--- A film that hangs from its left end under a load on each of its cells' volume; how: "gravity", "pulled" by a load at once, or "ramped".
local function film(how, length, thickness)
  local weight = 9.81 * 1000 * thickness * 1e-3 -- Pa
  local times, values = { 0*s, 1*s }, { -weight*u.Pa, -weight*u.Pa }
  if how == "ramped" then
    values[1] = 0*u.Pa
  end
  return stiction.scene {
    gravity = { 0*m/s^2, (how == "gravity" and -9.81 or 0)*m/s^2 },
    bodies = { d = stiction.body { density = 1000*u.kg/m^3,
      mesh = stiction.mesh.block { size = { length*mm, thickness*mm }, cells = { 5*length // 1, 1 }, kind = "quad8" },
      material = stiction.material.neo_hookean { young = 2*u.MPa, poisson = 0.3 } } },
    motions = { stiction.motion.fix { set = "d.left" } },
    loads = how ~= "gravity" and { stiction.load.traction { set = "d.bottom", times = times, y = values } } or nil,
    scheme = stiction.scheme.quasi_static {},
    schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = 30 } } },
    probes = { tip = stiction.probe.node { set = "d.right", near = { length*mm, 0*mm } }, energy = stiction.probe.energy {} } }
end

for _, own in ipairs { { 6, 0.1 }, { 10, 0.1 }, { 14, 0.25 } } do
  test(("a film of %g by %g mm hangs as if its load had grown in many steps"):format(own[1], own[2]), function()
    local ramped = run(film("ramped", own[1], own[2]))
    for _, how in ipairs { "gravity", "pulled" } do
      local once = run(film(how, own[1], own[2]))
      for _, name in ipairs { "u_x", "u_y" } do
        local a, b = once:last("tip", name), ramped:last("tip", name)
        assert(math.abs(a / b - 1) < 0.02, how .. " " .. a .. " " .. b)
      end
    end
  end)
end

test("what one step bears is put on in it", function()
  local own = run(film("gravity", 1, 0.2))
  equal(#own.time, 31)
  assert(math.abs(own:at(1 / 30, "tip", "u_y") / own:last("tip", "u_y") - 1) < 1e-6)
end)
