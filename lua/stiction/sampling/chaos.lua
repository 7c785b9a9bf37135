-- A polynomial of a sample (chaos expansion): least squares over orthonormal polynomials, its degree by leave-one-out errors; moments
-- and Sobol indices from its coefficients (Sudret 2008). Slopes at points, where they are known, are rows of it, too (Peng 2016).
local engine = require "stiction.engine"
local linear = require "stiction.fit.linear"
local numeric = require "stiction.numeric"

local chaos = {}

local most_degree, most_terms = 10, 400
local points_per_term = 1.5
local deviation = { normal = 1, uniform = 1 / math.sqrt(12) } -- of a coordinate
local rounding = 1e-12 -- of the values: a deviation that is less is none, and has no shares
local patience = 2 -- degrees without a gain
local thinner = { 1, 0.75, 0.5 } -- exponents of hyperbolic truncations: less, and products of many parameters are left out

--- Legendre's polynomials, orthonormal over x uniform in 0 to 1, up to a degree.
local function legendre(x, degree)
  local t, list = 2 * x - 1, { [0] = 1 }
  list[1] = t
  for n = 1, degree - 1 do
    list[n + 1] = ((2 * n + 1) * t * list[n] - n * list[n - 1]) / (n + 1)
  end
  for n = 1, degree do
    list[n] = list[n] * math.sqrt(2 * n + 1)
  end
  return list
end

--- Hermite's polynomials, orthonormal over x of the standard normal distribution.
local function hermite(x, degree)
  local list = { [0] = 1 }
  list[1] = x
  for n = 1, degree - 1 do
    list[n + 1] = (x * list[n] - math.sqrt(n) * list[n - 1]) / math.sqrt(n + 1)
  end
  return list
end

--- Derivatives of such polynomials; values: these, up to the degree.
local function slopes_of(kind, values, degree)
  local list = { [0] = 0 }
  if kind == "normal" then
    for n = 1, degree do
      list[n] = math.sqrt(n) * values[n - 1]
    end
    return list
  end
  local function plain(n) return values[n] / math.sqrt(2 * n + 1) end -- Legendre's own
  local plain_slopes = { [0] = 0, [1] = 2 } -- over x
  for n = 2, degree do
    plain_slopes[n] = plain_slopes[n - 2] + 2 * (2 * n - 1) * plain(n - 1)
  end
  for n = 1, degree do
    list[n] = plain_slopes[n] * math.sqrt(2 * n + 1)
  end
  return list
end

--- Exponents of all terms of up to this degree, the constant first: sum of powers n_k^q no more than degree^q.
local function terms_of(axes, degree, q)
  local list = {}
  local function extend(term, k, left)
    if #list > most_terms then
      return
    elseif k > axes then
      list[#list + 1] = table.move(term, 1, axes, 1, {})
      return
    end
    for n = 0, degree do
      if n ^ q <= left * (1 + 1e-12) then
        term[k] = n
        extend(term, k + 1, left - n ^ q)
      end
    end
  end
  extend({}, 1, degree ^ q)
  return list
end

--- Values of the terms at points: a column each; with slopes each point's value is followed by its slopes, times the standard deviations
--- of the coordinates.
local function columns_of(terms, points, kinds, degree, with_slopes)
  local columns = numeric.map(terms, function() return {} end)
  for _, point in ipairs(points) do
    local own, slopes = {}, {}
    for k, kind in ipairs(kinds) do
      own[k] = (kind == "normal" and hermite or legendre)(point[k], degree)
      slopes[k] = with_slopes and slopes_of(kind, own[k], degree)
    end
    for n, term in ipairs(terms) do
      for along = 0, with_slopes and #kinds or 0 do
        local product = along > 0 and deviation[kinds[along]] or 1
        for k, power in ipairs(term) do
          product = product * (k == along and slopes or own)[k][power]
        end
        columns[n][#columns[n] + 1] = product
      end
    end
  end
  return columns
end

--- Values, each followed by its slopes.
local function rows_of(values, slopes, kinds)
  local rows = {}
  for i, value in ipairs(values) do
    rows[#rows + 1] = value
    for k, kind in ipairs(kinds) do
      rows[#rows + 1] = slopes[i][k] * deviation[kind]
    end
  end
  return rows
end

--- First and total indices, the mean and the variance from coefficients.
local function read(terms, coefficients, axes)
  local mean, variance, first, total = 0, 0, {}, {}
  for k = 1, axes do
    first[k], total[k] = 0, 0
  end
  for n, term in ipairs(terms) do
    local involved = {}
    for k, power in ipairs(term) do
      involved[#involved + 1] = power > 0 and k or nil
    end
    local square = coefficients[n] ^ 2
    if #involved == 0 then
      mean = coefficients[n]
    else
      variance = variance + square
      first[involved[1]] = first[involved[1]] + (#involved == 1 and square or 0)
      for _, k in ipairs(involved) do
        total[k] = total[k] + square
      end
    end
  end
  for k = 1, axes do
    first[k], total[k] = numeric.share(first[k], variance), numeric.share(total[k], variance)
  end
  return mean, variance, first, total
end

--- Whether values differ by more than rounding.
function chaos.varies(values)
  local size, low, high = 0, math.huge, -math.huge
  for _, y in ipairs(values) do
    size, low, high = math.max(size, math.abs(y)), math.min(low, y), math.max(high, y)
  end
  return high - low > rounding * size
end

--- {mean =, deviation =, first =, total = (nil of a result that does not vary), degree =, terms = (how many), error = (of a point left
--- out, over the deviation of the values), at = function(point)}, or nil where there are too few points. points: lists, of kinds "uniform"
--- (in 0 to 1) or "normal"; slopes: of the values over these coordinates, lists, or nil.
function chaos.of(points, values, kinds, slopes)
  local best, variance, group = nil, 0, slopes and #kinds + 1 or 1
  local rows = slopes and rows_of(values, slopes, kinds) or values
  local mean = numeric.mean(values)
  for _, y in ipairs(values) do
    variance = variance + (y - mean) ^ 2 / #values
  end
  for degree = 1, most_degree do
    if best and degree > best.degree + patience then
      break
    end
    for _, q in ipairs(thinner) do
      local terms = terms_of(#kinds, degree, q)
      if #terms <= most_terms and points_per_term * #terms <= #rows and not (q < 1 and (degree == 1 or #kinds == 1)) then
        local coefficients, error = engine.regress(columns_of(terms, points, kinds, degree, slopes ~= nil), rows, group)
        if coefficients and (not best or error < best.square) then
          best = { terms = terms, coefficients = coefficients, square = error, degree = degree }
        end
      end
    end
  end
  if not best then
    return nil
  end
  local result = { degree = best.degree, terms = #best.terms, error = variance > 0 and math.sqrt(best.square / variance) or 0 }
  local spread
  result.mean, spread, result.first, result.total = read(best.terms, best.coefficients, #kinds)
  result.deviation = math.sqrt(spread)
  if not chaos.varies(values) then
    result.first, result.total, result.error = nil, nil, 0
  end
  result.at = function(point)
    local columns = columns_of(best.terms, { point }, kinds, best.degree)
    return linear.product(columns, best.coefficients, 1)[1]
  end
  return result
end

return chaos
