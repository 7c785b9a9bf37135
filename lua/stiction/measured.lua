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

--- The rows of a file, its head first, without comments (#) and empty lines.
local function rows_of(path)
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
  if not rows or #rows < 2 then
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

local function column(rows, i, factor, path, name)
  local list = {}
  for k = 2, #rows do
    local value = tonumber(rows[k][i])
    if not value or value ~= value or math.abs(value) == math.huge then
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
  local path = (t.file:sub(1, 1) == "/" or not folder) and t.file or folder .. "/" .. t.file
  local rows, text = rows_of(path)
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

return measured
