-- A contact sheet: one small picture of a field for each of many cases.
local case_module = require "stiction.case"
local drawing = require "stiction.drawing"
local engine = require "stiction.engine"
local fault = require "stiction.fault"
local field_pictures = require "stiction.field_pictures"
local figure = require "stiction.figure"
local provenance = require "stiction.provenance"
local report = require "stiction.report"

local sheet = {}

local most, most_columns = 100, 6 -- pictures, and those beside each other

--- Names of the parameters in which the cases differ.
local function varying(outcome, cases)
  local names = {}
  for _, column in ipairs(outcome.columns) do
    for _, case in ipairs(column.kind == "parameter" and cases or {}) do
      if case.values[column.name] ~= cases[1].values[column.name] then
        names[#names + 1] = column.name
        break
      end
    end
  end
  return names
end

local function title(case, names)
  local words = {}
  for i, name in ipairs(names) do
    local value = case.values[name]
    words[i] = ("%s %s"):format(name, type(value) == "number" and ("%.4g"):format(value) or tostring(value))
  end
  return #words > 0 and #words <= 3 and table.concat(words, ", ") or case.name
end

local function pictures(outcome, cases, field)
  local list, names = {}, varying(outcome, cases)
  for _, case in ipairs(cases) do
    if #list < most and field_pictures.file(case.folder) then
      local run = case_module.new(case.name, {}, case.folder, engine.absolute(case.folder))
      list[#list + 1] = figure.field { name = case.name, title = title(case, names), case = run, array = field,
        unit = field_pictures.unit(field), deformed = true, view = field_pictures.view(case.folder) }
    end
  end
  return list
end

--- Draws the field (its name, or nil) of the cases that have fields, at their ends, into `file`; false if the figure
--- program failed.
function sheet.draw(outcome, cases, file, field)
  if not file:find("%.png$") then
    fault.input("--sheet: a picture's name ends in .png, unlike %s", file)
  end
  field = field or field_pictures.default((cases[1] or outcome).folder)
  field_pictures.unit(field)
  local list = pictures(outcome, cases, field)
  if #list == 0 then
    fault.input("--sheet: none of these cases has fields (fields.pvd)")
  end
  local columns = math.min(most_columns, math.ceil(math.sqrt(#list)))
  local picture = { kind = "panel", name = "sheet", columns = columns, width = "double",
    common_range = true, figures = list }
  local drawn = provenance.in_scratch(drawing.one, picture, "sheet.png", file)
  if drawn then
    report.line("%s: %s of %d of %d cases", file, field, #list, #cases)
  end
  return drawn
end

return sheet
