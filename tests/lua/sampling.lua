-- Samples: Ishigami's function and Sobol's g with their known indices, moments and quantiles with errors, where failures lie.
local test, equal, fails = ...
local chaos = require "stiction.sampling.chaos"
local engine = require "stiction.engine"
local indices = require "stiction.sampling.indices"
local numeric = require "stiction.numeric"
local pictures = require "stiction.sampling.pictures"
local sample = require "stiction.sample"
local spec = require "stiction.sampling.spec"
local spread = require "stiction.sampling.spread"

--- Sobol's points in 0 to 1, lists of `axes` numbers.
local function points_of(count, axes)
  local of, list = {}, {}
  for k = 1, axes do
    of[("x%02d"):format(k)] = { 0, 1 }
  end
  for i, case in ipairs(sample.sobol { count = count, seed = 3, of = of }) do
    list[i] = {}
    for k = 1, axes do
      list[i][k] = case[("x%02d"):format(k)]
    end
  end
  return list
end

local function ishigami(u)
  local x = numeric.map(u, function(at) return math.pi * (2 * at - 1) end)
  return math.sin(x[1]) + 7 * math.sin(x[2]) ^ 2 + 0.1 * x[3] ^ 4 * math.sin(x[1])
end

-- Ishigami 1990; variances in closed form for a = 7, b = 0.1
local V1, V2, V13 = 0.5 * (1 + 0.1 * math.pi ^ 4 / 5) ^ 2, 7 ^ 2 / 8, 0.1 ^ 2 * math.pi ^ 8 * (1 / 18 - 1 / 50)
local V = V1 + V2 + V13
local ishigami_first, ishigami_total = { V1 / V, V2 / V, 0 }, { (V1 + V13) / V, V2 / V, V13 / V }

local weights = { 0, 1, 4.5, 9 } -- Sobol's g: product of (|4 x - 2| + a) / (1 + a); Sobol 2001

local function g(u)
  local product = 1
  for k, a in ipairs(weights) do
    product = product * (math.abs(4 * u[k] - 2) + a) / (1 + a)
  end
  return product
end

local function g_indices()
  local own, whole = {}, 1
  for k, a in ipairs(weights) do
    own[k] = 1 / (3 * (1 + a) ^ 2)
    whole = whole * (1 + own[k])
  end
  local first, total = {}, {}
  for k, v in ipairs(own) do
    first[k], total[k] = v / (whole - 1), v * whole / (1 + v) / (whole - 1)
  end
  return first, total
end

--- Rows for indices.of from points of twice as many axes.
local function rows_of(f, count, axes)
  return numeric.map(points_of(count, 2 * axes), function(point)
    local A, B = table.move(point, 1, axes, 1, {}), table.move(point, axes + 1, 2 * axes, 1, {})
    local row = { f(A), f(B), {} }
    for k = 1, axes do
      local own = table.move(A, 1, axes, 1, {})
      own[k] = B[k]
      row[3][k] = f(own)
    end
    return row
  end)
end

local function are_near(what, got, wanted, tolerance)
  for k, value in ipairs(wanted) do
    assert(math.abs(got[k] - value) <= tolerance, ("%s %d: %.4f, not %.4f"):format(what, k, got[k], value))
  end
end

local function within_errors(what, got, errors, wanted)
  for k, value in ipairs(wanted) do
    assert(math.abs(got[k] - value) <= 3 * errors[k] + 0.003, ("%s %d: %.4f +- %.4f, not %.4f"):format(what, k, got[k], errors[k], value))
  end
end

test("Ishigami's function: first and total indices by Saltelli's points", function()
  local found = indices.of(rows_of(ishigami, 2048, 3), 3)
  are_near("first", found.first, ishigami_first, 0.02)
  are_near("total", found.total, ishigami_total, 0.02)
  within_errors("first", found.first, found.first_error, ishigami_first)
  within_errors("total", found.total, found.total_error, ishigami_total)
  local few = indices.of(rows_of(ishigami, 64, 3), 3)
  within_errors("few", few.first, few.first_error, ishigami_first)
  assert(few.first_error[1] > 2 * found.first_error[1])
end)

test("Sobol's g: first and total indices", function()
  local first, total = g_indices()
  local found = indices.of(rows_of(g, 2048, 4), 4)
  are_near("first", found.first, first, 0.02)
  are_near("total", found.total, total, 0.02)
end)

--- Ishigami's function at other points is off by about what a polynomial says.
local function is_off_as_told(found)
  local off, other = 0, points_of(600, 3)
  for i = 401, 600 do
    off = off + (found.at(other[i]) - ishigami(other[i])) ^ 2 / 200
  end
  local error = math.sqrt(off / V)
  assert(error < 2 * found.error and error > found.error / 4, ("%.3g told, %.3g found"):format(found.error, error))
end

