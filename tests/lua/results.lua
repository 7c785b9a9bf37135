-- Tools on histories, the list of cases, checks, figures.
local test, equal, fails = ...
local stiction = require "stiction"
local case_module = require "stiction.case"
local check = require "stiction.check"
local engine = require "stiction.engine"
local numeric = stiction.numeric
local output = require "stiction.output"
local progress = require "stiction.progress"
local report = require "stiction.report"
local units = stiction.units
local mm, ms, s = units.mm, units.ms, units.s

test("numeric tools on lists", function()
  local value, at = numeric.max { 1, 5, 2, 5 }
  equal(value, 5)
  equal(at, 2)
  equal(numeric.min { 3, 1, 2 }, 1)
  equal(numeric.extreme { 3, -7, 2 }, -7)
  equal(numeric.extreme { 7, -7 }, 7)
  equal(numeric.argmax { 3, 9 }, 2)
  equal(numeric.interpolate({ 0, 1, 3 }, { 0, 10, 30 }, 2), 20)
  equal(numeric.interpolate({ 0, 1, 3 }, { 0, 10, 30 }, -1), 0)
  equal(numeric.interpolate({ 0, 1, 3 }, { 0, 10, 30 }, 9), 30)
  equal(numeric.first_where({ 0, 1, 3 }, function(x) return x > 0.5 end), 2)
  equal(numeric.first_where({ 0, 1, 3 }, function(x) return x > 5 end), nil)
  equal(numeric.integral({ 0, 1, 3 }, { 0, 2, 2 }), 5)
  fails("empty", numeric.max, {})
  fails("two lists of one length", numeric.interpolate, { 1 }, {}, 0)
end)

