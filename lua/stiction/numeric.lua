-- Small tools on histories: lists of numbers over a list of times.
local fault = require "stiction.fault"

local numeric = {}

--- The lists that a function called `what` is given, so that a wrong name in a script is told as such.
local function need_lists(what, ...)
  for i = 1, select("#", ...) do
    local list = select(i, ...)
    if type(list) ~= "table" then
      fault.script("numeric.%s needs a list of numbers, not %s", what, tostring(list))
    end
  end
end

local function best(what, values, better)
  need_lists(what, values)
  if #values == 0 then
    fault.script("this list is empty: it has no largest or smallest element")
  end
  local at = 1
  for i = 2, #values do
    if better(values[i], values[at]) then
      at = i
    end
  end
  return values[at], at
end

--- Largest value and its position (the first of equals).
function numeric.max(values)
  return best("max", values, function(a, b) return a > b end)
end

--- Smallest value and its position.
function numeric.min(values)
  return best("min", values, function(a, b) return a < b end)
end

--- Value of largest magnitude, with its sign, and its position.
function numeric.extreme(values)
  return best("extreme", values, function(a, b) return math.abs(a) > math.abs(b) end)
end

--- Position of the largest value (the first of equals).
function numeric.argmax(values)
  return select(2, numeric.max(values))
end

--- Position of the smallest value.
function numeric.argmin(values)
  return select(2, numeric.min(values))
end

--- Piecewise linear y(x), xs ascending; held constant outside.
function numeric.interpolate(xs, ys, x)
  need_lists("interpolate", xs, ys)
  if #xs == 0 or #xs ~= #ys then
    fault.script("interpolate needs two lists of one length, not %d and %d", #xs, #ys)
  elseif xs[1] > xs[#xs] then
    fault.script("interpolate needs xs that rise, not from %s to %s", tostring(xs[1]), tostring(xs[#xs]))
  end
  if x <= xs[1] then
    return ys[1]
  end
  local low, high = 1, #xs
  if x >= xs[high] then
    return ys[high]
  end
  while high - low > 1 do
    local middle = (low + high) // 2
    if xs[middle] <= x then
      low = middle
    else
      high = middle
    end
  end
  return ys[low] + (ys[high] - ys[low]) * (x - xs[low]) / (xs[high] - xs[low])
end

--- First position whose value satisfies the test, from `start` on (default 1); nil if none does.
function numeric.first_where(values, test, start)
  need_lists("first_where", values)
  for i = start or 1, #values do
    if test(values[i]) then
      return i
    end
  end
end

--- Integral of y over x by trapezia.
function numeric.integral(xs, ys)
  need_lists("integral", xs, ys)
  if #xs ~= #ys then
    fault.script("integral needs two lists of one length, not %d and %d", #xs, #ys)
  end
  local sum = 0
  for i = 2, #xs do
    sum = sum + 0.5 * (ys[i] + ys[i - 1]) * (xs[i] - xs[i - 1])
  end
  return sum
end

--- Arithmetic mean.
function numeric.mean(values)
  need_lists("mean", values)
  if #values == 0 then
    fault.script("this list is empty: it has no mean")
  end
  local sum = 0
  for _, value in ipairs(values) do
    sum = sum + value
  end
  return sum / #values
end

local function dot(a, b)
  local sum = 0
  for i in ipairs(a) do
    sum = sum + a[i] * b[i]
  end
  return sum
end

--- values without their part along `base`
local function without(values, base)
  local factor, rest = dot(values, base) / dot(base, base), {}
  for i in ipairs(values) do
    rest[i] = values[i] - factor * base[i]
  end
  return rest
end

--- What the polynomial of least squares over xs, of this degree, leaves of ys (Gram and Schmidt on its powers).
function numeric.without_trend(xs, ys, degree)
  need_lists("without_trend", xs, ys)
  if #xs ~= #ys or #xs <= degree then
    fault.script("without_trend needs two lists of one length, longer than the degree %d; got %d and %d", degree, #xs, #ys)
  end
  local widest, bases = math.abs(xs[select(2, numeric.extreme(xs))]), {}
  for power = 0, degree do
    local base = numeric.map(xs, function(x) return (x / widest) ^ power end)
    for _, earlier in ipairs(bases) do
      base = without(base, earlier)
    end
    bases[#bases + 1] = base
    ys = without(ys, base)
  end
  return ys
end

--- x of A x = b, A symmetric and positive definite, a list of rows, by Cholesky's factor.
function numeric.solve(A, b)
  need_lists("solve", A, b)
  local n, L, x = #b, {}, {}
  for i = 1, n do
    L[i] = {}
    for j = 1, i do
      local sum = A[i][j]
      for k = 1, j - 1 do
        sum = sum - L[i][k] * L[j][k]
      end
      L[i][j] = i == j and math.sqrt(math.max(sum, 1e-300)) or sum / L[j][j]
    end
  end
  for i = 1, n do
    x[i] = b[i]
    for k = 1, i - 1 do
      x[i] = x[i] - L[i][k] * x[k]
    end
    x[i] = x[i] / L[i][i]
  end
  for i = n, 1, -1 do
    for k = i + 1, n do
      x[i] = x[i] - L[k][i] * x[k]
    end
    x[i] = x[i] / L[i][i]
  end
  return x
end

--- Coefficients of the least squares of `values` by `functions`, a list of lists of their length.
function numeric.least_squares(functions, values)
  need_lists("least_squares", functions, values)
  local square, right = {}, {}
  for i, one in ipairs(functions) do
    square[i], right[i] = {}, dot(one, values)
    for j, other in ipairs(functions) do
      square[i][j] = dot(one, other)
    end
  end
  return numeric.solve(square, right)
end

--- Half of largest less smallest.
function numeric.amplitude(values)
  return (numeric.max(values) - numeric.min(values)) / 2
end

--- True of a number that is neither infinite nor undefined.
function numeric.is_finite(x)
  return type(x) == "number" and x == x and math.abs(x) < math.huge
end

--- f(a[i]) for every element, as a new list.
function numeric.map(values, f)
  need_lists("map", values)
  local list = {}
  for i, value in ipairs(values) do
    list[i] = f(value)
  end
  return list
end

--- Part over whole; of nothing nothing is 0, and anything else infinite.
function numeric.share(part, whole)
  return part == 0 and 0 or part / whole
end

return numeric
