-- stiction sample: how sure results are, given how sure parameters are.
local chaos = require "stiction.sampling.chaos"
local copy = require "stiction.copy"
local drawing = require "stiction.drawing"
local engine = require "stiction.engine"
local fit_spec = require "stiction.fit.spec"
local hold = require "stiction.hold"
local indices = require "stiction.sampling.indices"
local numeric = require "stiction.numeric"
local ordered = require "stiction.ordered"
local output = require "stiction.output"
local pictures = require "stiction.sampling.pictures"
local points_module = require "stiction.points"
local record = require "stiction.sampling.record"
local report = require "stiction.report"
local spec = require "stiction.sampling.spec"
local spread = require "stiction.sampling.spread"
local study_module = require "stiction.study"
local units = require "stiction.units"
local verdict = require "stiction.fit.verdict"

local most_told = 8 -- failed points

--- Values by name of each point, with those that are the same everywhere.
local function values_of(own)
  local list = {}
  if own.list then
    for i, point in ipairs(own.list) do
      list[i] = copy(own.set)
      for name, value in pairs(point) do
        list[i][name] = value
      end
    end
    return list
  end
  own.coordinates = spec.coordinates(own)
  for i, u in ipairs(own.coordinates) do
    list[i] = copy(own.set)
    for k, value in ipairs(spec.values(own, u)) do
      list[i][own.axes[k].name] = fit_spec.quantity(own.axes[k].like, value)
    end
  end
  return list
end

--- Names of all parameters that some point names.
local function names_of(values)
  local seen = {}
  for _, point in ipairs(values) do
    for name in pairs(point) do
      seen[name] = true
    end
  end
  return ordered.keys(seen)
end

--- What the rows give of one result, nil where a case failed.
local function column(rows, name)
  local list = {}
  for i, row in ipairs(rows) do
    local value = row.done and row.result.results[name]
    list[i] = numeric.is_finite(value) and value or false
  end
  return list
end

