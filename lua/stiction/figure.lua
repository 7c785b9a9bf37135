-- Figures as tables for the figure program; numbers here are SI or quantities, in its file they are in the
-- unit of their axis.
local engine = require "stiction.engine"
local fault = require "stiction.fault"
local numeric = require "stiction.numeric"
local ordered = require "stiction.ordered"
local units = require "stiction.units"

local figure = {}

local figure_mark = {}

local function factor_of(unit, what)
  unit = unit or "1"
  local factor = type(unit) == "string" and engine.parse_unit(unit)
  return factor or fault.script("%s: unknown unit '%s'%s", what, tostring(unit),
    fault.meant(tostring(unit), engine.unit_words()))
end

--- SI number or quantity (or a list of them) in the unit with this factor.
local function scaled(value, factor)
  if type(value) == "table" and not units.is_quantity(value) then
    return numeric.map(value, function(x) return units.si(x) / factor end)
  elseif value ~= nil then
    return units.si(value) / factor
  end
end

local function copy(t, known, what)
  local twin = {}
  for _, key in ipairs(ordered.keys(t)) do
    if not known[key] then
      fault.script("%s: unknown key '%s'%s; keys: %s", what, tostring(key), fault.meant(key, ordered.keys(known)),
        table.concat(ordered.keys(known), ", "))
    end
    twin[key] = t[key]
  end
  return twin
end

local function set_of(words)
  local set = {}
  for word in words:gmatch("%S+") do
    set[word] = true
  end
  return set
end

local figure_keys = "name title width height "
local known = {
  lines = set_of(figure_keys .. "x y legend colours curves marks"),
  field = set_of(figure_keys .. "case file time array component unit label deformed range window window_unit mesh"
    .. " scale_bar view mirror crop sphere"),
  panel = set_of(figure_keys .. "columns figures"),
  map = set_of(figure_keys .. "blocks columns kinds rows"),
  axis = set_of "label unit log range",
  curve = set_of "label case file x y x_shift y_shift x_sign y_sign colour style component",
  mark = set_of "x label",
  scale_bar = set_of "length unit",
  view = set_of "azimuth elevation",
  crop = set_of "xmin xmax ymin ymax zmin zmax",
  sphere = set_of "centre radius path",
  path = set_of "times x y z",
}

local function axis(t, what)
  local result = copy(t or {}, known.axis, what)
  local factor = factor_of(result.unit, what)
  result.range = scaled(result.range, factor)
  return result, factor
end

--- "/group/name" of "group/name"; numbers in the axis unit.
local function coordinate(value, factor)
  if type(value) == "string" then
    return value:sub(1, 1) == "/" and value or "/" .. value
  end
  return scaled(value, factor)
end

local function file_of(t, name)
  return t.file or (t.case and t.case.place .. "/" .. name) or nil
end

local function curve(t, x_factor, y_factor)
  local result = copy(t, known.curve, "curve")
  result.case, result.file = nil, file_of(t, "series.h5")
  result.x = coordinate(t.x or (result.file and "/time"), x_factor)
  result.y = coordinate(t.y, y_factor)
  if not result.x or not result.y then
    fault.script("curve '%s' needs y, and a case or x", tostring(t.label))
  end
  result.x_shift, result.y_shift = units.si(t.x_shift), units.si(t.y_shift)
  result.component = t.component and t.component - 1
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

--- Curves over one pair of axes: lines{ name =, x = {label =, unit =}, y =, curves = {{label =, case =, y =}} }.
function figure.lines(t)
  local result = make(t, "lines")
  local x_factor, y_factor
  result.x, x_factor = axis(t.x, "figure.lines: x")
  result.y, y_factor = axis(t.y, "figure.lines: y")
  result.curves = numeric.map(t.curves or {}, function(c) return curve(c, x_factor, y_factor) end)
  result.marks = t.marks and numeric.map(t.marks, function(mark)
    local twin = copy(mark, known.mark, "mark")
    twin.x = scaled(mark.x, x_factor)
    return twin
  end)
  return result
end

--- The box that a solid is cut by, its sides in the unit with this factor.
local function crop(t, factor)
  local result = copy(t, known.crop, "crop")
  for key, side in pairs(result) do
    result[key] = scaled(side, factor)
  end
  return result
end

--- A rigid sphere (a circle in a plane picture): centre, radius and path in the unit with this factor, times in s.
local function sphere(t, factor)
  local result = copy(t, known.sphere, "sphere")
  result.centre, result.radius = scaled(t.centre, factor), scaled(t.radius, factor)
  if t.path then
    local path = copy(t.path, known.path, "sphere.path")
    path.times = scaled(t.path.times, 1)
    for _, axis_name in ipairs { "x", "y", "z" } do
      path[axis_name] = scaled(t.path[axis_name], factor)
    end
    result.path = path
  end
  return result
end

--- A field on the mesh at one time: field{ name =, case =, time = number, quantity or "last", array =, unit = };
--- a solid with view = { azimuth = 30, elevation = 25 }, in degrees.
function figure.field(t)
  local result = make(t, "field")
  result.case, result.file = nil, file_of(t, "fields.pvd")
  result.time = type(t.time) == "string" and t.time or units.si(t.time)
  result.range = scaled(t.range, factor_of(t.unit, "figure.field"))
  local metres = factor_of(t.window_unit or "m", "figure.field: window_unit")
  result.window = scaled(t.window, metres)
  result.view = t.view and copy(t.view, known.view, "view")
  result.crop = t.crop and crop(t.crop, metres)
  result.sphere = t.sphere and sphere(t.sphere, metres)
  result.component = t.component and t.component - 1
  if t.scale_bar then
    result.scale_bar = copy(t.scale_bar, known.scale_bar, "scale_bar")
    result.scale_bar.length = scaled(t.scale_bar.length, factor_of(t.scale_bar.unit or "m", "scale_bar"))
  end
  return result
end

--- Several of the above beside each other: panel{ name =, columns = 2, figures = {...} }.
function figure.panel(t)
  return make(t, "panel")
end

--- A table of outcomes: map{ name =, blocks =, columns = {text}, kinds = {{letter =, label =, colour =}}, rows =
--- {{group =, label =, cells = "a letter of a kind per column, . for none"}} }.
function figure.map(t)
  local result = make(t, "map")
  result.columns = numeric.map(t.columns or {}, function(label) return { label = label } end)
  return result
end

--- The specification of a study's figures for the figure program.
function figure.spec(study, cases)
  local list = study.figures(cases)
  for i, entry in ipairs(type(list) == "table" and list or {}) do
    if getmetatable(entry) ~= figure_mark then
      fault.input("study.figures: entry %d is not made by stiction.figure", i)
    end
  end
  return { figures = list or {} }
end

return setmetatable(figure, {
  __index = function(_, kind)
    fault.script("there is no figure.%s%s", tostring(kind), fault.meant(kind, { "lines", "field", "map", "panel" }))
  end,
})
