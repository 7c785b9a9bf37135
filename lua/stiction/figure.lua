-- Figures as tables for the figure program; numbers here are SI or quantities, in its file they are in the
-- unit of their axis.
local engine = require "stiction.engine"
local fault = require "stiction.fault"
local known = require("stiction.figure_keys").known
local numeric = require "stiction.numeric"
local obstacles = require "stiction.obstacles"
local ordered = require "stiction.ordered"
local units = require "stiction.units"

local figure = {}

local figure_mark = {}

local function word_of(value)
  return type(value) == "string" and ("\"%s\""):format(value) or units.is_quantity(value) and tostring(value)
    or type(value) == "table" and "a table" or tostring(value)
end

--- {word =, what = for messages, factor = to SI, metre =, kilogram =, second =}
local function unit_of(word, what)
  word = word or "1"
  local unit = { word = word, what = what }
  if type(word) == "string" then
    unit.factor, unit.metre, unit.kilogram, unit.second = engine.parse_unit(word)
  end
  return unit.factor and unit or fault.script("%s: unknown unit '%s'%s", what, tostring(word),
    fault.meant(tostring(word), engine.unit_words()))
end

--- Where no unit is asked for, any will do.
local function fits(value, unit)
  return unit.word == "1" or (value.metre == unit.metre and value.kilogram == unit.kilogram
    and value.second == unit.second)
end

--- SI number or quantity (or a list of them) in this unit; nil stays nil.
local function scaled(value, unit)
  if type(value) == "table" and not units.is_quantity(value) then
    return numeric.map(value, function(x) return scaled(x, unit) end)
  elseif units.is_quantity(value) and not fits(value, unit) then
    fault.script("%s: %s cannot be written in '%s'", unit.what, word_of(value), unit.word)
  elseif value ~= nil and type(units.si(value)) ~= "number" then
    fault.script("%s: a number or a quantity is wanted, not %s", unit.what, word_of(value))
  elseif value ~= nil and not numeric.is_finite(units.si(value)) then
    fault.script("%s: %s cannot be drawn; leave such points out", unit.what, word_of(value))
  end
  return value and units.si(value) / unit.factor
end

local function copy(t, allowed, what)
  local keys = ordered.keys(allowed)
  if type(t) ~= "table" or units.is_quantity(t) then
    fault.script("%s is a table with %s, not %s", what, table.concat(keys, ", "), word_of(t))
  end
  local twin = {}
  for _, key in ipairs(ordered.keys(t)) do
    if not allowed[key] then
      fault.script("%s: unknown key '%s'%s; keys: %s", what, tostring(key), fault.meant(key, keys), table.concat(keys, ", "))
    end
    twin[key] = t[key]
  end
  return twin
end

