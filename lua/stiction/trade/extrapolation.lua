-- Where a quantity goes as one resolution is refined, and how sure that is (Richardson 1911, Roache 1994).
local extrapolation = {}

local orders = { low = 0.7, high = 4 } -- of the observed order that is believed
local slowest = 0.4 -- of what has no order: claims of single cases take this one as well
local spare = 1.5 -- over what is left by an order below those believed
local refined = 1.2 -- times as much is lacking before the last step of a resolution that refines the runs' own steps
local floor = 1e-6 -- of a value: what solvers leave
local single, agreement = 2.2, 0.5 -- up to this one from three levels; above it, the three before must have the same within so much
local near = 0.25 -- of the last value: what a first difference of three levels that show an order by themselves may come to

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
--- fall fast between three levels alone may be a crossing of errors, and levels that begin far from the answer show the order of what
--- is gone on fine ones.
local function is_confirmed(levels, order, size)
  local n = #levels
  if order <= single and math.abs(levels[n - 1].value - levels[n - 2].value) <= near * size then
    return true
  end
  local before = extrapolation.order(table.move(levels, 1, n - 1, 1, {}))
  return before and math.abs(before - order) <= agreement
end

--- What is left after the last of differences that fall with this order.
local function left(levels, difference, order)
  local n = #levels
  return math.abs(difference) / ((levels[n - 1].h / levels[n].h) ^ order - 1)
end

--- Do the last differences go one way without falling, `count` of them, by more than solvers leave?
local function grows(levels, count)
  local n = #levels
  if n <= count then
    return false
  end
  local before
  for i = n - count + 1, n do
    local difference = levels[i].value - levels[i - 1].value
    if before and (difference * before <= 0 or math.abs(difference) < math.abs(before)) then
      return false
    end
    before = difference
  end
  return math.abs(before) > floor * math.abs(levels[n].value)
end

--- Uncertainty of the last of three levels or more that show no order to be believed.
local function doubt(levels, order)
  local n = #levels
  local last, before = levels[n].value - levels[n - 1].value, levels[n - 1].value - levels[n - 2].value
  local most = math.max(math.abs(last), math.abs(before))
  if order and order < orders.low then
    return math.max(most, spare * left(levels, last, order))
  elseif grows(levels, 2) then
    return math.max(most, left(levels, last, slowest))
  end
  return most
end

--- What Richardson's correction makes of what values lack between the steps of their runs, if this refines the steps.
local function carried(levels, order)
  local n = #levels
  local last, before = levels[n].lacking or 0, levels[n - 1].lacking or 0
  return before > refined * last and left(levels, last + before, order) or 0
end

--- {correction =, uncertainty =, order =, diverges =} of levels {{h =, value =, lacking = (of sampled.lacking, or nil)}, ...}, h falling:
--- limit = last value + correction; `size`: of the quantity, by default of the last value.
--- Three levels with an order in 0.7 .. 4: Richardson's correction, uncertain by half of it; by the last difference, if more, where
--- the order is above 2.2 or the first of them is off by a quarter, unless a level more confirms the order. Else none, uncertain by
--- the larger of the last two differences, and by what is left of an order below 0.7 (half as much again) or, where differences do
--- not fall, of the order 0.4; three of these in a row show no limit: diverges. Uncertain by twice the difference where there are
--- but two levels, and not known (infinite) from one.
function extrapolation.limit(levels, size)
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
    local half = 0.5 * math.abs(correction)
    local confirmed = is_confirmed(levels, order, size or math.abs(levels[n].value))
    local unsure = confirmed and half or math.max(half, math.abs(last))
    return { correction = correction, uncertainty = unsure + carried(levels, order), order = order }
  end
  return { correction = 0, uncertainty = doubt(levels, order), order = order, diverges = grows(levels, 3) or nil }
end

return extrapolation
