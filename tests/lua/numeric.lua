-- Small tools on lists: means, trends taken off, amplitudes.
local test, equal, fails = ...
local numeric = require "stiction.numeric"

test("mean and amplitude", function()
  equal(numeric.mean { 1, 2, 6 }, 3)
  equal(numeric.amplitude { -1, 4, 3 }, 2.5)
  fails("this list is empty: it has no mean", numeric.mean, {})
end)

test("a trend of its degree is taken off whole, what is orthogonal to it stays", function()
  local x, parabola, shaken = {}, {}, {}
  for i = 1, 41 do
    x[i] = (i - 21) / 4
    parabola[i] = 3 - 2 * x[i] + 0.5 * x[i] ^ 2
    shaken[i] = parabola[i] + 0.1 * math.cos(2 * math.pi * (i - 1) / 4)
  end
  for _, rest in ipairs(numeric.without_trend(x, parabola, 2)) do
    equal(math.abs(rest) < 1e-12, true)
  end
  local cubic = numeric.without_trend(x, numeric.map(x, function(value) return value ^ 3 end), 2)
  equal(numeric.amplitude(cubic) > 1, true)
  local amplitude = numeric.amplitude(numeric.without_trend(x, shaken, 2))
  equal(math.abs(amplitude - 0.1) < 0.01, true)
  fails("without_trend needs two lists of one length", numeric.without_trend, { 1, 2 }, { 1 }, 0)
end)

test("least squares find what values were made of, and the mean of what does not fit", function()
  local one, x, square, values = {}, {}, {}, {}
  for i = 1, 9 do
    one[i], x[i], square[i] = 1, i - 5, (i - 5) ^ 2
    values[i] = 3 - 2 * x[i] + 0.5 * square[i]
  end
  local found = numeric.least_squares({ one, x, square }, values)
  for i, wanted in ipairs { 3, -2, 0.5 } do
    equal(math.abs(found[i] - wanted) < 1e-12, true)
  end
  equal(math.abs(numeric.least_squares({ { 1, 1, 1 } }, { 1, 2, 6 })[1] - 3) < 1e-12, true)
end)

test("what is no list is told with the line of the script", function()
  for _, name in ipairs { "max", "min", "extreme", "argmax", "argmin", "mean", "amplitude", "map", "first_where", "integral",
    "interpolate", "without_trend", "solve", "least_squares" } do
    fails("needs a list of numbers, not nil", numeric[name])
    fails("needs a list of numbers, not 5", numeric[name], 5)
  end
  fails("numeric.lua:47: numeric.mean needs a list of numbers, not nil", function() numeric.mean(nil) end)
  fails("integral needs two lists of one length, not 2 and 1", numeric.integral, { 1, 2 }, { 1 })
end)

test("interpolation between abscissas that fall is refused", function()
  equal(numeric.interpolate({ 1, 2, 3 }, { 10, 20, 30 }, 1.5), 15)
  fails("interpolate needs xs that rise, not from 3 to 1", numeric.interpolate, { 3, 2, 1 }, { 30, 20, 10 }, 1.5)
end)