--- Rows {a, b, {ab1, ...}} of saltelli's design without those in which one failed.
local function saltelli_rows(values, axes)
  local rows, size = {}, axes + 2
  for first = 1, #values, size do
    local row, whole = { values[first], values[first + 1], {} }, true
    for k = 0, size - 1 do
      whole = whole and values[first + k] ~= false
    end
    for k = 1, axes do
      row[3][k] = values[first + 1 + k]
    end
    rows[#rows + 1] = whole and row or nil
  end
  return rows
end

--- Whether the i-th point is a draw of its own: of saltelli's design those of A and B alone.
local function is_draw(own, i)
  return own.design ~= "saltelli" or (i - 1) % (#own.axes + 2) < 2
end

--- The points that are independent draws, with their results and places.
local function independent(own, values)
  local points, list, chosen = {}, {}, {}
  for i, value in ipairs(values) do
    if value and is_draw(own, i) then
      list[#list + 1], chosen[#list + 1] = value, i
      points[#points + 1] = own.coordinates and numeric.map(own.coordinates[i], function(u) return u end)
    end
  end
  return list, points, chosen
end

--- Coordinates as polynomials take them.
local function standard(own, points)
  return numeric.map(points, function(u)
    local x = {}
    for k, axis in ipairs(own.axes) do
      x[k] = axis.kind == "normal" and engine.quantile(u[k]) or u[k]
    end
    return x
  end)
end

--- Slopes of a result over the coordinates that polynomials take, at the points whose values count; nil where one is not known. points:
--- as spec.coordinates gives them.
local function slopes_of(own, entry, rows, points, chosen)
  local step, list = 1e-6, {}
  if own.joint or own.design == "saltelli" then
    return nil
  end
  for i, u in ipairs(points) do
    local row, found = rows[chosen[i]], {}
    for k, axis in ipairs(own.axes) do
      local slope = ((row.result.derivatives or {})[axis.name] or {})[entry.name]
      if not numeric.is_finite(slope) then
        return nil
      end
      local function moved(by)
        local other = table.move(u, 1, #u, 1, {})
        other[k] = u[k] + by
        return spec.values(own, other)[k], axis.kind == "normal" and engine.quantile(other[k]) or other[k]
      end
      local h = math.min(step, u[k] / 2, (1 - u[k]) / 2)
      local above, x_above = moved(h)
      local below, x_below = moved(-h)
      found[k] = slope * (above - below) / (x_above - x_below)
    end
    list[i] = found
  end
  return list
end

--- What is said of one result.
local function judge(own, entry, rows)
  local values = column(rows, entry.name)
  local list, points, chosen = independent(own, values)
  local result = { name = entry.name, unit = entry.unit, meaning = entry.meaning, values = values, failed = #values, entry = entry }
  for _, value in ipairs(values) do
    result.failed = result.failed - (value and 1 or 0)
  end
  if #list < 2 then
    return result
  end
  result.moments, result.quantiles = spread.moments(list), spread.quantiles(list)
  if own.list then
    return result
  end
  if own.design == "saltelli" and not own.joint and chaos.varies(list) then
    local of = saltelli_rows(values, #own.axes)
    result.indices = #of > 1 and indices.of(of, #own.axes) or nil
  end
  local polynomial = chaos.of(standard(own, points), list, numeric.map(own.axes, function(axis) return axis.kind end),
    slopes_of(own, entry, rows, points, chosen))
  if polynomial and own.joint then
    polynomial.first, polynomial.total = nil, nil -- of parameters that depend on each other there are none
  end
  result.chaos = polynomial
  return result
end

--- Failed points: {values =, reason =}, and along which parameters they lie, as independent draws tell it.
local function failures(own, rows, values)
  local list, coordinates = {}, {}
  for i, row in ipairs(rows) do
    if not row.done then
      list[#list + 1] = { values = values[i], reason = points_module.reason(row), case = row.case.id }
      coordinates[#coordinates + 1] = own.coordinates and is_draw(own, i) and own.coordinates[i] or nil
    end
  end
  return list, spread.where(coordinates)
end

--- A point in words, each value in the unit that the study wrote its distribution in.
local function words_of(values, own)
  local names = own.list and ordered.keys(values) or numeric.map(own.axes, function(axis) return axis.name end)
  return table.concat(numeric.map(names, function(name)
    local at = numeric.first_where(own.axes, function(axis) return axis.name == name end)
    return ("%s = %s"):format(name, at and verdict.words(own.axes[at], units.si(values[name]), 10) or report.value(values[name]))
  end), ", ")
end

local function show_failures(own, found)
  if #found.failures == 0 then
    return
  end
  report.line("%d of %d cases failed; they are in no number below, which is then of the others alone:", #found.failures, found.count)
  for i = 1, math.min(most_told, #found.failures) do
    report.line("  %s: %s", words_of(found.failures[i].values, own), found.failures[i].reason)
  end
  if #found.failures > most_told then
    report.line("  and %d more: sample.json", #found.failures - most_told)
  end
  for _, place in ipairs(found.where) do
    report.line("they lie at %s %s: between %.2g and %.2g of its distribution (chance %.2g)", place.side, own.axes[place.axis].name,
      place.from, place.to, place.chance)
  end
end

local function plus_minus(entry, value, error)
  return report.in_unit(entry, value) .. " +- " .. report.in_unit(entry, error, 2)
end

local function show_results(found)
  local rows = { { "result", "mean", "deviation", "5 %", "median", "95 %", "polynomial off by/%" } }
  for _, own in ipairs(found.results) do
    if own.moments then
      local q = own.quantiles
      rows[#rows + 1] = { report.head(own.entry), plus_minus(own.entry, own.moments.mean, own.moments.mean_error),
        plus_minus(own.entry, own.moments.deviation, own.moments.deviation_error), report.in_unit(own.entry, q[1].value),
        report.in_unit(own.entry, q[3].value), report.in_unit(own.entry, q[5].value),
        own.chaos and ("%.2g"):format(100 * own.chaos.error) or "-" }
    else
      rows[#rows + 1] = { report.head(own.entry), "-", "-", "-", "-", "-", "-" }
    end
  end
  report.line()
  report.table(rows)
end

--- First and total indices with what they may be off by: by Saltelli's rows where there are any, else by the polynomial.
local function show_indices(own, found)
  local rows = { { "share of variance", "parameter", "alone", "with others", "by" } }
  for _, result in ipairs(found.results) do
    local its = result.indices or result.chaos
    if its and not its.first and not own.joint then
      rows[#rows + 1] = { result.name, "-", "-", "-", "it does not vary" }
    end
    for k, axis in ipairs(its and its.first and own.axes or {}) do
      local function word(values, errors)
        return ("%.3f"):format(values[k]) .. (errors and (" +- %.2g"):format(errors[k]) or "")
      end
      rows[#rows + 1] = { k == 1 and result.name or "", axis.name, word(its.first, its.first_error), word(its.total, its.total_error),
        result.indices and "pairs of points" or "polynomial" }
    end
  end
  if #rows > 1 then
    report.line()
    report.table(rows)
  end
  if own.joint then
    report.line("parameters of a fit depend on each other, so that no share of the variance is one of theirs; their spread here is that "
      .. "of the data, without the simulation's own error")
  end
end

--- What of a fit is drawn, of which curve, and what is not.
local function show_fit(own)
  local fit = own.fit or { axes = {}, left_out = {}, held = {}, otherwise = {} }
  local rows = { { "of the fit", "best", "+-/%", "of the curve" } }
  for _, axis in ipairs(own.axes) do
    rows[#rows + 1] = axis.joint and { axis.name, axis.shown, ("%.2g"):format(100 * axis.relative_error), axis.curve or "all" } or nil
  end
  for _, entry in ipairs(fit.held) do
    rows[#rows + 1] = { entry.name, entry.shown, "held at its bound", entry.curve or "all" }
  end
  if #rows > 1 then
    report.table(rows)
  end
  for _, axis in ipairs(fit.asked and {} or own.axes) do
    if axis.curve then
      report.line("remark: %s is the curve %s's own, and no other curve's; every point takes it", axis.name, axis.curve)
    end
  end
  if #fit.otherwise > 0 then
    report.line("not as the fit has it, but as sample.of or sample.set say: %s", table.concat(fit.otherwise, ", "))
  end
  if #fit.left_out > 0 then
    report.line("left out, as no case has it (the fit's `against` alone reads it): %s", table.concat(fit.left_out, ", "))
  end
end

local function run(own, study, options, folder)
  local values = values_of(own)
  local names = names_of(values)
  local points = points_module.open(study, options, folder, names)
  report.line("%d points of %s", #values, own.list and "a list" or own.design)
  show_fit(own)
  local found = { folder = folder, values = values, names = names, count = #values }
  found.rows = points:run(values)
  found.results = numeric.map(own.results, function(entry) return judge(own, entry, found.rows) end)
  found.failures, found.where = failures(own, found.rows, values)
  record.write(own, study, options, found)
  show_failures(own, found)
  show_results(found)
  show_indices(own, found)
  report.line("%d case%s, %d of them run now, %d kept", #points.rows, #points.rows == 1 and "" or "s", points.ran, points.known)
  local drawn = options.no_figures or drawing.draw({ figures = function() return pictures.of(own, found) end }, {}, folder)
  report.line("output: %s", folder)
  return drawn and #found.failures == 0 and 0 or 1
end

--- Samples a study; the exit code: 1 if a case failed.
return function(options)
  options = copy(options)
  local study = study_module.load(options.study, options.trust)
  local folder = options.out or output.folder(study, options) .. "/sample"
  local own = spec.read(study, options)
  return hold.folder(folder, study, "sample", run, own, study, options, folder)
end
