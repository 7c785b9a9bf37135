-- What data say of parameters where a fit ended: errors, correlations, what is determined and what only in combination, and whether
-- the model is rejected. In relative coordinates: a change of 1 is by a factor e, or of a linear parameter by its own size.
local combination = require "stiction.fit.combination"
local correlated = require "stiction.fit.correlated"
local engine = require "stiction.engine"
local exact = require "stiction.fit.exact"
local linear = require "stiction.fit.linear"
local loss_module = require "stiction.fit.loss"
local numeric = require "stiction.numeric"
local space = require "stiction.fit.space"

local judge = {}

judge.settled = 0.25 -- relative standard error up to which a parameter or a combination counts as determined
judge.level = 0.95 -- of intervals
local doubt = 1e-3 -- probability below which a model is rejected
local blurred = 3 -- times the noise in derivatives: singular values below are not told from 0

--- By how much the relative coordinate of each parameter grows with its own one; and what a relative one is relative to.
function judge.scales(parameters, z)
  local values, slopes, sizes = space.values(parameters, z), {}, {}
  for k, own in ipairs(parameters) do
    slopes[k] = 1 / space.step(own, values[k], 1)
    local whole = own.from and not own.log and 0.1 * (own.to - own.from) or 0.1 * (own.size or 0)
    sizes[k] = own.from and own.log and values[k] or math.max(math.abs(values[k]), whole)
  end
  return slopes, sizes, values
end

--- What the squares of standard errors are multiplied by: 1 where errors are known, else the mean square of residuals; with a
--- robust loss as Huber (1981) has it, 7.6.
local function factor_of(problem, at, squares, free)
  local n, degrees = #at.r, math.max(1, #at.r - free)
  if problem.loss == "squares" then
    return problem.known and 1 or squares / degrees
  end
  local slope, h = 0, 1e-4
  squares = 0
  for i, r in ipairs(at.r) do
    local own, rise = loss_module.of(problem.loss, { r, r - h, r + h })
    squares = squares + (own[1] * rise[1]) ^ 2
    slope = slope + (own[3] * rise[3] - own[2] * rise[2]) / (2 * h)
    n = i
  end
  return squares / degrees / (slope / n) ^ 2
end

--- Standard errors of the parameters among `of` alone, the inverse of whose information this is; and how each is correlated.
local function errors_of(matrix)
  local errors, correlations = {}, {}
  for k, row in ipairs(matrix) do
    errors[k] = math.sqrt(row[k])
  end
  for k, row in ipairs(matrix) do
    correlations[k] = {}
    for l, value in ipairs(row) do
      correlations[k][l] = value / (errors[k] * errors[l])
    end
  end
  return errors, correlations
end

--- How often each residual counts, where curves have weights other than 1 (least squares); nil else.
local function weights_of(problem, curves, count)
  local list, any = {}, false
  for n = 1, count do
    list[n] = 1
  end
  for _, curve in ipairs(problem.loss == "squares" and curves or {}) do
    for n = curve.first, curve.last do
      list[n] = curve.weights and curve.weights[n - curve.first + 1] or curve.weight or 1
      any = any or list[n] ~= 1
    end
  end
  return any and list or nil
end

--- The least sum of squares of residuals without their weights: a step of Gauss and Newton away, on which these columns move.
local function squares_of(at, columns, weights)
  if not weights then
    return at.cost
  end
  local factors, plain, sum = numeric.map(weights, function(weight) return 1 / math.sqrt(weight) end), {}, 0
  for n, factor in ipairs(factors) do
    plain[n] = factor * at.r[n]
    sum = sum + plain[n] ^ 2
  end
  local gain = #columns > 0 and select(2, linear.step(linear.scaled(columns, factors), plain, math.huge)) or 0
  return math.max(sum - gain, 0)
end

