-- What an output folder holds, read without its study: cases with their parameters, results and verdicts, all in SI.
local csv = require "stiction.csv"
local engine = require "stiction.engine"
local fault = require "stiction.fault"
local hold = require "stiction.hold"
local loader = require "stiction.loader"
local ordered = require "stiction.ordered"
local output = require "stiction.output"
local standing = require "stiction.standing"
local study_module = require "stiction.study"

local outcomes = {}

--- The output folder that is meant: `out`, or `path` if it is one, else that of the study at `path`.
function outcomes.folder(path, out)
  local kind = engine.kind_of_path(path)
  if out then
    return out
  elseif kind == "folder" and engine.kind_of_path(path .. "/study.lua") ~= "file" then
    return (path:gsub("(.)/+$", "%1"))
  elseif not kind then
    fault.input("there is neither an output folder nor a study at '%s'", path)
  end
  local source = loader.find(path)
  return output.default_folder(study_module.name_of(source), source.file)
end

local function decoded(path)
  local value = engine.decode_json(engine.read_file(path) or "")
  return type(value) == "table" and value or nil
end

--- Names in the head of summary.csv, and its rows by name in their order; a second entry of a name, what a run took, is
--- called "measure <name>".
local function read_summary(folder)
  local path = folder .. "/summary.csv"
  local text = engine.read_file(path)
  local rows, reason = { { "case" } }, nil
  if text then
    rows, reason = csv.read(text)
    reason = reason or rows[1][1] ~= "case" and "its head does not begin with 'case'"
  end
  if reason then
    fault.input("%s is damaged: %s; 'stiction run' on the study writes it anew", path, reason)
  end
  local list = {}
  for i = 2, #rows do
    list[i - 1] = {}
    for k, name in ipairs(rows[1]) do
      list[i - 1][list[i - 1][name] and "measure " .. name or name] = rows[i][k]
    end
  end
  return rows[1], list
end

local function table_or(value, default)
  return type(value) == "table" and value or default
end

--- The case in folder/name: what its files say, and its row of summary.csv where there is one; nil if it is no case.
local function read_case(folder, name, row, known)
  local path = folder .. "/" .. name
  local ended = output.read_result_in(path)
  local manifest = not ended and decoded(path .. "/manifest.json")
  local begun = manifest and table_or(manifest.made_of, {})
  if manifest and type(manifest.result) == "table" then
    ended = manifest.result -- of which something is not as it should be
  elseif not ended and not begun and engine.kind_of_path(path .. "/manifest.json") then
    ended = { verdict = "unreadable", reason = path .. "/manifest.json is damaged" }
  end
  if not (ended or begun or row) then
    return nil
  end
  local entry = known.cases[name]
  local runs = entry and entry.life ~= "dead" and not ended
  ended = ended or not runs and row or { verdict = runs and "running" or "not finished",
    reason = standing.words(entry) or "its process was ended before it was" }
  return { name = name, folder = path, row = row or {}, ended = ended, verdict = tostring(ended.verdict),
    reason = tostring(ended.reason or ""), results = table_or(ended.results, {}), values = {},
    parameters = table_or((ended.parameters and ended or begun or ended).parameters, {}) }
end

