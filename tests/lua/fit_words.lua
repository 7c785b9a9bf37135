-- What a fit says of its parameters: combinations that are determined, as products of powers or as sums.
local test, equal = ...
local combination = require "stiction.fit.combination"
local judge = require "stiction.fit.judge"
local numeric = require "stiction.numeric"
local plain = require "stiction.fit.plain"
local u = require("stiction").units
local verdict = require "stiction.fit.verdict"

local x = {}
for i = 1, 30 do
  x[i] = 0.2 * i
end

--- y of f with a little that goes up and down, of 0.01.
local function measured(f, values)
  return numeric.map(x, function(at) return f(values, at) + 0.01 * math.sin(57 * at) end)
end

local function linear(name, from, to, start, like)
  return { name = name, from = from, to = to, start = start, like = like or 1 }
end

local function log(name, from, to, start)
  return { name = name, from = from, to = to, log = true, start = start, like = 1 }
end

--- What is said of the fit of f, and its judgement.
local function said(parameters, f, values)
  local found, judged = plain.fit { parameters = parameters, x = x, y = measured(f, values), sigma = 0.01, f = f }
  local lines = verdict.lines({ parameters = parameters, curves = {}, known = true }, judged, { variants = {}, reason = "none" }, found)
  return table.concat(lines, "\n"), judged
end

test("of linear parameters the sum that is determined is told, in their units", function()
  local function f(values, at) return (values[1] / 1e-6 - 2 * values[2] / 1e-3) * at end -- zero in um, load in mN
  local own = { linear("zero", -10e-6, 10e-6, 1e-6, 10 * u.um), linear("load", -5e-3, 5e-3, 1e-3, 5 * u.mN) }
  local text, judged = said(own, f, { 3e-6, 1e-3 })
  equal(judged.fates[1], "only in combination")
  local error = 0.01 / math.sqrt(30 * 31 * 61 / 6 * 0.04) -- of the slope, um
  assert(text:find(("zero and load; what these data tell is zero - 2 um/mN * load (near the best values) to %.2g um"):format(error), 1,
    true) or text:find(("load - 0.5 mN/um * zero (near the best values) to %.2g mN"):format(0.5 * error), 1, true), text)
  assert(not text:find("^", 1, true) and not text:find("powers", 1, true), text)
end)

test("a sum of like parameters has plain weights, one whose best value is 0 as well", function()
  local function f(values, at) return (values[1] + values[2]) * at end
  local own = { linear("a", -1, 1, 0.3), linear("b", -1, 1, -0.3) }
  local text = said(own, f, { 0, 0 })
  assert(text:find("a + b (near", 1, true) or text:find("b + a (near", 1, true), text)
end)

test("beside a logarithmic parameter a linear one that is above 0 is a power, another one a term beside a logarithm", function()
  local function f(values, at) return values[1] * values[2] * at end
  local text = said({ linear("mu", 0.02, 0.5, 0.08), log("young", 0.1, 10, 3) }, f, { 0.1, 1 })
  assert(text:find("mu * young (near", 1, true), text)
  local function g(values, at) return (math.log(values[1]) + 0.5 * values[2]) * at end
  text = said({ log("young", 0.1, 10, 3), linear("zero", -2, 2, 0.1) }, g, { 2, 0.3 })
  assert(text:find("ln(young) + 0.5 * zero (near", 1, true) or text:find("zero + 2 * ln(young) (near", 1, true), text)
end)

test("weights are in the units of the bounds, whichever these are", function()
  local judged = { values = { 0, 0, 0 }, sizes = { 1e-2, 1e-6, 1 } }
  local own = { linear("rate", -1, 1, 0, 0 * u.N / u.m), linear("zero", -1, 1, 0, 10 * u.um), log("young", 0.1, 10, 1) }
  equal(combination.words(own, { 1, -0.5, 0.25 }, judged), "rate - 0.005 (N/m)/um * zero + 0.0025 N/m * ln(young) (near the best values)")
  equal(combination.words(own, { 0, 1, 0.25 }, judged), "zero + 0.25 um * ln(young) (near the best values)")
  equal(combination.words(own, { 0, 0.25, 1 }, judged), "ln(young) + 0.25 1/um * zero (near the best values)")
end)

test("exponents of a linear parameter near 0 are of itself, not of a tenth of its range", function()
  local own = { linear("mu", 0.01, 10, 1), log("young", 0.1, 10, 3) }
  local judged = { values = { 0.1, 1 }, sizes = { 0.999, 1 } }
  equal(combination.words(own, { 0.999 / 0.1 / 10, 0.1 }, judged), "mu^0.1 * young^0.1 (near the best values)")
end)

