-- Figures of a trade: error against work with the front, and along each number error and work.
local exchange = require "stiction.trade.exchange"
local extrapolation = require "stiction.trade.extrapolation"
local figure = require "stiction.figure"
local numeric = require "stiction.numeric"

local pictures = {}

local floor = 1e-6 -- errors below are drawn there, a logarithm has no 0

local function shown(error)
  return math.max(error, floor)
end

local function points(label, runs, colour, style)
  return {
    label = label, colour = colour, style = style,
    x = numeric.map(runs, function(run) return run.work end),
    y = numeric.map(runs, function(run) return shown(run.error) end),
  }
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
  table.sort(front, function(a, b) return a.work < b.work end)
  local all = kept(trade.runs, function() return true end)
  local low, high = math.huge, 0
  for _, run in ipairs(all) do
    low, high = math.min(low, run.work), math.max(high, run.work)
  end
  local band = 0
  for _, reference in pairs(trade.references) do
    band = math.max(band, reference.uncertainty / reference.scale)
  end
  return figure.lines {
    name = "error_and_work", title = "what accuracy costs", legend = "below",
    x = { label = "work", unit = "1", log = true }, y = { label = "largest relative error", unit = "1", log = true },
    curves = {
      points("all settings", all, 1, "points"), points("front", front, 2, "solid"),
      points("default", kept(trade.runs, function(run) return run.default end), 3, "points"),
      { label = "uncertainty of the reference", x = { low, high }, y = { shown(band), shown(band) }, colour = 4,
        style = "dash" },
    },
  }
end

--- Along one number: error of each quantity against its resolution, with the observed order in the legend.
local function knob_figure(trade, knob)
  local curves = {}
  for i, quantity in ipairs(trade.quantities) do
    local line = exchange.line(trade.knobs, trade.runs, knob, quantity.name)
    local order = extrapolation.order(line)
    curves[i] = {
      label = quantity.name .. (order and (", order %.1f"):format(order) or ""), colour = i, style = "solid",
      x = numeric.map(line, function(level) return level.h end),
      y = numeric.map(line, function(level) return shown(level.run.errors[quantity.name]) end),
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
