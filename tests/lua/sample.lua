-- Samples for sweeps: strata, extension, Sobol's points, what is refused; and their cases.
local test, equal, fails = ...
local stiction = require "stiction"
local sweep = require "stiction.sweep"
local units = stiction.units
local mm, s = units.mm, units.s
local sample = stiction.sample

local axes = { mu = { 0.1, 0.5 }, speed = { 1*mm/s, 100*mm/s, "log" } }

--- How many cases lie in each of `count` equal parts of [low, high].
local function strata(list, name, count, low, high)
  local found = {}
  for k = 1, count do
    found[k] = 0
  end
  for _, case in ipairs(list) do
    local k = 1 + math.floor((case[name] - low) / (high - low) * count)
    found[k] = found[k] + 1
  end
  return table.concat(found, " ")
end

local function prefix_is(short, long)
  for i, case in ipairs(short) do
    equal(long[i].mu, case.mu)
    equal(long[i].speed.si, case.speed.si)
  end
end

test("a zip puts values side by side", function()
  local list = sample.zip { mu = { 0.1, 0.2 }, law = { "a", "b" } }
  equal(#list, 2)
  equal(list[2].mu, 0.2)
  equal(list[2].law, "b")
  fails("a list as long as the others", sample.zip, { mu = { 0.1, 0.2 }, law = { "a" } })
end)

test("a Latin hypercube has one case in every part of every axis", function()
  for _, count in ipairs { 1, 7, 16, 20 } do
    local list = sample.latin_hypercube { count = count, seed = 3, of = axes }
    equal(#list, count)
    equal(strata(list, "mu", count, 0.1, 0.5), (("1 "):rep(count):sub(1, -2)))
    for _, case in ipairs(list) do
      assert(case.speed >= 1*mm/s and case.speed <= 100*mm/s)
    end
  end
end)

test("twice the cases of a Latin hypercube keep the first, and further blocks all before", function()
  local function drawn(count, seed)
    return sample.latin_hypercube { count = count, seed = seed or 3, of = axes }
  end
  prefix_is(drawn(20), drawn(40))
  prefix_is(drawn { 20 }, drawn { 20, 10 })
  equal(strata(drawn(40), "mu", 40, 0.1, 0.5), (("1 "):rep(40):sub(1, -2)))
  assert(drawn(20)[1].mu ~= drawn(20, 4)[1].mu)
  local more = sample.latin_hypercube { count = 20, seed = 3, of = { mu = axes.mu, cells = { 4, 9, "whole" } } }
  equal(more[5].mu, drawn(20)[5].mu)
  equal(math.type(more[5].cells), "integer")
end)

-- Joe and Kuo's first points in three dimensions, in eighths, before the shift
local known = { { 0, 0, 0 }, { 4, 4, 4 }, { 6, 2, 2 }, { 2, 6, 6 }, { 3, 3, 5 }, { 7, 7, 1 }, { 5, 1, 7 }, { 1, 5, 3 } }

test("Sobol's points are Sobol's, but for a shift; a larger count keeps them", function()
  local unit = { a = { 0, 1 }, b = { 0, 1 }, c = { 0, 1 } }
  local list = sample.sobol { count = 8, seed = 5, of = unit }
  local function eighth(i, name)
    return math.floor(list[i][name] * 8)
  end
  for i, point in ipairs(known) do
    for k, name in ipairs { "a", "b", "c" } do
      equal(eighth(i, name) ~ eighth(1, name), point[k])
    end
  end
  prefix_is(sample.sobol { count = 10, seed = 1, of = axes }, sample.sobol { count = 100, seed = 1, of = axes })
  local all = {}
  for k = 1, 16 do
    all["p" .. k] = { 0, 1 }
  end
  local many = sample.sobol { count = 64, seed = 0, of = all }
  for name in pairs(all) do
    equal(strata(many, name, 64, 0, 1), (("1 "):rep(64):sub(1, -2)))
  end
  all.more = { 0, 1 }
  fails("17 axes, at most 16", sample.sobol, { count = 64, seed = 0, of = all })
end)

test("what cannot be sampled is told", function()
  fails("needs count = a whole number above 0, and seed", sample.sobol, { count = 8, of = axes })
  fails("needs count", sample.latin_hypercube, { count = 0, seed = 1, of = axes })
  fails("unknown key 'samples'", sample.sobol, { samples = 8, seed = 1, of = axes })
  fails("of.mu must be { low, high }", sample.sobol, { count = 8, seed = 1, of = { mu = { 1 } } })
  fails("of.mu must be { low, high }", sample.sobol, { count = 8, seed = 1, of = { mu = { 1, 2*mm } } })
  fails("of.mu must be { low, high }", sample.sobol, { count = 8, seed = 1, of = { mu = { 2, 1 } } })
  fails("begins above 0", sample.sobol, { count = 8, seed = 1, of = { mu = { 0, 1, "log" } } })
  fails("there is no", function() return sample.halton end)
end)

test("cases of a sample are called by their numbers", function()
  local function ids(count, set)
    local study = stiction.study { title = "t", given = { steps = 3 }, scene = function() end,
      sweep = sample.sobol { count = count, seed = 1, of = axes } }
    local words = {}
    for i, case in ipairs((sweep.cases(study, { set = set }))) do
      words[i] = case.id
    end
    return table.concat(words, " ")
  end
  equal(ids(3), "s1 s2 s3")
  equal(ids(4), "s1 s2 s3 s4")
  equal(ids(3, { "mu=0.3" }), "s1 s2 s3")
end)
