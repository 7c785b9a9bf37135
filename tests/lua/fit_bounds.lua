-- What a fit says of parameters that end at a bound: intervals on the free side, by profiles, that cover.
local test, equal = ...
local engine = require "stiction.engine"
local finer = require "stiction.fit.finer"
local judge = require "stiction.fit.judge"
local numeric = require "stiction.numeric"
local plain = require "stiction.fit.plain"
local u = require("stiction").units
local verdict = require "stiction.fit.verdict"

local x = {}
for i = 1, 30 do
  x[i] = 0.2 * i
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

local function line(values, at) return values[1] + values[2] * at end

local function measured(f, values, sigma, random)
  return numeric.map(x, function(at) return f(values, at) + sigma * random() end)
end

local function fitted(f, own, y, sigma)
  local found, judged, profiles, problem = plain.fit({ parameters = own, x = x, y = y, sigma = sigma, f = f, enough = 1e-8 }, 1, true)
  return judged, profiles, found, problem
end

--- The least squares over the first parameter of a straight line whose slope is given.
local function least(y, slope, sigma)
  local mean, sum = numeric.mean(numeric.map(x, function(at) return at * slope end)), 0
  mean = numeric.mean(y) - mean
  for i, at in ipairs(x) do
    sum = sum + ((y[i] - mean - slope * at) / sigma) ^ 2
  end
  return sum
end

test("at the end of the free side the squares have risen by what they should", function()
  for _, case in ipairs { { 0, 1, -0.02, "low" }, { -1, 0, 0.02, "high" }, { 0, 1, -0.2, "low" }, { -1, 0, 0.5, "high" } } do
    local own = { { name = "a", from = -5, to = 5, start = 1 },
      { name = "b", from = case[1], to = case[2], start = (case[1] + case[2]) / 2 } }
    local y = measured(line, { 1, case[3] }, 0.3, dice(5))
    local judged, profiles = fitted(line, own, y, 0.3)
    equal(judged.values[2], 0)
    equal(judged.errors[2], nil)
    equal(profiles[2].bound, case[4])
    local finish = profiles[2].low or profiles[2].high
    equal(profiles[2][case[4]], nil)
    local rise = math.sqrt(least(y, finish, 0.3) - least(y, 0, 0.3))
    assert(math.abs(rise / judged.t - 1) < 0.01, ("%g: %.4f, not %.4f"):format(case[3], rise, judged.t))
  end
end)

test("of a logarithmic parameter, and beside others that bend", function()
  local function rising(values, at) return values[1] * (1 - math.exp(-at / values[2])) end
  local own = { { name = "a", from = 0.1, to = 1.95, log = true, start = 1 }, { name = "l", from = 0.1, to = 10, log = true, start = 1 } }
  local y = measured(rising, { 2, 1.5 }, 0.1, dice(8))
  local judged, profiles, found = fitted(rising, own, y, 0.1)
  assert(math.abs(judged.values[1] - 1.95) < 1e-12)
  local low = profiles[1].low
  assert(profiles[1].bound == "high" and low < 1.95 and not profiles[1].high)
  local held = { { name = "l", from = 0.1, to = 10, log = true, start = 1 } }
  local there = fitted(function(values, at) return rising({ low, values[1] }, at) end, held, y, 0.1)
  assert(math.abs(math.sqrt(there.squares - found.at.cost) / judged.t - 1) < 0.03)
end)

test("intervals of a slope near its bound cover the truth, whether it ends at the bound or not", function()
  local covered, at_bound, repeats = 0, 0, 400
  for i = 1, repeats do
    local y = measured(line, { 1, 0.02 }, 0.3, dice(200 + i))
    local own = { { name = "a", from = -5, to = 5, start = 1 }, { name = "b", from = 0, to = 1, start = 0.5 } }
    local judged, profiles = fitted(line, own, y, 0.3)
    at_bound = at_bound + (judged.errors[2] and 0 or 1)
    covered = covered + ((profiles[2].low or 0) <= 0.02 and 0.02 <= profiles[2].high and 1 or 0)
  end
  assert(at_bound > 0.2 * repeats and at_bound < 0.5 * repeats, at_bound)
  assert(covered >= 0.93 * repeats, covered)
end)