test("where model and data do not agree errors, intervals and verdicts are widened alike", function()
  local function bent(values, at) return values[1] + values[2] * at + 0.15 * math.sin(6 * at) end
  local function line(values, at) return values[1] + values[2] * at end
  local function fitted(sigma, low)
    local own = { log("a", low, 10, 1), linear("b", -2, 2, 0.1) }
    local t = { parameters = own, x = x, y = measured(bent, { 0.1, 1 }), sigma = sigma, f = line, enough = 1e-10 }
    local found, judged, profiles, problem = plain.fit(t, 1, true)
    return judged, profiles, problem, found
  end
  local judged, profiles, problem, found = fitted(0.01, 0.01)
  judge.decide(judged, judge.by_profiles(problem.parameters, judged, profiles))
  equal(judged.fates[1], "determined")
  verdict.settle(judged, { known = false }, found)
  judge.stretch(problem, judged, profiles)
  judge.decide(judged, judge.by_profiles(problem.parameters, judged, profiles))
  assert(judged.rejected and judged.stretch > 8, judged.stretch)
  equal(judged.fates[1], "not determined")
  local guessed = fitted(nil, 0.01)
  for k = 1, 2 do
    assert(math.abs(judged.errors[k] / guessed.errors[k] - 1) < 1e-3, "those that the residuals show")
    assert(math.abs(judged.covariance[k][k] / guessed.covariance[k][k] - 1) < 1e-3)
  end
  local fit = { parameters = problem.parameters, known = true, curves = {} }
  local by_profile = verdict.interval(fit, judged, profiles, { known = false }, 2)
  local by_errors = verdict.interval(fit, judged, nil, { known = false }, 2)
  assert(math.abs(by_profile.low - by_errors.low) < 0.01 * judged.errors[2] and by_profile.stretch == judged.stretch)
  assert(math.abs(by_errors.high - judged.values[2] - judged.t * judged.errors[2]) < 1e-12)
  local text = table.concat(verdict.lines(fit, judged, { variants = {}, reason = "none" }, found, profiles), "\n")
  assert(text:find(("data %.3g times less sure"):format(judged.stretch), 1, true), text)
  judged = fitted(0.3, 0.01)
  judge.stretch(problem, judged)
  equal(judged.stretch, nil)
end)

test("a search that derivatives would have go on, while no step gains, says that it is stuck", function()
  local function saw(values, at) return (2 * (values[1] % 1e-3) - values[1]) * at end -- rises within each tooth, falls with the teeth
  local own = { linear("a", -4, 4, 1.0001) }
  local t = { parameters = own, x = x, y = measured(function(_, at) return 2 * at end, {}), sigma = 0.01, f = saw, share = 1e-6 }
  local function said_of(f)
    t.f = f
    local found, judged = plain.fit(t)
    local fit = { parameters = own, curves = {}, known = true }
    judged.runs = {}
    return table.concat(verdict.lines(fit, judged, { variants = {}, reason = "none" }, found), "\n"), found
  end
  local text = said_of(saw)
  assert(text:find("the search is STUCK: derivatives promise a gain of", 1, true), text)
  text = said_of(function(values, at) return values[1] * at end)
  assert(not text:find("STUCK", 1, true), text)
end)

test("where runs fail beside the best an interval is not followed, and that is not laid to the data", function()
  local own = { linear("a", -4, 4, 1.5), linear("b", -4, 4, 0.5) }
  local function edgy(values, at) return values[1] > 2.0001 and 0 / 0 or values[1] + values[2] * at end
  local t = { parameters = own, x = x, y = measured(function(_, at) return 2 + at end, {}), sigma = 0.01, f = edgy, enough = 1e-6 }
  local found, judged, profiles = plain.fit(t, 1, true)
  judge.decide(judged, judge.by_profiles(own, judged, profiles))
  equal(judged.fates[1], "not followed")
  judged.runs = {}
  local fit = { parameters = own, curves = {}, known = true }
  local text = table.concat(verdict.lines(fit, judged, { variants = {}, reason = "none" }, found, profiles), "\n")
  assert(text:find("NOT FOLLOWED", 1, true) and not text:find("NOT DETERMINED", 1, true) and not text:find("combination", 1, true), text)
  profiles[1].lost[1].flat = true
  judge.decide(judged, judge.by_profiles(own, judged, profiles))
  assert(judged.fates[1] ~= "not followed" and judged.fates[1] ~= "determined")
end)

test("a parameter is as sure as the wider side of its profile", function()
  local judged = { free = { 1, 2 }, values = { 0.43, 2 }, sizes = { 0.43, 2 }, relative = { 0.016, 0.3 }, t = 2 }
  local relative = judge.by_profiles({ linear("mu", 0, 1, 0.3), linear("young", 0, 10, 1) }, judged,
    { { low = 0.045, high = 0.44 }, { low = 1.9, high = 2.1 } })
  assert(math.abs(relative[1] - (0.43 - 0.045) / 0.43 / 2) < 1e-12, relative[1])
  equal(relative[2], 0.3)
end)
