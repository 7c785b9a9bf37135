-- Figures of a fit: data and model, residuals, profiles, correlations, the way of the search.
local figure = require "stiction.figure"
local numeric = require "stiction.numeric"
local verdict = require "stiction.fit.verdict"

local pictures = {}

local most_colours = 6
local margin = 0.05 -- beside the profiles
local highest = 4 -- in standard errors, that profiles are drawn to

--- What the model may be off by at each point of a curve, as the parameters are uncertain: half widths in SI.
local function band(fit, result, curve)
  local judged, list = result.judged, {}
  local slopes = numeric.map(judged.free, function(k)
    return curve:coloured(table.move(result.found.J[k], curve.first, curve.last, 1, {}))
  end)
  for n = 1, #curve.x do
    local sum = 0
    for i, k in ipairs(judged.free) do
      for j, l in ipairs(judged.free) do
        sum = sum + slopes[i][n] / judged.slopes[k] * judged.covariance[i][j] * slopes[j][n] / judged.slopes[l]
      end
    end
    list[n] = judged.t * math.sqrt(math.max(sum, 0) / curve.weight) * curve.sigma[n]
  end
  return list, fit
end

--- Curves with axes in common: {{x =, y =, curves = {places}}}.
local function groups(fit)
  local list, by_axes = {}, {}
  for i, curve in ipairs(fit.curves) do
    local key = table.concat({ curve.x_name, curve.x_word, curve.y_name, curve.y_word }, "|")
    if not by_axes[key] then
      by_axes[key] = { x = { label = curve.x_name, unit = curve.x_word }, y = { label = curve.y_name, unit = curve.y_word }, curves = {} }
      list[#list + 1] = by_axes[key]
    end
    table.insert(by_axes[key].curves, i)
  end
  return list
end

local function name_of(base, i, count)
  return count > 1 and ("%s_%d"):format(base, i) or base
end

local function sum(list, other, sign)
  local own = {}
  for i, x in ipairs(list) do
    own[i] = x + sign * other[i]
  end
  return own
end

local function data_figure(fit, result, group, name)
  local curves = {}
  for place, i in ipairs(group.curves) do
    local curve, colour = fit.curves[i], (place - 1) % most_colours
    local model, half = result.found.at.curves[i], band(fit, result, fit.curves[i])
    curves[#curves + 1] = { label = curve.name, x = curve.x, y = curve.y, error = curve.sigma, style = "points", colour = colour }
    curves[#curves + 1] = { label = place == 1 and "model" or nil, x = curve.x, y = model, colour = colour }
    for _, sign in ipairs { -1, 1 } do
      local label = place == 1 and sign < 0 and "95 % of the model" or nil
      curves[#curves + 1] = { label = label, x = curve.x, y = sum(model, half, sign), style = "dot", colour = colour }
    end
  end
  return figure.lines { name = name, title = "data and model", x = group.x, y = group.y, curves = curves, legend = "below",
    width = "double" }
end

local function residual_figure(fit, result, group, name)
  local curves, least, most, white = {}, math.huge, -math.huge, ""
  for place, i in ipairs(group.curves) do
    local curve, list = fit.curves[i], {}
    for n = curve.first, curve.last do
      list[#list + 1] = result.found.at.r[n]
    end
    white = (curve.common or white ~= "") and ", each without what it shares with those before" or ""
    least, most = math.min(least, curve.x[1]), math.max(most, curve.x[#curve.x])
    curves[#curves + 1] = { label = curve.name, x = curve.x, y = list, style = "points", colour = (place - 1) % most_colours }
  end
  for _, level in ipairs { -2, 0, 2 } do
    curves[#curves + 1] = { x = { least, most }, y = { level, level }, style = level == 0 and "solid" or "dash", colour = 6 }
  end
  return figure.lines { name = name, title = "residuals" .. white, x = group.x, y = { label = "(model - data) / standard error" },
    curves = curves, legend = "below", width = "double" }
end

local function profile_figure(fit, result, k)
  local own, profile, interval = fit.parameters[k], result.profiles[k], result.intervals[k]
  local _, unit = verdict.shown(own, 1)
  local x, y = {}, {}
  local function add(value, excess)
    local root = math.sqrt(math.max(excess, 0)) / (result.judged.stretch or 1) -- straight where the model is linear
    if root <= highest then
      x[#x + 1], y[#y + 1] = value, root
    end
  end
  local done = false
  for _, point in ipairs(profile.points) do
    if not done and point.value > result.judged.values[k] then
      add(result.judged.values[k], 0)
      done = true
    end
    add(point.value, point.excess)
  end
  if not done then
    add(result.judged.values[k], 0)
  end
  local marks, low, high = {}, x[1], x[#x]
  for _, value in ipairs { interval.statistical.low or false, interval.statistical.high or false } do
    marks[#marks + 1] = value and { x = value, label = "" } or nil
    low, high = math.min(low, value or low), math.max(high, value or high)
  end
  local t, over = result.judged.t, result.judged.stretch and " / root of chi square each" or ""
  return figure.lines { title = own.name, x = { label = own.name, unit = unit ~= "" and unit or "1",
    range = { low - margin * (high - low), high + margin * (high - low) } },
    y = { label = "root of the rise of squares" .. over }, marks = marks, legend = "none",
    curves = { { x = x, y = y, style = "solid", colour = 0 }, { x = x, y = y, style = "points", colour = 0 },
      { x = { low, high }, y = { t, t }, style = "dash", colour = 6 } } }
end

local kinds = {
  { letter = "N", label = "-1 to -0.9", colour = 1 }, { letter = "n", label = "-0.9 to -0.5", colour = 4 },
  { letter = "o", label = "-0.5 to 0.5", colour = 6 }, { letter = "p", label = "0.5 to 0.9", colour = 2 },
  { letter = "P", label = "0.9 to 1", colour = 0 },
}

local function kind_of(x)
  return x < -0.9 and "N" or x < -0.5 and "n" or x <= 0.5 and "o" or x <= 0.9 and "p" or "P"
end

local function correlation_figure(fit, judged)
  local columns, rows = {}, {}
  for i, k in ipairs(judged.free) do
    columns[i] = fit.parameters[k].name
    local cells = numeric.map(judged.correlations[i], kind_of)
    cells[i] = "."
    rows[i] = { group = "of", label = fit.parameters[k].name, cells = table.concat(cells) }
  end
  return figure.map { name = "correlations", title = "correlations of the parameters", columns = columns,
    kinds = kinds, rows = rows }
end

local function search_figure(fit, result)
  local curves, numbers, squares = {}, {}, {}
  local tracks = numeric.map(fit.parameters, function() return { x = {}, y = {} } end)
  for i, entry in ipairs(result.log) do
    if entry.cost and (entry.word == "start" or entry.word == "step") then
      numbers[#numbers + 1], squares[#squares + 1] = i, entry.cost
      for k, value in ipairs(entry.values) do
        local best = result.judged.values[k]
        table.insert(tracks[k].x, i)
        table.insert(tracks[k].y, fit.parameters[k].log and value / best or (value - best) / result.judged.sizes[k] + 1)
      end
    end
  end
  for k, own in ipairs(fit.parameters) do
    curves[k] = { label = own.name, x = tracks[k].x, y = tracks[k].y, colour = (k - 1) % most_colours }
  end
  return figure.panel { name = "search", title = "the search", columns = 2, figures = {
    figure.lines { x = { label = "evaluation" }, y = { label = "squares", log = true }, legend = "none",
      curves = { { x = numbers, y = squares }, { x = numbers, y = squares, style = "points", colour = 0 } } },
    figure.lines { x = { label = "evaluation" }, y = { label = "parameter / best" }, curves = curves } } }
end

--- All figures of a fit.
function pictures.of(fit, result)
  local list, parts, judged = {}, groups(fit), result.judged
  for i, group in ipairs(parts) do
    list[#list + 1] = data_figure(fit, result, group, name_of("data", i, #parts))
    list[#list + 1] = residual_figure(fit, result, group, name_of("residuals", i, #parts))
  end
  local profiles = {}
  for k in ipairs(fit.parameters) do
    profiles[#profiles + 1] = result.profiles and result.profiles[k] and profile_figure(fit, result, k) or nil
  end
  if #profiles > 0 then
    list[#list + 1] = figure.panel { name = "profiles", title = "profile likelihood", columns = math.min(2, #profiles), figures = profiles }
  end
  if #judged.free > 1 then
    list[#list + 1] = correlation_figure(fit, judged)
  end
  list[#list + 1] = search_figure(fit, result)
  return list
end

return pictures
