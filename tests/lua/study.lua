-- The study table: its keys, its parameters, and the cases they multiply out to.
local test, equal, fails = ...
local stiction = require "stiction"
local sweep = require "stiction.sweep"
local units = stiction.units
local mm, s = units.mm, units.s

local function make(changes)
  local t = { title = "t", scene = function() end }
  for key, value in pairs(changes) do
    t[key] = value
  end
  return stiction.study(t)
end

local function ids(study, options)
  local words = {}
  for i, case in ipairs((sweep.cases(study, options or {}))) do
    words[i] = case.id
  end
  return table.concat(words, " ")
end

local two = { given = { radius = 5*mm }, chosen = { dt = { 0.1*s, "why" } },
  sweep = { { "v", { 1000*mm/s, 333.3*mm/s } }, { "mu", { 0, 0.4 } } },
  quick = { sweep = { v = { 1000*mm/s } }, set = { dt = 1*s } } }

test("a sweep is a product, named in its stated unit", function()
  equal(ids(make(two)), "v1000_mu0 v1000_mu0.4 v333.3_mu0 v333.3_mu0.4")
  equal(ids(make { sweep = { mu = { 0, 1 }, b = { 2 } } }), "b2_mu0 b2_mu1")
  equal(ids(make { sweep = { { mu = 0, b = 1 }, { mu = 1, b = 5 } } }), "b1_mu0 b5_mu1")
  equal(ids(make { sweep = { kind = { "a b", "c" } } }), "kinda_b kindc")
  equal(ids(make {}), "case")
  equal(ids(make { sweep = { mu = { 0, 1 } }, case_id = function(p) return "x" .. p.mu end }), "x0 x1")
end)

test("quick and --set change values, a swept one is fixed", function()
  equal(ids(make(two), { quick = true }), "v1000_mu0 v1000_mu0.4")
  equal(ids(make { sweep = { mu = { 0, 1 } }, quick = { sweep = { mu = { 0.1, 0.2 } } } }, { quick = true }), "mu0.1 mu0.2")
  equal(ids(make(two), { set = { "mu=0.2" } }), "v1000_mu0.2 v333.3_mu0.2")
  equal(ids(make(two), { set = { "v=0.5 m/s", "mu = 1e-1" } }), "v500_mu0.1")
  equal(sweep.cases(make(two), { quick = true })[1].p.dt, 1*s)
  equal(sweep.cases(make(two), { quick = true, set = { "dt=5 ms" } })[1].p.dt, 0.005*s)
  equal(sweep.cases(make(two), {})[1].p.dt, 0.1*s)
  equal(ids(make { sweep = { { mu = 0, b = 1 }, { mu = 1, b = 1 } } }, { set = { "mu=3" } }), "b1_mu3")
end)

test("what --set cannot do is told", function()
  local function set(text)
    return function() return sweep.cases(make(two), { set = { text } }) end
  end
  fails("no parameter 'raduis'; did you mean 'radius'?", set "raduis=3 mm")
  fails("'radius' must be like 5 mm, not 3", set "radius=3")
  fails("'radius' must be like 5 mm, not 3 s", set "radius=3 s")
  fails("unknown unit 'furlong'", set "radius=3 furlong")
  fails("write NAME=VALUE", set "radius")
end)

test("a misspelt parameter is told where it is used", function()
  local p = sweep.cases(make(two), {})[1].p
  fails("there is no parameter 'raduis'; did you mean 'radius'?", function() return p.raduis end)
end)

test("a scene cannot change its parameters", function()
  local study = make { sweep = { mu = { 0.1 } }, scene = function(p) p.mu = 2 * p.mu end }
  fails("the parameter 'mu' cannot be changed in a scene", function() study:scene_of(sweep.cases(study, {})[1]) end)
end)

