-- Fits whose points count more or less than their errors say: chi square, errors and intervals are those of the data all the same.
local test, equal = ...
local engine = require "stiction.engine"
local numeric = require "stiction.numeric"
local plain = require "stiction.fit.plain"

local x, weights = {}, {}
for i = 1, 30 do
  x[i], weights[i] = 0.2 * i, i <= 15 and 9 or 0.5
end

--- Normal random numbers, the same in every run (Lehmer's generator).
local function dice(seed)
  local state = seed
  for _ = 1, 10 do
    state = state * 48271 % 2147483647
  end
  return function()
    state = state * 48271 % 2147483647
    return engine.quantile(state / 2147483647)
  end
end

local function rising(values, at)
  return values[1] * (1 - math.exp(-at / values[2]))
end

local function fitted(seed, t)
  local random = dice(seed)
  t.parameters = { { name = "a", from = 0.1, to = 10, log = true, start = 1 }, { name = "l", from = 0.1, to = 10, log = true, start = 1 } }
  t.x, t.f, t.enough, t.share = x, rising, 1e-4, 1e-4
  t.y = numeric.map(x, function(at) return rising({ 2, 1.5 }, at) + 0.1 * random() end)
  local found, judged, profiles = plain.fit(t, 1, true)
  return judged, profiles, found
end

test("weights of all points alike change nothing", function()
  local alike = numeric.map(x, function() return 4 end)
  for _, sigma in ipairs { 0.1, false } do
    local one, its = fitted(3, { sigma = sigma or nil })
    local other, of_other = fitted(3, { sigma = sigma or nil, weights = alike })
    assert(math.abs(other.squares / one.squares - 1) < 1e-6 and other.rejected == one.rejected)
    equal(other.chance ~= nil, sigma ~= false)
    for k = 1, 2 do
      assert(math.abs(other.errors[k] / one.errors[k] - 1) < 1e-4, ("%g, %g"):format(other.errors[k], one.errors[k]))
      assert(math.abs(other.alone[k] / one.alone[k] - 1) < 1e-4)
      for _, finish in ipairs { "low", "high" } do
        assert(math.abs(of_other[k][finish] - its[k][finish]) < 0.01 * one.errors[k])
      end
    end
  end
end)

test("of unlike weights intervals cover, errors are those that repeats show, and a right model is not rejected", function()
  local repeats, covered, rejected, sums, told = 300, { 0, 0 }, 0, { 0, 0 }, { 0, 0 }
  for i = 1, repeats do
    local judged, profiles = fitted(100 + i, { sigma = 0.1, weights = weights })
    rejected = rejected + (judged.chance < 0.01 and 1 or 0)
    for k, truth in ipairs { 2, 1.5 } do
      covered[k] = covered[k] + (profiles[k].low < truth and truth < profiles[k].high and 1 or 0)
      sums[k], told[k] = sums[k] + (math.log(judged.values[k] / truth)) ^ 2 / repeats, told[k] + judged.relative[k] ^ 2 / repeats
    end
  end
  assert(rejected <= 12, rejected .. " rejected")
  for k = 1, 2 do
    assert(covered[k] >= 0.91 * repeats and covered[k] <= 0.99 * repeats, ("%d: %d of %d"):format(k, covered[k], repeats))
    assert(math.abs(math.sqrt(told[k] / sums[k]) - 1) < 0.15, ("%d: %g told, %g found"):format(k, math.sqrt(told[k]), math.sqrt(sums[k])))
  end
end)

test("a wrong model is rejected whatever the weights, and directions that nothing determines stay so", function()
  local low = numeric.map(x, function() return 0.01 end)
  local function fit_line(t)
    t.parameters = { { name = "a", from = -10, to = 10, start = 1 }, { name = "b", from = -10, to = 10, start = 1 } }
    t.x, t.sigma, t.y = x, 0.02, numeric.map(x, function(at) return 2 * math.sqrt(at) + 0.01 * math.sin(57 * at) end)
    return select(2, plain.fit(t))
  end
  assert(fit_line({ weights = low, f = function(values, at) return values[1] + values[2] * at end }).chance < 1e-3)
  local judged = fit_line { weights = weights, f = function(values, at) return (values[1] + values[2]) * math.sqrt(at) end }
  equal(judged.fates[1], "only in combination")
  equal(#judged.combinations, 1)
end)
