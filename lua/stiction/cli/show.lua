-- stiction show: the cases that an output folder holds, filtered, sorted, on the screen or as csv; nothing is run.
local csv = require "stiction.csv"
local engine = require "stiction.engine"
local fault = require "stiction.fault"
local film = require "stiction.film"
local outcomes = require "stiction.outcomes"
local report = require "stiction.report"
local selection = require "stiction.selection"
local sheet = require "stiction.sheet"

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

--- What is known of the results, by name.
local function meanings_of(outcome)
  local by_name = {}
  for _, entry in ipairs(type(outcome.owner.results) == "table" and outcome.owner.results or {}) do
    if type(entry) == "table" and entry.name then
      by_name[entry.name] = type(entry.meaning) == "string" and entry.meaning or nil
    end
  end
  return by_name
end

local function si_unit(word)
  local factor, metre, kilogram, second = engine.parse_unit(word)
  return factor and word ~= "" and engine.dimension_text(metre, kilogram, second) or word
end

--- A column as engine.write_table takes it: numbers, not a number where there is none, or else texts.
local function table_column(column, cases, meaning)
  local own = { name = column.name, unit = si_unit(column.unit), meaning = meaning or column.kind }
  local numbers, texts = {}, {}
  for i, case in ipairs(cases) do
    local value = case.values[column.name]
    numbers[i] = type(value) == "number" and value + 0.0 or 0/0
    texts[i] = value == nil and "" or type(value) == "number" and engine.number_text(value) or tostring(value)
    own.worded = own.worded or value ~= nil and type(value) ~= "number"
  end
  own.worded = own.worded or not column.numeric
  own.numbers, own.texts = not own.worded and numbers or nil, own.worded and texts or nil
  return own
end

local function write_h5(outcome, file, cases, columns)
  if not file:find("%.h5$") and not file:find("%.hdf5$") then
    fault.input("--h5: the name of an HDF5 file ends in .h5 or .hdf5, unlike %s", file)
  end
  local list, meanings = {}, meanings_of(outcome)
  for k, column in ipairs(columns) do
    list[k] = table_column(column, cases, column.kind == "result" and meanings[column.of] or nil)
  end
  engine.write_table(file, "cases", #cases, list)
  report.line("%s: table 'cases' of %d rows: h5py.File(%q)[\"cases\"][:], pandas.read_hdf(%q, \"cases\")", file, #cases, file,
    file)
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

--- Refuses files in folders that are not there, before any is written.
local function check_places(options)
  for _, name in ipairs { "csv", "h5", "animate", "sheet" } do
    local file = options[name]
    local folder = file and file ~= "-" and (engine.absolute(file):match("^(.+)/[^/]*$") or "/")
    if folder and engine.kind_of_path(folder) ~= "folder" then
      fault.input("--%s %s: there is no folder %s", name, file, folder)
    end
  end
end

--- Writes every file that is asked for; nil if none is, else whether all could be drawn.
local function write(outcome, cases, columns, options)
  local good
  check_places(options)
  if options.csv then
    write_csv(outcome.folder, options.csv, csv_text(cases, columns))
    good = true
  end
  if options.h5 then
    write_h5(outcome, options.h5, cases, options.columns and columns or outcome.columns)
    good = true
  end
  if options.animate then
    good = film.draw(outcome, cases, options.animate, options) and good ~= false or false
  end
  if options.sheet then
    good = sheet.draw(outcome, cases, options.sheet, options.field) and good ~= false or false
  end
  return good
end

return function(options)
  local outcome = outcomes.read(outcomes.folder(options.study, options.out))
  local columns = selection.columns(outcome, options.columns)
  local cases = selection.filter(outcome, options.where)
  if options.case then
    cases = selection.one(outcome, cases, options.case)
  end
  if options.sort then
    cases = selection.sort(outcome, cases, options.sort)
  end
  if not options.animate and (options.frames or options.rate) then
    fault.input("--frames and --rate are of a film: --animate FILE")
  end
  local written = write(outcome, cases, columns, options)
  if written ~= nil then
    return written and 0 or 1
  end
  show_table(cases, columns)
  show_reasons(cases)
  report.line("%s: %s%s%s", outcome.folder, count(outcome.cases),
    (options.where or options.case) and ("; %d chosen"):format(#cases) or "",
    any_scaled(columns) and " (--where and --csv are in SI)" or "")
  return 0
end
