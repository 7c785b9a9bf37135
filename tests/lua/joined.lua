-- Sets of a mesh under one new name: what touches round an edge, what is held as one.
local test, _, _, shared = ...
local stiction = require "stiction"
local u = stiction.units
local mm, s = u.mm, u.s

local run = shared("runs").quasi_static "joined_runs"

--- A box pressed down and to the right into the corner of a floor and a wall; `joined` names sets, `secondary` is of one pair.
local function box(joined, secondary, more)
  local function plane(normal, point)
    return stiction.obstacle { shape = stiction.rigid.plane { normal = normal, point = point } }
  end
  local pairs = { floor = stiction.pair { secondary = "box." .. secondary, primary = "floor",
    friction = stiction.friction.coulomb { mu = 0.3 } } }
  if more then
    pairs.wall = stiction.pair { secondary = "box." .. more, primary = "wall" }
  end
  return stiction.scene { kinematics = "three_dimensional",
    bodies = { box = stiction.body { mesh = stiction.mesh.box { size = { 2*mm, 2*mm, 2*mm }, cells = { 2, 2, 2 } }, joined = joined,
      material = stiction.material.neo_hookean { young = 1*u.MPa, poisson = 0.4 }, density = 1000*u.kg/u.m^3 } },
    obstacles = { floor = plane({ 0, 0, 1 }, { 0*mm, 0*mm, 0*mm }), wall = plane({ -1, 0, 0 }, { 2*mm, 0*mm, 0*mm }) },
    pairs = pairs,
    motions = { stiction.motion.drive { set = "box.top", times = { 0*s, 1*s }, y = { 0*mm, 0*mm }, z = { 0*mm, -0.1*mm } },
      stiction.motion.drive { set = "box.left", times = { 0*s, 1*s }, x = { 0*mm, 0.05*mm } } },
    schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = 4 } } },
    probes = { floor = stiction.probe.contact { pair = "floor" }, wall = more and stiction.probe.contact { pair = "wall" } or nil } }
end

test("a joined set touches as the sets that it is of", function()
  local plain = run(box(nil, "bottom", "right"))
  local sole = run(box({ sole = { "bottom", "left", "bottom" }, side = { "right" } }, "sole", "side"))
  for pair, column in pairs { floor = "force_z", wall = "force_x" } do
    local one, other = plain:last(pair, column), sole:last(pair, column)
    assert(math.abs(one) > 1e-3 and math.abs(other / one - 1) < 1e-9, ("%s: %.12g, %.12g"):format(pair, one, other))
  end
end)

test("joined sets that cannot be are told", function()
  run(box({}, "bottom"))
  local function refused(joined, words)
    local made, why = pcall(run, box(joined, "bottom"))
    local text = made and "nothing" or tostring(why.message)
    assert(text:find(words, 1, true), text)
  end
  refused({ sole = { "botom", "left" } }, 'bodies.box.joined.sole: there is no set "botom"; known are all, back, bottom')
  refused({ left = { "bottom" } }, "bodies.box.joined.left: is a set of the mesh; give what is joined a name of its own")
  refused({ sole = {} }, "bodies.box.joined.sole: ")
  refused({ sole = "bottom" }, "bodies.box.joined.sole: is no list of names of sets")
  refused({ ["a.b"] = { "bottom" } }, 'has the name "a.b"')
end)
