-- Cases: which fit given parameters, which folder is theirs, what is told of wrong calls and failing results.
local test, equal, fails = ...
local stiction = require "stiction"
local case_module = require "stiction.case"
local engine = require "stiction.engine"
local output = require "stiction.output"
local sweep = require "stiction.sweep"
local warnings = require "stiction.warnings"
local units = stiction.units
local mm, m = units.mm, units.m

local function list_of(values, name)
  local list = {}
  for i, value in ipairs(values) do
    list[i] = case_module.new("case" .. i, { [name or "mu"] = value }, "nowhere")
  end
  return case_module.list(list)
end

test("where and find take values that are equal but for rounding, and no others", function()
  local cases = list_of { 0.4, 0.404, 0.4004, 0.40000004, 0.1 + 0.2, 0, 1e-12, -0.4 }
  equal(cases:find({ mu = 0.4 }).id, "case1")
  equal(cases:find({ mu = 0.3 }).id, "case5")
  equal(cases:find({ mu = 0 }).id, "case6")
  equal(cases:find({ mu = 0.4004 }).id, "case3")
  equal(cases:find({ mu = 0.39 }), nil)
  local lengths = list_of({ 1*mm, 1.001*mm, 1.000001*mm }, "size")
  equal(#lengths:where { size = 0.001*m }, 1)
  equal(#lengths:where { size = 0.001 }, 0)
end)

test("a method after a dot and a function after a colon are told", function()
  local cases = list_of { 1 }
  fails("write run:min(...), with a colon, not run.min(...)", function() return cases[1].min("sole", "force_x") end)
  for _, name in ipairs { "series", "columns", "max", "min", "at", "last", "derivative", "beside" } do
    fails(("write run:%s(...)"):format(name), function() return cases[1][name]("sole") end)
  end
  for _, name in ipairs { "where", "find", "values" } do
    fails(("write cases:%s(...)"):format(name), function() return cases[name] { mu = 1 } end)
  end
  for _, name in ipairs { "to", "abs", "display" } do
    fails(("write q:%s(...)"):format(name), function() return (1*mm)[name]("m") end)
  end
  fails("write numeric.max(...), with a dot, not numeric:max(...)", function() return stiction.numeric:max { 1 } end)
  fails("write schemes.make(...)", function() return stiction.schemes:make("default") end)
  equal(stiction.numeric.max { 1, 2 }, 2)
  equal((5*mm):to("m"), 0.005)
end)

test("a check that asks for a result that is none is told", function()
  local check = require "stiction.check"
  local cases = list_of { 1, 2 }
  for i, case in ipairs(cases) do
    case.results = { drag = i }
  end
  local function checked(f)
    return check.run({ results = { { name = "drag" }, { name = "lift" } }, check = f }, cases)
  end
  local held = checked(function(all, recorder)
    recorder.increasing("drag", all:values "drag")
    recorder.holds("no lift", all[1].results.lift == nil)
  end)
  equal(held[1].pass and held[2].pass, true)
  local words = "the study has no result 'drg'; did you mean 'drag'?"
  fails(words, checked, function(all, recorder) recorder.increasing("x", all:values "drg") end)
  fails(words, checked, function(all, recorder) recorder.close("x", all[1].results.drg, 1, 0.1) end)
  fails("a relative tolerance, not below 0", checked, function(_, recorder) recorder.close("x", 1, 1, -0.1) end)
  fails("and a tolerance, not below 0", checked, function(_, recorder) recorder.equal("x", 1, 1, -0.1) end)
end)

test("a result that fails leaves the others", function()
  local study = { results = { { name = "good", unit = "1", compute = function() return 1 end },
    { name = "bad", unit = "1", compute = function(_, p) return p.mu.no.such end },
    { name = "text", unit = "1", compute = function() return "x" end } } }
  local results, failures, missing = case_module.compute(study, list_of({ 1 })[1])
  equal(results.good, 1)
  equal(results.bad, nil)
  equal(#failures, 2)
  assert(failures[1]:find("result bad: cases.lua:73: ", 1, true), failures[1])
  equal(missing, false)
end)

test("a pretended case has the columns that are given, and no others", function()
  local run = case_module.pretend({ id = "a", p = {} }, { ["sole/force_y"] = 1 }, { 0, 1 }, { 3, 4 })
  equal(run:max("sole", "force_y"), 4)
  equal(run:at(0.5, "sole", "force_y"), 3.5)
  equal(run:last("sole", "force_y"), 4)
  equal(run:columns()[1], "sole/force_y")
  fails("no series 'sole/forcey'; did you mean 'sole/force_y'?", function() return run:max("sole", "forcey") end)
end)

local function study_of(sizes)
  return stiction.study { title = "t", given = { steps = 3 }, sweep = { size = sizes }, scene = function() end }
end

local function ids(study, set)
  local words = {}
  for i, case in ipairs((sweep.cases(study, { set = set }))) do
    words[i] = case.id
  end
  return table.concat(words, " ")
end

test("a case's name does not depend on how or in which unit its values are set", function()
  local study = study_of { 1*mm, 2*mm }
  equal(ids(study), "size1 size2")
  equal(ids(study, { "size=2 mm" }), "size2")
  equal(ids(study, { "size=0.002 m" }), "size2")
  equal(ids(study, { "size=2000*um" }), "size2")
  equal(ids(study, { "steps=7" }), "size1 size2")
  equal(ids(study_of { 0*mm, 2*mm }, { "size=0.002 m" }), "size2")
  local both = stiction.study { title = "t", sweep = { { a = 1 }, { a = 2 } }, scene = function() end,
    case_id = function() return "same" end }
  fails("two cases of the sweep are called 'same'", ids, both)
end)

local function write(folder, case, text)
  output.begin(folder, case, engine.encode_json { made_of = { parameters = output.plain(case.p) } })
  engine.write_file(output.case_folder(folder, case) .. "/series.txt", text)
end

local function held(folder, case)
  return engine.read_file(output.case_folder(folder, case) .. "/series.txt")
end

test("cases of other parameters share no folder, and the last one's is that of its id", function()
  local study, folder = study_of { 1*mm }, engine.absolute("settled.test")
  local own, other = sweep.cases(study, {})[1], sweep.cases(study, { set = { "steps=4" } })[1]
  engine.remove(folder)
  write(folder, own, "own")
  write(folder, other, "other")
  equal(output.case_name(folder, other), "size1")
  equal(output.case_name(folder, own):match("^size1@%x+$") ~= nil, true)
  equal(held(folder, own), "own")
  equal(held(folder, other), "other")
  output.settle(folder, { own })
  equal(output.case_name(folder, own), "size1")
  equal(held(folder, own), "own")
  equal(held(folder, other), "other")
  output.settle(folder, { own })
  equal(held(folder, own), "own")
  engine.remove(folder)
end)

test("warnings of one wording are told once", function()
  local function warned(id, ...)
    local list = {}
    for i, text in ipairs { ... } do
      list[i] = { text = text, change = "less" }
    end
    return { id = id, warnings = list }
  end
  local groups = warnings.groups { warned("a", "length 6.27 um, mesh 1e-05", "no end"), warned("b"),
    warned("c", "length 3 um, mesh 2e+05") }
  equal(#groups, 2)
  equal(groups[1].text, "length 6.27 um, mesh 1e-05")
  equal(table.concat(groups[1].ids, " "), "a c")
  equal(table.concat(groups[2].ids, " "), "a")
end)

test("a shift is towards 0 and keeps its unit; from 0 there is none", function()
  local derivatives = require "stiction.derivatives"
  local p = { size = 2*mm, mu = -0.5, zero = 0, word = "x" }
  local other, step = derivatives.shifted(p, "size")
  equal(other.size.si, 2e-3 * (1 - 1e-5))
  equal(step, other.size.si - 2e-3)
  equal(other.mu, -0.5)
  equal(p.size.si, 2e-3)
  equal(select(2, derivatives.shifted(p, "mu")) > 0, true)
  equal(derivatives.shifted(p, "zero"), nil)
  fails("study.derivatives: 'word' is x; only of a number", function() derivatives.shifted(p, "word") end)
end)

test("checks fail on what is no number, and refuse other dimensions and statements that are none", function()
  local check = require "stiction.check"
  local s, nan, MPa = units.s, 0 / 0, units.MPa
  local recorder, list = check.recorder()
  recorder.increasing("a", { 5, nan, 2 })
  recorder.increasing("b", { nan, 1 })
  recorder.non_decreasing("c", { 1, nan, 7 })
  recorder.non_increasing("d", { 5, nan, 2 })
  recorder.equal("e", nan, 1, 10)
  recorder.holds("f", nil)
  for _, entry in ipairs(list) do
    assert(entry.pass == false, entry.name)
  end
  recorder.close("g", 3*mm, 0.003*m, 1e-9)
  recorder.within("h", 0.003, 2*mm, 4*mm)
  recorder.non_decreasing("i", { 1*mm, 0.002*m })
  recorder.holds("j", ("text"):find("z"))
  equal(recorder.holds("k", ("text"):find("t")), true)
  equal(list[7].pass and list[8].pass and list[9].pass and not list[10].pass, true)
  local function refused(words, name, ...) fails(words, recorder[name], "x", ...) end
  refused("dimensions differ", "close", 3*mm, 0.003*s, 0.01)
  refused("dimensions differ", "within", 3*mm, 2*s, 4*s)
  refused("dimensions differ", "increasing", { 1*mm, 1*s, 2*MPa })
  refused("both finite", "close", 3, 1 / 0, 0.01)
  refused("both finite", "equal", 3, 5, math.huge)
  refused("two bounds", "within", 3, nan, 4)
  refused('needs true or false, not "false"', "holds", "false")
  refused("needs true or false, not 0", "holds", 0)
  refused("needs true or false, not a function", "holds", print)
  fails("run:at takes a time, not 0.5 mm", function() return list_of({ 1 })[1]:at(0.5*mm, "sole", "force_y") end)
  fails("dimensions of 3 mm and 2 MPa differ", recorder.proof, { case = "c", quantity = "q", kind = "exact", reference = 2*MPa,
    tolerance = 1, values = { { 1, 3*mm } } })
  fails("two resolutions are equal", recorder.proof, { case = "c", quantity = "q", kind = "exact", reference = 2, order = 1,
    tolerance = 1, values = { { 1, 3 }, { 1, 2 } } })
end)

test("cases that are warned alike tell each what it asks for", function()
  local function told(id, number) return { id = id, warnings = { { text = "it opens by " .. number .. " u0",
    change = number * 200 .. " steps" } } } end
  local groups = warnings.groups { told("a", 2), told("b", 15), told("c", 2) }
  equal(#groups, 1)
  equal(table.concat(groups[1].ids, " "), "a b c")
  local told_changes = {}
  for i, change in ipairs(groups[1].changes) do
    told_changes[i] = change.words .. " for " .. table.concat(change.ids, " ")
  end
  equal(table.concat(told_changes, ", "), "400 steps for a c, 3000 steps for b")
end)

test("of warnings alike the one of the most per cent is told", function()
  local function told(id, share)
    return { id = id, warnings = { { text = ("time steps made %g %% of 3 J"):format(share) } } }
  end
  local groups = warnings.groups { told("a", 2.5), told("b", 1580), told("c", 31) }
  equal(#groups, 1)
  equal(groups[1].text, "time steps made 1580 % of 3 J")
  equal(#groups[1].ids, 3)
end)
