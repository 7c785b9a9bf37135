-- A fit whose noise is correlated over lengths that its residuals tell: search and lengths in turn, and what is said of them.
local correlation = require "stiction.fit.correlation"
local noise = require "stiction.fit.noise"
local numeric = require "stiction.numeric"
local search = require "stiction.fit.search"

local correlated = {}

local most_rounds = 6
local same = 0.02 -- change of a length's logarithm that ends it

--- Minima with the lengths of curves that are to be estimated; where there are none, the same ones. tell(i, length): of each length that
--- was found. Curves are things with :correlate(length), x, first, last, length, estimated.
function correlated.settle(problem, minima, curves, tell)
  if not minima or not numeric.first_where(curves, function(curve) return curve.estimated end) then
    return minima
  end
  for _ = 1, most_rounds do
    local lengths, at_end = correlation.estimate(problem, minima[1], curves)
    local change = 0
    for i, length in pairs(lengths) do
      local curve = curves[i]
      change = math.max(change, curve.length and math.abs(math.log(length / curve.length)) or math.huge)
      curve:correlate(length)
      curve.endless = at_end[i]
    end
    minima = search.run(problem, numeric.map(minima, function(own) return own.z end), #minima)
    if change < same then
      break
    end
  end
  for i, curve in ipairs(curves) do
    if curve.estimated then
      tell(i, curve.length)
    end
  end
  return minima
end

--- What residuals of curves whose noise was taken for independent tell of a correlation: {length =, chance =, worth = (points)} by place,
--- false where it is nothing, or known already.
function correlated.told(residuals, curves)
  local list = {}
  for i, curve in ipairs(curves) do
    local free = curve.x and not curve.common and not curve.estimated
    local length, chance
    if free then
      length, chance = correlation.told(curve.x, table.move(residuals, curve.first, curve.last, 1, {}))
    end
    list[i] = length and { length = length, chance = chance, worth = noise.effective(noise.along(curve.x, length), #curve.x) } or false
  end
  return list
end

--- Whether residuals of a curve that may lie on a wrong model as well have no length that could be told from it.
function correlated.is_endless(curves)
  return numeric.first_where(curves, function(curve) return curve.endless end) ~= nil
end

--- Lines on the noise of each curve; doubt: the chance below which something is told.
function correlated.lines(curves, judged, doubt)
  local lines = {}
  for i, curve in ipairs(curves) do
    local told, chance = judged.correlated[i], judged.runs[i]
    local plain = told and told.chance < doubt / #curves
    if curve.endless then
      lines[#lines + 1] = ("%sthe residuals of %s are alike over half of the curve: no noise that can be told from a model that misses its "
        .. "course; where the noise is known to be so, give its length (correlation = ...)"):format(judged.coarse and "no agreement yet: "
        or "MODEL REJECTED: ", curve.name)
    elseif curve.length then
      lines[#lines + 1] = ("the noise of %s is correlated over %s%s%s: its %d points are worth %.3g independent ones"):format(curve.name,
        curve:along_x(curve.length), curve.estimated and ", as its residuals tell" or "",
        curve.shares and ", beside what each point has for itself" or "", #curve.x, curve:effective())
    elseif curve.common then
      lines[#lines + 1] = ("the noise of %s is as %s says: its %d points are worth %.3g independent ones"):format(curve.name,
        curve.covariance, #curve.x, curve:effective())
    elseif not judged.coarse and (plain or not curve.each and chance and chance < doubt / #curves) then
      lines[#lines + 1] = ("the residuals of %s are correlated along %s%s: either the model misses the curve's course, or the noise is so. "
        .. "It was taken for independent; else %s, and intervals are too narrow: say correlation = %s in study.fit.data.%s"):format(
        curve.name, curve.x_name, plain and (" over some %s (chance %.2g)"):format(curve:along_x(told.length), told.chance) or "",
        plain and ("the %d points are worth some %.2g"):format(#curve.x, told.worth) or "fewer points would tell as much",
        plain and curve:along_x(told.length, true) .. ", if that is its length, or \"estimated\"" or "\"estimated\"", curve.name)
    end
  end
  return lines
end

return correlated
