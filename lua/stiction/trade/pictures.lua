-- Figures of a trade: error against work with the front named, along each number error and work, and each choice.
local engine = require "stiction.engine"
local figure = require "stiction.figure"
local ladder = require "stiction.ladder"
local numeric = require "stiction.numeric"
local reference = require "stiction.trade.reference"
local report = require "stiction.report"
local units = require "stiction.units"

local pictures = {}

local hues = { 2, 3, 4, 5, 1 } -- of what is named; 6 is black, 0 the front's line
local most_letters = 34 -- of a name beside a figure of single width
local no_effect = 1e-6 -- of the scale: a knob that changes less has no order
local operations = { label = "work, operations", unit = "1", log = true }

--- Largest uncertainty of a reference that is judged, relative; 0 where all are known exactly.
local function band_of(trade)
  local band = 0
  for _, quantity in ipairs(trade.quantities) do
    local its = trade.references[quantity.name]
    band = math.max(band, quantity.watched and 0 or its.uncertainty / its.scale)
  end
  return band
end

--- Errors below a tenth of the relative uncertainty say nothing and are drawn there; a logarithm has no 0.
local function floor_under(band)
  return band > 0 and 0.1 * band or 1e-6
end

local function floor_of(trade)
  return floor_under(band_of(trade))
end

--- The uncertainty of the reference over x, nothing where there is none.
local function band_curve(trade, x)
  local band = band_of(trade)
  local curve = { label = "uncertainty of the reference", x = x, y = { band, band }, colour = 6, style = "dash" }
  return band > 0 and curve or nil
end

local function points(label, runs, pen, floor)
  return {
    label = label, colour = pen.colour, style = pen.style or "points",
    x = numeric.map(runs, function(run) return run.work end),
    y = numeric.map(runs, function(run) return math.max(run.error, floor) end),
  }
end