test("a polynomial of few points has Ishigami's indices, and says how far it is off", function()
  local points = points_of(256, 3)
  local values = numeric.map(points, ishigami)
  local found = chaos.of(points, values, { "uniform", "uniform", "uniform" })
  are_near("first", found.first, ishigami_first, 0.01)
  are_near("total", found.total, ishigami_total, 0.01)
  assert(math.abs(found.mean - 3.5) < 0.02 and math.abs(found.deviation / math.sqrt(V) - 1) < 0.01)
  assert(found.error < 0.05)
  is_off_as_told(found)
  local few = chaos.of(table.move(points, 1, 32, 1, {}), table.move(values, 1, 32, 1, {}), { "uniform", "uniform", "uniform" })
  assert(few.error > 0.3, "32 points do not do: " .. few.error)
end)

test("a polynomial of normal parameters is exact where the result is one", function()
  local points = numeric.map(points_of(40, 2), function(u) return { engine.quantile(u[1]), engine.quantile(u[2]) } end)
  local values = numeric.map(points, function(x) return 1 + 2 * x[1] + 0.5 * (x[2] ^ 2 - 1) + 0.3 * x[1] * x[2] end)
  local found = chaos.of(points, values, { "normal", "normal" })
  assert(math.abs(found.mean - 1) < 1e-9 and math.abs(found.deviation ^ 2 - (4 + 0.5 + 0.09)) < 1e-9)
  are_near("first", found.first, { 4 / 4.59, 0.5 / 4.59 }, 1e-9)
  are_near("total", found.total, { 4.09 / 4.59, 0.59 / 4.59 }, 1e-9)
  assert(found.error < 1e-9)
end)

local function slopes_at(f, points, size)
  return numeric.map(points, function(point)
    local list = {}
    for k = 1, size do
      local above, below = table.move(point, 1, size, 1, {}), table.move(point, 1, size, 1, {})
      above[k], below[k] = point[k] + 1e-5, point[k] - 1e-5
      list[k] = (f(above) - f(below)) / 2e-5
    end
    return list
  end)
end

test("with slopes fewer points do, and what is told of a point left out still is so", function()
  local kinds, points = { "uniform", "uniform", "uniform" }, points_of(64, 3)
  local values = numeric.map(points, ishigami)
  local plain, found = chaos.of(points, values, kinds), chaos.of(points, values, kinds, slopes_at(ishigami, points, 3))
  assert(found.error < 0.1 and found.error < plain.error / 4, ("%.3g with slopes, %.3g without"):format(found.error, plain.error))
  are_near("first", found.first, ishigami_first, 0.02)
  are_near("total", found.total, ishigami_total, 0.02)
  is_off_as_told(found)
  local normal = numeric.map(points_of(8, 2), function(u) return { engine.quantile(u[1]), engine.quantile(u[2]) } end)
  local function f(x) return 1 + 2 * x[1] + 0.5 * (x[2] ^ 2 - 1) + 0.3 * x[1] * x[2] end
  local exact = chaos.of(normal, numeric.map(normal, f), { "normal", "normal" }, slopes_at(f, normal, 2))
  assert(exact.error < 1e-8 and math.abs(exact.mean - 1) < 1e-8 and math.abs(exact.deviation ^ 2 - 4.59) < 1e-7)
end)

test("moments and quantiles of normal numbers lie within their errors", function()
  local inside, repeats, count = { 0, 0, 0 }, 100, 200
  local state = 7
  local function normal()
    state = state * 48271 % 2147483647
    return engine.quantile(state / 2147483647)
  end
  for _ = 1, repeats do
    local values = {}
    for i = 1, count do
      values[i] = 3 + 2 * normal()
    end
    local m, q = spread.moments(values), spread.quantiles(values)
    inside[1] = inside[1] + (math.abs(m.mean - 3) < 1.96 * m.mean_error and 1 or 0)
    inside[2] = inside[2] + (math.abs(m.deviation - 2) < 1.96 * m.deviation_error and 1 or 0)
    local truth = 3 + 2 * engine.quantile(0.95)
    inside[3] = inside[3] + (q[5].low < truth and truth < q[5].high and 1 or 0)
  end
  for k = 1, 3 do
    assert(inside[k] >= 88 and inside[k] <= 100, ("%d: %d of 100"):format(k, inside[k]))
  end
end)

test("intervals of quantiles are those of order statistics, whatever the number of points", function()
  -- the binomial distribution's own quantiles at 2.5 % and 97.5 %
  for _, known in ipairs { { 100, 0.95, 90, 99 }, { 247, 0.95, 228, 241 }, { 1000, 0.05, 37, 64 }, { 1000, 0.95, 936, 963 },
    { 100000, 0.5, 49690, 50310 }, { 100000, 0.95, 94864, 95135 } } do
    local sorted = {}
    for i = 1, known[1] do
      sorted[i] = i
    end
    local value, low, high = spread.quantile(sorted, known[2])
    assert(low < value and value < high)
    equal(low, known[3])
    equal(high, known[4] + 1)
  end
end)

