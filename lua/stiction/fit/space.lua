-- The parameters of a fit as coordinates: 0 and 1 at their bounds, logarithmic where the study says so.
local space = {}

local widest = 0.1 -- of the range: what a linear parameter near 0 is measured by

--- A parameter {name =, from =, to =, log =, start =} in SI; without bounds (both nil) it is measured by its start.
local function to_inner(own, value)
  if not own.from then
    return value / own.size
  elseif own.log then
    return math.log(value / own.from) / math.log(own.to / own.from)
  end
  return (value - own.from) / (own.to - own.from)
end

local function to_value(own, z)
  if not own.from then
    return z * own.size
  elseif own.log then
    return own.from * (own.to / own.from) ^ z
  end
  return own.from + (own.to - own.from) * z
end

--- Coordinates of values, a list in the order of the parameters.
function space.inner(parameters, values)
  local z = {}
  for k, own in ipairs(parameters) do
    z[k] = to_inner(own, values[k])
  end
  return z
end

--- Values of coordinates.
function space.values(parameters, z)
  local values = {}
  for k, own in ipairs(parameters) do
    values[k] = to_value(own, z[k])
  end
  return values
end

--- Coordinates brought between the bounds; whether one was outside.
function space.clipped(parameters, z)
  local inside, moved = {}, false
  for k, own in ipairs(parameters) do
    inside[k] = own.from and math.min(math.max(z[k], 0), 1) or z[k]
    moved = moved or inside[k] ~= z[k]
  end
  return inside, moved
end

--- How far a coordinate moves while its parameter changes by the relative amount `share`: of itself, of a linear one at
--- least of a tenth of its range.
function space.step(own, value, share)
  if not own.from then
    return share * math.max(math.abs(value / own.size), widest)
  elseif own.log then
    return share / math.log(own.to / own.from)
  end
  return share * math.max(math.abs(value) / (own.to - own.from), widest)
end

return space
