-- Noise that is correlated along a curve: residuals made independent, intervals that cover, lengths that are found or asked for.
local test, equal = ...
local correlated = require "stiction.fit.correlated"
local correlation = require "stiction.fit.correlation"
local curve = require "stiction.fit.curve"
local noise_module = require "stiction.fit.noise"
local numeric = require "stiction.numeric"
local plain = require "stiction.fit.plain"

--- Normal random numbers, the same in every run (Lehmer's generator; Box and Muller).
local function dice(seed)
  local state = seed
  local function uniform()
    state = state * 48271 % 2147483647
    return state / 2147483647
  end
  for _ = 1, 10 do
    uniform()
  end
  return function() return math.sqrt(-2 * math.log(uniform())) * math.cos(2 * math.pi * uniform()) end, uniform
end

--- Noise of variance 1, each value from the one before it; not by the library's.
local function noise(xs, length, random)
  local list = { random() }
  for i = 2, #xs do
    local share = math.exp(-(xs[i] - xs[i - 1]) / length)
    list[i] = share * list[i - 1] + math.sqrt(1 - share ^ 2) * random()
  end
  return list
end

local function spaced(count, step)
  local list = {}
  for i = 1, count do
    list[i] = step * i
  end
  return list
end

local function irregular(count, seed)
  local _, uniform = dice(seed)
  local list, x = {}, 0
  for i = 1, count do
    x = x + 0.02 + 0.2 * uniform()
    list[i] = x
  end
  return list
end

local function rising(values, x) -- to values[1], in a length values[2]
  return values[1] * (1 - math.exp(-x / values[2]))
end

local truth = { 2, 1.5 }
local parameters = { { name = "a", from = 0.1, to = 10, log = true, start = 1 },
  { name = "l", from = 0.1, to = 10, log = true, start = 1 } }
local x = spaced(60, 0.1)

--- A fit of data with such noise, of the deviation 0.1.
local function noisy(seed, length, t, profiled)
  local random = dice(seed)
  local own = length and noise(x, length, random) or numeric.map(x, function() return random() end)
  t.y = {}
  for i, at in ipairs(x) do
    t.y[i] = rising(truth, at) + 0.1 * own[i]
  end
  t.parameters, t.x, t.f, t.share, t.enough = parameters, x, rising, 1e-4, 1e-4
  return plain.fit(t, 1, profiled)
end

--- Cholesky's factor of a matrix, a list of rows.
local function cholesky(A)
  local L = {}
  for i = 1, #A do
    L[i] = {}
    for j = 1, i do
      local sum = A[i][j]
      for k = 1, j - 1 do
        sum = sum - L[i][k] * L[j][k]
      end
      L[i][j] = i == j and math.sqrt(sum) or sum / L[j][j]
    end
  end
  return L
end

local function forward(L, b)
  local own = {}
  for i = 1, #b do
    local sum = b[i]
    for k = 1, i - 1 do
      sum = sum - L[i][k] * own[k]
    end
    own[i] = sum / L[i][i]
  end
  return own
end

--- Of noise that goes on along xs and makes such shares of the standard errors, all where there are none.
local function covariances(xs, length, shares)
  local C = {}
  for i, a in ipairs(xs) do
    C[i] = {}
    for k, b in ipairs(xs) do
      local share = shares and shares[i] * shares[k] or 1
      C[i][k] = i == k and 1 or share * math.exp(-math.abs(a - b) / length)
    end
  end
  return C
end

test("whitened residuals are those of Cholesky's factor of the whole covariance", function()
  local xs, random, uniform = irregular(50, 3), dice(4)
  for _, length in ipairs { 0.05, 0.3, 2 } do
    local r = numeric.map(xs, function() return random() end)
    for _, shares in ipairs { false, numeric.map(xs, function() return 0.2 + 0.7 * uniform() end) } do
      local C = covariances(xs, length, shares)
      local L = cholesky(C)
      local exact, determinant, trace = forward(L, r), 0, 0
      for i, row in ipairs(L) do
        determinant = determinant + 2 * math.log(row[i])
        local column = forward(L, numeric.map(xs, function(at) return at == xs[i] and 1 or 0 end))
        for _, value in ipairs(column) do
          trace = trace + value ^ 2
        end
      end
      local course = noise_module.along(xs, length, shares or nil)
      assert(math.abs(course:log_determinant() - determinant) < 1e-9 * math.abs(determinant))
      for _, own in ipairs { course, noise_module.of_correlations(C) } do
        local white = own:whitened(r)
        local back = own:coloured(white)
        for i = 1, #xs do
          assert(math.abs(white[i] - exact[i]) < 1e-12 * math.max(1, math.abs(exact[i])), ("%d: %g"):format(i, white[i] - exact[i]))
          assert(math.abs(back[i] - r[i]) < 1e-12)
        end
        assert(math.abs(noise_module.roughened(own, #xs) / math.sqrt(trace / #xs) - 1) < 1e-9)
      end
    end
  end
end)

test("a table of correlations that no noise can have is told by its least eigenvalue", function()
  local none, least = noise_module.of_correlations { { 1, 0.9, -0.9 }, { 0.9, 1, 0.9 }, { -0.9, 0.9, 1 } }
  assert(none == nil and math.abs(least + 0.8) < 1e-12, least) -- of the vector (1, -1, 1)
  for _, near in ipairs { 1, 1 - 1e-15 } do -- known from one another, wholly or but for rounding
    none, least = noise_module.of_correlations { { 1, near }, { near, 1 } }
    assert(none == nil and math.abs(least) < 1e-12)
  end
end)

test("points count as many independent ones as tell a constant as well", function()
  local xs = irregular(20, 5)
  local ones = numeric.map(xs, function() return 1 end)
  local own = forward(cholesky(covariances(xs, 0.4)), ones)
  local sum = 0
  for _, value in ipairs(own) do
    sum = sum + value * value
  end
  assert(math.abs(noise_module.effective(noise_module.along(xs, 0.4), 20) - sum) < 1e-10, sum)
  assert(math.abs(noise_module.effective(noise_module.along(xs, 1e-4), 20) - 20) < 1e-10)
end)

--- How many of so many fits' intervals hold each parameter, and how many reject the model. draw(random): noise of the deviation 1.
local function coverage(repeats, draw, t)
  local held, rejected = { 0, 0 }, 0
  for i = 1, repeats do
    local list, own = draw(dice(900 + i)), { sigma = 0.1, parameters = parameters, x = x, f = rising, share = 1e-4, enough = 1e-4 }
    for key, value in pairs(t) do
      own[key] = value
    end
    own.y = numeric.map(x, function(at) return rising(truth, at) end)
    for n in ipairs(x) do
      own.y[n] = own.y[n] + 0.1 * list[n]
    end
    local _, judged = plain.fit(own, 1)
    rejected = rejected + (judged.rejected and 1 or 0)
    for k = 1, 2 do
      held[k] = held[k] + (math.abs(math.log(judged.values[k] / truth[k])) <= judged.t * judged.relative[k] and 1 or 0)
    end
  end
  return held, rejected
end

test("intervals cover where each point has noise for itself beside what goes on, or a scale has an error of its own", function()
  local repeats, share = 200, 0.8
  local shares = numeric.map(x, function() return share end)
  local function both(random)
    local slow = noise(x, 0.5, random)
    return numeric.map(slow, function(value) return share * value + math.sqrt(1 - share ^ 2) * random() end)
  end
  local R = covariances(x, 0.5, shares)
  for way, t in pairs { filter = { correlation = 0.5, shares = shares }, whole = { common = noise_module.of_correlations(R) } } do
    local held, rejected = coverage(repeats, both, t)
    for k = 1, 2 do
      assert(held[k] >= 180 and held[k] <= 198, ("%s: %d of %d"):format(way, held[k], repeats))
    end
    assert(rejected <= 6, ("%s: %d rejected"):format(way, rejected))
  end
  local few = 50
  local _, rejected = coverage(few, both, { correlation = 0.5 }) -- as if all of it went on: residuals jump too much
  assert(rejected > 0.9 * few, rejected)

  local gain = 0.7 -- of all values alike, as of a load cell whose scale is not known better
  local weights = numeric.map(x, function(at) return gain * rising(truth, at) / truth[1] end)
  local function scaled(random)
    local own = random()
    return numeric.map(weights, function(weight) return math.sqrt(1 - gain ^ 2) * random() + weight * own end)
  end
  local C = {}
  for i, a in ipairs(weights) do
    C[i] = numeric.map(weights, function(b) return a * b end)
    C[i][i] = C[i][i] + 1 - gain ^ 2
  end
  local sigma = {}
  for i, row in ipairs(C) do
    sigma[i] = math.sqrt(row[i])
  end
  for i, row in ipairs(C) do
    for k in ipairs(row) do
      row[k] = row[k] / (sigma[i] * sigma[k])
    end
  end
  local held = coverage(repeats, scaled, { common = noise_module.of_correlations(C), sigmas = numeric.map(sigma, function(s)
    return 0.1 * s end) })
  local alone = coverage(few, scaled, { sigma = 0.1 })
  for k = 1, 2 do
    assert(held[k] >= 180 and held[k] <= 198, ("scale: %d of %d"):format(held[k], repeats))
  end
  assert(alone[1] < 0.75 * few, alone[1])
end)

test("intervals cover with the correlation declared or estimated, and far less without", function()
  local repeats, length = 200, 0.3
  local covered = { declared = { 0, 0 }, estimated = { 0, 0 }, none = { 0, 0 } }
  local ways = { declared = length, estimated = "estimated", none = false }
  for i = 1, repeats do
    for way, told in pairs(ways) do
      local _, judged, profiles = noisy(100 + i, length, { sigma = 0.1, correlation = told or nil }, way ~= "estimated")
      for k = 1, 2 do
        local half = judged.t * judged.relative[k]
        local own = profiles and profiles[k] or { low = judged.values[k] * math.exp(-half), high = judged.values[k] * math.exp(half) }
        local holds = (not own.low or own.low < truth[k]) and (not own.high or truth[k] < own.high)
        covered[way][k] = covered[way][k] + (holds and 1 or 0)
      end
    end
  end
  for k = 1, 2 do
    local words = ("%d: declared %d, estimated %d, without %d"):format(k, covered.declared[k], covered.estimated[k], covered.none[k])
    assert(covered.declared[k] >= 0.9 * repeats and covered.declared[k] <= 0.99 * repeats, words)
    assert(covered.estimated[k] >= 0.88 * repeats and covered.estimated[k] <= 0.99 * repeats, words)
    assert(covered.none[k] <= 0.75 * repeats, words)
  end
end)

test("chi square, sizes and lengths are those of the noise", function()
  local repeats, each, logs, size = 50, 0, 0, 0
  for i = 1, repeats do
    local _, judged = noisy(400 + i, 0.3, { sigma = 0.1, correlation = 0.3 })
    each = each + judged.squares / judged.degrees / repeats
    equal(judged.rejected, false)
    local _, guessed, _, problem = noisy(400 + i, 0.3, { correlation = "estimated" })
    logs = logs + math.log(problem.curves[1].length / 0.3) / repeats
    size = size + math.log(guessed.factor / 0.01) / repeats
  end
  assert(math.abs(each - 1) < 0.06, "chi square " .. each)
  assert(math.abs(logs) < 0.25, "length " .. logs)
  assert(math.abs(size) < 0.25, "size " .. size)
end)

--- The lines on the noise of such a fit.
local function lines(judged, problem, name)
  local own = problem.curves[1]
  own.name, own.x_name, own.x_word = name, "time", "s"
  setmetatable(own, { __index = curve.methods })
  return table.concat(correlated.lines(problem.curves, judged, 1e-3), "\n")
end

test("a correlation that nobody declared is told with both readings and the remedy; independent noise is not", function()
  local told, wrong = 0, 0
  for i = 1, 50 do
    local _, judged, _, problem = noisy(700 + i, 0.3, { sigma = 0.1 })
    local words = lines(judged, problem, "trace")
    told = told + (words:find("either the model misses the curve's course, or the noise is so", 1, true) and 1 or 0)
    assert(words == "" or words:find 'say correlation = 0%.%d+%*s, if that is its length, or "estimated" in study%.fit%.data%.trace'
      or words:find 'say correlation = "estimated"', words)
    _, judged, _, problem = noisy(700 + i, nil, { sigma = 0.1 })
    wrong = wrong + (lines(judged, problem, "trace") == "" and 0 or 1)
  end
  assert(told >= 48 and wrong <= 1, ("%d, %d"):format(told, wrong))
  local _, judged, _, problem = noisy(701, 0.3, { sigma = 0.1, correlation = 0.3 })
  assert(lines(judged, problem, "trace"):find("correlated over 0.3 s: its 60 points are worth 10.7 independent ones", 1, true))
end)

test("a wrong model is not taken for noise that is correlated all along", function()
  local function line(values, at) return values[1] + (values[2] - 1) * at end
  local random, y = dice(5), {}
  for i, at in ipairs(x) do
    y[i] = 2 * at ^ 0.5 + 0.02 * random()
  end
  local _, judged, _, problem = plain.fit { parameters = parameters, x = x, y = y, f = line, correlation = "estimated" }
  assert(judged.rejected)
  assert(lines(judged, problem, "trace"):find "MODEL REJECTED: the residuals of trace are alike over half of the curve")
end)

test("the size of correlated noise comes from third differences as well", function()
  local xs, random = irregular(400, 9), dice(13)
  local own = noise(xs, 0.5, random)
  local y = {}
  for i, at in ipairs(xs) do
    y[i] = rising(truth, at) + 0.03 * own[i]
  end
  assert(math.abs(curve.noise(y, xs, 0.5) / 0.03 - 1) < 0.2, curve.noise(y, xs, 0.5))
  assert(curve.noise(y) < 0.02)
end)

test("two curves have a length each, and a third keeps its own", function()
  local own = { { first = 1, last = 60, x = x, estimated = true }, { first = 61, last = 120, x = irregular(60, 31), estimated = true },
    { first = 121, last = 160, x = irregular(40, 32), length = 0.2 } }
  local repeats, logs = 20, { 0, 0 }
  for i = 1, repeats do
    local r, J, random = {}, { {} }, dice(900 + i)
    for k, curve_of in ipairs(own) do
      local part = k < 3 and noise(curve_of.x, k == 1 and 0.3 or 0.15, random) or numeric.map(curve_of.x, function() return random() end)
      table.move(part, 1, #part, curve_of.first, r)
    end
    for n = 1, #r do
      J[1][n] = 1
    end
    local found = { at = { r = r }, J = J, free = { 1 } }
    local lengths, at_end = correlation.estimate({ loss = "squares", known = i % 2 == 0 }, found, own)
    logs[1], logs[2] = logs[1] + math.log(lengths[1] / 0.3) / repeats, logs[2] + math.log(lengths[2] / 0.15) / repeats
    equal(lengths[3], nil)
    assert(not at_end[1] or lengths[1] > 2.9)
  end
  assert(math.abs(logs[1]) < 0.2 and math.abs(logs[2]) < 0.2, ("%g, %g"):format(logs[1], logs[2]))
end)
