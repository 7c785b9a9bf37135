-- The same scenes answered by a closed formula and by the points of a half space: two rungs of a ladder.
--
--          .-'''-.       hertz, maugis_*: a sphere down (and, where it adheres, up again) by displacement
--         |   R   |      mindlin: a sphere pressed, then moved along and back; punch: flat and round
--     _____'-._.-'_____  wave: cosines pressed by a force that makes most of them touch
--
--     ./stiction run studies/proofs/half_space_formula
local stiction = require "stiction"
local units = stiction.units
local mm, um, m, s, MPa, Pa, N, J = units.mm, units.um, units.m, units.s, units.MPa, units.Pa, units.N, units.J
local jkr, maugis = stiction.reference.jkr, stiction.reference.maugis

local function modulus(p) return jkr.modulus(p.young.si, p.poisson) end

--- Work per area of the adhesion and its traction, of the Maugis parameter lambda.
local function sigma0(p, lambda) return maugis.traction(modulus(p), p.radius.si, p.w.si, lambda) end

local function sphere(p, extra)
  local made = { surface = stiction.surface.sphere { radius = p.radius }, times = { 0*s, 1*s } }
  for key, value in pairs(extra) do made[key] = value end
  return made
end

--- Of each kind: what presses, the extent of the points, its pair's law, its stages, and what is compared.
local kinds = {}

function kinds.hertz(p)
  local depth = (p.a / p.radius) * p.a
  return { size = 3 * p.a, steps = { 4 }, map = sphere(p, { z = { 0*mm, -depth } }) }
end

function kinds.mindlin(p)
  local depth = (p.a / p.radius) * p.a
  local way = p.way * p.mu * 3 * depth / 2 -- over that at which all slips: 3 mu P (2 - nu) / (16 G a), with nu = 1/2
  return { size = 3 * p.a, steps = { 2, 5, 5 }, law = { friction = stiction.friction.coulomb { mu = p.mu } },
    map = sphere(p, { times = { 0*s, 1*s, 2*s, 3*s }, z = { 0*mm, -depth, -depth, -depth }, x = { 0*mm, 0*mm, way, 0*mm } }) }
end

function kinds.punch(p)
  local depth = 0.02 * p.a
  return { size = 4 * p.a, steps = { 1 }, map = { surface = stiction.surface.punch { radius = p.a, clearance = 10 * depth },
      times = { 0*s, 1*s }, z = { 0*mm, -depth } } }
end

function kinds.wave(p)
  local most = math.pi * modulus(p) * p.amplitude.si / p.length.si -- Pa: all touches
  return { line = true, size = p.length, steps = { 10 }, map = { surface = stiction.surface.wave { amplitude = p.amplitude,
      wavelengths = { p.length } }, times = { 0*s, 1*s }, force = { 0*N, 0.7 * most * p.length.si * N } } }
end

local function adhesive(lambda, ramp) -- of the range at 64 points, less as points get more
  return function(p)
    local a, _, d = maugis.units(modulus(p), p.radius.si, p.w.si)
    local sigma = sigma0(p, lambda)
    return { size = 6 * a * m, steps = { 6, 60 }, map = sphere(p, { times = { 0*s, 1*s, 2*s }, z = { 0*mm, -0.5 * d * m, 2.5 * d * m } }),
      law = { adhesion = stiction.adhesion.dugdale { sigma0 = sigma*Pa, h0 = p.w.si / sigma * m, ramp = ramp * 64 / p.points } } }
  end
end
kinds.maugis_half = adhesive(0.5, 0.1)
kinds.maugis_one = adhesive(1, 0.2)

local function scene(p)
  local kind = kinds[p.kind](p)
  local stages = {}
  for k, steps in ipairs(kind.steps) do stages[k] = stiction.stage { to = k*s, steps = steps } end
  local pair = { secondary = "base.surface", primary = "sphere" }
  for key, law in pairs(kind.law or {}) do pair[key] = law end
  return stiction.scene {
    model = p.model,
    kinematics = kind.line and "plane_strain" or "three_dimensional",
    bodies = { base = stiction.body.half_space { young = p.young, poisson = p.poisson,
      size = kind.line and { kind.size } or { kind.size, kind.size },
      points = kind.line and { p.points } or { p.points, p.points }, boundary = kind.line and "periodic" or "free" } },
    obstacles = { sphere = stiction.obstacle.height_map(kind.map) },
    pairs = { touch = stiction.pair(pair) },
    scheme = stiction.scheme.quasi_static {},
    schedule = stiction.schedule { stages = stages },
    probes = { touch = stiction.probe.contact { pair = "touch" }, sphere = stiction.probe.rigid { obstacle = "sphere" },
      energy = p.kind ~= "mindlin" and stiction.probe.energy {} or nil },
  }
end

--- At the end, at a time, or the largest of a history.
local function value(case, row)
  local values = case:series(row.probe, row.column)
  if row.largest then
    return math.max(table.unpack(values))
  end
  for k, time in ipairs(case.time) do
    if row.time and time >= row.time - 1e-9 then return values[k] end
  end
  return values[#values]
end

local function row(quantity, unit, probe, column, tolerance, extra)
  local made = { quantity = quantity, unit = unit, probe = probe, column = column, tolerance = tolerance }
  for key, more in pairs(extra or {}) do made[key] = more end
  return made
end

--- The ramps of the traction reach beyond the range: a quarter of them.
local function of_ramp(p) return p.kind == "maugis_half" and 1.6 / p.points or 3.2 / p.points end

--- The work that they add: half of them.
local function of_work(p) return 2 * of_ramp(p) end

--- What is compared, with how far the finest of the quick form may be off, relative: errors fall with the spacing, but for
--- what Mindlin's formula leaves out.
local compared = {
  { kind = "hertz", title = "Hertz", source = "Johnson 1985, 4.2", row("force", "N", "sphere", "force_z", 2e-4),
    row("area", "mm^2", "touch", "closed_area", 2e-2), row("largest pressure", "MPa", "touch", "pressure_max", 2e-3),
    row("stored", "J", "energy", "strain", 2e-3) },
  { kind = "mindlin", title = "Mindlin", source = "Mindlin and Deresiewicz 1953",
    row("force along", "N", "touch", "force_x", 3e-3, { time = 2 }), row("force along, back", "N", "touch", "force_x", 2e-2) },
  { kind = "punch", title = "flat punch", source = "Sneddon 1946", row("force", "N", "sphere", "force_z", 2e-3),
    row("stored", "J", "energy", "strain", 2e-3) },
  { kind = "wave", title = "wave", source = "Westergaard 1939", row("lift", "um", "sphere", "u_y", 2e-3),
    row("width that touches", "mm", "touch", "closed_area", 2e-2), row("largest pressure", "MPa", "touch", "pressure_max", 5e-3),
    row("stored", "J/m", "energy", "strain", 2e-3) },
  { kind = "maugis_half", title = "Maugis, lambda = 0.5", source = "Maugis 1992",
    row("pull-off", "N", "touch", "force_z", of_ramp, { largest = true }),
    row("force where pressed", "N", "sphere", "force_z", 1e-2, { time = 1 }),
    row("largest pressure", "Pa", "touch", "pressure_max", 1e-2, { largest = true }),
    row("stored where pressed", "J", "energy", "strain", of_ramp, { time = 1 }),
    row("bond energy where pressed", "J", "energy", "bond", of_work, { time = 1 }) },
  { kind = "maugis_one", title = "Maugis, lambda = 1", source = "Maugis 1992",
    row("pull-off", "N", "touch", "force_z", of_ramp, { largest = true }),
    row("force where pressed", "N", "sphere", "force_z", 1e-2, { time = 1 }),
    row("largest pressure", "Pa", "touch", "pressure_max", 1e-2, { largest = true }),
    row("stored where pressed", "J", "energy", "strain", of_ramp, { time = 1 }),
    row("bond energy where pressed", "J", "energy", "bond", of_work, { time = 1 }) },
}

local function spacing(case)
  return kinds[case.p.kind](case.p).size.si / case.p.points
end

local function rungs(kind, ...)
  local list = { { kind = kind, model = "formula", points = 64 } }
  for _, points in ipairs { ... } do
    list[#list + 1] = { kind = kind, model = "half_space", points = points }
  end
  return list
end

local function all(...)
  local list = {}
  for _, part in ipairs { ... } do
    table.move(part, 1, #part, #list + 1, list)
  end
  return list
end

return stiction.study {
  title = "Formulas against the points of a half space",
  question = "Do a closed formula and the points of a half space answer the same scene alike, and at what cost?",
  given = { young = { 3*MPa, "" }, poisson = { 0.5, "" }, radius = { 20*mm, "of the sphere" }, a = { 1*mm, "contact radius" },
    mu = { 0.5, "" }, w = { 0.05*J/m^2, "work of adhesion" }, amplitude = { 10*um, "of the wave" }, length = { 1*mm, "of a wave" } },
  chosen = { way = { 0.6, "along, over that at which all slips" } },
  sweep = all(rungs("hertz", 64, 128, 256), rungs("mindlin", 32, 64, 128), rungs("punch", 64, 128, 256), rungs("wave", 128, 256, 512),
    rungs("maugis_half", 64, 128), rungs("maugis_one", 64, 128)),
  quick = { sweep = all(rungs("hertz", 64, 128), rungs("mindlin", 32, 64), rungs("punch", 64, 128, 256), rungs("wave", 128, 256),
    rungs("maugis_half", 64, 128)) },
  case_id = function(p) return p.model == "formula" and p.kind or ("%s_%d"):format(p.kind, p.points) end,
  scene = scene,
  results = {
    { name = "force", unit = "N", meaning = "largest force that presses (on a line: N/m)",
      function(run, p) return run:max("sphere", p.kind == "wave" and "force_y" or "force_z") end },
    { name = "pull", unit = "N", meaning = "largest force that it holds (on a line: N/m)",
      function(run, p) return run:max("touch", p.kind == "wave" and "force_y" or "force_z") end },
  },
  check = function(cases, check)
    for _, kind in ipairs(compared) do
      local formula, points = cases:where { kind = kind.kind, model = "formula" }[1], cases:where { kind = kind.kind, model = "half_space" }
      for _, its in ipairs(formula and kind or {}) do
        local values = {}
        for k, case in ipairs(points) do
          values[k] = { spacing(case), value(case, its) }
        end
        check.proof { case = kind.title .. ": points against the formula", quantity = its.quantity, unit = its.unit, kind = "exact",
          source = kind.source, reference = value(formula, its), values = values, resolution = "m spacing",
          tolerance = type(its.tolerance) == "function" and its.tolerance(points[#points].p) or its.tolerance, run = points[#points] }
      end
    end
  end,
  figures = function(cases)
    local curves = {}
    for _, kind in ipairs { "maugis_half", "maugis_one" } do
      local points = cases:where { kind = kind, model = "half_space" }
      for k, case in ipairs { cases:where { kind = kind, model = "formula" }[1], points[#points] } do
        local p = case.p
        local _, P, d = maugis.units(modulus(p), p.radius.si, p.w.si)
        local function over(column, unit)
          return stiction.numeric.map(case:series("sphere", column), function(one) return one / unit end)
        end
        curves[#curves + 1] = { label = case.id, x = over("u_z", -d), y = over("force_z", P), style = k == 2 and "points" or nil }
      end
    end
    return { stiction.figure.lines { name = "maugis", title = "The formula and the points", x = { label = "d*", range = { -2.5, 1 } },
      y = { label = "P*", range = { -2, 1.5 } }, curves = curves } }
  end,
}
