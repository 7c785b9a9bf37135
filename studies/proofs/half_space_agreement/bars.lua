-- Error bars from a sequence's own refinement: the grid convergence index (Roache 1994; Eca and Hoekstra 2014).
local bars = {}

--- Half length of the bar of the last of three values whose spacings halve: 1.25 of Richardson's remainder where the three
--- converge, at the order they show but no more than `most`; otherwise 3 of the largest change.
function bars.of(values, most)
  local first, second = values[2] - values[1], values[3] - values[2]
  local order = math.log(math.abs(first / second), 2)
  if first * second <= 0 or order < 0.5 then
    return 3 * math.max(math.abs(first), math.abs(second)), nil
  end
  return 1.25 * math.abs(second) / (2 ^ math.min(order, most) - 1), order
end

return bars
