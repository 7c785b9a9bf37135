-- Derivatives of a fit's residuals that take no cases of their own: from the runs beside cases whose study names the parameters in its
-- `derivatives`, and of what the comparison alone takes.
local copy = require "stiction.copy"
local engine = require "stiction.engine"
local space = require "stiction.fit.space"
local spec = require "stiction.fit.spec"

local exact = {}

exact.error = 1e-4 -- of a derivative
local relative = 1e-6 -- of its range, by which a parameter is moved that costs nothing

--- Whether derivatives over a parameter of a fit can be had without cases.
function exact.is_known(study, own)
  for _, name in ipairs(study.derivatives) do
    if name == own.key then
      return true
    end
  end
  return not own.setting
end

--- Whether these are all derivatives over so many coordinates; J: by place, or nil.
function exact.are_known(J, count)
  for k = 1, J and count or 0 do
    if not J[k] then
      return false
    end
  end
  return J ~= nil
end

--- Whether those over all of its parameters can.
function exact.all(study, fit)
  for _, own in ipairs(fit.parameters) do
    if not exact.is_known(study, own) then
      return false
    end
  end
  return true
end

--- What runs give at a curve's points where a parameter is a little different, and by how much, SI.
local function shifted(curve, runs, others, own)
  local moved, step = {}, nil
  if not own.setting then
    step = relative * (own.to - own.from)
    others[own.key] = others[own.key] + spec.quantity(own.like, step)
    return curve:model(runs, others), step
  end
  for i, run in ipairs(runs) do
    moved[i], step = run:beside(own.key)
  end
  return curve:model(moved, others), step
end

--- The derivatives of a curve's residuals over the coordinate of a parameter, nil where they cannot be had; part: {curve =, runs =,
--- others = (what the comparison takes besides), list = (what the runs give at its points)}.
local function slopes_of(part, own, value)
  local curve, slopes = part.curve, {}
  if own.curve and own.curve ~= curve.name then
    for i = 1, #part.list do
      slopes[i] = 0
    end
    return slopes
  end
  local held, list, step = engine.call(shifted, curve, part.runs, copy(part.others), own)
  if not held and list.kind == "stopped" then
    error(list, 0)
  elseif not held or not list then
    return nil
  end
  local dz = space.inner({ own }, { value + step })[1] - space.inner({ own }, { value })[1]
  local here, there = curve:residuals(part.list), curve:residuals(list)
  for i = 1, #here do
    slopes[i] = (there[i] - here[i]) / dz
  end
  return slopes
end

--- Derivatives of all residuals by place of parameter, of those that can be had; values: of the parameters, SI.
function exact.columns(study, parameters, values, parts)
  local J = {}
  for k, own in ipairs(parameters) do
    local column = exact.is_known(study, own) and {} or nil
    for _, part in ipairs(column and parts or {}) do
      local slopes = column and slopes_of(part, own, values[k])
      column = slopes and table.move(slopes, 1, #slopes, #column + 1, column)
    end
    J[k] = column
  end
  return J
end

return exact
