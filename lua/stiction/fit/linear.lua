-- Linear algebra of fits: columns as lists, what a step by Gauss and Newton gains, covariances from singular values.
local engine = require "stiction.engine"
local numeric = require "stiction.numeric"

local linear = {}

local least = 1e-13 -- of the largest singular value: below, nothing but rounding

function linear.dot(a, b)
  local sum = 0
  for i = 1, #a do
    sum = sum + a[i] * b[i]
  end
  return sum
end

function linear.length(a)
  return math.sqrt(linear.dot(a, a))
end

--- Sum of columns times the numbers x, of so many rows.
function linear.product(columns, x, rows)
  local sum = {}
  for i = 1, rows do
    local own = 0
    for k = 1, #columns do
      own = own + columns[k][i] * x[k]
    end
    sum[i] = own
  end
  return sum
end

--- Columns whose rows are multiplied by these numbers.
function linear.scaled(columns, factors)
  local list = {}
  for k, column in ipairs(columns) do
    local own = {}
    for i = 1, #column do
      own[i] = column[i] * factors[i]
    end
    list[k] = own
  end
  return list
end

--- The parts of a list that the left singular vectors take, beside singular values and right vectors.
local function parts(columns, list)
  local values, vectors = engine.singular(columns)
  local own = {}
  for i, value in ipairs(values) do
    local image = value > least * values[1] and linear.product(columns, vectors[i], #list)
    own[i] = image and linear.dot(image, list) / value or 0
  end
  return own, values, vectors
end

--- The step by which columns lessen the residuals most, and by how much that lessens their squares; along no singular
--- direction it goes farther than `reach`, and along none that gains no more than `worth` (default 0).
function linear.step(columns, residuals, reach, worth)
  local own, values, vectors = parts(columns, residuals)
  local step, gain = {}, 0
  for k = 1, #columns do
    step[k] = 0
  end
  for i, value in ipairs(values) do
    if own[i] ~= 0 then
      local along = math.max(-reach, math.min(reach, -own[i] / value))
      local won = -2 * along * value * own[i] - (along * value) ^ 2
      along = won > (worth or 0) and along or 0
      gain = gain + (along ~= 0 and won or 0)
      for k = 1, #columns do
        step[k] = step[k] + along * vectors[i][k]
      end
    end
  end
  return step, gain
end

--- The sum of the products of lists with themselves.
local function squares_of(lists, size)
  local matrix = {}
  for k = 1, size do
    matrix[k] = {}
    for l = 1, size do
      local sum = 0
      for _, list in ipairs(lists) do
        sum = sum + list[k] * list[l]
      end
      matrix[k][l] = sum
    end
  end
  return matrix
end

--- Inverse of the matrix of products of the columns, a list of lists; singular values below `floor` count as that. With it singular
--- values and right vectors, and the lists whose products with themselves add up to it.
function linear.covariance(columns, floor)
  local values, vectors = engine.singular(columns)
  local spreads = {}
  for i, value in ipairs(values) do
    spreads[i] = numeric.map(vectors[i], function(x) return x / math.max(value, floor, 1e-150) end)
  end
  return squares_of(spreads, #columns), values, vectors, spreads
end

--- Where row n of the columns counts as often as weights[n] say, while it is no surer for that: the covariance of what is then at its best,
--- and the lists whose products with themselves add up to it. values, vectors, spreads: as linear.covariance has them.
function linear.unweighted(columns, weights, values, vectors, spreads)
  local lists = {}
  for n = 1, #weights do
    lists[n] = numeric.map(columns, function() return 0 end)
  end
  for i, value in ipairs(values) do
    if value > least * values[1] then
      for n, x in ipairs(linear.product(columns, vectors[i], #weights)) do
        for k = 1, #columns do
          lists[n][k] = lists[n][k] + spreads[i][k] * x / value * math.sqrt(weights[n])
        end
      end
    else
      lists[#lists + 1] = spreads[i]
    end
  end
  return squares_of(lists, #columns), lists
end

return linear