test("results that share the name of another column are listed", function()
  local function doubled(t, name)
    t.results = { { name = name, unit = "N", function() return 1 end } }
    local list = make(t).doubled
    return list[1] and list[1].name .. " " .. list[1].why or ""
  end
  equal(doubled({ sweep = { v = { 1, 2 } } }, "v"), "v is swept")
  equal(doubled({ quick = { sweep = { { v = 1 } } } }, "v"), "v is swept")
  equal(doubled({}, "steps"), "steps is told of every case")
  equal(doubled({ sweep = { v = { 1, 2 } } }, "F"), "")
end)

test("mistakes in the study table are told", function()
  fails("unknown key 'titel'; did you mean 'title'?", make, { titel = "x" })
  fails("study.scene must be a function, not a number", make, { scene = 3 })
  fails("study has scene and problem", make, { problem = function() end })
  fails("study.scene is missing", stiction.study, { title = "t" })
  fails("study.chosen.dt needs its reason", make, { chosen = { dt = 3 } })
  fails("'dt' stands in both given and chosen", make, { given = { dt = 3 }, chosen = { dt = { 3, "why" } } })
  local function result(name) return { name = name, unit = "N", function() return 1 end } end
  fails("study.results: there are two called 'F'", make, { results = { result "F", result "F" } })
  fails("entry 1 has no name", make, { results = { result() } })
  fails("study.sweep.mu must be a list", make, { sweep = { mu = 3 } })
  fails("study.sweep.mu: value 2, 0.5 mm, is not of the first's dimension, 0.2", make, { sweep = { mu = { 0.2, 0.5*mm } } })
  fails("study.sweep.mu: value 2, 3 s, is not of the first's dimension, 2 mm", make, { sweep = { mu = { 2*mm, 3*s } } })
  fails("mu of case 2, 2 mm, is not of the first's dimension, 1", make, { sweep = { { mu = 1 }, { mu = 2*mm } } })
  fails("0.2 stands there without a name; write sweep = { mu = { 0.2, 0.5 } }", make, { sweep = { { 0.2, 0.5 } } })
  fails("the name 'a,b' holds a ','", make, { results = { result "a,b" } })
  fails("the name 'a?b' holds a control character", make, { results = { result "a\nb" } })
  fails("study.results.peak must be", make, { results = { peak = { unit = "Pa" } } })
  fails("study.results.peak: the unit is a boolean; a text is wanted", make, { results = { peak = { unit = true, function() end } } })
  fails("study.results.peak: unknown unit 'Pq'", make, { results = { peak = { unit = "Pq", function() end } } })
  fails("'mu' is swept, but stands in given or chosen", function()
    return ids(make { given = { mu = 1 }, sweep = { mu = { 1 } } })
  end)
  for _, b in ipairs { 2, 2*mm } do
    fails("a case gives 'b', which the first does not", function()
      return ids(make { sweep = { { mu = 0 }, { mu = 1, b = b } } })
    end)
  end
  fails("the sweep makes case 'mu0.1' twice", function() return ids(make { sweep = { mu = { 0.1, 0.2, 0.1 } } }) end)
  fails("two cases of the sweep are called 'x'", function()
    return ids(make { sweep = { mu = { 1, 2 } }, case_id = function() return "x" end })
  end)
  fails("a case's name is a folder's name", function()
    return ids(make { case_id = function() return "../x" end })
  end)
end)

test("derivatives are with respect to parameters of the study", function()
  local study = make { given = { radius = 5*mm }, sweep = { mu = { 0, 0.4 } }, derivatives = { "radius", "mu" } }
  equal(table.concat(study.derivatives, " "), "radius mu")
  equal(#make({}).derivatives, 0)
  equal(#make({ sweep = { { mu = 1 }, { mu = 2 } }, derivatives = { "mu" } }).derivatives, 1)
  fails("study.derivatives: the study has no parameter 'nu'; give a list of names", function()
    make { given = { radius = 5*mm }, derivatives = { "nu" } }
  end)
  fails("study has problem and derivatives", function()
    stiction.study { title = "t", problem = function() end, given = { radius = 5*mm }, derivatives = { "radius" } }
  end)
end)
