-- stiction show: the cases that an output folder holds, filtered, sorted, on the screen or as csv; nothing is run.
local csv = require "stiction.csv"
local engine = require "stiction.engine"
local fault = require "stiction.fault"
local outcomes = require "stiction.outcomes"
local report = require "stiction.report"
local selection = require "stiction.selection"

local most_rows, most_reasons, widest_word = 40, 5, 40 -- on the screen

--- Columns of the terminal; those that COLUMNS says, or 100, where there is none.
local function width()
  local words = engine.read_file("/proc/self/environ") or ""
  return engine.terminal_width() or tonumber(("\0" .. words):match("%zCOLUMNS=(%d+)")) or 100
end

local function csv_text(cases, columns)
  local lines = {}
  for i = 0, #cases do
    local words = {}
    for k, column in ipairs(columns) do
      words[k] = csv.word(i == 0 and column.name or i > 0 and cases[i].values[column.name])
    end
    lines[i + 1] = table.concat(words, ",")
  end
  return table.concat(lines, "\n") .. "\n"
end

local function write_csv(folder, file, text)
  if file == "-" then
    return engine.write(text)
  elseif engine.absolute(file) == engine.absolute(folder .. "/summary.csv") then
    fault.input("--csv: %s is what this table is read from; choose another file", file)
  end
  engine.write_file(file, text)
  report.line("%s", file)
end

--- As many columns as fit beside each other, and the names of the others. words: by column and row, heading first.
local function fit(words, columns, room)
  local shown, left, used = {}, {}, -2
  for k, column in ipairs(columns) do
    local widest = 0
    for _, word in ipairs(words[k]) do
      widest = math.max(widest, utf8.len(word) or #word)
    end
    if k == 1 or #left == 0 and used + 2 + widest <= room then
      shown[#shown + 1], used = words[k], used + 2 + widest
    else
      left[#left + 1] = column.name
    end
  end
  return shown, left
end

local function words_of(column, cases)
  local words = { report.head(column) }
  for i = 1, math.min(#cases, most_rows) do
    local digits = column.kind == "result" and 5 or 8
    local word = report.in_unit(column, cases[i].values[column.name], digits):gsub("%s*\n%s*", " ")
    local cut = utf8.len(word) and utf8.len(word) > widest_word and utf8.offset(word, widest_word - 2)
    words[i + 1] = cut and word:sub(1, cut - 1) .. "..." or word
  end
  return words
end

local function show_reasons(cases)
  local told = 0
  for _, case in ipairs(cases) do
    told = told + (case.reason ~= "" and 1 or 0)
    if case.reason ~= "" and told <= most_reasons then
      report.line("%s: %s: %s", case.name, case.verdict, case.reason)
    end
  end
  if told > most_reasons then
    report.line("and %d more with a reason: --columns case,reason", told - most_reasons)
  end
end

--- "25 cases: 23 finished, 2 failed"
local function count(cases)
  local list, number = {}, {}
  for _, case in ipairs(cases) do
    if not number[case.verdict] then
      list[#list + 1] = case.verdict
    end
    number[case.verdict] = (number[case.verdict] or 0) + 1
  end
  for i, verdict in ipairs(list) do
    list[i] = ("%d %s"):format(number[verdict], verdict)
  end
  return ("%d case%s: %s"):format(#cases, #cases == 1 and "" or "s", table.concat(list, ", "))
end

local function show_table(cases, columns)
  local words = {}
  for k, column in ipairs(columns) do
    words[k] = words_of(column, cases)
  end
  local shown, left = fit(words, columns, width())
  local rows = {}
  for i = 1, math.min(#cases, most_rows) + 1 do
    rows[i] = {}
    for k, column in ipairs(shown) do
      rows[i][k] = column[i]
    end
  end
  report.table(rows)
  if #cases > most_rows then
    report.line("and %d more cases: --where chooses, --csv - prints all", #cases - most_rows)
  end
  if #left > 0 then
    local words_left = ("and %d more column%s, which --columns chooses and --csv - prints: %s"):format(#left,
      #left == 1 and "" or "s", table.concat(left, ", "))
    report.line("%s", report.wrapped(words_left, "", math.max(width(), 40)))
  end
end

local function any_scaled(columns)
  for _, column in ipairs(columns) do
    if (engine.parse_unit(column.unit) or 1) ~= 1 then
      return true
    end
  end
  return false
end

return function(options)
  local outcome = outcomes.read(outcomes.folder(options.study, options.out))
  local columns = selection.columns(outcome, options.columns)
  local cases = selection.filter(outcome, options.where)
  if options.sort then
    cases = selection.sort(outcome, cases, options.sort)
  end
  if options.csv then
    write_csv(outcome.folder, options.csv, csv_text(cases, columns))
    return 0
  end
  show_table(cases, columns)
  show_reasons(cases)
  report.line("%s: %s%s%s", outcome.folder, count(outcome.cases),
    options.where and ("; %d chosen"):format(#cases) or "",
    any_scaled(columns) and " (--where and --csv are in SI)" or "")
  return 0
end
