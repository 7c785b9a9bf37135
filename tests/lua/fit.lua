-- Fits of functions: intervals that cover, directions that nothing determines, wrong models, bounds, outliers, failing points.
local test, equal, fails = ...
local advice = require "stiction.fit.advice"
local curve = require "stiction.fit.curve"
local combination = require "stiction.fit.combination"
local judge = require "stiction.fit.judge"
local loss = require "stiction.fit.loss"
local numeric = require "stiction.numeric"
local plain = require "stiction.fit.plain"
local space = require "stiction.fit.space"
local verdict = require "stiction.fit.verdict"

--- Uniform and normal random numbers, the same in every run (Lehmer's generator; Box and Muller).
local function dice(seed)
  local state = seed
  local function uniform()
    state = state * 48271 % 2147483647
    return state / 2147483647
  end
  for _ = 1, 10 do
    uniform()
  end
  return function() return math.sqrt(-2 * math.log(uniform())) * math.cos(2 * math.pi * uniform()) end
end

local function range(low, high, count)
  local list = {}
  for i = 1, count do
    list[i] = low + (high - low) * (i - 1) / (count - 1)
  end
  return list
end

local function log(name, from, to, start)
  return { name = name, from = from, to = to, log = true, start = start }
end

local function rising(values, x) -- to values[1], in a length values[2]
  return values[1] * (1 - math.exp(-x / values[2]))
end

--- Measured values of f with noise.
local function measured(f, values, x, sigma, random)
  return numeric.map(x, function(at) return f(values, at) + sigma * random() end)
end

local x = range(0.2, 6, 30)
local parameters = { log("a", 0.1, 10, 1), log("l", 0.1, 10, 1) }

test("95 % intervals cover the truth 90 to 99 % of the time, without bias", function()
  local covered, tighter, sum, repeats = { 0, 0 }, 0, { 0, 0 }, 400
  for i = 1, repeats do
    local y = measured(rising, { 2, 1.5 }, x, 0.1, dice(100 + i))
    local _, judged, profiles = plain.fit({ parameters = parameters, x = x, y = y, sigma = 0.1, f = rising, share = 1e-4,
      enough = 1e-4 }, 1, true)
    for k, truth in ipairs { 2, 1.5 } do
      local own = profiles[k]
      covered[k] = covered[k] + (own.low < truth and truth < own.high and 1 or 0)
      sum[k] = sum[k] + (judged.values[k] - truth) / judged.errors[k] / repeats
    end
    tighter = tighter + (profiles[2].high - judged.values[2] > judged.values[2] - profiles[2].low and 1 or 0)
  end
  for k = 1, 2 do
    assert(covered[k] >= 0.9 * repeats and covered[k] <= 0.99 * repeats, ("%d of %d"):format(covered[k], repeats))
    assert(math.abs(sum[k]) < 0.1 * 2 * 1.96, "bias " .. sum[k])
  end
  assert(tighter > 0.9 * repeats, "the profile of a length is wider above")
end)

test("at the ends of a profile the squares have risen by what they should, the others at their best", function()
  local function bent(values, at) -- b follows a^2
    return 0.3 * values[1] * math.sin(3 * at) + (values[2] - values[1] ^ 2) * at
  end
  local own = { { name = "a", from = -4, to = 4, start = 0.5 }, { name = "b", from = -20, to = 20, start = 1 } }
  local y = measured(bent, { 1, 1 }, x, 0.5, dice(21))
  local found, judged, profiles = plain.fit({ parameters = own, x = x, y = y, sigma = 0.5, f = bent, enough = 1e-8 }, 1, true)
  local function least(a) -- of all b, in closed form
    local xx, xy, sum = 0, 0, 0
    for i, at in ipairs(x) do
      xx, xy = xx + at * at, xy + at * (y[i] - bent({ a, a * a }, at))
    end
    for i, at in ipairs(x) do
      sum = sum + ((bent({ a, a * a + xy / xx }, at) - y[i]) / 0.5) ^ 2
    end
    return sum
  end
  for _, a in ipairs { profiles[1].low, profiles[1].high } do
    local rise = math.sqrt(least(a) - found.at.cost)
    assert(math.abs(rise / judged.t - 1) < 0.05, ("%.3f, not %.3f"):format(rise, judged.t))
  end
end)

test("along a curved ridge a profile goes as far as the others can follow", function()
  local function hertz(values, at) -- of values[1] / (1 - values[2]^2) alone
    return values[1] / (1 - values[2] ^ 2) * (at + values[3]) ^ 1.5
  end
  for _, nu in ipairs { 0.3, 0.2 } do
    for _, logarithmic in ipairs { true, false } do
      local own = { { name = "young", from = 0.2, to = 5, log = logarithmic, start = 1 },
        { name = "nu", from = 0.05, to = 0.49, start = nu }, { name = "zero", from = -0.1, to = 0.1, start = 0 } }
      local t = { parameters = own, x = x, y = measured(hertz, { 1.2, 0.45, 0 }, x, 0.05, dice(31)), sigma = 0.05, f = hertz,
        enough = 0.04 }
      local count = select(4, plain.fit(t)).count.evaluations
      local found, judged, profiles, problem = plain.fit(t, 1, true)
      assert(not profiles[2].low and not profiles[2].high and #profiles[2].lost == 0, "nu is told")
      for _, point in ipairs(profiles[2].points) do
        assert(math.abs(point.excess) < 0.05, ("nu = %g: %g"):format(point.value, point.excess))
      end
      local alone = select(3, plain.fit({ parameters = { { name = "plain", from = 0.2, to = 5, log = true, start = 1 }, own[3] }, x = x,
        y = t.y, sigma = 0.05, enough = 1e-8, f = function(values, at) return hertz({ values[1], 0, values[2] }, at) end }, 1, true))[1]
      local low, high = alone.low * (1 - 0.49 ^ 2), alone.high * (1 - 0.05 ^ 2) -- with nu at its bounds
      assert(math.abs(profiles[1].low / low - 1) < 2e-3 and math.abs(profiles[1].high / high - 1) < 2e-3, ("%g .. %g, not %g .. %g"):format(
        profiles[1].low or 0, profiles[1].high or 0, low, high))
      assert(found.at.cost < 40 and judged.values[2] <= 0.49)
      count = problem.count.evaluations - count
      assert(count <= 120, count .. " evaluations")
    end
  end
end)

test("where the others do not settle, or points fail, a profile says so and tells no end", function()
  local own = { { name = "a", from = 0, to = 4, start = 1.9 }, { name = "b", from = -4, to = 4, start = 0.9 } }
  local y = measured(function(_, at) return 2 * at + 0.1 * at ^ 2 end, {}, x, 0.3, dice(41))
  local profiles
  for _, beyond in ipairs { function() return 0 / 0 end, function(b) return 5 * math.sqrt(math.abs(b - 1.234)) end } do -- of a = 2.1
    local function f(values, at)
      return values[1] * at + 0.1 * values[2] * at ^ 2 + (values[1] > 2.1 and beyond(values[2]) or 0)
    end
    profiles = select(3, plain.fit({ parameters = own, x = x, y = y, sigma = 0.3, f = f }, 1, true))
    assert(profiles[1].low and not profiles[1].high and #profiles[1].lost == 1, tostring(profiles[1].high))
    local side = profiles[1].lost[1]
    equal(side.way, 1)
    assert(side.value > 1.9 and side.value <= 2.1, side.value)
  end
  own[1].like, own[2].like = 1, 1
  local judged = { squares = 1, degrees = 1, runs = {}, correlated = {}, free = {}, errors = { 1, 1 }, values = { 2, 1 } }
  local lines = table.concat(verdict.lines({ parameters = own, curves = {} }, judged, { variants = {}, reason = "none" }, { lost = 0 },
    profiles), "\n")
  assert(lines:find("the interval of a is open above: its profile could not be followed beyond ", 1, true), lines)
end)

test("a misfit no larger than what a finer level changes rejects nothing yet", function()
  local y = measured(rising, { 2, 1.5 }, x, 0.02, dice(15))
  for i in ipairs(y) do
    y[i] = y[i] + 0.06 * math.sin(i)
  end
  local found, judged = plain.fit { parameters = parameters, x = x, y = y, sigma = 0.02, f = rising }
  local function settled(change)
    judged.rejected = true
    verdict.settle(judged, { known = true, changes = numeric.map(x, function() return change end),
      variants = { { residual = change } } }, found)
    return judged.coarse
  end
  assert(judged.chance < 1e-3)
  equal(settled(0.1), false)
  equal(judged.rejected, true)
  equal(settled(3), true)
  equal(judged.rejected, false)
  -- nor where the change passes 0 at the point that misses most
  local worst, changes = 1, numeric.map(x, function() return 3 end)
  for i, r in ipairs(found.at.r) do
    worst = math.abs(r) > math.abs(found.at.r[worst]) and i or worst
  end
  changes[worst] = 0
  local function rejected(curves)
    judged.curves, judged.rejected = curves, true
    found.at.r[worst] = 10
    verdict.settle(judged, { known = true, changes = changes, variants = { { residual = 3 } } }, found)
    return judged.rejected
  end
  equal(rejected {}, true)
  equal(rejected { { first = 1, last = #x } }, false)
end)

test("a standard error that is not known is that of the residuals", function()
  local y = measured(rising, { 2, 1.5 }, x, 0.1, dice(7))
  local _, known = plain.fit { parameters = parameters, x = x, y = y, sigma = 0.1, f = rising }
  local _, guessed = plain.fit { parameters = parameters, x = x, y = y, f = rising }
  local each = math.sqrt(known.squares / known.degrees)
  for k = 1, 2 do
    assert(math.abs(guessed.errors[k] / (each * known.errors[k]) - 1) < 1e-3)
  end
  assert(guessed.t > known.t and not guessed.chance)
end)

test("only a product of powers: the direction is found", function()
  local function f(values, at) return values[1] ^ 2 * values[2] ^ -1 * (1 - math.exp(-at)) end
  local y = measured(f, { 2, 3 }, x, 0.01, dice(3))
  local _, judged = plain.fit { parameters = parameters, x = x, y = y, sigma = 0.01, f = f }
  equal(judged.fates[1], "only in combination")
  equal(judged.fates[2], "only in combination")
  equal(#judged.combinations, 1)
  local powers = judged.combinations[1].powers
  assert(math.abs(powers[1] / powers[2] + 2) < 1e-3, powers[1] / powers[2])
  equal(combination.words(parameters, powers), "a * l^-0.5")
  local squares = 0 -- of the slopes over a / l^0.5, whose square the curve is proportional to
  for _, at in ipairs(x) do
    squares = squares + (2 * 4 / 3 * (1 - math.exp(-at))) ^ 2
  end
  assert(math.abs(judged.combinations[1].error / (0.01 / math.sqrt(squares)) - 1) < 0.01)
  assert(judged.eigenvalues[2] < 1e-8 * judged.eigenvalues[1])
end)

test("what only others' small changes would make up for is not determined", function()
  local function f(values, at) -- a l^0.03, but for a little that tells them apart
    return values[1] * (1 - math.exp(-at)) * values[2] ^ 0.03 + 1e-3 * values[1] * math.sin(3 * at) * math.log(values[2])
  end
  local y = measured(f, { 2, 1.5 }, x, 0.01, dice(17))
  local _, judged = plain.fit { parameters = parameters, x = x, y = y, sigma = 0.01, f = f }
  equal(judged.fates[1], "determined")
  equal(judged.fates[2], "not determined")
  assert(judged.alone[2] < 0.1 and judged.relative[2] > 0.3, ("%g, %g"):format(judged.alone[2], judged.relative[2]))
end)

test("what has no effect is not determined, and its interval is open", function()
  local function f(values, at) return values[1] * at + 0 * values[2] end
  local y = measured(f, { 2, 3 }, x, 0.1, dice(4))
  local _, judged, profiles = plain.fit({ parameters = parameters, x = x, y = y, sigma = 0.1, f = f }, 1, true)
  equal(judged.fates[1], "determined")
  equal(judged.fates[2], "not determined")
  assert(not profiles[2].low and not profiles[2].high and profiles[1].low)
end)

test("a wrong model is rejected, by chi square and by runs of signs alone", function()
  local function bent(values, at) return values[1] * at ^ 0.5 + 0 * values[2] end
  local y = measured(bent, { 2, 1 }, x, 0.02, dice(5))
  local function line(values, at) return values[1] + (values[2] - 1) * at end
  local _, judged = plain.fit { parameters = parameters, x = x, y = y, sigma = 0.02, f = line }
  assert(judged.rejected and judged.chance < 1e-3)
  _, judged = plain.fit { parameters = parameters, x = x, y = y, f = line }
  assert(judged.rejected and not judged.chance and judged.runs[1] < 1e-3)
  _, judged = plain.fit { parameters = parameters, x = x, y = measured(rising, { 2, 1.5 }, x, 0.02, dice(6)), sigma = 0.02, f = rising }
  assert(not judged.rejected and judged.chance > 0.01)
end)

test("the runs test knows few and many runs", function()
  local function signs(text)
    local list = {}
    for c in text:gmatch "." do
      list[#list + 1] = c == "+" and 1 or -1
    end
    return list
  end
  assert(judge.runs(signs(("+"):rep(10) .. ("-"):rep(10))) < 1e-4)
  assert(judge.runs(signs(("+-"):rep(10))) > 0.99)
  assert(math.abs(judge.runs(signs "++--+-+--+-++-+-++--") - 0.7) < 0.3)
  equal(judge.runs(signs "+-+"), nil)
end)

test("a best value beyond a bound stays at it, and the others follow", function()
  local bounded = { log("a", 0.1, 1.5, 1), log("l", 0.1, 10, 1) }
  local y = measured(rising, { 2, 1.5 }, x, 0.01, dice(8))
  local found, judged = plain.fit { parameters = bounded, x = x, y = y, sigma = 0.01, f = rising }
  equal(judged.values[1], 1.5)
  equal(#judged.free, 1)
  local _, alone = plain.fit { parameters = { log("l", 0.1, 10, 1) }, x = x, y = y, sigma = 0.01,
    f = function(values, at) return rising({ 1.5, values[1] }, at) end }
  assert(math.abs(judged.values[2] / alone.values[1] - 1) < 1e-3)
  assert(found.z[1] == 1 and judged.rejected)
end)

test("outliers draw a robust fit less", function()
  local y = measured(rising, { 2, 1.5 }, x, 0.05, dice(9))
  for _, i in ipairs { 5, 14, 22 } do
    y[i] = y[i] + 3
  end
  local off = {}
  for _, name in ipairs { "squares", "huber", "cauchy", "soft" } do
    local _, judged = plain.fit { parameters = parameters, x = x, y = y, sigma = 0.05, f = rising, loss = name }
    off[name] = math.abs(judged.values[1] - 2)
  end
  assert(off.squares > 0.15, off.squares)
  for _, name in ipairs { "huber", "cauchy", "soft" } do
    assert(off[name] < 0.25 * off.squares, name .. " " .. off[name])
  end
end)

test("a robust loss over known errors is no reason to say that these were not given", function()
  local y = measured(rising, { 2, 1.5 }, x, 0.05, dice(9))
  for _, known in ipairs { true, false } do
    local found, judged = plain.fit { parameters = parameters, x = x, y = y, sigma = known and 0.05 or nil, f = rising, loss = "huber" }
    local fit = { parameters = parameters, curves = {}, known = known, loss = "huber" }
    local lines = table.concat(verdict.lines(fit, judged, { variants = {}, reason = "none" }, found), "\n")
    equal(lines:find("errors of the data were not given", 1, true) == nil, known)
    equal(lines:find("the loss is 'huber'", 1, true) ~= nil, known)
  end
end)

test("losses are squares of what they hand on, and slopes are theirs", function()
  for _, name in ipairs { "squares", "huber", "soft", "cauchy" } do
    for _, r in ipairs { -7.3, -1, -0.2, 0, 0.4, 1.3, 6 } do
      local own, slopes, sum = loss.of(name, { r })
      assert(math.abs(own[1] ^ 2 - sum) < 1e-12)
      local h = 1e-6
      local up, down = loss.of(name, { r + h }), loss.of(name, { r - h })
      assert(math.abs((up[1] - down[1]) / (2 * h) - slopes[1]) < 1e-6, name .. " " .. r)
    end
  end
  fails("did you mean 'huber'?", loss.check, "hubr")
end)

test("a long step does not leave a parameter where it has no effect", function()
  local function f(values, at) return values[1] * (1 - math.exp(-at)) + 2 * math.exp(-at) / (1 + values[2] ^ 4) end
  for _, a in ipairs { 0.2, 1, 8 } do
    for _, l in ipairs { 0.01, 0.1, 1, 10 } do
      for _, truth in ipairs { 0.3, 1, 3 } do
        local y = numeric.map(x, function(at) return f({ 2, truth }, at) + 0.01 * math.sin(60 * at) end)
        local _, judged = plain.fit { parameters = { log("a", 0.01, 100, a), log("l", 1e-3, 1e3, l) }, x = x, y = y, sigma = 0.01, f = f,
          enough = 0.01 }
        assert(judged.squares < 60, ("from %g, %g to %g: squares %g"):format(a, l, truth, judged.squares))
      end
    end
  end
end)

test("points that fail are steps too long: the search comes back", function()
  local function edgy(values, at) -- there is nothing beyond a = 2.3
    return values[1] > 2.3 and 0 / 0 or rising(values, at)
  end
  local y = measured(rising, { 2.2, 1.5 }, x, 0.02, dice(10))
  local found, judged, profiles = plain.fit({ parameters = { log("a", 0.1, 10, 0.2), log("l", 0.1, 10, 6) }, x = x, y = y, sigma = 0.02,
    f = edgy }, 1, true)
  assert(math.abs(judged.values[1] - 2.2) < 0.05, judged.values[1])
  equal(found.lost, 0)
  assert(profiles[1].low < 2.2)
  equal(plain.fit { parameters = { log("a", 3, 10, 4), log("l", 0.1, 10, 1) }, x = x, y = y, sigma = 0.02, f = edgy }, nil)
end)

test("several starts find the lower of two minima", function()
  local function f(values, at) return math.sin(values[1] * at) end
  local y = measured(f, { 5 }, x, 0.05, dice(11))
  local own = { { name = "k", from = 0.5, to = 8, start = 1 } }
  local _, one = plain.fit { parameters = own, x = x, y = y, sigma = 0.05, f = f }
  local _, many = plain.fit({ parameters = own, x = x, y = y, sigma = 0.05, f = f }, 32)
  assert(one.rejected and not many.rejected)
  assert(math.abs(many.values[1] - 5) < 0.01)
end)

test("derivatives that are kept along cost fewer evaluations", function()
  local y = measured(rising, { 2, 1.5 }, x, 0.05, dice(12))
  local function count(always)
    local _, _, _, problem = plain.fit { parameters = parameters, x = x, y = y, sigma = 0.05, f = rising, always = always, enough = 0.01 }
    return problem.count.evaluations
  end
  assert(count(false) < count(true), ("%d, %d"):format(count(false), count(true)))
end)

test("derivatives that a last step tells are those of differences", function()
  for seed = 30, 49 do
    local y = measured(rising, { 2, 1.5 }, x, 0.05, dice(seed))
    local function judged(central)
      return select(2, plain.fit { parameters = parameters, x = x, y = y, sigma = 0.05, f = rising, share = 3e-3, enough = 0.01,
        central = central })
    end
    local kept, exact = judged(false), judged(true)
    for k = 1, 2 do
      assert(math.abs(kept.errors[k] / exact.errors[k] - 1) < 0.03, ("%d: %g, %g"):format(seed, kept.errors[k], exact.errors[k]))
    end
  end
end)

test("the noise of a curve comes from its third differences, and jumps do not change it", function()
  local y = measured(rising, { 2, 1.5 }, range(0, 6, 200), 0.03, dice(13))
  assert(math.abs(curve.noise(y) / 0.03 - 1) < 0.2)
  for i = 100, #y do
    y[i] = y[i] - 2
  end
  assert(math.abs(curve.noise(y) / 0.03 - 1) < 0.25)
end)

test("coordinates and values are each other's inverse", function()
  local own = { log("a", 0.1, 10), { name = "b", from = -2, to = 5 }, { name = "c", size = 3 } }
  local values = { 0.7, 1.25, -6 }
  for k, value in ipairs(space.values(own, space.inner(own, values))) do
    assert(math.abs(value - values[k]) < 1e-14)
  end
  local inside, moved = space.clipped(own, { 1.2, 0.5, 40 })
  assert(inside[1] == 1 and inside[3] == 40 and moved)
end)

test("values are told in the unit of their bounds, whichever these are", function()
  local u = require "stiction".units
  equal(verdict.words({ like = 0 * u.um }, 2.5e-6), "2.5 um")
  equal(verdict.words({ like = 3 * u.N * u.s / u.m }, 0.25), "0.25 N s/m")
  equal(verdict.words({ like = 1 }, 0.125), "0.125")
end)

test("what is claimed is never less than the simulation's own error", function()
  local y = measured(rising, { 2, 1.5 }, x, 0.02, dice(14))
  local _, judged, profiles = plain.fit({ parameters = parameters, x = x, y = y, sigma = 0.02, f = rising }, 1, true)
  for _, own in ipairs(parameters) do
    own.like = 1
  end
  local fit = { parameters = parameters, known = true }
  local sure = verdict.interval(fit, judged, profiles, { known = false, variants = {} }, 1)
  local coarse = verdict.interval(fit, judged, profiles, { known = true, relative = { 0.1, 0.1 }, variants = {} }, 1)
  assert(sure.simulation == nil and math.abs(coarse.simulation - 0.1 * judged.values[1]) < 1e-12)
  assert(math.abs(coarse.high / sure.high - math.exp(0.1)) < 1e-12 and math.abs(coarse.low / sure.low - math.exp(-0.1)) < 1e-12)
  parameters[1].log = false
  local line = verdict.interval(fit, judged, profiles, { known = true, relative = { 0.1, 0.1 }, variants = {} }, 1)
  parameters[1].log = true
  assert(math.abs(line.high - line.low - (sure.high - sure.low) - 2 * line.simulation) < 1e-12)
  fails("speed = { values }", advice.check, { further = { 3 } })
end)

test("a repeat is told in bits only where the data determine something", function()
  --- What is said of a repeat where the residuals go with two parameters so.
  local function said(J)
    local fit = { parameters = { { name = "a" }, { name = "b" } }, curves = { { name = "drag", first = 1, last = 3 } } }
    local found = { J = J, at = { r = { 0, 0, 0 }, slopes = { 1, 1, 1 } } }
    return advice.said(fit, advice.of({ fit = fit }, found, { free = { 1, 2 }, slopes = { 1, 1 }, relative = { 1, 2 } })[1])
  end
  equal(said { { 1, 2, 3 }, { 3, 1, 0 } }, "once more: drag would bring the error of b to 0.71 of what it is (1 bits in all)")
  equal(said { { 0, 0, 0 }, { 0, 0, 0 } }, "once more: drag would determine nothing either")
  equal(said { { 0, 0, 0 }, { 3, 1, 0 } }, "once more: drag would bring the error of b to 0.71 of what it is (0.5 bits in all)")
end)

test("what data determine is not claimed where the simulation is rougher than that", function()
  local word = require("stiction.fit.verdict").word
  local judged, own = { fates = { "determined", "determined", "not determined" } }, { known = true, relative = { 0.1, 0.3, 0.3 } }
  equal(word(judged, own, 1), "determined")
  equal(word(judged, own, 2), "not claimed")
  equal(word(judged, own, 3), "not determined")
  equal(word(judged, own, 4), "at its bound")
  equal(word(judged, { known = false }, 2), "determined")
end)
