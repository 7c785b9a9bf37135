-- Which further measurement would tell most: repeats of the curves that are there, and those that the study thinks of.
local copy = require "stiction.copy"
local fault = require "stiction.fault"
local linear = require "stiction.fit.linear"
local numeric = require "stiction.numeric"
local ordered = require "stiction.ordered"
local units = require "stiction.units"

local advice = {}

local two = math.log(2)
local tiny = 1e-12 -- of the largest singular value: what is as good as none

--- Rows of columns, in relative coordinates, weighted by the loss.
local function rows_of(columns, judged, slopes, first, last)
  local list = {}
  for i, k in ipairs(judged.free) do
    list[i] = {}
    for n = first, last do
      list[i][#list[i] + 1] = columns[k][n] / judged.slopes[k] * slopes[n]
    end
  end
  return list
end

local function joined(one, other)
  local list = {}
  for i in ipairs(one) do
    list[i] = table.move(other[i], 1, #other[i], #one[i] + 1, table.move(one[i], 1, #one[i], 1, {}))
  end
  return list
end

--- The place of the parameter that is known worst.
local function worst_of(judged)
  local at = 1
  for i, k in ipairs(judged.free) do
    at = judged.relative[k] > judged.relative[judged.free[at]] and i or at
  end
  return at
end

--- {words =, bits = (of all parameters; nil: it determines what was not determined at all), nothing = (true where it, too, determines
--- nothing), shrinks = (the standard error of the worst known parameter over what it was)}.
local function gain(words, base, more, judged, worst)
  local before, singular = linear.covariance(base, 0)
  local after, then_singular = linear.covariance(joined(base, more), 0)
  local bits, least = 0, tiny * then_singular[1]
  for i, value in ipairs(singular) do
    if value > least then
      bits = bits and bits + math.log(then_singular[i] / value) / two
    elseif then_singular[i] > least then
      bits = nil
    end
  end
  return { words = words, bits = bits, nothing = then_singular[1] == 0 or nil, parameter = judged.free[worst],
    shrinks = math.sqrt(after[worst][worst] / before[worst][worst]) }
end

--- The candidates of study.fit.further: lists of values by name become one each.
local function candidates(further)
  local list = {}
  for _, key in ipairs(ordered.keys(further)) do
    local entry = further[key]
    if type(key) == "number" then
      list[#list + 1] = entry
    else
      for _, value in ipairs(type(entry) == "table" and not units.is_quantity(entry) and entry or { entry }) do
        list[#list + 1] = { [key] = value }
      end
    end
  end
  return list
end

local function words_of(values)
  return table.concat(numeric.map(ordered.keys(values), function(name) return ("%s = %s"):format(name, tostring(values[name])) end), ", ")
end

--- A curve as another one with other values in its cases, over what its run covers; nil and why if there is none.
local function imagined(model, base, values, found)
  local twin = setmetatable(copy(base), getmetatable(base))
  twin.case = copy(base.case)
  for name, value in pairs(values) do
    twin.case[name] = value
  end
  local answer = model:evaluate({ found.z }, "further", nil, { twin })[1]
  if answer.failed then
    local low, high = model:range(twin, found.z)
    if not low then
      return nil, answer.failed
    end
    local span = twin.x[#twin.x] - twin.x[1]
    twin.x = numeric.map(base.x, function(x) return low + (x - base.x[1]) / span * (high - low) end)
  end
  return twin
end

--- Derivatives of a curve that was never measured: columns by place, nil and why if a run fails.
local function derivatives(model, curve, found)
  local step, points = model:problem(0).step, { found.z }
  for k in ipairs(model.fit.parameters) do
    points[k + 1] = table.move(found.z, 1, #found.z, 1, {})
    points[k + 1][k] = found.z[k] + (found.z[k] > 0.5 and -1 or 1) * step(k, found.z)
  end
  local answers, columns = model:evaluate(points, "further", nil, { curve }), {}
  for _, answer in ipairs(answers) do
    if answer.failed then
      return nil, answer.failed
    end
  end
  for k in ipairs(model.fit.parameters) do
    local h = points[k + 1][k] - found.z[k]
    columns[k] = {}
    for n, r in ipairs(answers[k + 1].r) do
      columns[k][n] = (r - answers[1].r[n]) / h
    end
  end
  return columns
end

--- What is said of one of them; nil if it could not be had.
function advice.said(fit, own)
  if own.nothing then
    return own.words .. " would determine nothing either"
  end
  return own.shrinks and ("%s would bring the error of %s to %.2g of what it is (%s)"):format(own.words,
    fit.parameters[own.parameter].name, own.shrinks, own.bits and ("%.2g bits in all"):format(own.bits)
    or "and determine what is not determined at all")
end

--- Measurements in the order of what they would tell of the worst known parameter, then of all: {words =, bits =, nothing =, shrinks =,
--- parameter = (its place)}, as gain has them, or {words =, reason =}.
function advice.of(model, found, judged)
  if #judged.free == 0 then
    return {}
  end
  local fit, worst, list = model.fit, worst_of(judged), {}
  local base = rows_of(found.J, judged, found.at.slopes, 1, #found.at.r)
  for _, curve in ipairs(fit.curves) do
    list[#list + 1] = gain(("once more: %s"):format(curve.name), base,
      rows_of(found.J, judged, found.at.slopes, curve.first, curve.last), judged, worst)
  end
  for _, values in ipairs(candidates(fit.further or {})) do
    local curve = fit.curves[1]
    local words = ("%s with %s"):format(curve.name, words_of(values))
    local twin, reason = imagined(model, curve, values, found)
    local columns
    if twin then
      columns, reason = derivatives(model, twin, found)
    end
    if columns then
      local ones = numeric.map(columns[1], function() return 1 end)
      list[#list + 1] = gain(words, base, rows_of(columns, judged, ones, 1, #ones), judged, worst)
    else
      list[#list + 1] = { words = words, reason = reason }
    end
  end
  table.sort(list, function(a, b)
    local one, other = a.shrinks or math.huge, b.shrinks or math.huge
    return one == other and a.words < b.words or one < other
  end)
  return list
end

advice.check = function(fit)
  for _, values in ipairs(candidates(fit.further or {})) do
    if type(values) ~= "table" or units.is_quantity(values) then
      fault.script("study.fit.further: a list of { speed = ... } or speed = { values }; not %s", tostring(values))
    end
  end
end

return advice
