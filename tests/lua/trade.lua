-- The arithmetic of a trade: references, the front, promising combinations.
local test, equal, fails = ...
local accuracy = require "stiction.trade.accuracy"
local check = require "stiction.check"
local claim = require "stiction.trade.claim"
local engine = require "stiction.engine"
local exchange = require "stiction.trade.exchange"
local ladder = require "stiction.ladder"
local output = require "stiction.output"
local pictures = require "stiction.trade.pictures"
local quantity = require "stiction.trade.quantity"
local reference = require "stiction.trade.reference"
local units = require("stiction").units

local function near(got, wanted, tolerance)
  if got ~= got or math.abs(got - wanted) > (tolerance or 1e-9) * math.max(1, math.abs(wanted)) then
    error(("got %.17g, wanted %.17g"):format(got, wanted), 2)
  end
end

local mm = units.mm
local knobs = ladder.knobs(
  { { "size", { 4*mm, 2*mm, 1*mm } }, { "steps", { 10, 20, 40 } }, { "scheme", { "a", "b" } } },
  { size = 2*mm, steps = 20, scheme = "a" })

test("knobs know where they stand and where they are refined to", function()
  equal(table.concat(ladder.levels(knobs), " "), "2 2 1")
  equal(table.concat(ladder.corner(knobs), " "), "3 3 1")
  near(ladder.resolution(knobs[1], 3), 1e-3)
  near(ladder.resolution(knobs[2], 3), 1 / 40)
  equal(#ladder.first_round(knobs), 7) -- the default, two more of each number, one word, the corner
end)

test("a knob that no scene reads is told, as all its levels give one scene", function()
  local stiction = require "stiction"
  local study = stiction.study { title = "t", scene = function(p) return { steps = p.steps } end,
    chosen = { steps = { 20, "why" }, size = { 2*mm, "why" } } }
  local case = { id = "a", p = { steps = 20, size = 2*mm } }
  study:scene_of(case)
  claim.require_read(study, { { name = "steps" } })
  fails("study.trade.knobs: no scene reads 'size'", claim.require_read, study, { { name = "steps" }, { name = "size" } })
end)

test("levels that lie close are told apart", function()
  local close = ladder.knobs({ { "n", { 1000, 1001, 1002 } } }, { n = 1001 })
  equal(close[1].default, 2)
  equal(ladder.level_of(close[1], 1001 * (1 + 1e-12)), 2)
  equal(ladder.level_of(close[1], 1001.5), nil)
end)

test("knobs that cannot be are refused", function()
  fails("must be one of its levels", function() ladder.knobs({ { "n", { 1, 2 } } }, { n = 3 }) end)
  fails("has no parameter", function() ladder.knobs({ { "n", { 1, 2 } } }, { m = 3 }) end)
  fails("rise or fall", function() ladder.knobs({ { "n", { 1, 3, 2 } } }, { n = 3 }) end)
  fails("at least two levels", function() ladder.knobs({ { "n", { 1 } } }, { n = 1 }) end)
  fails("lists no knob", function() ladder.knobs({}, {}) end)
end)

--- Runs of a model world: value = 10 + 1e5 size^2 + 2/steps (+ 1 for scheme b), work rising with refinement.
local function world(list)
  local runs = {}
  for i, chosen in ipairs(list) do
    local size, steps = knobs[1].levels[chosen[1]].si, knobs[2].levels[chosen[2]]
    runs[i] = { levels = chosen, values = { q = 10 + 1e5 * size ^ 2 + 2 / steps + (chosen[3] == 2 and 1 or 0) },
      work = steps / size ^ 2 }
  end
  return runs
end

local quantities = { { name = "q" } }

test("the reference is the limit in all numbers at once", function()
  local runs = world(ladder.first_round(knobs))
  local references = reference.all(knobs, runs, quantities)
  near(references.q.value, 10, 1e-6)
  assert(references.q.uncertainty < 0.1 and references.q.uncertainty > 0.02, references.q.uncertainty)
  exchange.judge(runs, references, quantities)
  near(runs[1].error, 0.05, 1e-6) -- 0.4 of the size, 0.1 of the steps, over 10
  assert(runs[1].bound > runs[1].error)
end)

test("what two numbers do together adds to the reference's uncertainty", function()
  local runs = world(ladder.first_round(knobs))
  for _, run in ipairs(runs) do
    local size, steps = knobs[1].levels[run.levels[1]].si, knobs[2].levels[run.levels[2]]
    run.values.q = run.values.q + 4 * (1e5 * size ^ 2) * (2 / steps)
  end
  -- corrections of 0.1 (1 + 0.4) and 0.05 (1 + 1.6) with half of each; half of 4 (0.4 - 0.1) (0.1 - 0.05) together
  near(reference.all(knobs, runs, quantities).q.uncertainty, math.sqrt(0.07 ^ 2 + 0.065 ^ 2 + 0.03 ^ 2), 1e-6)
end)

test("what two numbers do together counts as well where no order shows", function()
  local runs = world(ladder.first_round(knobs))
  for _, run in ipairs(runs) do
    local size, steps = 1e6 * knobs[1].levels[run.levels[1]].si ^ 2, knobs[2].levels[run.levels[2]]
    run.values.q = 10 + (size == 4 and 0.1 or 0) + (steps == 20 and 0.1 or 0) + (size == 1 and steps == 40 and 3 or 0)
  end
  -- differences of 0.1 to and fro along both; half of 3 where both are finest
  near(reference.all(knobs, runs, quantities).q.uncertainty, math.sqrt(2 * 0.1 ^ 2 + 1.5 ^ 2), 1e-6)
end)

test("what a number leaves exactly as it is, though it moves others, is told", function()
  local runs, both = world(ladder.first_round(knobs)), { { name = "q" }, { name = "t" } }
  local function told()
    local its = reference.all(knobs, runs, both).t
    return its.doubt or ""
  end
  for _, run in ipairs(runs) do
    run.values.t = 1 / knobs[2].levels[run.levels[2]]
  end
  equal(told(), "size moves others and leaves it exactly as it is; it may take steps")
  both[2].watched = true
  equal(told(), "")
  both[2] = { name = "t", exact = 1 }
  equal(told(), "")
end)

test("without its finest run there is no reference", function()
  local runs = world(ladder.first_round(knobs))
  runs[#runs].values = nil
  local references, reason = reference.all(knobs, runs, quantities)
  equal(references, nil)
  assert(reason:find("did not finish"), reason)
end)

test("the front holds what nothing beats; promising combinations are new and no dearer than the finest", function()
  local runs = world(ladder.first_round(knobs))
  local references = reference.all(knobs, runs, quantities)
  exchange.judge(runs, references, quantities)
  local front = exchange.front(runs)
  for i = 2, #front do
    assert(front[i].work > front[i - 1].work and front[i].error < front[i - 1].error)
  end
  local seen = {}
  for _, run in ipairs(runs) do
    seen[table.concat(run.levels, " ")] = true
  end
  local promising = exchange.promising(knobs, runs, references, quantities, 3)
  assert(#promising >= 1 and #promising <= 3)
  for _, chosen in ipairs(promising) do
    equal(seen[table.concat(chosen, " ")], nil)
    equal(chosen[3], 1) -- scheme b is always a unit off
  end
end)

--- A straight curve a + b x on [0, 2] with n + 1 points.
local function straight(n, a, b)
  local curve = { x = {}, y = {} }
  for i = 0, n do
    curve.x[i + 1], curve.y[i + 1] = 2 * i / n, a + b * 2 * i / n
  end
  return curve
end

test("the norm of a curve is that of its polygon, whatever its points", function()
  for _, n in ipairs { 1, 3, 8 } do
    local entry, run = { name = "c" }, { values = {}, curves = { c = straight(n, 1, -1) } }
    quantity.align(entry, { run })
    near(quantity.size(entry, run.values.c), math.sqrt(2 / 3)) -- integral of (1 - x)^2 over 0 .. 2
  end
  near(quantity.size({}, -3), 3)
end)

test("curves are compared on the abscissas of the one with most points", function()
  local coarse = { values = {}, curves = { c = straight(2, 1, 0) } }
  local fine = { values = {}, curves = { c = straight(7, 1, 0.5) } }
  local entry = { name = "c" }
  quantity.align(entry, { coarse, fine, { verdict = "stopped" } })
  equal(#coarse.values.c, 8)
  near(quantity.distance(entry, coarse.values.c, fine.values.c), math.sqrt(2 / 3)) -- integral of x^2 / 4 over 0 .. 2
end)

--- Runs of the model world whose curve is 3 + size^2 * 1e5 + 1 / steps everywhere on [0, 2].
local function curved_world()
  local runs = world(ladder.first_round(knobs))
  for _, run in ipairs(runs) do
    local size, steps = knobs[1].levels[run.levels[1]].si, knobs[2].levels[run.levels[2]]
    run.curves = { c = straight(steps, 3 + 1e5 * size ^ 2 + 1 / steps, 0) }
  end
  return runs
end

test("a curve's error is the relative L2 norm of its difference from the finest run's", function()
  local runs, curve = curved_world(), { name = "c", curve = true }
  quantity.align(curve, runs)
  local references = reference.all(knobs, runs, { curve })
  exchange.judge(runs, references, { curve })
  local finest = 3 + 0.1 + 1 / 40
  near(runs[1].error, (3 + 0.4 + 1 / 20 - finest) / finest)
  near(references.c.scale, finest * math.sqrt(2))
  -- what is left of order 2 and 1: 0.1 of the size, and as it begins more than a quarter off, its last difference of 0.3;
  -- 1/40 of the steps with half of it more
  near(references.c.uncertainty, math.sqrt((0.1 + 0.3) ^ 2 + (1.5 * 0.025) ^ 2) * math.sqrt(2), 1e-6)
  near(reference.order(reference.line(knobs, runs, knobs[1], curve), curve), 2, 1e-6)
end)

test("what is known exactly has no uncertainty and needs no finest run", function()
  local runs = curved_world()
  runs[#runs].values, runs[#runs].curves = nil, nil
  local curve = { name = "c", curve = true, exact = function(x) return 3 + 0 * x end }
  local number = { name = "q", exact = 10 }
  quantity.align(curve, runs)
  local references = reference.all(knobs, runs, { curve, number })
  exchange.judge(runs, references, { curve, number })
  equal(references.c.uncertainty, 0)
  equal(references.q.uncertainty, 0)
  near(runs[1].errors.c, 0.45 / 3)
  near(runs[1].errors.q, 0.05)
  near(runs[1].bound, 0.15)
  local line = reference.line(knobs, runs, knobs[1], number)
  near(reference.order(line, number), math.log(0.5 / 0.2) / math.log(2)) -- errors 0.4 + 0.1 and 0.1 + 0.1
end)

test("curves of a guess add up point by point", function()
  local runs, curve = curved_world(), { name = "c", curve = true, exact = function() return 3 end }
  quantity.align(curve, runs)
  local references = reference.all(knobs, runs, { curve })
  exchange.judge(runs, references, { curve })
  equal(#exchange.promising(knobs, runs, references, { curve }, 3) > 0, true)
end)

test("a watched quantity has an error of its own and no part in the verdict", function()
  local runs = curved_world()
  local all = { { name = "q", exact = 10 }, { name = "w", watched = true, scale = 1 } }
  for _, run in ipairs(runs) do
    run.values.w = 100 * run.values.q
  end
  exchange.judge(runs, reference.all(knobs, runs, all), all)
  near(runs[1].error, 0.05)
  near(runs[1].errors.w, 50, 1e-6)
end)

local function listed(...)
  local study = { results = { { name = "peak" }, { name = "other" } }, trade = { quantities = { ... } } }
  return quantity.list(study, { n = 7 })
end

test("quantities are results or curves, with what is known of them", function()
  local list = listed({ name = "peak", reference = 3*mm },
    { name = "c", curve = function() end, reference = function(x, p) return x * p.n end })
  near(list[1].exact, 3e-3)
  near(list[2].exact(2), 14)
  equal(list[3].name, "other")
  equal(list[3].watched, true)
  near(listed({ name = "peak", reference = function(p) return p.n end })[1].exact, 7)
  fails("no result 'pique'", function() listed("pique") end)
  fails("unknown key 'kurve'", function() listed { name = "peak", kurve = 1 } end)
  fails("is a function of its abscissa", function() listed { name = "c", series = "a/b", reference = 1 } end)
  fails("must be a number, a quantity", function() listed { name = "peak", reference = "much" } end)
  fails("probe/column", function() listed { name = "c", series = "beta" } end)
  fails("lists no result", function() listed() end)
end)

test("a curve is two lists of numbers with rising abscissas", function()
  local function curve(x, y)
    return quantity.curve({ name = "c", curve = function() return x, y end }, {})
  end
  near(curve({ 0*mm, 2*mm }, { 1, 2 }).x[2], 2e-3)
  fails("two lists of one length", function() curve({ 0, 1 }, { 1 }) end)
  fails("must rise", function() curve({ 0, 2, 1 }, { 1, 1, 1 }) end)
  fails("point 2 of curve 'c' is no number", function() curve({ 0, 1 }, { 1, 0 / 0 }) end)
end)

test("neighbours of the front are new, one number a level coarser", function()
  local runs = world(ladder.first_round(knobs))
  local all = { { name = "q", exact = 10 } }
  exchange.judge(runs, reference.all(knobs, runs, all), all)
  local seen, near_front = {}, exchange.neighbours(knobs, runs, 10)
  for _, run in ipairs(runs) do
    seen[ladder.key(run.levels)] = true
  end
  for _, chosen in ipairs(near_front) do
    equal(seen[ladder.key(chosen)], nil)
    equal(chosen[3], 1)
  end
  equal(ladder.key(near_front[1]), "1 1 1")
  equal(#exchange.neighbours(knobs, runs, 1), 1)
end)

test("--accuracy takes the cheapest bound that holds", function()
  near(accuracy.share("2%"), 0.02)
  near(accuracy.share("0.02"), 0.02)
  fails("write a share", function() accuracy.share("much") end)
  fails("did you mean 3%", function() accuracy.share("3") end)
  local runs = { { work = 1, bound = 0.1 }, { work = 3, bound = 0.01 }, { work = 2, bound = 0.02 }, { work = 0.5 } }
  equal(accuracy.cheapest(runs, 0.02).work, 2)
  local none, nearest = accuracy.cheapest(runs, 0.001)
  equal(none, nil)
  near(nearest, 0.01)
end)

test("a number is refined to its next level, by half beyond the last, never beyond that of a tolerance", function()
  local size, steps = knobs[1], knobs[2]
  local finer, ratio = ladder.finer(size, 4*mm)
  near(finer.si, 2e-3)
  near(ratio, 2)
  near(ladder.finer(size, 1*mm).si, 0.5e-3)
  near(ladder.finer(size, 3*mm).si, 2e-3)
  near(ladder.finer(size, 40*mm).si, 20e-3)
  equal(ladder.finer(steps, 10), 20)
  equal(ladder.finer(steps, 15), 40)
  equal(ladder.finer(steps, 40), 80)
  local tolerance = ladder.knobs({ { "tol", { 1e-8, 1e-10 } } }, { tol = 1e-8 })[1]
  near(ladder.finer(tolerance, 1e-8) * 1e10, 1)
  equal(ladder.finer(tolerance, 1e-10), nil)
end)

test("what is run beside a case: each number finer, each choice that is not the default", function()
  local list = claim.variants(knobs, { size = 4*mm, steps = 20, scheme = "b" })
  equal(#list, 3)
  equal(list[1].knob .. list[2].knob .. list[3].knob, "sizestepsscheme")
  near(list[1].factor, 1 / (1 - 0.5 ^ 0.4))
  equal(list[3].value, "a")
  equal(list[3].factor, 1)
  equal(#claim.variants(knobs, { size = 4*mm, steps = 20, scheme = "a" }), 2)
end)

--- A study of one judged result, one watched one and a curve, and a case of it.
local judged_study = {
  results = { { name = "q" }, { name = "w" } },
  trade = { quantities = { "q", { name = "c", curve = function(case) return { 0, 1 }, { case.level, case.level } end } } },
}
local function judged_case(level)
  return { p = {}, level = level, results = { q = 10 * level, w = 100 * level } }
end

test("a claim sums what each finer setting changes, times its factor", function()
  local found = claim.judge(judged_study, judged_case(1), { { factor = 3 }, { factor = 2 } },
    { judged_case(1.01), judged_case(0.98) }, judged_case(1.05))
  near(found.q.absolute, 0.3 + 0.4, 1e-4)
  near(found.q.relative, 0.07, 1e-4)
  near(found.w.absolute, 7, 1e-4)
  near(found.c.absolute, 0.07, 1e-4)
  near(found.q.error, 0.05)
  assert(found.q.judged and not found.w.judged)
  local none = claim.judge(judged_study, { p = {}, level = 1, results = { q = 0 / 0, w = 1 } }, {}, {})
  equal(none.q, nil)
end)

test("what a finer setting leaves exactly as it is, though it moves others, is not claimed", function()
  local steps, cells = { factor = 2, knob = "steps", value = 20 }, { factor = 4, knob = "cells", value = 8 }
  local function case(q, w, level)
    return { p = {}, level = level, results = { q = q, w = w } }
  end
  local function judged(q, w, level, variants)
    return claim.judge(judged_study, case(1, 5, 2), variants or { steps, cells }, { case(q, w, level), case(1.01, 5, 2.02) })
  end
  local found = judged(1, 5.1, 2)
  equal(found.q.unmoved, steps)
  equal(found.q.absolute, nil)
  equal(found.q.relative, math.huge)
  equal(found.c.unmoved, steps)
  equal(found.w.unmoved, cells)
  -- a setting that moves nothing has no effect, nor one that moves others by what solvers leave
  near(judged(1, 5, 2).q.absolute, 0.04, 1e-4)
  near(judged(1, 5 + 1e-9, 2).q.absolute, 0.04, 1e-4)
  -- another choice may well give the same
  near(judged(1, 5.1, 2, { { factor = 1, choice = true }, cells }).q.absolute, 0.04, 1e-4)
  -- what is 0 whatever the settings is off by nothing
  local none = claim.judge(judged_study, case(0, 5, 2), { steps }, { case(0, 5.1, 2) })
  equal(none.q.absolute, 0)
end)

test("what an accuracy is about must be measured", function()
  equal(claim.names(nil, { "peak", "force" }), nil)
  equal(table.concat(claim.names("force, peak", { "peak", "force" }), " "), "force peak")
  fails("no 'peek'; did you mean 'peak'? (it measures: peak, force)", claim.names, "peek", { "peak", "force" })
  fails("name what the trade measures", claim.names, " ", { "peak" })
end)

--- Two measured scenes, whose errors differ from quantity to quantity.
local function asked()
  local function scene(steps)
    return { p = { steps = steps, mu = 0.2 }, values = { a = 1, b = 2, c = 4 }, errors = { a = 0.1, b = 0.2, c = 0.3 } }
  end
  return { scenes = { scene(5), scene(10) }, chosen = { steps = 5, mu = 0.2 }, share = 0.03, judged = { a = true } }
end

local function case_of(steps, mu, results)
  return { id = ("s%d_mu%g"):format(steps, mu), p = { steps = steps, mu = mu }, results = results }
end

test("only the scene that was measured is claimed, in all its parameters", function()
  local own, cases = asked(), { case_of(5, 0.2), case_of(5, 0.3), case_of(7, 0.2) }
  local known = accuracy.known(own, cases, {})
  equal(table.concat(known.names, " "), "a b c")
  equal(known.of["s5_mu0.2"].b, 0.2)
  equal(known.of["s5_mu0.3"], nil)
  equal(known.of["s7_mu0.2"], nil)
  equal(#accuracy.known(own, { case_of(5, 0.3) }, {}).names, 0)
end)

test("each column of errors is that of its result, and empty where nothing is claimed", function()
  local rows = {}
  for i, case in ipairs { case_of(5, 0.2), case_of(5, 0.3) } do
    rows[i] = { case = case, result = { verdict = "finished", results = { a = 1, b = 2, c = 4 } } }
  end
  rows[1].result.derivatives = { mu = { a = 7, c = 9 } }
  local study = { results = { { name = "a" }, { name = "b" }, { name = "c" } }, derivatives = { "mu" } }
  local write, text = engine.write_file, nil
  engine.write_file = function(_, written) text = written end
  output.write_summary("", study, { "mu" }, rows, accuracy.known(asked(), { rows[1].case, rows[2].case }, {}))
  engine.write_file = write
  equal(text, "case,mu,a,b,c,verdict,steps,iterations,contact,seconds,a_error,b_error,c_error,d_a_d_mu,d_b_d_mu,d_c_d_mu,set,"
    .. "warnings\ns5_mu0.2,0.2,1,2,4,finished,,,,,0.1,0.2,0.3,7,nan,9,,\ns5_mu0.3,0.3,1,2,4,finished,,,,,,,,nan,nan,nan,,\n")
end)

test("claims of cases whose cells explain warns of are doubted, once for each warning", function()
  local report = require "stiction.report"
  local rows, lines, line = {}, {}, report.line
  local locks = "body b: plain quad4 cells lock at nu = 0.49"
  for i, text in ipairs { locks, "pair p: something else", locks } do
    rows[i] = { case = { id = "c" .. i }, done = true, result = { warnings = { { text = text } }, results = {} } }
  end
  rows[4] = { case = { id = "c4" }, done = true, result = { warnings = rows[1].result.warnings, results = {} } }
  report.line = function(...) lines[#lines + 1] = string.format(...) end
  accuracy.keep({ claims = { of = { c1 = {}, c2 = {}, c3 = {} } } }, rows)
  report.line = line
  equal(#lines, 1)
  assert(lines[1]:find("claimed of c1, c3 may be too little", 1, true) and lines[1]:find("cells lock at nu", 1, true), lines[1])
end)

test("a parameter called set leaves its column the name, and that of what --set changed steps aside", function()
  local case = { id = "A", p = { set = 3 } }
  local study = { results = { { name = "warnings" } }, derivatives = {} }
  local write, text = engine.write_file, nil
  engine.write_file = function(_, written) text = written end
  output.write_summary("", study, { "set" }, { { case = case, result = { verdict = "finished", results = { warnings = 4 } } } }, nil)
  engine.write_file = write
  equal(text, "case,set,warnings,verdict,steps,iterations,contact,seconds,run_set,run_warnings\nA,3,4,finished,,,,,,\n")
end)

--- Names of the checks that fail.
local function failing(own, cases)
  local recorder, list = check.recorder()
  accuracy.check(own, cases, recorder)
  local names = {}
  for _, entry in ipairs(list) do
    names[#names + 1] = not entry.pass and entry.name or nil
  end
  return table.concat(names, "; "), #list
end

test("a measured scene is held to the very error that it was told, each result to its own", function()
  local _, count = failing(asked(), { case_of(5, 0.2, { a = 1.09, b = 1.81, c = 4.29 }), case_of(5, 0.3, {}) })
  equal(count, 3)
  equal((failing(asked(), { case_of(5, 0.2, { a = 1.09, b = 1.81, c = 4.29 }) })), "")
  equal((failing(asked(), { case_of(5, 0.2, { a = 1.11, b = 1.81, c = 4.29 }) })),
    "s5_mu0.2: a within its error of what its trade measured")
  equal((failing(asked(), { case_of(5, 0.2, { a = 1, b = 2.21, c = 4.31 }) })),
    "s5_mu0.2: b within its error of what its trade measured; s5_mu0.2: c within its error of what its trade measured")
end)

test("what was found now is held to the share asked for", function()
  local own = asked()
  own.worst = { ["s5_mu0.3"] = 0.029 }
  equal((failing(own, { case_of(5, 0.3, {}) })), "")
  own.worst["s5_mu0.3"] = 0.031
  equal((failing(own, { case_of(5, 0.3, {}) })), "s5_mu0.3: off by no more than asked for")
  own.share = nil
  equal(select(2, failing(own, { case_of(5, 0.3, {}) })), 0)
end)

test("in a trade's figures each named run has its letter beside it, and errors on the floor are marked as such", function()
  local axes = ladder.knobs({ { "size", { 4*mm, 2*mm } }, { "scheme", { "a", "b" } } }, { size = 2*mm, scheme = "a" })
  local function run(size, scheme, work, error, more)
    local made = { levels = { size, scheme }, work = work, error = error, errors = { q = error }, values = { q = error } }
    for key, value in pairs(more or {}) do
      made[key] = value
    end
    return made
  end
  local list = pictures.of {
    knobs = axes, quantities = { { name = "q" } }, references = { q = { uncertainty = 0.01, scale = 1, value = 0 } },
    runs = { run(2, 1, 20, 1e-5, { default = true, front = true }), run(1, 1, 10, 0.1, { front = true }), run(2, 2, 30, 0.2) },
  }
  local front, along, choice = list[1], list[2], list[3]
  local named, clamped = {}, 0
  for _, curve in ipairs(front.curves) do
    named[#named + 1] = curve.names and curve.names[1] .. "=" .. curve.label
    clamped = clamped + (curve.label == "at most this" and 1 or 0)
    for i, below in ipairs(curve.at_most or {}) do
      equal(below, curve.y[i] <= 0.001 and 1 or 0)
    end
  end
  equal(table.concat(named, "; "), "a=a  size 4 mm; b=b  default")
  equal(clamped, 1)
  equal(front.marks, nil)
  equal(along.curves[#along.curves].label, "at most this")
  equal(#along.curves[#along.curves].x, 1)
  equal(along.curves[#along.curves].y[1], 0.001)
  equal(choice.curves[#choice.curves].names[1], "b")
end)