test("quantiles are drawn where they are, with their intervals beside them", function()
  local values = {}
  for i = 1, 300 do
    values[i] = i ^ 3
  end
  local result = { name = "q", meaning = "", unit = "1", values = values, moments = spread.moments(values),
    quantiles = spread.quantiles(values) }
  local drawn = pictures.of({ axes = {} }, { results = { result }, values = numeric.map(values, function() return {} end) })[1]
  local dots = drawn.curves[#drawn.curves]
  equal(#drawn.curves, 7)
  for i, q in ipairs(result.quantiles) do
    equal(dots.x[i], q.value)
    equal(dots.y[i], q.level)
    equal(drawn.curves[i + 1].x[1], q.low)
    equal(drawn.curves[i + 1].x[2], q.high)
  end
end)

test("points of a list that name different parameters are drawn with what their cases have", function()
  local values = { { a = 1 }, { b = 5, a = 2 }, { b = 7 } }
  local rows = { { case = { p = { a = 1, b = 3 } } }, { case = { p = { a = 2, b = 5 } } }, { case = { p = { a = 9, b = 7 } } } }
  local result = { name = "q", meaning = "", unit = "1", values = { 10, 20, 30 } }
  result.moments, result.quantiles = spread.moments(result.values), spread.quantiles(result.values)
  local drawn = pictures.of({ list = values, axes = {} }, { results = { result }, values = values, names = { "a", "b" }, rows = rows })
  local a, b = drawn[2].figures[1].curves[1], drawn[2].figures[2].curves[1]
  equal(table.concat(a.x, " ") .. "; " .. table.concat(b.x, " "), "1.0 2.0 9.0; 3.0 5.0 7.0")
end)

test("what is wrong with a number of points is told, and where it stands", function()
  local study = { name = "s", sample = { of = { a = { uniform = { 0, 1 } } } } }
  fails("--count 2.7; a whole number of points, 2 or more, is wanted", spec.read, study, { count = 2.7 })
  fails("--count 1; a whole number of points", spec.read, study, { count = 1.0 })
  fails("--count 200000; it is 2 to 100000", spec.read, study, { count = 200000.0 })
  study.sample.count = 3.5
  fails("study.sample: count = 3.5; a whole number", spec.read, study, {})
end)

test("failures along one axis are told with their side", function()
  local failed = {}
  for _, u in ipairs(points_of(64, 2)) do
    failed[#failed + 1] = u[1] < 0.2 and u or nil
  end
  local where = spread.where(failed)
  equal(#where, 1)
  equal(where[1].axis, 1)
  equal(where[1].side, "small")
  assert(where[1].to < 0.2)
  equal(#spread.where(points_of(64, 2)), 0)
end)

test("what does not vary, or by rounding alone, has no shares", function()
  local points = points_of(64, 2)
  for _, f in ipairs { function() return 3 end, function(i) return 0.1 * (1 + 1e-16 * (i % 3)) * 3 end, function() return 0 end } do
    local values = {}
    for i in ipairs(points) do
      values[i] = f(i)
    end
    local own = chaos.of(points, values, { "uniform", "uniform" })
    assert(own and not own.first and not own.total)
    equal(own.error, 0)
  end
  local small = chaos.of(points, numeric.map(points, function(u) return 1 + 1e-9 * u[1] end), { "uniform", "uniform" })
  assert(small.first[1] > 0.999, small.first[1])
end)

test("pairs of few points tell what their indices are off by", function()
  local exact, count = { { 0.3139, 0.4424, 0 }, { 0.5576, 0.4424, 0.2437 } }, 12
  local squares = { { 0, 0, 0 }, { 0, 0, 0 } }
  for seed = 1, count do
    local points, rows = spec.coordinates { design = "saltelli", axes = { 1, 2, 3 }, count = 64, seed = seed }, {}
    local values = numeric.map(points, function(u)
      local x = numeric.map(u, function(part) return (2 * part - 1) * math.pi end)
      return math.sin(x[1]) + 7 * math.sin(x[2]) ^ 2 + 0.1 * x[3] ^ 4 * math.sin(x[1]) -- Ishigami's
    end)
    for i = 1, #values, 5 do
      rows[#rows + 1] = { values[i], values[i + 1], { values[i + 2], values[i + 3], values[i + 4] } }
    end
    local found = indices.of(rows, 3)
    for k = 1, 3 do
      squares[1][k] = squares[1][k] + ((found.first[k] - exact[1][k]) / found.first_error[k]) ^ 2
      squares[2][k] = squares[2][k] + ((found.total[k] - exact[2][k]) / found.total_error[k]) ^ 2
    end
  end
  for i = 1, 2 do
    for k = 1, 3 do
      local over = math.sqrt(squares[i][k] / count)
      assert(over < 1.6, ("%d, %d: %g times what is told"):format(i, k, over))
    end
  end
end)

test("scrambled points stay as even along each axis, and more of them keep the first", function()
  local few, many = sample.scrambled_points(4, 32, 7), sample.scrambled_points(4, 64, 7)
  for k = 1, 4 do
    local taken = {}
    for i, point in ipairs(many) do
      taken[math.floor(64 * point[k])] = true
      assert(i > 32 or point[k] == few[i][k])
    end
    for stratum = 0, 63 do
      assert(taken[stratum], ("axis %d, stratum %d"):format(k, stratum))
    end
  end
end)
