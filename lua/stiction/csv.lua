-- Comma-separated text: values as words of a line, and whole files read strictly.
local engine = require "stiction.engine"
local units = require "stiction.units"

local csv = {}

--- A value as a word of a line; numbers in SI, with every digit.
function csv.word(value)
  value = units.si(value)
  if type(value) == "number" then
    return math.type(value) == "integer" and tostring(value) or engine.number_text(value)
  end
  local text = value == nil and "" or tostring(value)
  return text:find('[,"\n]') and '"' .. text:gsub('"', '""') .. '"' or text
end

--- The word that begins at `at` and the place after it; nil if its quotes do not close.
local function word_at(text, at)
  if text:sub(at, at) ~= '"' then
    local word = text:match("^[^,\n]*", at)
    return word, at + #word
  end
  local stop = text:find('"', at + 1, true)
  while stop and text:sub(stop + 1, stop + 1) == '"' do
    stop = text:find('"', stop + 2, true)
  end
  if stop then
    return (text:sub(at + 1, stop - 1):gsub('""', '"')), stop + 1
  end
end

--- List of rows of words, the head first, all as long; or nil and what is wrong.
function csv.read(text)
  local rows, row, at = {}, {}, 1
  text = text:gsub("\r\n", "\n")
  while at <= #text do
    local word, stop = word_at(text, at)
    local mark = word and text:sub(stop, stop)
    row[#row + 1] = word
    if mark == "\n" then
      rows[#rows + 1], row = row, {}
      if #rows[#rows] ~= #rows[1] then
        return nil, ("line %d has %d entries, its head %d"):format(#rows, #rows[#rows], #rows[1])
      end
    elseif mark ~= "," then
      return nil, ("line %d is cut off"):format(#rows + 1)
    end
    at = stop + 1
  end
  if #row > 0 or #rows == 0 then
    return nil, ("line %d is cut off"):format(#rows + 1)
  end
  return rows
end

return csv
