-- Limits of a trade's results as one resolution is refined, with their uncertainty.
local test, equal = ...
local extrapolation = require "stiction.trade.extrapolation"

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
    local found = extrapolation.limit(levels(3, -0.7, p, { 0.9, 0.5, 0.3, 0.1 }))
    near(found.order, p, 1e-6)
    near(3 - 0.7 * 0.1 ^ p + found.correction, 3)
    near(found.uncertainty, 0.5 * 0.7 * 0.1 ^ p, 1e-6)
  end
end)

test("an order above 2 from three levels alone is uncertain by the last difference", function()
  -- a pull-off at n = 64, 128 and 256; 92132 where n grows on
  local three = { { h = 1 / 64, value = 91008.8 }, { h = 1 / 128, value = 91863.2 }, { h = 1 / 256, value = 91964.3 } }
  local found = extrapolation.limit(three)
  assert(found.order > 3 and found.order < 3.2, found.order)
  near(found.uncertainty, 101.1)
  -- nor does a level before confirm it that has another order
  table.insert(three, 1, { h = 1 / 32, value = 88000 })
  near(extrapolation.limit(three).uncertainty, 101.1)
  for _, p in ipairs { 0.8, 1, 2 } do
    near(extrapolation.limit(levels(3, -0.7, p, { 0.5, 0.3, 0.1 })).uncertainty, 0.5 * 0.7 * 0.1 ^ p, 1e-6)
  end
end)

test("the order of levels that begin far from the answer is uncertain by the last difference, unless one more has it", function()
  -- the normal force of a sheared layer, nu = 0.49, at n = 2, 4, 8; 1647 at n = 128
  local three = { { h = 1 / 2, value = 471.88 }, { h = 1 / 4, value = 1237.82 }, { h = 1 / 8, value = 1444.60 } }
  local found = extrapolation.limit(three)
  assert(found.order > 1.8 and found.order < 2, found.order)
  near(found.uncertainty, 206.78)
  assert(math.abs(1444.60 + found.correction - 1647) < found.uncertainty)
  for _, far in ipairs { 0.8, 2.4 } do -- first differences of a fifth and three fifths of the value
    local list, alone = levels(1, far, 1, { 0.5, 0.25, 0.125 }), 0.5 * far / 8
    near(extrapolation.limit(list).uncertainty, far == 0.8 and alone or far / 8)
    near(extrapolation.limit(levels(1, far, 1, { 1, 0.5, 0.25, 0.125 })).uncertainty, alone, 1e-6)
    near(extrapolation.limit(list, 100).uncertainty, alone)
  end
end)

test("what values lack between steps is carried on with them", function()
  local list = levels(3, -0.7, 1, { 0.4, 0.2, 0.1 })
  local plain = extrapolation.limit(list).uncertainty
  list[2].lacking, list[3].lacking = 0.02, 0.01
  near(extrapolation.limit(list).uncertainty, plain + 0.03)
  list[2].lacking = 0.01 -- of a resolution in space
  near(extrapolation.limit(list).uncertainty, plain)
end)

test("levels that do not approach one limit are not continued", function()
  local found = extrapolation.limit { { h = 4, value = 1 }, { h = 2, value = 1.5 }, { h = 1, value = 1.2 } }
  equal(found.correction, 0)
  near(found.uncertainty, 0.5)
  equal(found.order, nil)
  near(extrapolation.limit({ { h = 2, value = 1 }, { h = 1, value = 1.25 } }).uncertainty, 0.5)
  equal(extrapolation.limit({ { h = 1, value = 1 } }).uncertainty, math.huge)
end)

test("an order beyond belief is no order, and a low one leaves more than the last difference", function()
  for _, p in ipairs { 0.6, 0.5, 0.3, 0.2 } do
    local found = extrapolation.limit(levels(1, 1, p, { 16, 8, 4, 2 }))
    near(found.order, p, 1e-6)
    equal(found.correction, 0)
    assert(found.uncertainty > 2 ^ p, p) -- off by that much
  end
end)

test("values that move more at each level have no limit", function()
  -- the largest pressure at a block's corner, on 20, 40, 80 and 160 cells; 189 and 245 kPa follow
  local corner = { { h = 8, value = 64 }, { h = 4, value = 84 }, { h = 2, value = 111 }, { h = 1, value = 145 } }
  local found = extrapolation.limit(corner)
  equal(found.diverges, true)
  near(found.uncertainty, 34 / (2 ^ 0.4 - 1))
  -- two such differences alone may be those of coarse levels, and so may others be rounding
  found = extrapolation.limit { corner[2], corner[3], corner[4] }
  equal(found.diverges, nil)
  assert(found.uncertainty > 100)
  found = extrapolation.limit { { h = 8, value = 1 }, { h = 4, value = 1 + 1e-9 }, { h = 2, value = 1 + 3e-9 },
    { h = 1, value = 1 + 6e-9 } }
  equal(found.diverges, nil)
  near(found.uncertainty, 3e-9, 1e-12)
end)
