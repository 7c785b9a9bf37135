-- Tables and lists for the terminal.
local engine = require "stiction.engine"
local tables = require "stiction.tables"
local units = require "stiction.units"

local report = {}

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
local function check_word(x)
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
  return ("%%.%dg"):format(digits or 5):format(value / (engine.parse_unit(entry.unit or "") or 1))
end

--- The cases with verdict and results, each result in its own unit.
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
  report.table(lines)
  for _, row in ipairs(rows) do
    if row.result.verdict ~= "finished" then
      report.line("%s: %s: %s", row.case.id, row.result.verdict, row.result.reason or "")
    end
    for _, remark in ipairs(row.result.remarks or {}) do
      report.line("%s: remark: %s", row.case.id, remark)
    end
  end
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
      report.line("check failed: %s: value %s, expected %s, tolerance %s", check.name, check_word(check.value),
        check_word(check.expected), check_word(check.tolerance))
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
