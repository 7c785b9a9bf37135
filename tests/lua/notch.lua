-- A body whose crack closes: its two faces meet at a node of both, which is no point of contact.
local test, _, _, shared = ...
local stiction = require "stiction"
local u = stiction.units
local mm, s, e = u.mm, u.s, stiction.edge

local run = shared("runs").quasi_static "notch_runs"

--- A square with a wedge cut in from its right side, pressed from above.
local function notched(pair)
  local mesh = stiction.mesh.gmsh { size = 1.5*mm, start = { 0*mm, 0*mm }, edges = {
    e { to = { 20*mm, 0*mm }, name = "bottom" }, e { to = { 20*mm, 9*mm }, name = "below" }, e { to = { 6*mm, 10*mm }, name = "low" },
    e { to = { 20*mm, 11*mm }, name = "up" }, e { to = { 20*mm, 20*mm }, name = "above" }, e { to = { 0*mm, 20*mm }, name = "top" },
    e { to = { 0*mm, 0*mm }, name = "left" } } }
  return stiction.scene {
    bodies = { b = stiction.body { mesh = mesh, density = 1000*u.kg/u.m^3,
      material = stiction.material.neo_hookean { young = 1*u.MPa, poisson = 0.3 } } },
    pairs = { faces = stiction.pair(pair) },
    motions = { stiction.motion.fix { set = "b.bottom" },
      stiction.motion.drive { set = "b.top", times = { 0*s, 1*s }, x = { 0*mm, 0*mm }, y = { 0*mm, -4*mm } } },
    scheme = stiction.scheme.quasi_static {},
    schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = 20 } } },
    probes = { faces = stiction.probe.contact { pair = "faces" }, press = stiction.probe.force { set = "b.top" },
      energy = stiction.probe.energy {} },
  }
end

test("either face may have the points, with friction too, and the press is the same", function()
  local friction = stiction.friction.coulomb { mu = 0.3 }
  for _, mu in ipairs { friction, false } do
    local one = run(notched { secondary = "b.low", primary = "b.up", friction = mu or nil })
    local two = run(notched { secondary = "b.up", primary = "b.low", friction = mu or nil })
    local a, b = one:last("press", "force_y"), two:last("press", "force_y")
    assert(math.abs(a / b - 1) < 0.01, a .. " " .. b)
    assert(math.abs(one:last("faces", "force_y")) > 1, one:last("faces", "force_y"))
    for _, own in ipairs { one, two } do
      assert(own:min("energy", "scheme_loss") > -0.01 * own:last("energy", "motion_work"))
    end
  end
end)


test("sides that have facets in common are told", function()
  local engine = require "stiction.engine"
  engine.write_file("notch_runs/two.inp", [[
*NODE
1, 0, 0
2, 1, 0
3, 1, 1
4, 0, 1
5, 1, 2
6, 0, 2
*ELEMENT, TYPE=CPE4
1, 1, 2, 3, 4
2, 4, 3, 5, 6
*SURFACE, NAME=low, TYPE=ELEMENT
1, S2
*SURFACE, NAME=side, TYPE=ELEMENT
1, S2
2, S2
*NSET, NSET=foot
1, 2
]])
  local scene = notched { secondary = "b.low", primary = "b.side" }
  scene.bodies.b.mesh = stiction.mesh.msh_file { path = engine.absolute "notch_runs/two.inp", scale = 1*mm }
  scene.motions = { stiction.motion.fix { set = "b.foot" } }
  scene.probes = {}
  local _, why = engine.call(run, scene)
  assert(tostring(why):find("pairs.faces.secondary: has 1 of the facets of the primary", 1, true), tostring(why))
end)
