-- How time and memory grow with the size of a scene, and which part of the work takes them.
--
--      _______________
--     |               |  down in one step, then across in `steps`
--     |     block     |
--     |_______________|
--     ///////////////// mu = 0.3
--
-- The block of block3d in space and its section in the plane, by a factor and by multigrid, up to a million unknowns.
--
--     ./stiction run studies/peers/scaling --jobs 1
local stiction = require "stiction"
local units = stiction.units
local mm, m, s, kg, MPa = units.mm, units.m, units.s, units.kg, units.MPa

local kinds = { -- cells along the sole
  { name = "plane, factor", space = false, bulk = "direct", cells = { 32, 64, 128, 256, 512, 700 } },
  { name = "space, factor", space = true, bulk = "direct", cells = { 8, 12, 16, 24, 32, 40 } },
  { name = "space, multigrid", space = true, bulk = "multigrid", cells = { 8, 12, 16, 24, 32, 40, 48, 64, 88 } },
}
local phases = { "assembly", "factorization", "solve", "contact", "output" }

local function all_cases(most)
  local cases = {}
  for _, kind in ipairs(kinds) do
    for i, cells in ipairs(kind.cells) do
      cases[#cases + 1] = (i <= most or nil) and { kind = kind.name, cells = cells }
    end
  end
  return cases
end

local function kind_of(p)
  for _, kind in ipairs(kinds) do
    if kind.name == p.kind then return kind end
  end
end

local function mesh_of(p, in_space)
  if in_space then
    return stiction.mesh.box { size = { p.length, p.length, p.height }, cells = { p.cells, p.cells, p.cells / 2 } }
  end
  return stiction.mesh.block { size = { p.length, p.height }, cells = { p.cells, p.cells / 2 } }
end

local function scene(p)
  local kind, zero = kind_of(p), 0*mm
  local lift = { zero, -p.press, -p.press }
  return stiction.scene {
    kinematics = kind.space and "three_dimensional" or "plane_strain",
    bodies = { block = stiction.body { mesh = mesh_of(p, kind.space),
      material = stiction.material.linear_elastic { young = p.young, poisson = p.poisson }, density = p.density } },
    obstacles = { plane = stiction.obstacle { shape = stiction.rigid.plane {} } },
    pairs = { sole = stiction.pair { secondary = "block.bottom", primary = "plane",
      friction = stiction.friction.coulomb { mu = p.mu } } },
    motions = { stiction.motion.drive { set = "block.top", times = { 0*s, 1*s, 2*s }, x = { zero, zero, p.shear },
      y = kind.space and { zero, zero, zero } or lift, z = kind.space and lift or nil } },
    scheme = stiction.scheme.quasi_static {},
    schedule = stiction.schedule { stages = {
      stiction.stage { to = 1*s, steps = 1 }, stiction.stage { to = 2*s, steps = p.steps } } },
    control = stiction.control { bulk = kind.bulk },
    probes = { sole = stiction.probe.contact { pair = "sole" } },
  }
end

local function cost(name, unit, meaning, counter)
  return { name = name, unit = unit, meaning = meaning, function(run) return run.cost[counter] end }
end

local results = {
  { name = "drag", unit = "N", meaning = "friction at the end (of a millimetre of depth in the plane)", function(run, p)
    return -run:at(2*s, "sole", "force_x") * (kind_of(p).space and 1 or 1e-3)
  end },
  cost("unknowns", "1", "degrees of freedom", "unknowns"),
  cost("points", "1", "rows of the largest contact problem", "contact_unknowns"),
  cost("cpu_seconds", "s", "processor time", "cpu_seconds"),
  cost("memory", "1", "bytes of memory at the peak", "peak_memory"),
}
for _, phase in ipairs(phases) do
  results[#results + 1] = cost("in_" .. phase, "s", "processor time of this part", "seconds_in_" .. phase)
end

local function of_kind(cases, name)
  local found = {}
  for _, case in ipairs(cases) do
    found[#found + 1] = case.p.kind == name and case or nil
  end
  return found
end

local function values(cases, name, scale)
  local list = {}
  for i, case in ipairs(cases) do
    list[i] = case.results[name] * (scale or 1)
  end
  return list
end

--- Exponent of a result's growth with the unknowns, between the first and the last of these cases.
local function growth(cases, name)
  local first, last = cases[1].results, cases[#cases].results
  return math.log(last[name] / first[name]) / math.log(last.unknowns / first.unknowns)
end

local function growing(cases, result, label, scale, unit)
  local curves = {}
  for _, kind in ipairs(kinds) do
    local own = of_kind(cases, kind.name)
    curves[#curves + 1] = #own > 0 and { label = kind.name, x = values(own, "unknowns"),
      y = values(own, result, scale) } or nil
  end
  return stiction.figure.lines { name = result, title = label, curves = curves, legend = "below",
    x = { label = "unknowns", log = true }, y = { label = label, unit = unit, log = true } }
end

local function shares(cases, kind)
  local own, curves = of_kind(cases, kind), {}
  for i, phase in ipairs(phases) do
    local part = {}
    for n, case in ipairs(own) do
      part[n] = case.results["in_" .. phase] / case.results.cpu_seconds
    end
    curves[i] = { label = phase, x = values(own, "unknowns"), y = part }
  end
  return stiction.figure.lines { name = "share", title = kind, curves = curves, legend = "below",
    x = { label = "unknowns", log = true }, y = { label = "part of processor time", range = { 0, 1 } } }
end

return stiction.study {
  title = "Time and memory over the size of a scene",
  question = "How do processor time and memory grow with the unknowns, by a factor and by multigrid, and what takes them?",
  given = {
    length = 40*mm, height = 20*mm, young = 5*MPa, poisson = 0.3, mu = 0.3, press = 0.4*mm, shear = 0.25*mm,
    steps = { 10, "while it is dragged" }, density = { 1000*kg/m^3, "not used in statics" },
  },
  sweep = all_cases(math.huge),
  quick = { sweep = all_cases(2) },
  case_id = function(p) return p.kind:gsub(", ", "_") .. "_" .. p.cells end,
  scene = scene,
  results = results,
  check = function(cases, check)
    local by_factor = {}
    for _, case in ipairs(of_kind(cases, "space, factor")) do
      by_factor[case.p.cells] = case.results.drag
    end
    for _, case in ipairs(of_kind(cases, "space, multigrid")) do
      local drag = by_factor[case.p.cells]
      if drag then
        check.close(("drag with %d cells: multigrid as the factor"):format(case.p.cells), case.results.drag, drag, 1e-6)
      end
    end
    local rows = {}
    for i, kind in ipairs(kinds) do
      local own = of_kind(cases, kind.name)
      rows[i] = { kind.name, own[1].results.unknowns, own[#own].results.unknowns, growth(own, "cpu_seconds"), growth(own, "memory") }
    end
    check.table { title = "Growth with the unknowns, exponents", columns = { "by", "from", "to", "time", "memory" }, rows = rows }
  end,
  figures = function(cases)
    return { stiction.figure.panel { name = "scaling", columns = 2, figures = {
      growing(cases, "cpu_seconds", "processor time", 1, "s"), growing(cases, "memory", "peak memory (MB)", 1e-6),
      shares(cases, "space, factor"), shares(cases, "space, multigrid") } } }
  end,
}