--- Runs test of Wald (1940): the probability of no more runs of like signs than these
--- residuals have, of which each follows another; nil where there are too few.
function judge.runs(residuals)
  local plus, minus, runs, last = 0, 0, 0, nil
  for _, r in ipairs(residuals) do
    local sign = r > 0
    plus, minus = plus + (sign and 1 or 0), minus + (sign and 0 or 1)
    runs, last = runs + (sign ~= last and 1 or 0), sign
  end
  local n = plus + minus
  if n < 10 then
    return nil
  elseif plus == 0 or minus == 0 then
    return 0.5 ^ (n - 1)
  end
  local mean = 2 * plus * minus / n + 1
  local variance = (mean - 1) * (mean - 2) / (n - 1)
  return variance > 0 and engine.beyond(-(runs + 0.5 - mean) / math.sqrt(variance)) or nil
end

--- Directions in which some of the parameters are determined together: list of {error =, powers = by place, the largest 1}, the best
--- first. From a root of their covariance: small errors beside large ones would be lost in the covariance itself.
local function combinations(judged, ks)
  local own, list = {}, {}
  for i, k in ipairs(ks) do
    own[i] = numeric.map(judged.spreads, function(spread) return spread[k] end)
  end
  local values, vectors = engine.singular(own)
  for i = #values, 1, -1 do
    local powers, largest = {}, 0
    for j, x in ipairs(vectors[i]) do
      largest = math.abs(x) > math.abs(largest) * (1 + 1e-6) and x or largest
      powers[ks[j]] = x
    end
    for k, x in pairs(powers) do
      powers[k] = x / largest
    end
    list[#list + 1] = { error = values[i] / math.abs(largest), powers = powers }
  end
  return list
end


local function fate(error, alone)
  return error <= judge.settled and "determined" or alone <= judge.settled and "only in combination" or "not determined"
end

--- The place among the free ones of the parameter that is most correlated with the i-th; nil where there is none.
local function companion(judged, i)
  local best
  for j, x in ipairs(judged.correlations[i]) do
    if j ~= i and (not best or math.abs(x) > math.abs(judged.correlations[i][best])) then
      best = j
    end
  end
  return best
end

--- Takes those for not determined that would be determined with the others known, but stand in no combination that is: what the others do
--- not leave open tells nothing of them.
local function leave_out(judged, mixed)
  for _, i in ipairs(#judged.combinations > 0 and mixed or {}) do
    local k = judged.free[i]
    local held = numeric.first_where(judged.combinations, function(own) return math.abs(own.powers[k] or 0) >= combination.told end)
    if judged.fates[k] == "only in combination" and not held then
      judged.fates[k] = "not determined"
    end
  end
end

--- Sets the fate of each parameter, of whose relative standard errors these are the ones that count, and the combinations that are
--- determined where not all of them are.
function judge.decide(judged, relative)
  local mixed = {}
  judged.combinations = {}
  for i, k in ipairs(judged.free) do
    judged.fates[k] = fate(relative[k], judged.alone[k])
    mixed[#mixed + 1] = judged.fates[k] == "only in combination" and i or nil
  end
  if #mixed == 1 then
    mixed[2] = companion(judged, mixed[1])
  end
  local list = #mixed > 1 and combinations(judged, mixed) or {}
  for n, own in ipairs(list) do
    local powers = {}
    for i, x in pairs(own.powers) do
      powers[judged.free[i]] = x
    end
    local good = own.error <= judge.settled and n < #list -- the last one is what leaves them open
    judged.combinations[#judged.combinations + 1] = good and { error = own.error, powers = powers } or nil
  end
  leave_out(judged, mixed)
  for k in pairs(judged.lost or {}) do
    judged.fates[k] = judged.fates[k] == "determined" and "not followed" or judged.fates[k]
  end
end

--- Widens all that is told of parameters, here and in the profiles' intervals (nil: none), where model and data with known errors
--- do not agree: by the root of chi square per degree of freedom, judged.stretch; nil where nothing is widened.
function judge.stretch(problem, judged, intervals)
  local each = judged.squares / math.max(1, judged.degrees)
  if not (judged.misfit and problem.known and (problem.loss or "squares") == "squares" and each > 1) then
    return
  end
  local by = math.sqrt(each)
  judged.stretch, judged.factor = by, judged.factor * each
  judged.eigenvalues = numeric.map(judged.eigenvalues, function(x) return x / each end)
  for i, k in ipairs(judged.free) do
    judged.errors[k], judged.relative[k], judged.alone[k] = by * judged.errors[k], by * judged.relative[k], by * judged.alone[k]
    judged.covariance[i] = numeric.map(judged.covariance[i], function(x) return x * each end)
  end
  judged.spreads = numeric.map(judged.spreads, function(spread)
    return numeric.map(spread, function(x) return x * by end)
  end)
  for k, own in pairs(intervals or {}) do
    local parameter, value, straight = problem.parameters[k], judged.values[k], own.straight or 0
    local times = 2 * each / (straight + math.sqrt(straight ^ 2 + 4 * (1 - straight) * each)) -- `by` where the squares rise as a square
    local function widened(x)
      local far = x and (parameter.log and value * (x / value) ^ times or value + times * (x - value))
      return far and (not parameter.from or far > parameter.from and far < parameter.to) and far or nil
    end
    own.low, own.high = widened(own.low), widened(own.high)
  end
end

--- Whether the open sides of an interval are those along which its profile could not be followed.
local function is_lost(own)
  local lost = { low = own.low ~= nil, high = own.high ~= nil }
  for _, side in ipairs(own.lost or {}) do
    lost[side.way < 0 and "low" or "high"] = not side.flat
  end
  return lost.low and lost.high
end

--- Relative standard errors as the wider side of profiles has them, where that is wider: infinite where they are open; of one that
--- could not be followed as its other side or the covariance has it, and that is noted in judged.lost.
function judge.by_profiles(parameters, judged, intervals)
  local relative = {}
  judged.lost = {}
  for _, k in ipairs(judged.free) do
    local own, value, wider = intervals[k], judged.values[k], math.huge
    if own and is_lost(own) then
      local function half(far)
        return far and math.abs(parameters[k].log and math.log(far / value) or (far - value) / judged.sizes[k])
      end
      local low, high = half(own.low), half(own.high)
      judged.lost[k] = not (low and high) or nil
      wider = math.max(low or high or 0, high or low or 0)
    end
    relative[k] = math.max(judged.relative[k], wider / judged.t)
  end
  return relative
end

--- Squares of what the simulation changes (a list), each at least the mean of its curve: where a change passes 0 the curve is no surer.
local function smoothed(changes, curves)
  local list = numeric.map(changes, function(change) return change ^ 2 end)
  for _, curve in ipairs(curves) do
    local sum = 0
    for i = curve.first, curve.last do
      sum = sum + changes[i] ^ 2
    end
    for i = curve.first, curve.last do
      list[i] = math.max(list[i], sum / (curve.last - curve.first + 1))
    end
  end
  return list
end

--- The chance of so large squares if each residual may be off by the simulation's own change too (lists); nil where it tells nothing.
function judge.chance_with(judged, residuals, changes)
  local sum, own = 0, smoothed(changes, judged.curves)
  for i, r in ipairs(residuals) do
    local weight = judged.weights and judged.weights[i] or 1
    sum = sum + r * r / (weight + own[i])
  end
  return judged.chance and engine.beyond(sum, judged.degrees)
end

judge.doubt = doubt

--- The length of the longest of these columns.
local function longest(columns)
  local most = 0
  for _, column in ipairs(columns) do
    most = math.max(most, linear.length(column))
  end
  return most
end

--- By what weights widen the standard error of a parameter with this column, the others being known.
local function alone_of(column, weights)
  local sum = 0
  for n, weight in ipairs(weights or {}) do
    sum = sum + weight * column[n] ^ 2
  end
  return weights and sum > 0 and math.sqrt(sum) / linear.length(column) or 1
end

--- {values =, slopes = (of relative coordinates), sizes =, free = places of the parameters that move, errors = (standard errors, nil of
--- one at a bound), relative = (the same of relative coordinates), covariance = (of relative coordinates of the free ones), inverse = (of
--- the products of columns; the covariance but for factor and weights), times = {by place: how much wider weights make errors than that},
--- weights = (of residuals, or nil), spreads = (its root), correlations =, eigenvalues = (of the information in relative coordinates, the
--- largest first), directions =, fates = by place, combinations = {{error =, powers =}}, squares = (the least without weights), degrees =,
--- factor =, t = (of 95 %), chance = (of so large squares; nil where errors are not known), runs = {by curve: the chance, or false},
--- correlated = (of correlated.told), curves = (of about), rejected =, stretch = (by judge.stretch), lost = {by place: whether its
--- interval could not be followed, of judge.by_profiles}}. about = {curves = {{name =, first =, last =, x =, length =, estimated =,
--- endless =}}, noise = (of a residual), share = (of differences)}.
function judge.of(problem, found, about)
  local at, free = found.at, found.free
  local slopes, sizes, values = judge.scales(problem.parameters, found.z)
  local columns = {}
  for i, k in ipairs(free) do
    columns[i] = numeric.map(found.J[k], function(x) return x / slopes[k] end)
  end
  local weights = weights_of(problem, about.curves, #at.r)
  local squares = squares_of(at, columns, weights)
  local judged = { values = values, free = free, sizes = sizes, slopes = slopes, errors = {}, relative = {}, fates = {}, runs = {},
    weights = weights, squares = squares, degrees = #at.r - #free, factor = factor_of(problem, at, squares, #free), times = {},
    alone = {}, curves = about.curves or {} }
  judged.t = engine.quantile(0.5 + judge.level / 2, not problem.known and math.max(1, judged.degrees) or nil)
  local floor = exact.are_known(at.J, #found.z) and exact.error * longest(columns)
    or blurred * (about.noise or 0) * math.sqrt(#at.r) / (about.share or 1)
  local matrix, singular, vectors, spreads = {}, {}, {}, {}
  if #free > 0 then
    matrix, singular, vectors, spreads = linear.covariance(columns, floor)
  end
  judged.inverse = matrix
  if weights and #free > 0 then
    matrix, spreads = linear.unweighted(columns, weights, singular, vectors, spreads)
  end
  matrix = numeric.map(matrix, function(row)
    return numeric.map(row, function(x) return x * judged.factor end)
  end)
  local errors, correlations = errors_of(matrix)
  for i, k in ipairs(free) do
    judged.relative[k], judged.errors[k] = errors[i], errors[i] * sizes[k]
    judged.times[k] = errors[i] / math.sqrt(judged.factor * judged.inverse[i][i])
    judged.alone[k] = alone_of(columns[i], weights) * math.sqrt(judged.factor) / math.max(linear.length(columns[i]), floor, 1e-150)
  end
  for k in ipairs(found.z) do
    judged.times[k] = judged.times[k] or alone_of(found.J[k], weights) -- at a bound
  end
  judged.covariance, judged.correlations, judged.directions = matrix, correlations, vectors
  judged.eigenvalues = numeric.map(singular, function(x) return x * x / judged.factor end)
  judged.spreads = numeric.map(spreads, function(spread)
    return numeric.map(spread, function(x) return x * math.sqrt(judged.factor) end)
  end)
  judge.decide(judged, judged.relative)
  judged.chance = problem.known and problem.loss == "squares" and judged.degrees > 0
    and engine.beyond(judged.squares, judged.degrees) or nil
  for i, curve in ipairs(about.curves or {}) do
    judged.runs[i] = judge.runs(table.move(at.r, curve.first, curve.last, 1, {})) or false
  end
  judged.correlated = correlated.told(at.r, about.curves or {})
  judged.rejected = judged.chance and judged.chance < doubt or correlated.is_endless(about.curves or {})
  for _, chance in ipairs(judged.runs) do
    judged.rejected = judged.rejected or chance and chance < doubt / #judged.runs or false
  end
  return judged
end

return judge
