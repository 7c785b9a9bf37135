-- Combinations of parameters that data determine, in words: products of powers of logarithmic ones, sums of linear ones.
local engine = require "stiction.engine"
local numeric = require "stiction.numeric"
local units = require "stiction.units"

local combination = {}

combination.told = 0.05 -- exponents below are not told
local near = " (near the best values)" -- of what linear parameters are in: elsewhere the directions are others

--- The places that are told, the one of the largest exponent first where `first` is asked for.
local function places(parameters, powers, first)
  local list = {}
  for k in ipairs(parameters) do
    list[#list + 1] = math.abs(powers[k] or 0) >= combination.told and k or nil
  end
  local at = first and numeric.first_where(list, function(k) return powers[k] == 1 end)
  if at then
    table.insert(list, 1, table.remove(list, at))
  end
  return list
end

--- Whether all of them are linear, or one is that need not be above 0: no product of powers then.
local function is_sum(parameters, list)
  local linear, any = true, false
  for _, k in ipairs(list) do
    local own = parameters[k]
    linear, any = linear and not own.log, any or not own.log and (own.from or 0) <= 0
  end
  return linear or any
end

--- "w * E^-0.5"; exponents of linear ones as they change near the best values.
local function product(parameters, powers, judged, list)
  local linear = false
  local words = numeric.map(list, function(k)
    local own = parameters[k]
    local x = powers[k] * (own.log and 1 or judged.values[k] / judged.sizes[k])
    linear = linear or not own.log
    return math.abs(x - 1) < 0.005 and own.name or ("%s^%.2g"):format(own.name, x)
  end)
  return table.concat(words, " * ") .. (linear and near or "")
end

--- The unit in which a parameter is told, and its size in SI; nil and 1 of pure numbers and of logarithms.
local function unit_of(own)
  local unit = units.is_quantity(own.like) and not own.log and select(2, own.like:display()) or nil
  return unit, unit and engine.parse_unit(unit) or 1
end

--- "um/mN", "(N/m)/um": one unit over another, nil where they are alike.
local function over(one, other)
  local function bound(unit)
    return unit:find("[ /*]") and "(" .. unit .. ")" or unit
  end
  if one == other then
    return nil
  end
  return (one and (other and bound(one) or one) or "1") .. (other and "/" .. bound(other) or "")
end

--- "zero - 2.5 um/mN * load": logarithmic ones by their logarithms.
local function sum(parameters, powers, judged, list)
  local function weight(k)
    return powers[k] / (parameters[k].log and 1 or judged.sizes[k])
  end
  local first, text = list[1], ""
  local whole, whole_size = unit_of(parameters[first])
  for i, k in ipairs(list) do
    local own = parameters[k]
    local unit, size = unit_of(own)
    local x, word = weight(k) / weight(first) * size / whole_size, over(whole, unit)
    text = text .. (i > 1 and (x < 0 and " - " or " + ") or "")
    if word or math.abs(math.abs(x) - 1) >= 0.005 then
      text = text .. ("%.2g%s * "):format(math.abs(x), word and " " .. word or "")
    end
    text = text .. (own.log and ("ln(%s)"):format(own.name) or own.name)
  end
  return text .. near
end

--- The combination of these exponents of relative coordinates, by place, the largest 1; judged: where linear parameters are in it.
function combination.words(parameters, powers, judged)
  local list = places(parameters, powers)
  if is_sum(parameters, list) then
    return sum(parameters, powers, judged, places(parameters, powers, true))
  end
  return product(parameters, powers, judged, list)
end

--- The standard error of a combination {error =, powers =} in words: of a sum in the unit of its first parameter.
function combination.error_words(parameters, own, judged)
  local first = places(parameters, own.powers, true)[1]
  if not is_sum(parameters, places(parameters, own.powers)) then
    return ("%.2g %%"):format(100 * own.error)
  end
  local unit, size = unit_of(parameters[first])
  return ("%.2g%s"):format(own.error * (parameters[first].log and 1 or judged.sizes[first]) / size, unit and " " .. unit or "")
end

return combination
