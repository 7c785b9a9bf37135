-- Sobol indices of a result: which parameter its variance is of, alone and with all others.
-- First: Saltelli 2010; total: Jansen 1999.
local indices = {}

local resamplings, seed = 200, 12345

--- Whole numbers from 1 to n, the same in every run (Lehmer).
local function dice()
  local state = seed
  return function(n)
    state = state * 48271 % 2147483647
    return 1 + state % n
  end
end

--- Estimates of rows, each {a, b, {ab1, ab2, ...}}.
local function estimate(rows, count)
  local n, sum, square = #rows, 0, 0
  for _, row in ipairs(rows) do
    sum, square = sum + row[1] + row[2], square + row[1] ^ 2 + row[2] ^ 2
  end
  local mean = sum / (2 * n)
  local variance, first, total = square / (2 * n) - mean ^ 2, {}, {}
  for k = 1, count do
    local alone, all = 0, 0
    for _, row in ipairs(rows) do
      alone, all = alone + (row[2] - mean) * (row[3][k] - row[1]), all + (row[1] - row[3][k]) ^ 2
    end
    first[k], total[k] = variance > 0 and alone / n / variance or 0, variance > 0 and all / (2 * n) / variance or 0
  end
  return first, total
end

--- {first =, first_error =, total =, total_error =}, lists by parameter, of rows {a, b, {ab1, ...}}: a result at points A, B, and at A with
--- one parameter of B each. Errors by resampling the rows.
function indices.of(rows, count)
  local result = { first_error = {}, total_error = {}, rows = #rows }
  result.first, result.total = estimate(rows, count)
  local roll, sums = dice(), {}
  for k = 1, 2 * count do
    sums[k] = { 0, 0 }
  end
  for _ = 1, resamplings do
    local drawn = {}
    for i = 1, #rows do
      drawn[i] = rows[roll(#rows)]
    end
    local first, total = estimate(drawn, count)
    for k = 1, count do
      for i, value in ipairs { first[k], total[k] } do
        local own = sums[2 * k + i - 2]
        own[1], own[2] = own[1] + value, own[2] + value * value
      end
    end
  end
  for k = 1, count do
    local function deviation(own)
      return math.sqrt(math.max(own[2] / resamplings - (own[1] / resamplings) ^ 2, 0))
    end
    result.first_error[k], result.total_error[k] = deviation(sums[2 * k - 1]), deviation(sums[2 * k])
  end
  return result
end

return indices
