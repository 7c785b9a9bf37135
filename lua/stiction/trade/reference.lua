-- What the runs of a trade are compared with: known exactly, or made of the finest runs with its uncertainty.
local extrapolation = require "stiction.trade.extrapolation"
local ladder = require "stiction.ladder"
local numeric = require "stiction.numeric"
local quantity_module = require "stiction.trade.quantity"

local reference = {}

local floor = 1e-6 -- of a value: what solvers leave

--- {h =, value =, work =, run =} of the finished runs along one numeric knob through the default, the finest last; the
--- value of a curve is how far it has moved from the coarsest, distance by distance.
function reference.line(knobs, runs, knob, quantity)
  local by_levels, line, moved = ladder.index(runs), {}, 0
  for level = 1, #knob.levels do
    local run = by_levels[ladder.key(ladder.levels(knobs, { [knob.name] = level }))]
    if run and run.values then
      local value = run.values[quantity.name]
      if quantity.curve then
        local before = line[#line] and line[#line].run.values[quantity.name] or value
        moved = moved + quantity_module.distance(quantity, value, before)
        value = moved
      end
      line[#line + 1] = { h = ladder.resolution(knob, level), value = value, work = run.work, run = run,
        lacking = (run.lacking or {})[quantity.name] }
    end
  end
  return line
end

--- Observed order along a line: of the last two errors where the answer is known, of the last three values else; nil
--- where they do not fall.
function reference.order(line, quantity)
  if not quantity.exact then
    return extrapolation.order(line)
  end
  local a, b = line[#line - 1], line[#line]
  local before, last = a and a.run.errors[quantity.name], b and b.run.errors[quantity.name]
  if before and before > last and last > 0 then
    return math.log(before / last) / math.log(a.h / b.h)
  end
end

local function words_diverging(knob)
  return knob and ("it moves more at each finer level of %s: no limit shows"):format(knob)
end

--- The corner and, knob by knob, the correction to its limit. The corrections are those of the lines through the
--- default; how far the corner is from the sum of these lines tells how much less they hold there, and adds to the
--- uncertainty: up to the corrections, where all lines have one; and so does what the corner lacks between its steps.
local function extrapolated(knobs, runs, quantity, default, corner, lacking)
  local sum, correction, squares, whole, diverges = default, 0, lacking ^ 2, true, nil
  for _, knob in ipairs(knobs) do
    if knob.numeric then
      local line = reference.line(knobs, runs, knob, quantity)
      local limit = extrapolation.limit(line, quantity.scale)
      sum = sum + line[#line].value - default
      correction, squares = correction + limit.correction, squares + limit.uncertainty ^ 2
      whole = whole and (limit.correction ~= 0 or limit.uncertainty == 0)
      diverges = diverges or limit.diverges and knob.name
    end
  end
  local interaction = 0.5 * math.abs(corner - sum)
  return {
    value = corner + correction,
    uncertainty = math.sqrt(squares + (whole and math.min(interaction, math.abs(correction)) or interaction) ^ 2),
    doubt = words_diverging(diverges),
  }
end

--- The corner's curve as it is: uncertain by all that the lines through the default still have to move.
local function finest_curve(knobs, runs, quantity, corner)
  local squares, diverges = 0, nil
  for _, knob in ipairs(knobs) do
    if knob.numeric then
      local limit = extrapolation.limit(reference.line(knobs, runs, knob, quantity), quantity_module.size(quantity, corner))
      squares = squares + (math.abs(limit.correction) + limit.uncertainty) ^ 2
      diverges = diverges or limit.diverges and knob.name
    end
  end
  return { value = corner, uncertainty = math.sqrt(squares), doubt = words_diverging(diverges) }
end

--- {value =, uncertainty =}, of a curve known exactly on its abscissas; nil if it takes runs that did not finish.
local function reference_of(knobs, runs, quantity)
  if quantity.exact then
    return { value = quantity.curve and numeric.map(quantity.x, quantity.exact) or quantity.exact, uncertainty = 0 }
  end
  local by_levels = ladder.index(runs)
  local default, corner = by_levels[ladder.key(ladder.levels(knobs))], by_levels[ladder.key(ladder.corner(knobs))]
  if not (default and default.values and corner and corner.values) then
    return nil
  end
  local name = quantity.name
  if quantity.curve then
    return finest_curve(knobs, runs, quantity, corner.values[name])
  end
  return extrapolated(knobs, runs, quantity, default.values[name], corner.values[name], (corner.lacking or {})[name] or 0)
end

--- What errors are relative to: the reference itself, or the scale given; of a curve its norm, or that of the scale.
local function scale_of(quantity, value)
  if not quantity.curve then
    return quantity.scale or math.abs(value)
  elseif quantity.scale then
    return quantity.scale * math.sqrt(quantity.x[#quantity.x] - quantity.x[1])
  end
  return quantity_module.size(quantity, value)
end

--- Whether a line moves at all, by more than this share of its values.
local function moves(line, share)
  return numeric.first_where(line, function(own)
    return math.abs(own.value - line[1].value) > share * math.abs(line[1].value)
  end) ~= nil
end

--- By name, a knob whose number leaves a judged quantity exactly as it is, though it moves others: the quantity may take steps. What
--- is known exactly, or is 0, is left out.
local function still(knobs, runs, quantities)
  local list = {}
  for _, knob in ipairs(knobs) do
    local lines = knob.numeric and numeric.map(quantities, function(quantity) return reference.line(knobs, runs, knob, quantity) end) or {}
    local any = numeric.first_where(lines, function(line) return moves(line, floor) end)
    for i, quantity in ipairs(any and quantities or {}) do
      local line = lines[i]
      local open = not quantity.watched and not quantity.exact and #line > 1 and (quantity.curve or line[1].value ~= 0)
      list[quantity.name] = open and not moves(line, 0) and knob.name or list[quantity.name]
    end
  end
  return list
end

--- References of all quantities: by name {value =, uncertainty =, scale =, doubt = (words on why how sure it is is not known, or
--- nil)}, the two before the last in the quantity's unit; nil and the reason if the default or the finest run did not finish.
function reference.all(knobs, runs, quantities)
  local references, kept = {}, still(knobs, runs, quantities)
  for _, quantity in ipairs(quantities) do
    local its = reference_of(knobs, runs, quantity)
    if not its then
      return nil, "the default run or the finest one did not finish: there is nothing to compare with"
    end
    its.scale = scale_of(quantity, its.value)
    if its.scale == 0 then
      return nil, ("'%s' tends to 0: give it a scale in study.trade.quantities"):format(quantity.name)
    end
    local knob = kept[quantity.name]
    its.doubt = its.doubt or knob and ("%s moves others and leaves it exactly as it is; it may take steps"):format(knob)
    references[quantity.name] = its
  end
  return references
end

return reference