--- What a run changes of the default settings, in a few words.
local function name_of(trade, run)
  local words = {}
  for i, knob in ipairs(trade.knobs) do
    if run.levels[i] ~= knob.default then
      local value = report.value(knob.levels[run.levels[i]])
      words[#words + 1] = knob.numeric and knob.label .. " " .. value or value
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

local function by_work(a, b)
  return a.work < b.work
end

--- Largest error of every run against its work, log-log: the front joined, a letter over each of its runs, the default
--- marked, and the reference's own uncertainty as a line below which nothing is known.
local function exchange_figure(trade)
  local front, all = kept(trade.runs, function(run) return run.front end), kept(trade.runs, function() return true end)
  table.sort(front, by_work)
  table.sort(all, by_work)
  local floor, marks, longest = floor_of(trade), {}, 0
  local curves = { points("all settings", all, { colour = 6 }, floor) }
  curves[#curves + 1] = band_curve(trade, { all[1].work, all[#all].work })
  curves[#curves + 1] = points("front of work and error:", front, { colour = 0, style = "solid" }, floor)
  for i, run in ipairs(front) do
    local letter = string.char(96 + i)
    local name, pen = name_of(trade, run), { colour = hues[(i - 1) % #hues + 1] }
    longest = math.max(longest, #name)
    curves[#curves + 1] = points(letter .. "  " .. name, { run }, pen, floor)
    marks[i] = { x = run.work, label = run.default and letter .. ", default" or letter }
  end
  local default = kept(all, function(run) return run.default and not run.front end)[1]
  if default then
    marks[#marks + 1] = { x = default.work, label = "default" }
    curves[#curves + 1] = points("default", { default }, { colour = 0 }, floor)
  end
  return figure.lines {
    name = "error_and_work", title = "what accuracy costs", legend = "below", marks = marks,
    width = longest > most_letters and "double" or nil,
    x = operations, y = { label = "largest relative error", unit = "1", log = true }, curves = curves,
  }
end

local function unit_of(knob)
  local level = knob.levels[1]
  if not units.is_quantity(level) then
    return "1"
  end
  return engine.dimension_text(level.metre, level.kilogram, level.second)
end

--- Axis of a number's resolution: itself where it falls, else its inverse.
local function resolution_axis(knob)
  local label = knob.falls and knob.name or "1 / " .. knob.name
  return { label = label, unit = knob.falls and unit_of(knob) or "1", log = true }
end

--- "order 1.9", or why there is none.
local function order_text(line, quantity, its)
  local a, b = line[#line - 1], line[#line]
  if a and math.abs(b.value - a.value) <= no_effect * its.scale then
    return "no effect"
  end
  local order = reference.order(line, quantity)
  return order and ("order %.1f"):format(order) or "no order"
end

--- Along one number: error of each judged quantity against its resolution, with the observed order in the legend.
local function knob_figure(trade, knob)
  local curves, extent = {}, nil
  for _, quantity in ipairs(trade.quantities) do
    if not quantity.watched then
      local line = reference.line(trade.knobs, trade.runs, knob, quantity)
      local its = trade.references[quantity.name]
      local floor = floor_under(its.uncertainty / its.scale)
      curves[#curves + 1] = {
        label = quantity.name .. ", " .. order_text(line, quantity, its), colour = #curves, style = "solid",
        x = numeric.map(line, function(level) return level.h end),
        y = numeric.map(line, function(level) return math.max(level.run.errors[quantity.name], floor) end),
      }
      extent = { line[1].h, line[#line].h }
    end
  end
  curves[#curves + 1] = band_curve(trade, extent)
  return figure.lines {
    name = "error_" .. knob.name, title = "error along " .. knob.name, legend = "below", x = resolution_axis(knob),
    y = { label = "relative error", unit = "1", log = true }, curves = curves,
  }
end

--- A range that holds a tick, however near to each other the values are.
local function roomy(values)
  return { numeric.min(values) / 3, numeric.max(values) * 3 }
end

--- All values of one choice, the others by default: error against work, the five least errors named.
local function choice_figure(trade, knob)
  local by_levels, runs = ladder.index(trade.runs), {}
  for level = 1, #knob.levels do
    local run = by_levels[ladder.key(ladder.levels(trade.knobs, { [knob.name] = level }))]
    runs[#runs + 1] = run and run.error and { name = tostring(knob.levels[level]), run = run, level = level } or nil
  end
  table.sort(runs, function(a, b) return a.run.error ~= b.run.error and a.run.error < b.run.error or
    a.run.error == b.run.error and a.level < b.level end)
  local curves, others, floor = {}, {}, floor_of(trade)
  for i, entry in ipairs(runs) do
    local name = entry.name .. (entry.run.default and entry.name ~= "default" and " (default)" or "")
    if i <= #hues or entry.run.default then
      curves[#curves + 1] = points(name, { entry.run }, { colour = i <= #hues and hues[i] or 0 }, floor)
    else
      others[#others + 1] = entry.run
    end
  end
  curves[#curves + 1] = #others > 0 and points("others", others, { colour = 6 }, floor) or nil
  if #runs == 0 then
    return nil
  end
  local work = numeric.map(runs, function(entry) return entry.run.work end)
  local errors = numeric.map(runs, function(entry) return math.max(entry.run.error, floor) end)
  return figure.lines {
    name = "choice_" .. knob.name, title = "choice of " .. knob.name, legend = "below", curves = curves,
    x = { label = operations.label, unit = "1", log = true, range = roomy(work) },
    y = { label = "largest relative error", unit = "1", log = true, range = roomy(errors) },
  }
end

local function work_figure(trade)
  local curves = {}
  for _, knob in ipairs(trade.knobs) do
    if knob.numeric then
      local line = reference.line(trade.knobs, trade.runs, knob, trade.quantities[1])
      curves[#curves + 1] = {
        label = knob.name, colour = #curves, style = "solid",
        x = numeric.map(line, function(level) return level.h / line[#line].h end),
        y = numeric.map(line, function(level) return level.work end),
      }
    end
  end
  return #curves > 0 and figure.lines {
    name = "work", title = "work along each number", legend = "below",
    x = { label = "resolution / the finest", unit = "1", log = true }, y = operations, curves = curves,
  } or nil
end

--- All figures of a judged trade.
function pictures.of(trade)
  local list = { exchange_figure(trade) }
  for _, knob in ipairs(trade.knobs) do
    list[#list + 1] = (knob.numeric and knob_figure or choice_figure)(trade, knob)
  end
  list[#list + 1] = work_figure(trade)
  return list
end

return pictures
