-- Proof rows: error, observed order, verdict; and the mistakes in them.
local test, equal, fails = ...
local check = require "stiction.check"
local units = require("stiction").units

local function row(changes)
  local t = { case = "bar", quantity = "stress", kind = "exact", reference = 2, tolerance = 0.01,
    values = { { 0.2, 2.04 }, { 0.1, 2.01 } } }
  for key, value in pairs(changes) do
    t[key] = value
  end
  local recorder, list = check.recorder()
  recorder.proof(t)
  return list[1]
end

local function near(got, wanted)
  if got ~= got or math.abs(got - wanted) > 1e-12 * math.max(1, math.abs(wanted)) then
    error(("got %.17g, wanted %.17g"):format(got, wanted), 2)
  end
end

test("the finest value decides, relative to the reference", function()
  local entry = row {}
  equal(entry.name, "bar: stress")
  equal(entry.pass, true)
  near(entry.value, 2.01)
  near(entry.tolerance, 0.02)
  near(entry.proof.levels[1].error, 0.02)
  near(entry.proof.levels[2].error, 0.005)
  near(entry.proof.order, 2)
  equal(row { tolerance = 0.004 }.pass, false)
  equal(row { values = { { 0.1, 2.01 }, { 0.2, 2.04 } } }.pass, false)
end)

test("errors of rounding tell no order", function()
  local levels = { { 0.2, 2 * (1 + 1e-13) }, { 0.1, 2 * (1 + 3e-13) } }
  equal(row { values = levels }.proof.order, nil)
  equal(row { values = { { 0.2, 2 * (1 + 4e-9) }, { 0.1, 2 * (1 + 1e-9) } } }.proof.order ~= nil, true)
end)

test("a claimed order is held against the observed one", function()
  equal(row { order = 1.9 }.pass, true)
  equal(row { order = 2.1 }.pass, false)
  equal(row { order = 2.1, values = { { 0.1, 2.01 } } }.pass, true) -- one level tells no order
end)

test("a reference of zero needs a scale; quantities count in SI", function()
  near(row { reference = 0, scale = 4, values = { { 1, 0.02 } } }.proof.levels[1].error, 0.005)
  near(row { reference = 2*units.mm, values = { { 1*units.mm, 2.01*units.mm } } }.proof.levels[1].error, 0.005)
  fails("a scale where that is zero", row, { reference = 0 })
end)

test("no number is no proof", function()
  equal(row { values = { { 0.1, 0 / 0 } } }.pass, false)
end)

test("mistakes are told", function()
  fails("unknown key 'tolerence'; did you mean 'tolerance'?", row, { tolerence = 1 })
  fails("kind is exact, published or ours", row, { kind = "guess" })
  fails("has no value", row, { values = {} })
  fails("values is a list", row, { values = { 3 } })
end)

local function audited(open, largest)
  local series = { unaccounted = { 0, open, 0 } }
  return { id = "run", columns = function() return { "energy/kinetic", "energy/unaccounted" } end, series = function(_, probe, name)
    equal(probe, "energy")
    return series[name] or { 0, name == "kinetic" and -(largest or 2) or 0, 0 }
  end }
end

test("a ledger closes to a part of its largest term", function()
  local function held(open, tolerance, largest)
    local recorder, list = check.recorder()
    recorder.ledger(audited(open, largest), tolerance)
    return list[1].pass
  end
  equal(held(1.9e-6), true)
  equal(held(-1.9e-6), true)
  equal(held(2.1e-6), false)
  equal(held(-2.1e-6), false)
  equal(held(0 / 0), false)
  equal(held(0.1, 0.1), true)
  equal(held(0.9e-9, 1e-6, 1e-3), true)
  equal(held(1.1e-9, 1e-6, 1e-3), false)
end)

test("an account without audit says so, and what half spaces have instead", function()
  local recorder = check.recorder()
  local case = audited(0)
  case.columns = function() return { "energy/kinetic" } end
  local good, problem = pcall(recorder.ledger, case)
  equal(good, false)
  assert(tostring(problem):find("energy must be stiction.probe.energy { audit = true }, which half spaces", 1, true), tostring(problem))
end)
