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

--- Points of runs; names: beside them. Errors below the floor stand on it as triangles.
local function points(label, runs, pen, floor, names)
  return {
    label = label, colour = pen.colour, style = pen.style or "points", names = names,
    x = numeric.map(runs, function(run) return run.work end),
    y = numeric.map(runs, function(run) return math.max(run.error, floor) end),
    at_most = numeric.map(runs, function(run) return run.error <= floor end),
  }
end

--- Triangles for the errors that stand on the floor.
local function clamped(label, xs, errors, floor, colour)
  local x = {}
  for i, error in ipairs(errors) do
    x[#x + 1] = error <= floor and xs[i] or nil
  end
  local function each(value)
    return numeric.map(x, function() return value end)
  end
  return #x > 0 and { label = label, x = x, y = each(floor), at_most = each(true), colour = colour, style = "points" } or nil
end

--- Those of runs, to say in the legend what they stand for.
local function below_of(runs, floor)
  return clamped("at most this", numeric.map(runs, function(run) return run.work end),
    numeric.map(runs, function(run) return run.error end), floor, 6)
end

local function letter_of(i)
  return i <= 26 and string.char(96 + i) or tostring(i)
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

--- Largest error of every run against its work, log-log: the front joined, a letter at each of its runs, the default
--- named, and the reference's own uncertainty as a line below which nothing is known.
local function exchange_figure(trade)
  local front, all = kept(trade.runs, function(run) return run.front end), kept(trade.runs, function() return true end)
  table.sort(front, by_work)
  table.sort(all, by_work)
  local floor, longest = floor_of(trade), 0
  local curves = { points("all settings", all, { colour = 6 }, floor) }
  curves[2] = below_of(all, floor)
  curves[#curves + 1] = band_curve(trade, { all[1].work, all[#all].work })
  curves[#curves + 1] = points("front of work and error:", front, { colour = 0, style = "solid" }, floor)
  for i, run in ipairs(front) do
    local letter = letter_of(i)
    local name, pen = name_of(trade, run), { colour = hues[(i - 1) % #hues + 1] }
    longest = math.max(longest, #name)
    curves[#curves + 1] = points(letter .. "  " .. name, { run }, pen, floor, { letter })
  end
  local default = kept(all, function(run) return run.default and not run.front end)[1]
  if default then
    curves[#curves + 1] = points("default", { default }, { colour = 0 }, floor, { "default" })
  end
  return figure.lines {
    name = "error_and_work", title = "what accuracy costs", legend = "below",
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
  local curves, below, extent = {}, {}, nil
  for _, quantity in ipairs(trade.quantities) do
    if not quantity.watched then
      local line = reference.line(trade.knobs, trade.runs, knob, quantity)
      local its = trade.references[quantity.name]
      local floor = floor_under(its.uncertainty / its.scale)
      local h = numeric.map(line, function(level) return level.h end)
      local errors = numeric.map(line, function(level) return level.run.errors[quantity.name] end)
      curves[#curves + 1] = {
        label = quantity.name .. ", " .. order_text(line, quantity, its), colour = #curves, style = "solid",
        x = h, y = numeric.map(errors, function(error) return math.max(error, floor) end),
      }
      local label = #below == 0 and "at most this" or nil
      below[#below + 1] = clamped(label, h, errors, floor, #curves - 1)
      extent = { line[1].h, line[#line].h }
    end
  end
  curves[#curves + 1] = band_curve(trade, extent)
  table.move(below, 1, #below, #curves + 1, curves)
  return figure.lines {
    name = "error_" .. knob.name, title = "error along " .. knob.name, legend = "below", x = resolution_axis(knob),
    y = { label = "relative error", unit = "1", log = true }, curves = curves,
  }
end

--- A range that holds a tick, however near to each other the values are.
local function roomy(values)
  return { numeric.min(values) / 3, numeric.max(values) * 3 }
end

--- All values of one choice, the others by default: error against work, a letter for each in the order of the errors.
local function choice_figure(trade, knob)
  local by_levels, runs = ladder.index(trade.runs), {}
  for level = 1, #knob.levels do
    local run = by_levels[ladder.key(ladder.levels(trade.knobs, { [knob.name] = level }))]
    runs[#runs + 1] = run and run.error and { name = tostring(knob.levels[level]), run = run, level = level } or nil
  end
  table.sort(runs, function(a, b) return a.run.error ~= b.run.error and a.run.error < b.run.error or
    a.run.error == b.run.error and a.level < b.level end)
  local floor = floor_of(trade)
  local curves = { below_of(numeric.map(runs, function(entry) return entry.run end), floor) }
  for i, entry in ipairs(runs) do
    local name = entry.name .. (entry.run.default and entry.name ~= "default" and " (default)" or "")
    curves[#curves + 1] = points(letter_of(i) .. "  " .. name, { entry.run }, { colour = hues[i] or 6 }, floor, { letter_of(i) })
  end
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
