-- What the page on a study says of its fit and its sample, from their files.
local html = require "stiction.html"
local numeric = require "stiction.numeric"
local ordered = require "stiction.ordered"
local output = require "stiction.output"

local fit_page = {}

local function list_of(value)
  return type(value) == "table" and value or {}
end

local function number(value, digits)
  return type(value) == "number" and ("%%.%dg"):format(digits or 5):format(value) or "-"
end

local function share(value)
  return type(value) == "number" and ("%.2g %%"):format(100 * value) or "-"
end

local function ends(interval, bound)
  local own = list_of(interval)
  local function word(side)
    return own[side] and number(own[side]) or bound == side and "at its bound" or "open"
  end
  return interval and ("%s .. %s"):format(word("low"), word("high")) or "-"
end

local function lines(list, class)
  local items = numeric.map(list, function(text) return ("<li>%s</li>"):format(html.plain(text)) end)
  return #items > 0 and ("<ul%s>%s</ul>"):format(class or "", table.concat(items, "\n")) or ""
end

local function parameters_of(fit)
  local rows = {}
  for _, own in ipairs(numeric.map(list_of(fit.parameters), list_of)) do
    local interval = list_of(own.interval)
    rows[#rows + 1] = { tostring(own.name), number(own.best), tostring(own.unit), ends(own.interval and interval, interval.bound),
      ends(own.interval and list_of(interval.statistical), interval.bound), number(own.simulation_error, 2), tostring(own.verdict) }
  end
  return html.rows(rows, { "parameter", "best", "unit (SI)", "95 %, as claimed", "of the data alone", "simulation's own error", "verdict" })
end

local function correlations_of(fit)
  local names, rows = list_of(fit.free), {}
  for i, row in ipairs(list_of(fit.correlations)) do
    rows[i] = { tostring(names[i]) }
    for j, value in ipairs(list_of(row)) do
      rows[i][j + 1] = ("%.2f"):format(tonumber(value) or 0 / 0)
    end
  end
  local heading = table.move(numeric.map(names, tostring), 1, #names, 2, { "correlations" })
  local values = table.concat(numeric.map(list_of(fit.eigenvalues), function(x) return number(x, 3) end), ", ")
  return html.rows(rows, heading) .. ("<p>Eigenvalues of the information, in relative changes of the parameters: %s.</p>"):format(
    html.plain(values))
end

local function advice_of(fit)
  local rows = {}
  for _, own in ipairs(numeric.map(list_of(fit.further), list_of)) do
    rows[#rows + 1] = { tostring(own.measurement), own.reason and tostring(own.reason) or number(own.bits, 2),
      own.error_becomes and ("%s of what it is (%s)"):format(number(own.error_becomes, 2), tostring(own.of)) or "-" }
  end
  return #rows > 0 and "<h3>Further measurements</h3>" .. html.rows(rows, { "measurement", "bits", "worst known error becomes" }) or ""
end

--- The body of a fit's section, "" where the folder has none.
function fit_page.fit(folder)
  local fit = output.read_file(folder .. "/fit.json")
  if not fit then
    return ""
  end
  local bad = fit.rejected and ' class="bad"' or ""
  return lines(list_of(fit.says), bad) .. parameters_of(fit)
    .. ("<p>Squares %s, %s degrees of freedom; %s cases, %s of them of the search.</p>"):format(number(fit.squares, 6),
      number(fit.degrees_of_freedom), number(fit.cases), number(fit.cases_of_search)) .. correlations_of(fit) .. advice_of(fit)
end

local function moments_of(sample)
  local rows = {}
  for _, own in ipairs(numeric.map(list_of(sample.results), list_of)) do
    local m, quantiles = list_of(own.moments), {}
    for i, q in ipairs(numeric.map(list_of(own.quantiles), list_of)) do
      quantiles[i] = ("%s: %s"):format(share(q.level), number(q.value))
    end
    rows[#rows + 1] = { tostring(own.name), ("%s \u{b1} %s"):format(number(m.mean), number(m.mean_error, 2)),
      ("%s \u{b1} %s"):format(number(m.deviation), number(m.deviation_error, 2)), table.concat(quantiles, "; "),
      share(list_of(own.polynomial).error) }
  end
  return html.rows(rows, { "result (SI)", "mean", "standard deviation", "quantiles", "polynomial off by" })
end

local function shares_of(sample)
  local rows = {}
  for _, own in ipairs(numeric.map(list_of(sample.results), list_of)) do
    local its = list_of(own.indices or list_of(own.polynomial).indices)
    for _, name in ipairs(ordered.keys(list_of(its.first))) do
      rows[#rows + 1] = { tostring(own.name), name, number(its.first[name], 3), number(list_of(its.total)[name], 3) }
    end
  end
  return #rows > 0 and "<h3>Whose the variance is</h3>" .. html.rows(rows, { "result", "parameter", "alone", "with others" }) or ""
end

--- What is drawn as a fit has it.
local function drawn_of(sample)
  local rows = {}
  for _, own in ipairs(numeric.map(list_of(sample.drawn), list_of)) do
    rows[#rows + 1] = { tostring(own.name), number(own.best), own.held and "held at its bound" or share(own.relative_error),
      own.curve and tostring(own.curve) or "all" }
  end
  return #rows > 0 and html.rows(rows, { "of the fit (SI)", "best", "standard error", "of the curve" }) or ""
end

--- The body of a sample's section, "" where the folder has none.
function fit_page.sample(folder)
  local sample = output.read_file(folder .. "/sample.json")
  if not sample then
    return ""
  end
  local failed = {}
  for _, entry in ipairs(numeric.map(list_of(sample.failed), list_of)) do
    failed[#failed + 1] = ("%s: %s"):format(tostring(entry.case), tostring(entry.reason))
  end
  for _, place in ipairs(numeric.map(list_of(sample.failed_lie), list_of)) do
    failed[#failed + 1] = ("failed cases lie at %s %s"):format(tostring(place.side), tostring(place.parameter))
  end
  return ("<p>%s points of %s.</p>"):format(number(sample.points), html.plain(sample.design)) .. lines(failed, ' class="bad"')
    .. drawn_of(sample) .. moments_of(sample) .. shares_of(sample)
end

return fit_page
