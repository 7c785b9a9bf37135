-- The arithmetic of a trade: limits with their uncertainty, references, the front, promising combinations.
local test, equal, fails = ...
local accuracy = require "stiction.trade.accuracy"
local exchange = require "stiction.trade.exchange"
local extrapolation = require "stiction.trade.extrapolation"
local ladder = require "stiction.trade.ladder"
local units = require("stiction").units

local function near(got, wanted, tolerance)
  if got ~= got or math.abs(got - wanted) > (tolerance or 1e-9) * math.max(1, math.abs(wanted)) then
    error(("got %.17g, wanted %.17g"):format(got, wanted), 2)
  end
end

local function levels(limit, c, p, hs)
  local list = {}
  for i, h in ipairs(hs) do
    list[i] = { h = h, value = limit + c * h ^ p }
  end
  return list
end

test("a power law is continued to its limit, with its order", function()
  for _, p in ipairs { 0.8, 1, 2, 3.5 } do
    local found = extrapolation.limit(levels(3, -0.7, p, { 0.5, 0.3, 0.1 }))
    near(found.order, p, 1e-6)
    near(3 - 0.7 * 0.1 ^ p + found.correction, 3)
    near(found.uncertainty, 0.5 * 0.7 * 0.1 ^ p, 1e-6)
  end
end)

test("levels that do not approach one limit are not continued", function()
  local found = extrapolation.limit { { h = 4, value = 1 }, { h = 2, value = 1.5 }, { h = 1, value = 1.2 } }
  equal(found.correction, 0)
  near(found.uncertainty, 0.5)
  equal(found.order, nil)
  near(extrapolation.limit({ { h = 2, value = 1 }, { h = 1, value = 1.25 } }).uncertainty, 0.5)
  equal(extrapolation.limit({ { h = 1, value = 1 } }).uncertainty, math.huge)
end)

test("an order beyond belief is no order", function()
  local found = extrapolation.limit(levels(1, 1, 0.2, { 4, 2, 1 }))
  near(found.order, 0.2, 1e-6)
  equal(found.correction, 0)
end)

local mm = units.mm
local knobs = ladder.knobs({ { "size", { 4*mm, 2*mm, 1*mm } }, { "steps", { 10, 20, 40 } }, { "scheme", { "a", "b" } } },
  { size = 2*mm, steps = 20, scheme = "a" })

test("knobs know where they stand and where they are refined to", function()
  equal(table.concat(ladder.levels(knobs), " "), "2 2 1")
  equal(table.concat(ladder.corner(knobs), " "), "3 3 1")
  near(ladder.resolution(knobs[1], 3), 1e-3)
  near(ladder.resolution(knobs[2], 3), 1 / 40)
  equal(#ladder.first_round(knobs), 7) -- the default, two more of each number, one word, the corner
end)

test("knobs that cannot be are refused", function()
  fails("must be one of its levels", function() ladder.knobs({ { "n", { 1, 2 } } }, { n = 3 }) end)
  fails("has no parameter", function() ladder.knobs({ { "n", { 1, 2 } } }, { m = 3 }) end)
  fails("rise or fall", function() ladder.knobs({ { "n", { 1, 3, 2 } } }, { n = 3 }) end)
  fails("at least two levels", function() ladder.knobs({ { "n", { 1 } } }, { n = 1 }) end)
  fails("lists no knob", function() ladder.knobs({}, {}) end)
end)

--- Runs of a model world: value = 10 + 1e5 size^2 + 2/steps (+ 1 for scheme b), work rising with refinement.
local function world(list)
  local runs = {}
  for i, chosen in ipairs(list) do
    local size, steps = knobs[1].levels[chosen[1]].si, knobs[2].levels[chosen[2]]
    runs[i] = { levels = chosen, values = { q = 10 + 1e5 * size ^ 2 + 2 / steps + (chosen[3] == 2 and 1 or 0) },
      work = steps / size ^ 2 }
  end
  return runs
end

local quantities = { { name = "q" } }

test("the reference is the limit in all numbers at once", function()
  local runs = world(ladder.first_round(knobs))
  local references = exchange.references(knobs, runs, quantities)
  near(references.q.value, 10, 1e-6)
  assert(references.q.uncertainty < 0.1 and references.q.uncertainty > 0.02, references.q.uncertainty)
  exchange.judge(runs, references, quantities)
  near(runs[1].error, 0.05, 1e-6) -- 0.4 of the size, 0.1 of the steps, over 10
  assert(runs[1].bound > runs[1].error)
end)

test("without its finest run there is no reference", function()
  local runs = world(ladder.first_round(knobs))
  runs[#runs].values = nil
  local references, reason = exchange.references(knobs, runs, quantities)
  equal(references, nil)
  assert(reason:find("did not finish"), reason)
end)

test("the front holds what nothing beats; promising combinations are new and no dearer than the finest", function()
  local runs = world(ladder.first_round(knobs))
  local references = exchange.references(knobs, runs, quantities)
  exchange.judge(runs, references, quantities)
  local front = exchange.front(runs)
  for i = 2, #front do
    assert(front[i].work > front[i - 1].work and front[i].error < front[i - 1].error)
  end
  local seen = {}
  for _, run in ipairs(runs) do
    seen[table.concat(run.levels, " ")] = true
  end
  local promising = exchange.promising(knobs, runs, references, quantities, 3)
  assert(#promising >= 1 and #promising <= 3)
  for _, chosen in ipairs(promising) do
    equal(seen[table.concat(chosen, " ")], nil)
    equal(chosen[3], 1) -- scheme b is always a unit off
  end
end)

test("--accuracy takes the cheapest bound that holds", function()
  near(accuracy.share("2%"), 0.02)
  near(accuracy.share("0.02"), 0.02)
  fails("write a share", function() accuracy.share("much") end)
  local runs = { { work = 1, bound = 0.1 }, { work = 3, bound = 0.01 }, { work = 2, bound = 0.02 }, { work = 0.5 } }
  equal(accuracy.cheapest(runs, 0.02).work, 2)
  local none, nearest = accuracy.cheapest(runs, 0.001)
  equal(none, nil)
  near(nearest, 0.01)
end)
