-- What the help pages, on the terminal and as one page, say of a part and of a unit.
local engine = require "stiction.engine"

local describe = {}

--- How scripts call a kind of a category: "mesh.block", "body".
function describe.call(category, kind)
  return kind.name == category.name and kind.name or category.name .. "." .. kind.name
end

--- What a parameter may be.
function describe.range(parameter)
  local kind = parameter.kind
  if kind == "nested" then
    return ("a %s"):format(parameter.unit)
  elseif kind == "choice" then
    return "one of " .. table.concat(parameter.choices, ", ")
  elseif kind == "number" or kind == "integer" then
    return parameter.range .. (kind == "integer" and ", whole" or "")
  elseif kind == "numbers" then
    return "list of numbers" .. (parameter.unit ~= "1" and " in " .. parameter.unit or "")
  elseif kind == "file" then
    return "file, named from the study's folder on"
  end
  return kind
end

--- Whether a parameter must be given, or what it is otherwise.
function describe.need(parameter)
  return parameter.required and "required" or parameter.default and "default " .. parameter.default or "optional"
end

--- Rows {word, factor to SI, dimension} of all units.
function describe.units()
  local rows = {}
  for i, word in ipairs(engine.unit_words()) do
    local factor, metre, kilogram, second = engine.parse_unit(word)
    rows[i] = { word, ("%g"):format(factor), engine.dimension_text(metre, kilogram, second) }
  end
  return rows
end

return describe
