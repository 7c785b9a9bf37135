-- Figures: what they take, what reaches the figure program, and what is said of mistakes.
local test, equal, fails = ...
local figure_keys = require "stiction.figure_keys"
local stiction = require "stiction"
local figure, units = stiction.figure, stiction.units
local mm, ms, s = units.mm, units.ms, units.s

local function field(more)
  local t = { name = "f", file = "a.pvd", array = "cauchy_stress" }
  for key, value in pairs(more) do
    t[key] = value
  end
  return figure.field(t)
end

local function lines(more)
  local t = { name = "l", x = { label = "time", unit = "ms" }, y = { label = "force" }, curves = {} }
  for key, value in pairs(more) do
    t[key] = value
  end
  return figure.lines(t)
end

test("components of fields have names, numbers from 1, or are the magnitude", function()
  for i, name in ipairs { "xx", "yy", "zz", "xy", "yz", "xz" } do
    equal(field { component = name }.component, i - 1)
    equal(field { component = i }.component, i - 1)
  end
  equal(field { array = "displacement", component = "z" }.component, 2)
  equal(field { array = "my_own", component = "xz" }.component, 5)
  equal(field { component = "magnitude" }.component, nil)
  equal(field {}.component, nil)
  fails('component = "x"; of cauchy_stress it is "xx", "yy", "zz", "xy", "yz", "xz", or "magnitude"',
    field, { component = "x" })
  fails('component = "yy"; of displacement it is "x", "y", "z", or "magnitude"', field,
    { array = "displacement", component = "yy" })
  for _, wrong in ipairs { 0, 7, 1.5, "norm" } do
    fails("component = ", field, { component = wrong })
  end
  fails('component = "x"; a number from 1', function() return lines { curves = { { x = {}, y = {}, component = "x" } } } end)
end)

test("a scale bar is a length however it is given", function()
  for _, bar in ipairs { 1*mm, { length = 1*mm, unit = "mm" } } do
    local made = field { scale_bar = bar }.scale_bar
    equal(made.unit, "mm")
    equal(math.abs(made.length - 1) < 1e-12, true)
  end
  equal(field { scale_bar = 1e-3 }.scale_bar.length, 1e-3)
  fails("scale_bar = 1 s; a length is wanted", field, { scale_bar = 1*s })
  fails('scale_bar is a table with length, unit, not "1 mm"', field, { scale_bar = "1 mm" })
end)

test("what is no table, no list, or in another unit is told", function()
  fails("view is a table with azimuth, elevation, not 30", field, { view = 30 })
  fails("figure.lines: x is a table with label, log, range, unit, not \"time\"", lines, { x = "time" })
  fails("figure.lines: curves: a list { ... } is wanted, not a table", lines, { curves = { x = { 1 }, y = { 1 } } })
  fails("figure.lines: marks: a list { ... } is wanted, not 3", lines, { marks = 3 })
  fails("figure.lines: x: 1 mm cannot be written in 'ms'", lines, { marks = { { x = 1*mm } } })
  fails("figure.lines: x: a number or a quantity is wanted, not \"now\"", lines, { marks = { { x = "now" } } })
  fails("figure.field: time: 1 mm cannot be written in 's'", field, { time = 1*mm })
  fails("figure.panel: figures holds a table; each is made by", figure.panel, { name = "p", figures = { { name = "x" } } })
  fails("unknown key 'color'; did you mean 'colour'?", lines, { curves = { { x = {}, y = {}, color = 1 } } })
  equal(lines { marks = { { x = 2*ms } } }.marks[1].x, 2)
end)

test("title and height of a panel reach the figure program, and a single figure is a list of one", function()
  local panel = figure.panel { name = "p", title = "All", height = 90, figures = { lines {} } }
  local spec = figure.spec({ figures = function() return panel end }, {})
  equal(#spec.figures, 1)
  equal(spec.figures[1].title, "All")
  equal(spec.figures[1].height, 90)
  fails("must return a list of figures, not 3", figure.spec, { figures = function() return 3 end }, {})
end)

test("every key that a table takes is explained", function()
  for name in pairs { lines = 1, field = 1, panel = 1, map = 1, axis = 1, curve = 1, mark = 1 } do
    equal(type(figure_keys.known[name]), "table")
  end
  for _, entry in ipairs(figure_keys.tables) do
    for _, key in ipairs(entry[3]) do
      equal(#key[2] > 0, true)
    end
  end
end)
