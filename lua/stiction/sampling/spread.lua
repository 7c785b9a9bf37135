-- Mean, spread and quantiles of a sample, each with its sampling error; where failed points lie.
local engine = require "stiction.engine"

local spread = {}

spread.levels = { 0.05, 0.25, 0.5, 0.75, 0.95 }
local inside = 0.95 -- of intervals
local much = 2.5 -- standard errors by which failed points lie off the middle to be told

--- {count =, mean =, mean_error =, deviation =, deviation_error =} of numbers, errors as of independent ones; the deviation's with
--- the fourth moment.
function spread.moments(values)
  local n, sum = #values, 0
  for _, y in ipairs(values) do
    sum = sum + y
  end
  local mean, second, fourth = sum / n, 0, 0
  for _, y in ipairs(values) do
    second, fourth = second + (y - mean) ^ 2, fourth + (y - mean) ^ 4
  end
  local variance = n > 1 and second / (n - 1) or 0
  local deviation = math.sqrt(variance)
  local of_variance = n > 1 and math.max(fourth / n - variance ^ 2 * (n - 3) / (n - 1), 0) / n or 0
  return { count = n, mean = mean, mean_error = deviation / math.sqrt(n), deviation = deviation,
    deviation_error = deviation > 0 and math.sqrt(of_variance) / (2 * deviation) or 0 }
end

--- The number of successes in n trials of chance p that is not exceeded with this probability.
local function binomial(n, p, probability)
  local term, sum = n * math.log(1 - p), 0 -- term: its logarithm, as (1 - p)^n may be less than any number
  for k = 0, n do
    sum = sum + math.exp(term)
    if sum >= probability then
      return k
    end
    term = term + math.log((n - k) / (k + 1) * p / (1 - p))
  end
  return n
end

--- The quantile of sorted numbers, linear between them, and the ends of its 95 % interval by order statistics (nil: beyond all).
function spread.quantile(sorted, level)
  local n = #sorted
  local at = 1 + (n - 1) * level
  local low = math.floor(at)
  local value = sorted[low] + (at - low) * ((sorted[low + 1] or sorted[low]) - sorted[low])
  local first, last = binomial(n, level, (1 - inside) / 2), binomial(n, level, (1 + inside) / 2) + 1
  return value, sorted[first], sorted[last]
end

--- {{level =, value =, low =, high =}} of numbers.
function spread.quantiles(values)
  local sorted, list = table.move(values, 1, #values, 1, {}), {}
  table.sort(sorted)
  for i, level in ipairs(spread.levels) do
    local value, low, high = spread.quantile(sorted, level)
    list[i] = { level = level, value = value, low = low, high = high }
  end
  return list
end

--- Where points that failed lie: {{axis =, side = "small" | "large", from =, to = (of all points, 0 to 1), chance =}}, of the axes along
--- which they are not spread as all points are. coordinates: of the failed ones, lists in 0 to 1.
function spread.where(coordinates)
  local list, n = {}, #coordinates
  for k in ipairs(coordinates[1] or {}) do
    local sum, from, to = 0, 1, 0
    for _, u in ipairs(coordinates) do
      sum, from, to = sum + u[k], math.min(from, u[k]), math.max(to, u[k])
    end
    local off = (sum / n - 0.5) * math.sqrt(12 * n)
    if math.abs(off) > much then
      list[#list + 1] = { axis = k, side = off < 0 and "small" or "large", from = from, to = to, chance = 2 * engine.beyond(math.abs(off)) }
    end
  end
  table.sort(list, function(a, b) return a.chance < b.chance end)
  return list
end

return spread
