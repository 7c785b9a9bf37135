-- The map of outcomes: a table for programs, and a figure for people.
local drawing = require "stiction.drawing"
local engine = require "stiction.engine"
local figure = require "stiction.figure"
local numeric = require "stiction.numeric"
local outcome = require "stiction.extremes.outcome"

local map = {}

local function csv(value)
  local text = value == nil and "" or tostring(value)
  return text:find('[,"\n]') and '"' .. text:gsub('"', '""'):gsub("\n", " | ") .. '"' or text
end

--- map.csv: one row per cell.
function map.write(plan, rows)
  local lines = { "cell,scene,axis,level,outcome,verdict,checks,steps,cuts,iterations,seconds,reason,remarks" }
  for _, row in ipairs(rows) do
    local p, o, words = row.case.p, row.outcome, {}
    for i, value in ipairs { row.case.id, p.scene, p.axis, p.level, o.letter, o.verdict or "", o.checks or 0,
      o.steps or "", o.cuts or "", o.iterations or "", o.seconds or "", o.reason or "",
      table.concat(o.remarks or {}, " | ") } do
      words[i] = csv(value)
    end
    lines[#lines + 1] = table.concat(words, ",")
  end
  engine.write_file(plan.folder .. "/map.csv", table.concat(lines, "\n") .. "\n")
end

--- What stands in the figure's legend, failures all alike in colour.
local function kinds(rows)
  local colours = { C = 2, R = 0, S = 4 }
  local count, list = outcome.letters(rows), {}
  for _, letter in ipairs(outcome.order) do
    if count[letter] or colours[letter] then
      list[#list + 1] = { letter = letter, label = ("%s: %d"):format(outcome.word(letter), count[letter] or 0),
        colour = colours[letter] or 1 }
    end
  end
  return list
end

--- Values that `rows` take under `key`, in the order of their first appearance, and the place of each.
local function distinct(rows, key)
  local list, place = {}, {}
  for _, row in ipairs(rows) do
    local value = row.case.p[key]
    if not place[value] then
      list[#list + 1] = value
      place[value] = #list
    end
  end
  return list, place
end

local raised = { ["-"] = "⁻", ["0"] = "⁰", ["1"] = "¹", ["2"] = "²", ["3"] = "³", ["4"] = "⁴", ["5"] = "⁵", ["6"] = "⁶",
  ["7"] = "⁷", ["8"] = "⁸", ["9"] = "⁹" }

local function power(exponent)
  return (("%d"):format(exponent):gsub(".", raised))
end

--- "1e-09" -> "10⁻⁹", "3e4" -> "3·10⁴", "1000" -> "10³", "um" -> "µm"; other words as they are.
local function word(text)
  local mantissa, exponent = text:match("^(%-?[%d.]+)e([+-]?%d+)$")
  if text:match("^10000*$") then
    mantissa, exponent = "1", #text - 1
  elseif text:match("^0%.00+1$") then
    mantissa, exponent = "1", 2 - #text
  end
  if not mantissa then
    return (text:gsub("^u(%l)$", "µ%1"))
  end
  return (mantissa == "1" and "" or mantissa .. "·") .. "10" .. power(tonumber(exponent))
end

--- A level as the figure shows it.
local function label(level)
  return (level:gsub("_", " "):gsub("%S+", word))
end

--- Rows of the map: a level of an axis each, a letter for every scene that has it.
local function lines_of(rows, scenes, place)
  local lines, of_level = {}, {}
  for _, row in ipairs(rows) do
    local p = row.case.p
    local key = p.axis .. "-" .. p.level
    if not of_level[key] then
      of_level[key] = { axis = p.axis, meaning = p.meaning or p.axis, level = p.level, cells = {} }
      for i = 1, #scenes do
        of_level[key].cells[i] = "."
      end
      lines[#lines + 1] = of_level[key]
    end
    of_level[key].cells[place[p.scene]] = row.outcome.letter
  end
  return lines
end

--- Levels of one axis stand together, axes in the order of their first appearance.
local function grouped(lines)
  local rank, count = {}, 0
  for i, line in ipairs(lines) do
    line.number = i
    if not rank[line.axis] then
      count = count + 1
      rank[line.axis] = count
    end
  end
  table.sort(lines, function(a, b)
    return rank[a.axis] < rank[b.axis] or (rank[a.axis] == rank[b.axis] and a.number < b.number)
  end)
  return numeric.map(lines, function(line)
    return { group = line.meaning:gsub("%^(%d)", raised), label = label(line.level), cells = table.concat(line.cells) }
  end)
end

--- figures/map.png; false if the figure program failed.
function map.draw(plan, rows)
  local scenes, place = distinct(rows, "scene")
  local columns = numeric.map(scenes, function(name) return (name:gsub("_", ", ")) end)
  local title = ("%s: how each of %d cells ends"):format(plan.study.title, #rows)
  local picture = figure.map { name = "map", title = title, blocks = 3, columns = columns, kinds = kinds(rows),
    rows = grouped(lines_of(rows, scenes, place)) }
  return drawing.draw({ figures = function() return { picture } end }, {}, plan.folder)
end

return map