--- A list of tables or values, each by `make`.
local function each(list, what, make)
  if type(list) ~= "table" or units.is_quantity(list) or (#list == 0 and next(list) ~= nil) then
    fault.script("%s: a list { ... } is wanted, not %s", what, word_of(list))
  end
  return numeric.map(list, make)
end

local places = { x = 1, y = 2, z = 3, xx = 1, yy = 2, zz = 3, xy = 4, yz = 5, xz = 6 }
local vector, tensor = { "x", "y", "z" }, { "xx", "yy", "zz", "xy", "yz", "xz" }
local names_of_array = { displacement = vector, velocity = vector, cauchy_stress = tensor }

--- The index from 0 of a field's component by number or name; nil: the magnitude, or the only one.
local function component(value, array)
  if value == nil or value == "magnitude" then
    return nil
  end
  local names = names_of_array[array] -- nil: of a file that is not ours
  local named = names and numeric.first_where(names, function(name) return name == value end)
  local at = named or math.type(value) and math.tointeger(value) or not names and places[value]
  if not at or at < 1 or (names and at > #names) then
    fault.script("figure.field: component = %s; of %s it is \"%s\", or \"magnitude\"", word_of(value),
      tostring(array), table.concat(names or { "x", "y", "z", table.unpack(tensor) }, '", "'))
  end
  return at - 1
end

local function axis(t, what)
  local result = copy(t or {}, known.axis, what)
  local unit = unit_of(result.unit, what)
  result.range = scaled(result.range, unit)
  return result, unit
end

--- "/group/name" of "group/name"; numbers in the axis unit.
local function coordinate(value, unit)
  if type(value) == "string" then
    return value:sub(1, 1) == "/" and value or "/" .. value
  end
  return scaled(value, unit)
end

local function file_of(t, name)
  return t.file or (t.case and t.case.place .. "/" .. name) or nil
end

--- Half lengths of error bars in this unit, one for each point of a curve that is given by lists.
local function errors(t, key, unit)
  local given = t[key]
  if given == nil then
    return nil
  elseif type(t.x) ~= "table" or type(t.y) ~= "table" then
    fault.script("curve '%s': %s belongs to a curve whose x and y are lists", tostring(t.label), key)
  elseif type(given) ~= "table" or units.is_quantity(given) then
    given = numeric.map(t.x, function() return t[key] end)
  elseif #given ~= #t.x then
    fault.script("curve '%s': %s has %d values, x has %d", tostring(t.label), key, #given, #t.x)
  end
  return scaled(given, unit)
end

local function curve(t, x_unit, y_unit)
  local result = copy(t, known.curve, "curve")
  result.case, result.file = nil, file_of(t, "series.h5")
  local function along(key, unit)
    return { word = unit.word, what = ("curve '%s': %s"):format(tostring(t.label), key), factor = unit.factor, metre = unit.metre,
      kilogram = unit.kilogram, second = unit.second }
  end
  result.x = coordinate(t.x or (result.file and "/time"), along("x", x_unit))
  result.y = coordinate(t.y, along("y", y_unit))
  if not result.x or not result.y then
    fault.script("curve '%s' needs y, and a case or x", tostring(t.label))
  end
  result.error, result.x_error = errors(t, "error", y_unit), errors(t, "x_error", x_unit)
  result.at_most = t.at_most and numeric.map(t.at_most, function(below) return below and 1 or 0 end)
  result.x_shift, result.y_shift = units.si(t.x_shift), units.si(t.y_shift)
  local at = math.type(t.component) and math.tointeger(t.component)
  if t.component and not (at and at >= 1) then
    fault.script("curve '%s': component = %s; a number from 1 is wanted", tostring(t.label), word_of(t.component))
  end
  result.component = at and at - 1
  return result
end

local function make(t, kind)
  if type(t) ~= "table" then
    fault.script("figure.%s takes one table", kind)
  end
  local result = copy(t, known[kind], "figure." .. kind)
  result.kind = kind
  return setmetatable(result, figure_mark)
end

--- Says which points a logarithmic axis leaves out.
local function tell_unseen(result, key)
  for _, its in ipairs(result[key].log and result.curves or {}) do
    local count = 0
    for _, value in ipairs(type(its[key]) == "table" and its[key] or {}) do
      count = count + (type(value) == "number" and value <= 0 and 1 or 0)
    end
    if count > 0 then
      engine.complain(("stiction: figure '%s': %d of the points of curve '%s' have no place on the logarithmic %s axis: they are not "
        .. "above 0\n"):format(tostring(result.name), count, tostring(its.label), key))
    end
  end
end

--- Curves over one pair of axes: lines{ name =, x = {label =, unit =}, y =, curves = {{label =, case =, y =}} }.
function figure.lines(t)
  local result = make(t, "lines")
  local x_unit, y_unit
  result.x, x_unit = axis(t.x, "figure.lines: x")
  result.y, y_unit = axis(t.y, "figure.lines: y")
  result.curves = each(t.curves or {}, "figure.lines: curves", function(c) return curve(c, x_unit, y_unit) end)
  result.marks = t.marks and each(t.marks, "figure.lines: marks", function(mark)
    local twin = copy(mark, known.mark, "mark")
    twin.x = scaled(mark.x, x_unit)
    return twin
  end)
  tell_unseen(result, "x")
  tell_unseen(result, "y")
  return result
end

--- The box that a solid is cut by, its sides in this unit.
local function crop(t, unit)
  local result = copy(t, known.crop, "crop")
  for key, side in pairs(result) do
    result[key] = scaled(side, unit)
  end
  return result
end

--- Displacements in this unit at times in s.
local function path(t, unit, what)
  local result = copy(t, known.path, what)
  result.times, result.angle = scaled(t.times, unit_of("s", what .. ": times")), scaled(t.angle, unit_of("1", what))
  for _, axis_name in ipairs { "x", "y", "z" } do
    result[axis_name] = scaled(t[axis_name], unit)
  end
  return result
end

--- A rigid sphere (a circle in a plane picture): centre, radius and path in this unit, times in s.
local function sphere(t, unit)
  local result = copy(t, known.sphere, "sphere")
  result.centre, result.radius = scaled(t.centre, unit), scaled(t.radius, unit)
  result.path = t.path and path(t.path, unit, "sphere.path")
  return result
end

local lengths = { centre = true, radius = true, point = true, points = true, pivot = true }

--- Rigid obstacles of a plane picture in this unit: those given, or those of the case.
local function obstacle_list(t, unit)
  local list = t.obstacles
  if list == false or list == nil and (not t.case or t.view or t.sphere) then
    return nil
  elseif list == nil or list == true then
    list = t.case and obstacles.of(t.case, t.deformed)
  end
  if not list then
    return nil
  end
  return each(list, "figure.field: obstacles", function(entry)
    local twin = copy(entry, known.obstacle, "obstacle")
    for key, value in pairs(twin) do
      twin[key] = lengths[key] and scaled(value, unit) or value
    end
    twin.path = entry.path and path(entry.path, unit, "obstacle.path")
    return twin
  end)
end

--- A length, in the unit it was written in or plainly in m; or {length =, unit =}.
local function scale_bar(t)
  if type(t) == "number" then
    return { length = t, unit = "m" }
  elseif units.is_quantity(t) then
    if not units.same_dimension(t, units.units.m) then
      fault.script("figure.field: scale_bar = %s; a length is wanted, e.g. 1*mm", word_of(t))
    end
    local length, unit = t:display()
    return { length = length, unit = unit }
  end
  local bar = copy(t, known.scale_bar, "scale_bar")
  bar.length = scaled(t.length, unit_of(t.unit or "m", "scale_bar"))
  return bar
end

--- A field on the mesh at one time: field{ name =, case =, time = number, quantity or "last", array =, unit = };
--- a solid with view = { azimuth = 30, elevation = 25 }, in degrees.
function figure.field(t)
  local result = make(t, "field")
  result.case, result.file = nil, file_of(t, "fields.pvd")
  result.time = type(t.time) == "string" and t.time or scaled(t.time, unit_of("s", "figure.field: time"))
  result.range = scaled(t.range, unit_of(t.unit, "figure.field"))
  local metres = unit_of(t.window_unit or "m", "figure.field: window_unit")
  result.window = scaled(t.window, metres)
  if t.view then
    result.view = copy(t.view, known.view, "view")
    result.view.azimuth = result.view.azimuth or 30 -- an empty table would be a list
  end
  result.crop = t.crop and crop(t.crop, metres)
  result.sphere = t.sphere and sphere(t.sphere, metres)
  result.obstacles = obstacle_list(t, metres)
  result.component = component(t.component, t.array)
  if type(t.component) == "string" and result.component and not t.label then
    result.label = ("%s, %s"):format(tostring(t.array), tostring(t.component))
  end
  result.scale_bar = t.scale_bar and scale_bar(t.scale_bar)
  if t.film then
    result.film = copy(t.film == true and {} or t.film, known.film, "film")
    result.film.rate = result.film.rate or 10 -- an empty table would be a list
  end
  return result
end

--- Several of the others beside each other: panel{ name =, columns = 2, figures = {...} }.
function figure.panel(t)
  local result = make(t, "panel")
  result.figures = each(t.figures or {}, "figure.panel: figures", function(entry)
    if getmetatable(entry) ~= figure_mark then
      fault.script("figure.panel: figures holds %s; each is made by figure.lines, field or map", word_of(entry))
    elseif entry.dpi or entry.svg or entry.pdf then
      fault.script("figure.panel: dpi, svg and pdf are the panel's, not those of a figure in it")
    elseif entry.film then
      fault.script("figure.panel: a film is a figure of its own, not a part of a panel")
    end
    return entry
  end)
  return result
end

--- A table of outcomes: map{ name =, blocks =, columns = {text}, kinds = {{letter =, label =, colour =}}, rows =
--- {{group =, label =, cells = "a letter of a kind per column, . for none"}} }.
function figure.map(t)
  local result = make(t, "map")
  result.columns = each(t.columns or {}, "figure.map: columns", function(label) return { label = label } end)
  return result
end

--- The specification of a study's figures for the figure program.
function figure.spec(study, cases)
  local list = study.figures(cases)
  if getmetatable(list) == figure_mark then
    list = { list }
  elseif type(list) ~= "table" then
    fault.input("study.figures must return a list of figures, not %s", list == nil and "nothing" or word_of(list))
  end
  for i, entry in ipairs(list) do
    if getmetatable(entry) ~= figure_mark then
      fault.input("study.figures: entry %d is not made by stiction.figure", i)
    end
  end
  return { figures = list }
end

return setmetatable(figure, {
  __index = function(_, kind)
    fault.script("there is no figure.%s%s", tostring(kind), fault.meant(kind, { "lines", "field", "map", "panel" }))
  end,
})
