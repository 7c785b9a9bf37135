-- Where a quantity goes as one resolution is refined, and how sure that is (Richardson 1911, Roache 1994).
local extrapolation = {}

local orders = { low = 0.7, high = 4 } -- of the observed order that is believed
local single, agreement = 2.2, 0.5 -- up to this one from three levels; above it, the three before must have the same within so much

--- (h1^p - h2^p) / (h2^p - h3^p), rising with p.
local function ratio(h1, h2, h3, p)
  return (h1 ^ p - h2 ^ p) / (h2 ^ p - h3 ^ p)
end

--- Order p of q = limit + c h^p through three levels h1 > h2 > h3; nil where they do not approach one limit.
function extrapolation.order(levels)
  local n = #levels
  if n < 3 then
    return nil
  end
  local a, b, c = levels[n - 2], levels[n - 1], levels[n]
  local wanted = (b.value - a.value) / (c.value - b.value)
  local low, high = 0.05, 12
  if not (wanted > ratio(a.h, b.h, c.h, low) and wanted < ratio(a.h, b.h, c.h, high)) then
    return nil
  end
  for _ = 1, 80 do
    local middle = 0.5 * (low + high)
    if ratio(a.h, b.h, c.h, middle) < wanted then
      low = middle
    else
      high = middle
    end
  end
  return 0.5 * (low + high)
end

--- Whether an order is one that three levels may show by themselves, or the three before the last have it as well: that differences
--- fall fast between three levels alone may be a crossing of errors.
local function is_confirmed(levels, order)
  local before = order > single and extrapolation.order(table.move(levels, 1, #levels - 1, 1, {}))
  return order <= single or before and math.abs(before - order) <= agreement
end

--- {correction =, uncertainty =, order =} of levels {{h =, value =}, ...}, h falling: limit = last value + correction.
--- Three levels with an order in 0.7 .. 4: Richardson's correction, uncertain by half of it; above 2.2 by the last difference, unless
--- a level more confirms the order. Else none, uncertain by the larger of the last two differences; by twice the difference where
--- there are but two levels, and not known (infinite) from one.
function extrapolation.limit(levels)
  local n = #levels
  if n < 2 then
    return { correction = 0, uncertainty = math.huge }
  end
  local last = levels[n].value - levels[n - 1].value
  if n == 2 then
    return { correction = 0, uncertainty = 2 * math.abs(last) }
  end
  local order = extrapolation.order(levels)
  if order and order >= orders.low and order <= orders.high then
    local correction = last / ((levels[n - 1].h / levels[n].h) ^ order - 1)
    local doubt = is_confirmed(levels, order) and 0.5 * math.abs(correction) or math.abs(last)
    return { correction = correction, uncertainty = doubt, order = order }
  end
  local before = levels[n - 1].value - levels[n - 2].value
  return { correction = 0, uncertainty = math.max(math.abs(last), math.abs(before)), order = order }
end

return extrapolation
