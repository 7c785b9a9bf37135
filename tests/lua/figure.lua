-- Figures: what they take, what reaches the figure program, and what is said of mistakes.
local test, equal, fails = ...
local engine = require "stiction.engine"
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
  equal(field { component = "yy" }.label, "cauchy_stress, yy")
  equal(field { component = "yy", label = "own" }.label, "own")
  equal(field { component = "magnitude" }.label, nil)
  fails('component = "x"; of cauchy_stress it is "xx", "yy", "zz", "xy", "yz", "xz", or "magnitude"',
    field, { component = "x" })
  fails('component = "yy"; of displacement it is "x", "y", "z", or "magnitude"', field,
    { array = "displacement", component = "yy" })
  for _, wrong in ipairs { 0, 7, 1.5, "norm" } do
    fails("component = ", field, { component = wrong })
  end
  fails('component = "x"; a number from 1', function() return lines { curves = { { x = {}, y = {}, component = "x" } } } end)
end)

test("errors of measured points stand in the unit of their axis, one for all or one for each", function()
  local function of(more)
    local t = { x = { 1*ms, 2*ms }, y = { 3, 4 } }
    for key, value in pairs(more) do
      t[key] = value
    end
    return lines { curves = { t } }.curves[1]
  end
  equal(of({ error = 0.5 }).error[2], 0.5)
  equal(of({ x_error = { 0.25*ms, 1e-3 } }).x_error[1], 0.25)
  equal(of({ x_error = { 0.25*ms, 1e-3 } }).x_error[2], 1)
  equal(of({}).error, nil)
  fails("error has 1 values, x has 2", of, { error = { 1 } })
  fails("cannot be written in 'ms'", of, { x_error = 1*mm })
  fails("error belongs to a curve whose x and y are lists", function()
    return lines { curves = { { file = "a.h5", y = "top/force_y", error = 1 } } }
  end)
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
  fails("curve 'c': y: inf cannot be drawn", lines, { curves = { { label = "c", x = { 1, 2 }, y = { 3, 1/0 } } } })
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
  equal(figure.panel({ name = "p", svg = true, dpi = 600, figures = { lines {} } }).dpi, 600)
  fails("dpi, svg and pdf are the panel's", figure.panel, { name = "p", figures = { lines { svg = true } } })
  fails("dpi, svg and pdf are the panel's", figure.panel, { name = "p", figures = { lines { pdf = true } } })
  fails("must return a list of figures, not 3", figure.spec, { figures = function() return 3 end }, {})
  local complain, told = engine.complain, ""
  engine.complain = function(text) told = told .. text end
  stiction.figure.lines { name = "it", x = { label = "x", unit = "1" }, y = { label = "y", unit = "1", log = true },
    curves = { { label = "c", x = { 1, 2, 3 }, y = { 1, 0, -2 } }, { label = "d", x = { -1, 2 }, y = { 1, 2 } } } }
  engine.complain = complain
  equal(told, "stiction: figure 'it': 2 of the points of curve 'c' have no place on the logarithmic y axis: they are not above 0\n")
  fails("must return a list of figures, not nothing", figure.spec, { figures = function() end }, {})
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

local function case_of(folder, manifest)
  folder = engine.absolute(folder)
  engine.remove(folder)
  engine.make_folder(folder)
  engine.write_file(folder .. "/manifest.json", engine.encode_json(manifest))
  engine.write_file(folder .. "/fields.pvd", '<DataSet timestep="0"/><DataSet timestep="0.5"/>')
  local case = { folder = folder, place = "c" }
  function case.at(_, time, probe, column)
    return probe == "where" and column == "u_y" and -time or 0
  end
  return case
end

local function metres(value)
  return { value = value, unit = "m" }
end

test("the obstacles of a case are drawn in plane pictures, where its manifest and probes say they are", function()
  local disc = { kind = "rigid.circle", centre = { metres(1e-3), metres(0) }, radius = metres(2e-3) }
  local scene = { obstacles = {
    a = { shape = disc, times = { 0, 1 }, y = { metres(0), metres(1e-3) } },
    b = { shape = { kind = "rigid.plane" }, mass = 1 },
    c = { shape = { kind = "rigid.polyline", points = { metres(0), metres(0), metres(1), metres(0) }, side = "inside" }, mass = 1 },
  }, probes = { where = { kind = "probe.rigid", obstacle = "c" } } }
  local case = case_of("obstacles.test", { scene = scene })
  local function list(more)
    more.case, more.window_unit = case, "mm"
    return field(more).obstacles
  end
  local moving = list { deformed = true }
  equal(#moving, 2)
  equal(moving[1].radius, 2)
  equal(moving[1].centre[1], 1)
  equal(moving[1].path.y[2], 1)
  equal(moving[1].path.times[2], 1)
  equal(moving[2].hollow, true)
  equal(moving[2].points[3], 1000)
  equal(moving[2].path.y[2], -500)
  local still = list {}
  equal(#still, 3)
  equal(still[1].path, nil)
  equal(still[2].normal[2], 1)
  equal(list { obstacles = false }, nil)
  equal(list { view = { azimuth = 0 } }, nil)
  equal(list { obstacles = { { centre = { 0*mm, 1*mm }, radius = 3*mm } } }[1].radius, 3)
  fails("obstacle: unknown key 'center'; did you mean 'centre'?", list, { obstacles = { { center = { 0, 1 } } } })
  case = case_of("obstacles.test", { scene = { kinematics = "three_dimensional", obstacles = scene.obstacles } })
  equal(list {}, nil)
end)

test("measured values come from a csv file with their units", function()
  local path = engine.absolute("measured.test.csv")
  local function read(text, more)
    engine.write_file(path, text)
    return stiction.csv { file = path, units = more }
  end
  local table_of = read("# pulled twice\nway [mm],force (N/m),n\r\n1,2e3,3\n\n2,4,5")
  equal(tostring(table_of.way[2]), "2 mm")
  equal(table_of.force[1].si, 2000)
  equal(table_of.n[2], 5)
  local made = lines { curves = { { x = table_of.way, y = table_of.n, error = table_of.n } }, x = { label = "d", unit = "um" } }
  equal(("%.9g"):format(made.curves[1].x[2]), "2000")
  equal(read("way_mm,f\n1,2\n", { way_mm = "mm" }).way_mm[1].si, 1e-3)
  equal(stiction.csv(path).f[1], 2)
  fails("has no column 'g'; did you mean 'f'?; columns: way_mm, f", function() return stiction.csv(path).g end)
  fails("has no column 'way'; columns: way_mm, f", read, "way_mm,f\n1,2\n", { way = "mm" })
  fails("column 'way': unknown unit 'furlong'", read, "way [furlong]\n1\n")
  fails("row 2, column 'f': '-' is no number", read, "way,f\n1,2\n2,-\n")
  fails("line 2 has 1 entries, its head 2", read, "way,f\n1\n")
  fails("save it with commas", read, "way;f\n1;2\n")
  fails("no row of values", read, "way,f\n")
  fails("stiction.csv takes a file's name", stiction.csv, 3)
  fails("nowhere.csv", stiction.csv, "nowhere.csv")
end)
