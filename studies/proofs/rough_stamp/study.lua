-- One rough rigid surface pressed into a block of finite elements and into a half space: the same force, within the error bars of both?
--
--     ___________________
--     \__/\_/\___/\__/\_/     rigid, self-affine, the same waves on any number of points
--      _________________
--     | elements, or a  |     as wide as the waves repeat, as deep as wide; held below
--     | half space of a |     the half space: periodic, so much of it gives under the mean pressure
--     |_given_depth_____|
--
-- Waves decay with exp(-2 pi depth / wavelength) into the block, so that its held bottom is felt by the mean alone. Slopes are small
-- and elasticity linear. Each side is refined twice; its bar is the last change.
--
--     ./stiction run studies/proofs/rough_stamp
local stiction = require "stiction"
local units = stiction.units
local m, s, kg, MPa = units.m, units.s, units.kg, units.MPa

local function waves(p)
  return stiction.surface.rough { hurst = p.hurst, longest = p.width / p.longest, shortest = p.width / p.shortest, rms_slope = p.slope,
    seed = p.seed }
end

local function scene(p)
  local t = { schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = p.steps } } },
    scheme = stiction.scheme.quasi_static {}, probes = { touch = stiction.probe.contact { pair = "touch" } } }
  local times, y = { 0*s, 1*s }, { 0*m, -p.sink * p.slope * p.width }
  if p.side == "mesh" then
    t.bodies = { block = stiction.body { density = 1000*kg/m^3,
      material = stiction.material.linear_elastic { young = p.young, poisson = p.poisson },
      mesh = stiction.mesh.block { origin = { -p.width / 2, -p.width }, size = { p.width, p.width }, cells = { p.cells, p.cells / 2 },
        grading = { 1, p.grading } } } }
    t.obstacles = { stamp = stiction.obstacle { times = times, y = y, shape = stiction.rigid.height_map { surface = waves(p),
      size = { p.width }, points = { p.map }, normal = { 0, -1 } } } }
    t.motions = { stiction.motion.fix { set = "block.bottom" } }
    t.constraints = { stiction.constraint.periodic { set = "block.right", to = "block.left" } }
    t.pairs = { touch = stiction.pair { secondary = "block.top", primary = "stamp" } }
  else
    t.bodies = { base = stiction.body.half_space { young = p.young, poisson = p.poisson, size = { p.width }, points = { p.cells },
      depth = p.width } }
    t.obstacles = { stamp = stiction.obstacle.height_map { surface = waves(p), times = times, y = y } }
    t.pairs = { touch = stiction.pair { secondary = "base.surface", primary = "stamp" } }
  end
  return stiction.scene(t)
end

--- A value on the finest grid of a side and what the last refinement changed.
local function finest(cases, side, seed, name)
  local its = cases:where { side = side, seed = seed }
  table.sort(its, function(one, other) return one.p.cells < other.p.cells end)
  local last, before = its[#its].results[name], its[#its - 1].results[name]
  return last, math.abs(last - before)
end

local function sweep(seeds, cells, points)
  local list = {}
  for seed = 1, seeds do
    for level = 1, 3 do
      list[#list + 1] = { side = "mesh", cells = cells[level], seed = seed }
      list[#list + 1] = { side = "points", cells = points[level], seed = seed }
    end
  end
  return list
end

return stiction.study {
  title = "A rough rigid surface on elements and on a half space",
  question = "Is the force of a height map the same on a block of finite elements and on a half space?",
  given = { width = { 1*m, "" }, young = { 1*MPa, "" }, poisson = { 0.3, "" }, hurst = { 0.8, "" },
    longest = { 2, "waves over the width" }, shortest = { 8, "waves over the width" },
    slope = { 2e-4, "rms: what finite slopes and strains change, in proportion, is below the bars" },
    sink = { 0.3, "of the surface over slope and width" } },
  chosen = { map = { 1024, "points of the rigid map, as of the finest half space: the highest of them touches first" },
    steps = { 3, "without friction they do not matter" },
    grading = { 0.25, "of the uppermost cells over the lowest" } },
  sweep = sweep(3, { 128, 256, 512 }, { 256, 512, 1024 }),
  quick = { sweep = sweep(1, { 64, 128, 256 }, { 256, 512, 1024 }) },
  case_id = function(p) return ("%s_%d_surface_%d"):format(p.side, p.cells, p.seed) end,
  scene = scene,
  results = {
    { name = "pressure", unit = "1", meaning = "mean over E* slope",
      function(run, p)
        local force = run:series("touch", "force_y")
        return math.abs(force[#force]) / (p.width.si * p.slope * p.young.si / (1 - p.poisson ^ 2))
      end },
    { name = "part", unit = "1", meaning = "of the width that touches",
      function(run, p)
        local closed = run:series("touch", "closed_area")
        return closed[#closed] / p.width.si
      end },
  },
  check = function(cases, check)
    local seeds = {}
    for _, case in ipairs(cases) do
      seeds[case.p.seed] = true
    end
    for seed = 1, #seeds do
      local mesh, mesh_bar = finest(cases, "mesh", seed, "pressure")
      local points, points_bar = finest(cases, "points", seed, "pressure")
      check.equal(("surface %d: pressure of elements and half space within both error bars"):format(seed), mesh, points,
        mesh_bar + points_bar)
      check.within(("surface %d: part that touches, so that it is contact in part"):format(seed),
          (finest(cases, "mesh", seed, "part")), 0.1, 0.9)
    end
  end,
  figures = function(cases)
    local curves = {}
    for k, side in ipairs { "mesh", "points" } do
      local its, x, y = cases:where { side = side, seed = 1 }, {}, {}
      table.sort(its, function(one, other) return one.p.cells < other.p.cells end)
      for i, case in ipairs(its) do
        x[i], y[i] = 1 / case.p.cells, case.results.pressure
      end
      curves[k] = { label = side == "mesh" and "elements" or "half space", x = x, y = y, style = "points" }
    end
    return { stiction.figure.lines { name = "refinement", title = "The same rough surface", x = { label = "spacing / width", unit = "1" },
      y = { label = "mean pressure / (E* slope)" }, curves = curves } }
  end,
}