--- The cases of summary.csv in their order, then all others.
local function read_cases(folder, rows)
  local cases, seen, known = {}, {}, standing.read(folder)
  local function add(name, row)
    cases[#cases + 1], seen[name] = not seen[name] and read_case(folder, name, row, known) or nil, true
  end
  for _, row in ipairs(rows) do
    add(row.case, row)
  end
  for _, path in ipairs(engine.list(folder, false)) do
    add(path:match("[^/]+$"))
  end
  return cases
end

--- Gathers columns {name =, kind =, unit =} and the values of cases under their names.
local Table = {}
Table.__index = Table

--- A column; where its name is taken it is called "<kind>_<name>".
function Table:column(kind, name, unit)
  local key = kind .. " " .. name
  if not self.by_key[key] then
    local own = self.by_name[name] and kind .. "_" .. name or name
    local column = { name = own, of = name, kind = kind, unit = unit or "" }
    self.columns[#self.columns + 1], self.by_key[key], self.by_name[own] = column, column, column
  end
  return self.by_key[key]
end

function Table:put(case, kind, name, value, unit)
  local column = self:column(kind, name, unit)
  case.values[column.name] = value
  column.numeric = column.numeric or type(value) == "number"
end

--- By the name of each result that cases have or study.json tells its unit, or "" where that is not known.
local function known_results(cases, owner)
  local unit_of = {}
  for _, case in ipairs(cases) do
    for name in pairs(case.results) do
      unit_of[name] = ""
    end
  end
  for _, entry in ipairs(table_or(owner.results, {})) do
    if type(entry) == "table" and type(entry.name) == "string" then
      unit_of[entry.name] = tostring(entry.unit)
    end
  end
  return unit_of
end

--- By the name of each parameter its unit: of those in the cases' files and those in the summary, where nothing else is
--- between the case and the verdict but results.
local function known_parameters(cases, head, results)
  local unit_of = {}
  for i = 2, #head do
    if head[i] == "verdict" then
      break
    end
    unit_of[head[i]] = not results[head[i]] and "" or nil
  end
  for _, case in ipairs(cases) do
    for name, value in pairs(case.parameters) do
      unit_of[name] = type(value) == "table" and tostring(value.unit) or unit_of[name] or ""
    end
  end
  return unit_of
end

--- Columns of a kind, in the order in which the summary has them, the others in that of their names.
local function add_columns(t, kind, unit_of, head)
  for _, names in ipairs { head, ordered.keys(unit_of) } do
    for _, name in ipairs(names) do
      if unit_of[name] then
        t:column(kind, name, unit_of[name])
      end
    end
  end
end

--- A word of summary.csv as a value.
local function value_of(word)
  if word == "true" or word == "false" then
    return word == "true"
  end
  return tonumber(word) or word ~= "" and word or nil
end

--- What its files say of a case; where there are none, its row.
local function put_values(t, case, parameters, results)
  local row_alone = case.ended == case.row
  for name in pairs(parameters) do
    local value = case.parameters[name]
    if value == nil then
      value = value_of(case.row[name])
    end
    if type(value) == "table" then
      value = value.value
    end
    t:put(case, "parameter", name, value)
  end
  for name in pairs(results) do
    t:put(case, "result", name, tonumber(case.results[name] or row_alone and case.row[name] or nil))
  end
  for _, name in ipairs { "steps", "iterations", "contact", "seconds" } do
    local value = case.ended[name]
    if row_alone then
      value = value_of(case.row["measure " .. name] or value)
    end
    t:put(case, "measure", name, value, name == "seconds" and "s" or "")
  end
end

--- What the claims in the summary say that results may be off by, derivatives, and words on the case.
local function put_words(t, case, head, parameters, results)
  for _, name in ipairs(head) do
    local own = not results[name] and not parameters[name]
    if own and name:find("._error$") then
      t:put(case, "error", name, tonumber(case.row[name]), results[name:sub(1, -7)] or "")
    elseif own and name:find("^d_.+_d_.") then
      t:put(case, "derivative", name, tonumber(case.row[name]))
    end
  end
  t:put(case, "word", "set", case.row.set)
  t:put(case, "word", "warnings", case.row.warnings)
  t:put(case, "word", "reason", case.reason)
end

--- {folder =, owner = (study.json), columns = {{name =, of =, kind =, unit =, numeric =}}, by_name =, by_key = (of "<kind> <name>"),
--- cases = {{name =, folder =, verdict =, reason =, values = by column}}}; bad input if there is nothing to read.
function outcomes.read(folder)
  engine.watch_lines(false) -- no script runs
  if engine.kind_of_path(folder) ~= "folder" then
    fault.input("there is no output folder %s; 'stiction run' on the study makes it", folder)
  end
  local owner, head, rows = hold.owner(folder), read_summary(folder)
  local cases = read_cases(folder, rows)
  if #cases == 0 then
    fault.input("%s holds no results: no summary.csv with cases, and no folder of a case", folder)
  end
  local t = setmetatable({ folder = folder, owner = owner, cases = cases, columns = {}, by_key = {}, by_name = {} }, Table)
  for _, case in ipairs(cases) do
    t:put(case, "word", "case", case.name)
    t:put(case, "word", "verdict", case.verdict)
  end
  local results = known_results(cases, owner)
  local parameters = known_parameters(cases, head, results)
  add_columns(t, "parameter", parameters, head)
  add_columns(t, "result", results, head)
  for _, case in ipairs(cases) do
    put_values(t, case, parameters, results)
    put_words(t, case, head, parameters, results)
  end
  return t
end

return outcomes
