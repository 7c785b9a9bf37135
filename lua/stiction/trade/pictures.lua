-- Figures of a trade: error against work with the front, and along each number error and work.
local exchange = require "stiction.trade.exchange"
local extrapolation = require "stiction.trade.extrapolation"
local figure = require "stiction.figure"
local numeric = require "stiction.numeric"
local report = require "stiction.report"

local pictures = {}

local least = 1e-12 -- a logarithm has no 0
local hues = { 2, 3, 4, 5, 7 } -- of the front's runs; 6 is black, 1 the front's line

--- Largest uncertainty of a reference, relative.
local function band_of(trade)
  local band = 0
  for _, reference in pairs(trade.references) do
    band = math.max(band, reference.uncertainty / reference.scale)
  end
  return math.max(band, least)
end

--- Errors below a tenth of the uncertainty say nothing and are drawn there.
local function points(label, runs, look, floor)
  return {
    label = label, colour = look.colour, style = look.style or "points",
    x = numeric.map(runs, function(run) return run.work end),
    y = numeric.map(runs, function(run) return math.max(run.error, floor) end),
  }
end

--- What a run changes of the default settings, in words.
local function name_of(trade, run)
  local words = {}
  for i, knob in ipairs(trade.knobs) do
    if run.levels[i] ~= knob.default then
      local value = report.value(knob.levels[run.levels[i]])
      words[#words + 1] = knob.numeric and knob.name .. " " .. value or value
    end
  end
  return #words > 0 and table.concat(words, ", ") or "default"
end

local function kept(runs, test)
  local list = {}
  for _, run in ipairs(runs) do
    if run.error and test(run) then
      list[#list + 1] = run
    end
  end
  return list
end

--- Largest error of every run against its work, log-log; the front joined, the default marked, and the reference's own
--- uncertainty as a line below which nothing is known.
local function exchange_figure(trade)
  local front = kept(trade.runs, function(run) return run.front end)
  local all = kept(trade.runs, function() return true end)
  table.sort(front, function(a, b) return a.work < b.work end)
  table.sort(all, function(a, b) return a.work < b.work end)
  local band = band_of(trade)
  local floor = 0.1 * band
  local curves = {
    points("all settings", all, { colour = 6 }, floor),
    { label = "uncertainty of the reference", x = { all[1].work, all[#all].work }, y = { band, band }, colour = 6,
      style = "dash" },
    points("front:", front, { colour = 1, style = "solid" }, floor),
  }
  for i, run in ipairs(front) do
    curves[#curves + 1] = points(name_of(trade, run), { run }, { colour = hues[(i - 1) % #hues + 1] }, floor)
  end
  if not kept(front, function(run) return run.default end)[1] then
    curves[#curves + 1] = points("default", kept(all, function(run) return run.default end), { colour = 1 }, floor)
  end
  return figure.lines {
    name = "error_and_work", title = "what accuracy costs", legend = "below",
    x = { label = "work, operations", unit = "1", log = true },
    y = { label = "largest relative error", unit = "1", log = true }, curves = curves,
  }
end

--- Along one number: error of each quantity against its resolution, with the observed order in the legend.
local function knob_figure(trade, knob)
  local curves, floor = {}, 0.1 * band_of(trade)
  for i, quantity in ipairs(trade.quantities) do
    local line = exchange.line(trade.knobs, trade.runs, knob, quantity.name)
    local order = extrapolation.order(line)
    curves[i] = {
      label = quantity.name .. (order and (", order %.1f"):format(order) or ""), colour = i, style = "solid",
      x = numeric.map(line, function(level) return level.h end),
      y = numeric.map(line, function(level) return math.max(level.run.errors[quantity.name], floor) end),
    }
  end
  return figure.lines {
    name = "error_" .. knob.name, title = "error along " .. knob.name, legend = "below",
    x = { label = knob.name .. (knob.falls and ", SI" or ", inverse"), unit = "1", log = true },
    y = { label = "relative error", unit = "1", log = true }, curves = curves,
  }
end

local function work_figure(trade)
  local curves = {}
  for _, knob in ipairs(trade.knobs) do
    if knob.numeric then
      local line = exchange.line(trade.knobs, trade.runs, knob, trade.quantities[1].name)
      curves[#curves + 1] = {
        label = knob.name, colour = #curves + 1, style = "solid",
        x = numeric.map(line, function(level) return level.h / line[#line].h end),
        y = numeric.map(line, function(level) return level.work end),
      }
    end
  end
  return #curves > 0 and figure.lines {
    name = "work", title = "work along each number", legend = "below",
    x = { label = "resolution over the finest", unit = "1", log = true }, y = { label = "work", unit = "1", log = true },
    curves = curves,
  }
end

--- All figures of a judged trade.
function pictures.of(trade)
  local list = { exchange_figure(trade) }
  for _, knob in ipairs(trade.knobs) do
    if knob.numeric then
      list[#list + 1] = knob_figure(trade, knob)
    end
  end
  list[#list + 1] = work_figure(trade) or nil
  return list
end

return pictures