test("what is said of it: the end on the free side; none without profiles; all at bounds", function()
  local y = measured(line, { 1, -0.02 }, 0.3, dice(5))
  local own = { { name = "a", from = -5, to = 5, start = 1, like = 1 }, { name = "b", from = 0, to = 1, start = 0.5, like = u.mm } }
  local judged, profiles, found = fitted(line, own, y, 0.3)
  local fit, unknown = { parameters = own, curves = {}, known = true }, { variants = {}, reason = "none" }
  local function said(intervals)
    return table.concat(verdict.lines(fit, judged, unknown, found, intervals), "\n")
  end
  local words = ("b is at its bound 0 mm: the data would have it beyond; on the other side its interval (95 %%) ends at %s"):format(
    verdict.words(own[2], profiles[2].high))
  assert(said(profiles):find(words, 1, true), said(profiles))
  assert(said():find("the data would have it beyond, and no error is told", 1, true), said())
  local interval = verdict.interval(fit, judged, profiles, { known = true, relative = { 0, 0.5 }, variants = {} }, 2)
  assert(interval.bound == "low" and not interval.low and math.abs(interval.high - profiles[2].high - 0.05) < 1e-12)
  local rough = { known = true, relative = { 0, 12 }, variants = {} }
  local lines = table.concat(verdict.lines(fit, judged, rough, found, profiles), "\n")
  assert(lines:find("is open by the simulation's own error, by the data it ends at", 1, true), lines)
  local tight = { { name = "a", from = 2, to = 5, start = 3 }, { name = "b", from = 0.1, to = 1, start = 0.5 } }
  judged, profiles = fitted(line, tight, y, 0.3)
  equal(#judged.free, 0)
  assert(profiles[1].high > 2 and profiles[2].high > 0.1 and not profiles[1].low)
end)

test("one of which the data tell nothing is not said to be wanted beyond its bound", function()
  local own = { { name = "a", from = -5, to = 5, start = 1, like = 1 }, { name = "b", from = 0, to = 1, start = 0, like = 1 } }
  local function flat(values, at) return values[1] + at + 1e-9 * values[2] end
  local judged, profiles, found = fitted(flat, own, measured(flat, { 0.999, -1 }, 0.3, dice(5)), 0.3)
  local fit, rough = { parameters = own, curves = {}, known = true }, { variants = {}, reason = "none" }
  local text = table.concat(verdict.lines(fit, judged, rough, found, profiles), "\n")
  assert(judged.errors[2] or text:find("b is at its bound 0, and NOT DETERMINED by these data", 1, true), text)
  judged.errors[2] = nil
  text = verdict.lines(fit, judged, rough, found, { [2] = { bound = "low", points = {} } })
  assert(table.concat(text, "\n"):find("b is at its bound 0, and NOT DETERMINED by these data", 1, true))
end)

test("where the simulation's own error leads beyond the bounds an interval is open", function()
  local fit = { parameters = { { name = "a", from = 0.2, to = 5, log = true, like = 1 } }, known = true }
  local judged = { values = { 1 }, errors = { 0.05 }, relative = { 0.05 }, sizes = { 1 }, t = 1.96 }
  local interval = verdict.interval(fit, judged, nil, { known = true, relative = { 1.7 }, variants = {} }, 1)
  assert(interval.statistical.low and interval.statistical.high and not interval.low and not interval.high)
end)

test("where model and data do not agree the end is where the squares have risen by as much more", function()
  local own = { { name = "a", from = -5, to = 5, start = 1 }, { name = "b", from = 0, to = 10, start = 0.5 } }
  for _, slope in ipairs { -0.015, -0.1, -0.4 } do
    local y = measured(line, { 1, slope }, 0.3, dice(5))
    local judged, profiles, found, problem = fitted(line, own, y, 0.1)
    equal(judged.errors[2], nil)
    judged.misfit = true
    judge.stretch(problem, judged, profiles)
    local rise = math.sqrt(least(y, profiles[2].high, 0.1) - found.at.cost)
    assert(judged.stretch > 2 and math.abs(rise / judged.stretch / judged.t - 1) < 0.02, ("%.4f, not %.4f"):format(rise / judged.stretch,
      judged.t))
  end
end)

test("the simulation's own error is told of it, too, as it moves with the others", function()
  local J, found = { {}, {} }, { z = { 0.5, 0 }, at = { r = {}, slopes = {} } }
  for i, at in ipairs(x) do
    J[1][i], J[2][i], found.at.r[i], found.at.slopes[i] = 10, at, 0, 1
  end
  found.J = J
  local model = { fit = { parameters = { { name = "a", from = -5, to = 5, start = 1 }, { name = "b", from = 0, to = 1, start = 0.5 } } } }
  function model.evaluate()
    return { { r = numeric.map(x, function(at) return 2 + 0.1 * at end) } } -- by a slope of 0.1, and a height of 2
  end
  local judged = { free = { 1 }, slopes = { 1, 1 } }
  local own = finer.shifts(model, found, judged, { { settings = {}, factor = 3, words = "finer" } })
  assert(math.abs(own.relative[2] - 0.3) < 1e-9, own.relative[2])
  local alone = 3 * (2 + 0.1 * numeric.mean(x)) / 10
  assert(math.abs(own.relative[1] - alone) < 1e-9, own.relative[1])
end)

test("a curve that a finer level leaves exactly as it is, though it moves results, tells nothing of the simulation's own error", function()
  local J, found = { {} }, { z = { 0.5 }, at = { r = {}, slopes = {}, curves = { {}, {} }, results = { { force = 1 } } } }
  for i = 1, 8 do
    J[1][i], found.at.r[i], found.at.slopes[i] = 10, 0, 1
    found.at.curves[i < 5 and 1 or 2][(i - 1) % 4 + 1] = i
  end
  found.J = J
  local fit = { parameters = { { name = "a", from = -5, to = 5, start = 1 } }, curves = { { name = "time" }, { name = "pull" } } }
  --- What is told where a finer level moves the result to this and the second curve by so much.
  local function told(force, by, factor)
    local answer = { r = {}, curves = { found.at.curves[1], numeric.map(found.at.curves[2], function(y) return y + by end) },
      results = { { force = force } } }
    for i = 1, 8 do
      answer.r[i] = i < 5 and 0 or by
    end
    local model = { fit = fit, evaluate = function() return { answer } end }
    return finer.shifts(model, found, { free = { 1 }, slopes = { 1 } }, { { settings = {}, factor = factor or 3, words = "steps = 20" } })
  end
  local none = told(1.1, 0)
  assert(not none.known and none.reason:find("steps = 20 moves other results and leaves time, pull exactly as they are", 1, true))
  local one = told(1, 0.1)
  assert(one.known and one.relative[1] > 0 and one.variants[1].doubt:find("leaves time exactly as it is", 1, true))
  for _, own in ipairs { told(1, 0), told(1 + 1e-9, 0), told(1.1, 0, 1) } do -- no effect at all, but the solver's; another choice
    assert(own.known and own.relative[1] == 0 and not own.variants[1].doubt)
  end
end)
