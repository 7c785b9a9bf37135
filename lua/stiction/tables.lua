-- Tables that studies put into the report, and their join over several studies.
local fault = require "stiction.fault"
local units = require "stiction.units"

local tables = {}

local function check_row(t, row)
  if type(row) ~= "table" or type(row[1]) ~= "string" then
    fault.script("check.table '%s': every row is a list that begins with a text, its key", t.title)
  end
  local plain = {}
  for i = 1, #t.columns do
    local value = units.si(row[i])
    plain[i] = value == nil and "-" or value
  end
  return plain
end

--- The entry in checks.json of check.table {title =, columns =, rows =}; "-" where a row has nothing.
function tables.read(t)
  if type(t) ~= "table" or type(t.title) ~= "string" or type(t.columns) ~= "table" or type(t.rows) ~= "table" then
    fault.script("check.table takes { title = \"...\", columns = {...}, rows = {{...}, ...} }")
  end
  local rows = {}
  for i, row in ipairs(t.rows) do
    rows[i] = check_row(t, row)
  end
  return { name = t.title, pass = true, table = { columns = t.columns, rows = rows } }
end

local function word(value)
  return type(value) == "number" and ("%.5g"):format(value) or tostring(value)
end

--- Lists of texts, the heading first.
function tables.words(t)
  local lines = { t.columns }
  for i, row in ipairs(t.rows) do
    local words = {}
    for k = 1, #t.columns do
      words[k] = word(row[k])
    end
    lines[i + 1] = words
  end
  return lines
end

local function row_of(joined, key)
  if not joined.by_key[key] then
    local row = { key }
    for k = 2, #joined.columns do
      row[k] = "-"
    end
    joined.by_key[key] = row
    joined.rows[#joined.rows + 1] = row
  end
  return joined.by_key[key]
end

local function add(joined, t)
  local first = #joined.columns
  for k = 2, #t.columns do
    joined.columns[first + k - 1] = t.columns[k]
  end
  for _, row in ipairs(joined.rows) do
    for k = first + 1, #joined.columns do
      row[k] = "-"
    end
  end
  for _, row in ipairs(t.rows) do
    local whole = row_of(joined, row[1])
    for k = 2, #t.columns do
      whole[first + k - 1] = row[k]
    end
  end
end

--- The tables of all parts {checks =}; those of one title become one, a row per first column, columns one after another.
--- List of {title =, columns =, rows =}.
function tables.join(parts)
  local list, by_title = {}, {}
  for _, part in ipairs(parts) do
    for _, entry in ipairs(part.checks) do
      if entry.table then
        local joined = by_title[entry.name]
        if not joined then
          joined = { title = entry.name, columns = { entry.table.columns[1] }, rows = {}, by_key = {} }
          by_title[entry.name], list[#list + 1] = joined, joined
        end
        add(joined, entry.table)
      end
    end
  end
  return list
end

return tables
