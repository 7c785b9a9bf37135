-- A soft block pressed onto another and drawn along it: its corners, where pressure has no bound, turn the surface under them.
local test, equal, _, shared = ...
local stiction = require "stiction"
local units = stiction.units
local mm, s, kg, m, MPa = units.mm, units.s, units.kg, units.m, units.MPa

local run, attempt = shared("runs").quasi_static "corners_runs", shared("runs").below "corners_failed"

local function body(x, y, width, across, young)
  local mesh = stiction.mesh.block { origin = { x*mm, y*mm }, size = { width*mm, 3*mm }, cells = { across, across * 3 // width } }
  return stiction.body { mesh = mesh, density = 1000*kg/m^3,
    material = stiction.material.neo_hookean { young = young*MPa, poisson = 0.4 } }
end

--- below, above: cells along the lower body, the upper one; t: depth by which that is pressed, mm, mu, discretisation, halvings.
local function slide(below, above, t)
  local times = { 0*s, 0.5*s, 1*s }
  return stiction.scene {
    bodies = { low = body(0, 0, 12, below, 3), top = body(3, 3, 6, above, 2) },
    pairs = { joint = stiction.pair { secondary = "top.bottom", primary = "low.top", discretisation = t.discretisation,
      friction = stiction.friction.coulomb { mu = t.mu or 0.4 } } },
    motions = { stiction.motion.fix { set = "low.bottom" },
      stiction.motion.drive { set = "top.top", times = times, x = { 0*mm, 0*mm, 1.2*mm }, y = { 0*mm, -t.depth*mm, -t.depth*mm } } },
    scheme = stiction.scheme.quasi_static {},
    schedule = stiction.schedule { halvings = t.halvings,
      stages = { stiction.stage { to = 0.5*s, steps = 5 }, stiction.stage { to = 1*s, steps = 15 } } },
    output = stiction.output { frames = 0 }, probes = { joint = stiction.probe.contact { pair = "joint" } },
  }
end

for _, cells in ipairs { { 36, 21 }, { 36, 29 }, { 48, 15 } } do
  test(("corners slide over facets of %d cells by %d, in the steps they are given"):format(cells[1], cells[2]), function()
    local own = run(slide(cells[1], cells[2], { depth = 0.25 }))
    equal(#own.time, 21)
    assert(own.result.iterations < 8 * 20, own.result.iterations)
  end)
end

test("where no step is found, what spreads a corner's force is named, and goes on", function()
  local failed = 0 -- at least one of them, whatever rounding makes of each
  for _, own in ipairs { { above = 15, depth = 0.25 }, { above = 15, depth = 0.4 }, { above = 21, depth = 0.25, mu = 0.6 } } do
    own.halvings = 1
    local result = attempt(slide(60, own.above, own)).result
    if result.verdict ~= "finished" then
      failed = failed + 1
      assert(result.reason:find('discretisation = "mortar" spreads', 1, true), result.reason)
    end
    own.discretisation = "mortar"
    equal(#run(slide(60, own.above, own)).time, 21)
  end
  assert(failed > 0)
end)