local function some_cases()
  local list = {}
  for _, v in ipairs { 1, 2 } do
    for _, mu in ipairs { 0, 0.4 } do
      local case = case_module.new(("v%g_mu%g"):format(v, mu), { v = v*mm/s, mu = mu }, "nowhere")
      case.results = { peak = v + mu }
      list[#list + 1] = case
    end
  end
  return case_module.list(list, true)
end

test("cases are picked by their parameters", function()
  local cases = some_cases()
  equal(#cases:where { mu = 0.4 }, 2)
  equal(cases:find { v = 0.001*units.m/s, mu = 0.4 }.id, "v1_mu0.4")
  equal(cases:find { v = 3*mm/s, mu = 0.4 }, nil)
  equal(table.concat(cases:where { mu = 0 }:values("peak"), " "), "1 2")
  equal(cases:where { mu = 0 }.quick, true)
  fails("2 cases fit, not one", function() return cases:find { mu = 0 } end)
  fails("a case has no 'peak'", function() return cases[1].peak end)
end)

--- What f(...) writes.
local function printed(f, ...)
  local words, write = {}, engine.write
  engine.write = function(text) words[#words + 1] = text end
  local held, reason = pcall(f, ...)
  engine.write = write
  assert(held, tostring(reason))
  return table.concat(words)
end

local function verdicts(f)
  local recorder, list = check.recorder()
  f(recorder)
  local words = {}
  for i, entry in ipairs(list) do
    words[i] = entry.pass and "yes" or "no"
  end
  return table.concat(words, " "), list
end

test("checks hold exactly where they should", function()
  equal(verdicts(function(c)
    c.equal("a", 1.05, 1, 0.05 + 1e-12)
    c.equal("b", 1.06, 1, 0.05)
    c.equal("c", 0/0, 1, 1)
    c.equal("d", nil, 1, 1)
    c.close("e", 102, 100, 0.03)
    c.close("f", -104, -100, 0.03)
    c.within("g", 2, 2, 3)
    c.within("h", 1.9, 2, 3)
    c.within("i", 3.1, 2, 3)
    c.holds("j", true)
    c.holds("k", nil)
  end), "yes no no no yes no yes no no yes no")
  equal(verdicts(function(c)
    c.non_decreasing("a", { 1, 1, 2 })
    c.non_decreasing("b", { 1, 0.9, 2 })
    c.non_decreasing("c", { 1, 0.9, 2 }, 0.11)
    c.non_increasing("d", { 3, 3, 2 })
    c.increasing("e", { 1, 2 })
    c.increasing("f", { 1, 1 })
    c.equal("g", 5*mm, 0.005*units.m, 1e-9*units.m)
  end), "yes no yes yes yes no yes")
  equal(verdicts(function(c) -- of one value, as --set may leave, nothing rises or falls: that is no check
    c.non_decreasing("a", { 1 })
    c.non_increasing("b", { 1 })
    c.increasing("c", { 1 })
    c.holds("d", true)
  end), "yes")
end)

test("checks keep their numbers and refuse nonsense", function()
  local _, list = verdicts(function(c) c.within("x", 2, 1, 5) end)
  equal(list[1].expected, 3.0)
  equal(list[1].tolerance, 2.0)
  fails("name of its own", verdicts, function(c)
    c.holds("x", true)
    c.holds("x", true)
  end)
  fails("needs an expected number", verdicts, function(c) c.equal("x", 1) end)
  fails("there is no check.equals; did you mean 'equal'?", verdicts, function(c) c.equals("x", 1) end)
end)

test("results are kept in SI, whatever their unit, and printed in it", function()
  local study = { results = { { name = "peak", unit = "mm", compute = function(case) return 2 * case.p.size end },
    { name = "rise", unit = "mm", compute = function() return 0.003 end } } }
  local case = case_module.new("one", { size = 4*mm }, "nowhere")
  local results = case_module.compute(study, case)
  equal(results.peak, 0.008)
  equal(results.rise, 0.003)
  local text = printed(report.cases, study, { { case = case, result = { verdict = "finished", results = results } } })
  assert(text:find("one +finished +8 +3\n"), text)
end)

test("what is 0 is shown as that, whatever its sign", function()
  equal(report.in_unit({ unit = "mm" }, -0.0), "0")
  equal(report.in_unit({ unit = "1" }, -1e-3), "-0.001")
  equal(report.in_unit({}, 0), "0")
end)

test("failures of many cases are told once, of few each", function()
  local study, rows = { results = {} }, {}
  for i = 1, 9 do
    rows[i] = { case = { id = "c" .. i }, result = i < 3 and { verdict = "stopped", reason = "by the user" }
      or { verdict = "failed", reason = ("no force at %g s"):format(0.1 * i) } }
  end
  local text = printed(report.cases, study, rows)
  assert(text:find("c1: stopped: by the user\nc2: stopped: by the user\n", 1, true), text)
  assert(text:find("c3: failed: no force at 0.3 s\n  alike in 6 more: c4, c5, c6, c7, c8, c9\n", 1, true), text)
end)

test("a sweep says where it stands", function()
  equal(progress.sweep_line({ total = 100, done = 20, failed = 1, began = 10 }, 2, 70),
    "20 of 100 cases done, 1 failed, 2 running  20/min  left 4 min 00 s")
  equal(progress.sweep_line({ total = 9, done = 0, failed = 0, began = 10 }, 2, 70), "0 of 9 cases done, 0 failed, 2 running  0/min")
end)

test("checks that failed are counted and told", function()
  local list = select(2, verdicts(function(c)
    c.equal("low", 1, 2, 0.5)
    c.holds("right", true)
    c.within("high", 4, 2, 3)
  end))
  local failed
  local text = printed(function() failed = report.checks(list) end)
  equal(failed, 2)
  assert(text:find("check failed: high: value 4", 1, true) and text:find("1 of 3 checks held", 1, true), text)
end)

test("a result counts as done only for what it was run with", function()
  equal(output.is_done({ verdict = "finished", fingerprint = "a" }, "a"), true)
  equal(output.is_done({ verdict = "finished", fingerprint = "a" }, "b"), false)
  equal(output.is_done({ verdict = "not converged", fingerprint = "a" }, "a"), false)
  equal(output.is_done(nil, "a"), false)
end)

test("figures are written in the units of their axes", function()
  local case = some_cases()[2]
  local lines = stiction.figure.lines { name = "f", x = { label = "t", unit = "ms", range = { 0, 5*ms } },
    y = { label = "u", unit = "mm" }, curves = { { label = "a", case = case, y = "crown/u", x_shift = 2*ms },
      { label = "b", x = { 0, 0.001 }, y = { 1*mm, 0.002 } }, { label = "c", case = case, y = "line/u", component = 3 } },
    marks = { { x = 1*ms, label = "onset" } } }
  equal(lines.x.range[2], 5.0)
  equal(lines.curves[1].file, "v1_mu0.4/series.h5")
  equal(lines.curves[1].x, "/time")
  equal(lines.curves[1].y, "/crown/u")
  equal(lines.curves[1].x_shift, 0.002)
  equal(lines.curves[2].x[2], 1.0)
  equal(lines.curves[2].y[1], 1.0)
  equal(lines.curves[2].y[2], 2.0)
  equal(lines.curves[3].component, 2)
  equal(lines.marks[1].x, 1.0)
  local field = stiction.figure.field { name = "g", case = case, array = "von_mises", unit = "MPa", time = 2*ms,
    range = { 0, 2e6 }, window = { 0, 1e-3, 0, 1*mm }, window_unit = "mm" }
  equal(field.time, 0.002)
  equal(field.range[2], 2.0)
  equal(field.window[4], 1.0)
  equal(field.file, "v1_mu0.4/fields.pvd")
  local solid = stiction.figure.field { name = "s", case = case, array = "von_mises", window_unit = "mm",
    view = { azimuth = -20 }, mirror = { "x", "y" }, crop = { ymin = 0, zmax = 2*mm },
    sphere = { centre = { 0, 0, 9*mm }, radius = 4e-3, path = { times = { 0, 2*ms }, z = { 0, -1*mm } } } }
  equal(solid.view.azimuth, -20)
  equal(solid.mirror[2], "y")
  equal(solid.crop.zmax, 2.0)
  equal(solid.sphere.centre[3], 9.0)
  equal(solid.sphere.radius, 4.0)
  equal(solid.sphere.path.times[2], 0.002)
  equal(solid.sphere.path.z[2], -1.0)
  fails("view: unknown key 'azimut'; did you mean 'azimuth'?", stiction.figure.field, { view = { azimut = 1 } })
  fails("sphere: unknown key 'center'", stiction.figure.field, { sphere = { center = { 0, 0 } } })
  fails("sphere.path: unknown key 'time'", stiction.figure.field, { sphere = { path = { time = {} } } })
  fails("crop: unknown key 'xmid'", stiction.figure.field, { crop = { xmid = 0 } })
  fails("unknown key 'curve'; did you mean 'curves'?", stiction.figure.lines, { curve = {} })
  fails("unknown unit '5'", stiction.figure.lines, { x = { unit = 5 } })
  fails("unknown unit 'mq'", stiction.figure.lines, { x = { unit = "mq" } })
  fails("there is no figure.line", function() return stiction.figure.line end)
end)
