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

test("corners of the primary that dig in between points of the secondary are told, with where and how deep", function()
  local function remarks(secondary, primary, discretisation)
    local case = run(stiction.scene {
      bodies = { low = body(0, 0, 12, 12, 3), stamp = body(4.3, 3, 2.4, 8, 30) },
      pairs = { joint = stiction.pair { secondary = secondary, primary = primary, discretisation = discretisation } },
      motions = { stiction.motion.fix { set = "low.bottom" }, stiction.motion.fix { set = "stamp.top", y = false },
        stiction.motion.drive { set = "stamp.top", times = { 0*s, 1*s }, y = { 0*mm, -0.3*mm } } },
      schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = 6 } } },
    })
    return table.concat(case.result.remarks, "\n")
  end
  local told = remarks("low.top", "stamp.bottom")
  local x, depth, part = told:match "of the primary of pair joint, at %(([%d.]+), [%d.]+%) m, lies ([%d.]+) um within.* ([%d.]+) of a facet"
  x, depth, part = tonumber(x), tonumber(depth), tonumber(part)
  assert(x and (math.abs(x - 4.3e-3) < 2e-4 or math.abs(x - 6.7e-3) < 2e-4), told)
  assert(depth > 100 and depth < 300 and math.abs(part - depth / 1000) < 0.05, told)
  equal(remarks("stamp.bottom", "low.top"):find("digs in", 1, true), nil)
  equal(remarks("low.top", "stamp.bottom", "mortar"):find("digs in", 1, true), nil)
end)

test("a run that ends as a pressed corner slides off the border of its counterpart says so", function()
  local function shape(size, start, ...)
    local edges = {}
    for i, to in ipairs { ... } do
      edges[i] = stiction.edge { to = { to[1]*mm, to[2]*mm }, name = to[3] }
    end
    return stiction.mesh.gmsh { size = size*mm, start = { start[1]*mm, start[2]*mm }, edges = edges }
  end
  local function rubber(mesh, young, poisson)
    return stiction.body { mesh = mesh, density = 1000*kg/m^3, interpolation = "mean_dilatation",
      material = stiction.material.neo_hookean { young = young*MPa, poisson = poisson } }
  end
  local wedge = shape(0.5, { -1, 6 }, { -0.2, 0, "flank" }, { 0.2, 0, "flank" }, { 1, 6, "flank" }, { -1, 6, "top" })
  local left = shape(0.5, { -4, -6 }, { -0.3, -6 }, { -0.3, 1, "face" }, { -4, 1, "face" }, { -4, -6, "back" })
  local right = shape(0.5, { 4, -6 }, { 4, 1, "back" }, { 0.3, 1, "face" }, { 0.3, -6, "face" }, { 4, -6 })
  local result = attempt(stiction.scene {
    bodies = { wedge = rubber(wedge, 50, 0.3), left = rubber(left, 2, 0.45), right = rubber(right, 2, 0.45) },
    pairs = { a = stiction.pair { secondary = "left.face", primary = "wedge.flank" },
      b = stiction.pair { secondary = "right.face", primary = "wedge.flank" } },
    motions = { stiction.motion.fix { set = "left.back" }, stiction.motion.fix { set = "right.back" },
      stiction.motion.drive { set = "wedge.top", times = { 0*s, 1*s }, x = { 0*mm, 0*mm }, y = { 0*mm, -5*mm } } },
    scheme = stiction.scheme.quasi_static {}, schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = 50 } } },
  }).result
  equal(result.verdict, "not converged")
  assert(result.reason:find("slides off the border of its counterpart", 1, true), result.reason)
end)
