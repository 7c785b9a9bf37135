-- Tables and lists for the terminal.
local engine = require "stiction.engine"
local tables = require "stiction.tables"
local units = require "stiction.units"

local report = {}

local most_rows, most_ids, most_alike = 40, 6, 3 -- of cases on a terminal, of names in a line, of alike lines

--- Prints a formatted line.
function report.line(format, ...)
  engine.write((format or ""):format(...) .. "\n")
end

--- Columns aligned, numbers to the right; rows are lists of texts, the first is the heading.
function report.table(rows)
  local widths = {}
  for _, row in ipairs(rows) do
    for i, text in ipairs(row) do
      widths[i] = math.max(widths[i] or 0, utf8.len(text) or #text)
    end
  end
  for _, row in ipairs(rows) do
    local words = {}
    for i, text in ipairs(row) do
      local gap = (" "):rep(widths[i] - (utf8.len(text) or #text))
      local right = i > 1 and tonumber(rows[2] and rows[2][i])
      words[i] = right and gap .. text or text .. gap
    end
    engine.write((table.concat(words, "  "):gsub("%s+$", "")) .. "\n")
  end
end

--- Text broken into lines of at most `width`, each after `indent`.
function report.wrapped(text, indent, width)
  local lines, line = {}, ""
  for word in text:gmatch("%S+") do
    if line ~= "" and #line + #word + 1 > (width or 100) - #indent then
      lines[#lines + 1] = indent .. line
      line = word
    else
      line = line == "" and word or line .. " " .. word
    end
  end
  lines[#lines + 1] = indent .. line
  return table.concat(lines, "\n")
end

--- What a value of a check looks like.
function report.check_word(x)
  return type(x) == "number" and ("%.6g"):format(x) or x == nil and "none" or tostring(x)
end

local function result_word(result, entry)
  return report.in_unit(entry, (result.results or {})[entry.name])
end

--- A name with its unit, of {name =, unit =}.
function report.head(entry)
  return (entry.unit == "1" or entry.unit == "") and entry.name or ("%s/(%s)"):format(entry.name, entry.unit)
end

--- A value given in SI, in the unit of {unit =}; "-" for none.
function report.in_unit(entry, value, digits)
  if type(value) ~= "number" then
    return value == nil and "-" or tostring(value)
  end
  return ("%%.%dg"):format(digits or 5):format(value / (engine.parse_unit(entry.unit or "") or 1) + 0) -- + 0: no -0
end

--- What the cases remark, once for those alike.
local function show_remarks(rows)
  local warnings, told = require "stiction.warnings", {}
  for i, row in ipairs(rows) do
    told[i] = { id = row.case.id, warnings = {} }
    for k, remark in ipairs(row.result.remarks or {}) do
      told[i].warnings[k] = { text = tostring(remark) }
    end
  end
  for _, group in ipairs(warnings.groups(told)) do
    if #group.ids == 1 then
      report.line("%s: remark: %s", group.ids[1], group.text)
    else
      report.line("remark: %s (or alike, in %s)", group.text, warnings.cases_of(group.ids, #rows))
    end
  end
end

--- As many columns as fit beside each other, at least one; how many do not.
local function fit(rows, room)
  local used, count = -2, 0
  for k in ipairs(rows[1]) do
    local widest = 0
    for _, row in ipairs(rows) do
      widest = math.max(widest, utf8.len(row[k]) or #row[k])
    end
    used = used + 2 + widest
    count = (k == 1 or used <= room) and k or count
    if used > room then
      break
    end
  end
  local left = #rows[1] - count
  for i, row in ipairs(rows) do
    rows[i] = table.move(row, 1, count, 1, {})
  end
  return left
end

--- The table of the cases, on a terminal shortened to what fits.
local function show_table(lines, width)
  local rows = table.move(lines, 1, width and math.min(#lines, most_rows + 1) or #lines, 1, {})
  local left = width and fit(rows, width) or 0
  report.table(rows)
  local more = { #rows < #lines and ("%d more cases"):format(#lines - #rows) or nil }
  more[#more + 1] = left > 0 and ("%d more column%s"):format(left, left == 1 and "" or "s") or nil
  if #more > 0 then
    report.line("and %s: stiction show", table.concat(more, ", "))
  end
end

--- "mu0: failed: words" for each wording, whatever its numbers, and in which other cases it is told; of few cases each.
local function show_alike(told)
  local groups, by_words = {}, {}
  for _, entry in ipairs(told) do
    local words = entry.text:gsub("%d[%d.e+-]*", "#")
    local group = by_words[words]
    if not group then
      group = {}
      groups[#groups + 1], by_words[words] = group, group
    end
    group[#group + 1] = entry
  end
  for _, group in ipairs(groups) do
    for i = 1, #group > most_alike and 1 or #group do
      report.line("%s: %s", group[i].id, group[i].text)
    end
    if #group > most_alike then
      local ids = {}
      for i = 2, math.min(#group, most_ids + 1) do
        ids[i - 1] = group[i].id
      end
      report.line("  alike in %d more: %s%s", #group - 1, table.concat(ids, ", "), #group > most_ids + 1 and ", ..." or "")
    end
  end
end

--- Why cases did not finish: {id =, text =}.
local function words_on(rows)
  local told = {}
  for _, row in ipairs(rows) do
    if row.result.verdict ~= "finished" then
      told[#told + 1] = { id = row.case.id, text = ("%s: %s"):format(row.result.verdict, row.result.reason or "") }
    end
  end
  return told
end

--- The cases with verdict and results, each result in its own unit, and remarks, those alike once.
function report.cases(study, rows)
  local head = { "case", "verdict" }
  for _, entry in ipairs(study.results) do
    head[#head + 1] = report.head(entry)
  end
  local lines = { head }
  for _, row in ipairs(rows) do
    local words = { row.case.id, row.result.verdict }
    for _, entry in ipairs(study.results) do
      words[#words + 1] = result_word(row.result, entry)
    end
    lines[#lines + 1] = words
  end
  report.line()
  show_table(lines, engine.terminal_width())
  show_alike(words_on(rows))
  show_remarks(rows)
end

--- Prints the tables among the checks, then the failing checks; how many failed.
function report.checks(checks)
  local failed, count = 0, 0
  for _, check in ipairs(checks) do
    count = count + (check.table and 0 or 1)
    if check.table then
      report.line("\n%s", check.name)
      report.table(tables.words(check.table))
      report.line()
    elseif not check.pass then
      failed = failed + 1
      report.line("check failed: %s: value %s, expected %s, tolerance %s", check.name, report.check_word(check.value),
        report.check_word(check.expected), report.check_word(check.tolerance))
    end
  end
  if count > 0 then
    report.line("%d of %d checks held", count - failed, count)
  end
  return failed
end

--- Prints the message of an error value as main would.
function report.fault(value)
  local trace = type(value) == "table" and value.trace or ""
  engine.complain(("stiction: %s%s\n"):format(tostring(value), trace))
end

--- A parameter as the study wrote it.
function report.value(value)
  return units.is_quantity(value) and tostring(value) or type(value) == "number" and ("%.10g"):format(value)
    or tostring(value)
end

return report
