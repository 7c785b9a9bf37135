-- Measured values from comma-separated files: columns as lists of quantities.
local csv = require "stiction.csv"
local engine = require "stiction.engine"
local fault = require "stiction.fault"
local ordered = require "stiction.ordered"
local units = require "stiction.units"

local measured = {}

--- "force", "N/m" of "force [N/m]" or "force (N/m)"; the unit is nil where the head names none.
local function split(head)
  local name, unit = head:match("^%s*(.-)%s*[%[(]([^%])]*)[%])]%s*$")
  return name or head:match("^%s*(.-)%s*$"), unit
end

local function place(file, folder)
  return (file:sub(1, 1) == "/" or not folder) and file or folder .. "/" .. file
end

--- The rows of a file, its head first (head: it has one), without comments (#) and empty lines; and its text.
local function rows_of(path, head)
  local text, reason = engine.read_file(path)
  if not text then
    fault.script("csv: %s", reason)
  end
  local lines = {}
  for line in (text:gsub("^\239\187\191", "") .. "\n"):gmatch("([^\n]*)\n") do
    lines[#lines + 1] = line:find("^%s*#") == nil and line:find("%S") and line:gsub("\r$", "") or nil
  end
  if #lines > 0 and lines[1]:find(";") and not lines[1]:find(",") then
    fault.script("csv: %s: its head has ';' and no ','; save it with commas between columns and points in numbers", path)
  end
  local rows
  rows, reason = csv.read(table.concat(lines, "\n") .. "\n")
  if not rows or head and #rows < 2 then
    fault.script("csv: %s: %s", path, reason or "there is no row of values below its head")
  end
  return rows, text
end

--- The unit as a factor, 1 for pure numbers.
local function factor_of(word, path, name)
  word = word or "1"
  if type(word) ~= "string" or not engine.parse_unit(word) then
    fault.script("csv: %s: column '%s': unknown unit '%s'%s", path, name, tostring(word),
      fault.meant(tostring(word), engine.unit_words()))
  end
  return word == "1" and 1 or units.units(word)
end

local function finite(word)
  local value = tonumber(word)
  return value and value == value and math.abs(value) < math.huge and value
end

local function column(rows, i, factor, path, name)
  local list = {}
  for k = 2, #rows do
    local value = finite(rows[k][i])
    if not value then
      fault.script("csv: %s: row %d, column '%s': '%s' is no number; leave the row out, or comment it out with #", path,
        k - 1, name, rows[k][i])
    end
    list[k - 1] = value * factor
  end
  return list
end

--- The columns of a file, from `folder` on, as lists of quantities; of plain numbers where neither `units` nor the head
--- names a unit. t: its name, or {file =, units = {column = "N/m"}}; note(path, text) is told what was read. Also
--- the units that are named, by column.
function measured.read(t, folder, note)
  t = type(t) == "string" and { file = t } or t
  if type(t) ~= "table" or type(t.file) ~= "string" or (t.units ~= nil and type(t.units) ~= "table") then
    fault.script("stiction.csv takes a file's name, or { file = \"...\", units = { column = \"N/m\" } }")
  end
  local path = place(t.file, folder)
  local rows, text = rows_of(path, true)
  local columns, names, words = {}, {}, {}
  for i, head in ipairs(rows[1]) do
    local name, unit = split(head)
    words[name] = t.units and t.units[name] or unit
    columns[name] = column(rows, i, factor_of(words[name], path, name), path, name)
    names[i] = name
  end
  for _, name in ipairs(ordered.keys(t.units or {})) do
    if not columns[name] then
      fault.script("csv: %s has no column '%s'%s; columns: %s", path, name, fault.meant(name, names), table.concat(names, ", "))
    end
  end
  if note then
    note(path, text)
  end
  return setmetatable(columns, { __index = function(_, name)
    fault.script("%s has no column '%s'%s; columns: %s", path, tostring(name), fault.meant(name, names),
      table.concat(names, ", "))
  end }), words
end

--- The numbers of a square file without head, a list of rows, in SI, and its unit. t: {file =, unit =}; what: where that is said.
function measured.matrix(t, folder, note, what)
  local path = place(t.file or fault.script("%s: file is missing", what), folder)
  local unit = factor_of(t.unit or fault.script("%s: unit is missing: unit = \"mN^2\"", what), path, "1")
  local rows, text = rows_of(path)
  local factor = units.si(unit)
  note(path, text)
  for i, row in ipairs(rows) do
    if #row ~= #rows then
      fault.script("csv: %s: %d rows of %d; as many columns as rows are wanted, and no head", path, #rows, #row)
    end
    for k, word in ipairs(row) do
      row[k] = factor * (finite(word) or fault.script("csv: %s: row %d, column %d: '%s' is no number", path, i, k, word))
    end
  end
  return rows, unit
end

return measured
