-- Figures of a sample: how each result is spread, how it goes with each parameter, whose its variance is.
local figure = require "stiction.figure"
local numeric = require "stiction.numeric"
local units = require "stiction.units"

local pictures = {}

local function kept(result, list)
  local own = {}
  for i, value in ipairs(result.values) do
    own[#own + 1] = value and list[i] or nil
  end
  return own
end

--- The share of points below each value.
local function spread_figure(result)
  local values = kept(result, result.values)
  table.sort(values)
  local share = {}
  for i in ipairs(values) do
    share[i] = (i - 0.5) / #values
  end
  local curves = { { label = "of all points", x = values, y = share } }
  for i, q in ipairs(result.quantiles) do
    curves[i + 1] = { label = i == 1 and "95 % intervals" or nil, x = { q.low or values[1], q.high or values[#values] },
      y = { q.level, q.level }, colour = 1 }
  end
  curves[#curves + 1] = { label = "quantiles", x = numeric.map(result.quantiles, function(q) return q.value end),
    y = numeric.map(result.quantiles, function(q) return q.level end), style = "points", colour = 1 }
  return figure.lines { name = "spread_" .. result.name, title = "spread of " .. result.name, legend = "below",
    x = { label = result.meaning ~= "" and result.meaning or result.name, unit = result.unit }, y = { label = "share of points below" },
    curves = curves }
end

local function parameters_of(own, found)
  return own.list and found.names or numeric.map(own.axes, function(axis) return axis.name end)
end

--- A result over each parameter that is a number.
local function scatter_figure(own, found, result)
  local parts = {}
  for place, name in ipairs(parameters_of(own, found)) do
    local like = own.axes[place] and own.axes[place].like
    local list = {}
    for i, values in ipairs(found.values) do -- a point of a list need not name all: the case has the study's own
      list[i] = values[name] == nil and found.rows[i].case.p[name] or values[name]
    end
    local first = units.is_quantity(like) and like or list[1]
    if type(units.si(first)) == "number" then
      local unit = units.is_quantity(first) and select(2, first:display()) or "1"
      parts[#parts + 1] = figure.lines { legend = "none", x = { label = name, unit = unit },
        y = { label = result.name, unit = result.unit },
        curves = { { style = "points", colour = 0, x = kept(result, numeric.map(list, units.si)), y = kept(result, result.values) } } }
    end
  end
  return #parts > 0 and figure.panel { name = "over_" .. result.name, title = result.name .. " over the parameters",
    columns = math.min(2, #parts), figures = parts } or nil
end

local function index_figure(own, result)
  local its = result.indices or result.chaos
  if not its or not its.first then
    return nil
  end
  local places = numeric.map(own.axes, function() return 0 end)
  local names = {}
  for k, axis in ipairs(own.axes) do
    places[k], names[k] = k, axis.name
  end
  return figure.lines { name = "shares_" .. result.name, title = "whose the variance of " .. result.name .. " is", legend = "below",
    x = { label = "parameter", range = { 0.5, #places + 0.9 } }, y = { label = "share of the variance" },
    curves = { { label = "alone", x = places, y = its.first, error = its.first_error, style = "points", colour = 0 },
      { label = "with others", x = numeric.map(places, function(k) return k + 0.08 end), y = its.total, error = its.total_error,
        style = "points", colour = 1, names = names } } }
end

--- All figures of a sample.
function pictures.of(own, found)
  local list = {}
  for _, result in ipairs(found.results) do
    if result.moments then
      list[#list + 1] = spread_figure(result)
      list[#list + 1] = scatter_figure(own, found, result)
      list[#list + 1] = index_figure(own, result)
    end
  end
  return list
end

return pictures
