-- Which cases and columns of an output are wanted: a filter, an order, names.
local copy = require "stiction.copy"
local engine = require "stiction.engine"
local fault = require "stiction.fault"
local numeric = require "stiction.numeric"
local ordered = require "stiction.ordered"
local units = require "stiction.units"

local selection = {}

local words_of_lua = { ["and"] = true, ["or"] = true, ["not"] = true, ["true"] = true, ["false"] = true, ["nil"] = true,
  math = true }
local example = "it is an expression in Lua, in SI, such as: mu > 0.3 and verdict == 'finished' (equal: ==, not: ~=)"
local most_instructions = 1000000 -- that a filter may take for a case

local function names_of(outcome)
  local names = {}
  for i, column in ipairs(outcome.columns) do
    names[i] = column.name
  end
  return names
end

--- The column of a name; bad input if there is none.
local function column_of(outcome, name, option)
  local names = names_of(outcome)
  return outcome.by_name[name] or fault.input("%s: %s has no parameter or result '%s'%s; there are: %s", option,
    outcome.folder, name, fault.meant(name, names), table.concat(names, ", "))
end

--- Every name in the expression that is neither a field nor a word of Lua; texts are left out.
local function check_names(outcome, text)
  local bare = text:gsub("\\.", ""):gsub('"[^"]*"', '""'):gsub("'[^']*'", "''")
  for before, name in (" " .. bare):gmatch("([^%w_])([%a_][%w_]*)") do
    if before ~= "." and before ~= ":" and not words_of_lua[name] then
      column_of(outcome, name, "--where")
    end
  end
end

--- Puts the names of a case into `names`; numbers that it does not have are no numbers, of which nothing holds but ~=.
local function fill(names, outcome, case)
  for _, column in ipairs(outcome.columns) do
    local value = case.values[column.name]
    names[column.name] = value == nil and column.numeric and 0/0 or value
  end
end

--- Of these cases the one of this name, alone; bad input if the folder has none of it.
function selection.one(outcome, cases, name)
  local names, kept = {}, {}
  for i, case in ipairs(outcome.cases) do
    names[i] = case.name
  end
  if not numeric.first_where(names, function(own) return own == name end) then
    fault.input("--case: %s has no case '%s'%s", outcome.folder, name, fault.meant(name, names))
  end
  for _, case in ipairs(cases) do
    kept[#kept + 1] = case.name == name and case or nil
  end
  return kept
end

--- The cases for which the expression holds, all without one.
function selection.filter(outcome, text)
  if not text then
    return outcome.cases
  end
  local kept, names = {}, { math = copy(math) }
  local function refuse(reason)
    fault.input("--where '%s': %s; %s", text, (tostring(reason):gsub("^%-%-where:%d+: ", "")), example)
  end
  local test, complaint = engine.load_script("return (" .. text .. "\n)", "--where", names)
  if not test then
    refuse(complaint)
  end
  check_names(outcome, text)
  for _, case in ipairs(outcome.cases) do
    fill(names, outcome, case)
    local held, value = engine.call_within(most_instructions, test)
    if not held or type(value) ~= "boolean" then
      refuse(held and ("it gives %s for %s, not true or false"):format(tostring(value), case.name)
        or ("%s (in case %s)"):format(tostring(value), case.name))
    end
    kept[#kept + 1] = value and case or nil
  end
  return kept
end

--- What selection.filter wants of cases that need not have run: their parameters, in SI.
function selection.of_parameters(name, cases)
  local outcome = { folder = name, columns = {}, by_name = {}, cases = {} }
  for i, case in ipairs(cases) do
    local values = {}
    for _, key in ipairs(ordered.keys(case.p)) do
      values[key] = units.si(case.p[key])
      if not outcome.by_name[key] then
        outcome.by_name[key] = { name = key, kind = "parameter", numeric = type(values[key]) == "number" }
        table.insert(outcome.columns, outcome.by_name[key])
      end
    end
    outcome.cases[i] = { name = case.id, values = values }
  end
  return outcome
end

local function before(a, b)
  if type(a) ~= type(b) then
    return type(a) < type(b)
  elseif type(a) == "boolean" then
    return b and not a
  end
  return a < b
end

--- The cases by "name", or by "-name" from the largest on; those without a value last, alike ones as they were.
function selection.sort(outcome, cases, text)
  local descending, name = text:match("^(%-?)(.*)$")
  local key, place, sorted = column_of(outcome, name, "--sort").name, {}, {}
  for i, case in ipairs(cases) do
    place[case], sorted[i] = i, case
  end
  table.sort(sorted, function(one, other)
    local a, b = one.values[key], other.values[key]
    if a == b or a == nil or b == nil then
      if (a == nil) ~= (b == nil) then
        return b == nil
      end
      return place[one] < place[other]
    elseif descending == "-" then
      return before(b, a)
    end
    return before(a, b)
  end)
  return sorted
end

local function varies(cases, name)
  for _, case in ipairs(cases) do
    if case.values[name] ~= cases[1].values[name] then
      return true
    end
  end
  return false
end

--- The columns named in "a,b,c"; without it case, verdict, the parameters that are not the same everywhere, results and
--- what they may be off by.
function selection.columns(outcome, text)
  local chosen = {}
  for name in (text or ""):gmatch("[^,%s]+") do
    chosen[#chosen + 1] = column_of(outcome, name, "--columns")
  end
  for _, column in ipairs(text and {} or outcome.columns) do
    local kind, name = column.kind, column.name
    local wanted = kind == "result" or kind == "error" or name == "case" or name == "verdict"
      or kind == "parameter" and varies(outcome.cases, name)
    chosen[#chosen + 1] = wanted and column or nil
  end
  if #chosen == 0 then
    fault.input("--columns names nothing; there are: %s", table.concat(names_of(outcome), ", "))
  end
  return chosen
end

return selection
