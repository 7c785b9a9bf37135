-- stiction compare: what differs between two output folders, and by how much.
local comparison = require "stiction.comparison"
local fault = require "stiction.fault"
local outcomes = require "stiction.outcomes"
local report = require "stiction.report"

local most = 20 -- lines of a kind without --all
local widest = 50

local function cut(text)
  return #text > widest and text:sub(1, widest - 3) .. "..." or text
end

--- The first rows, or all; how to see the others.
local function show_rows(head, rows, options)
  local shown = { head }
  table.move(rows, 1, options.all and #rows or math.min(#rows, most), 2, shown)
  report.line()
  report.table(shown)
  if #rows > #shown - 1 then
    report.line("and %d more: --all", #rows - #shown + 1)
  end
end

local function show_alone(letter, cases, options)
  local names = {}
  for i = 1, options.all and #cases or math.min(#cases, most) do
    names[i] = cases[i].name
  end
  if #cases > 0 then
    report.line("only in %s (%d): %s%s", letter, #cases, table.concat(names, ", "),
      #names < #cases and ", ... (--all)" or "")
  end
end

local function cases_of(number)
  return ("%d case%s"):format(number, number == 1 and "" or "s")
end

local function show_matches(matched)
  local by_name = 0
  for _, pair in ipairs(matched) do
    by_name = by_name + (pair.by == "name" and 1 or 0)
  end
  report.line("%s matched by their parameters, %d by their names%s", cases_of(#matched - by_name), by_name,
    by_name > 0 and " (their parameters differ)" or "")
end

local function show_settings(differing, count, options)
  local rows = {}
  for i, one in ipairs(differing) do
    local where = #one.cases == count and "all" or #one.cases == 1 and one.cases[1] or ("%d cases"):format(#one.cases)
    rows[i] = { one.kind .. " " .. one.name, cut(one.a), cut(one.b), where }
  end
  if #rows == 0 then
    return report.line("parameters, settings, files and program are the same")
  end
  show_rows({ "differs", "A", "B", "in" }, rows, options)
end

local function result_row(one, bounds)
  local words = { one.case, report.head(one), report.in_unit(one, one.a, 10), report.in_unit(one, one.b, 10),
    report.in_unit(one, one.absolute, 3), one.relative == math.huge and "-" or ("%.3g"):format(one.relative) }
  if bounds then
    words[#words + 1], words[#words + 2] = report.in_unit(one, one.bound_a, 3), report.in_unit(one, one.bound_b, 3)
  end
  return words
end

local function show_results(differing, equal, options)
  local rows, bounds = {}, false
  for _, one in ipairs(differing) do
    bounds = bounds or one.bound_a ~= nil or one.bound_b ~= nil
  end
  for i, one in ipairs(differing) do
    rows[i] = result_row(one, bounds)
  end
  if #rows > 0 then
    local head = { "case", "result", "A", "B", "difference", "relative" }
    if bounds then
      head[7], head[8] = "A may be off by", "B may be off by"
    end
    show_rows(head, rows, options)
  end
  report.line("\n%d of %d results and verdicts are equal (%s)", equal, equal + #rows,
    options.tolerance and ("within %g, relative"):format(options.tolerance) or "to the last bit")
end

return function(options)
  local tolerance = options.tolerance or 0
  if not (tolerance >= 0 and tolerance < math.huge) then
    fault.input("--tolerance must be a relative difference of 0 or more, not %g", tolerance)
  end
  local a, b = outcomes.read(outcomes.folder(options.a)), outcomes.read(outcomes.folder(options.b))
  local matched, only_a, only_b = comparison.match(a, b)
  report.line("A: %s, %s\nB: %s, %s", a.folder, cases_of(#a.cases), b.folder, cases_of(#b.cases))
  show_matches(matched)
  show_alone("A", only_a, options)
  show_alone("B", only_b, options)
  if #matched == 0 then
    return 1
  end
  show_settings(comparison.settings(a, b, matched), #matched, options)
  local differing, equal = comparison.results(a, b, matched, tolerance)
  show_results(differing, equal, options)
  return #differing + #only_a + #only_b == 0 and 0 or 1
end
