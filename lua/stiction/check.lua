-- The checks of a study: each a name, a value, what was expected, and whether it held.
local accuracy = require "stiction.trade.accuracy"
local calls = require "stiction.calls"
local fault = require "stiction.fault"
local ledger = require "stiction.ledger"
local numeric = require "stiction.numeric"
local proof = require "stiction.proof"
local report = require "stiction.report"
local tables = require "stiction.tables"
local units = require "stiction.units"

local check = {}

local function number(x)
  x = units.si(x)
  return type(x) == "number" and x or nil
end

--- Refuses quantities of different dimensions; a plain number goes with any, as SI.
local function check_alike(name, values)
  local first
  for _, value in ipairs(values) do
    first = first or units.is_quantity(value) and value or nil
    if first and units.is_quantity(value) and not units.same_dimension(first, value) then
      fault.script("check '%s' compares %s and %s: their dimensions differ", tostring(name), tostring(first), tostring(value))
    end
  end
end

local function check_bounds(name, what, expected, tolerance)
  local finite = expected and tolerance and numeric.is_finite(expected) and numeric.is_finite(tolerance)
  if not finite or tolerance < 0 then
    fault.script("check '%s' needs an expected number and %s%s", tostring(name), what,
      finite and ", not below 0" or expected and tolerance and ", both finite" or "")
  end
end

--- The recorder that `check(cases, check)` receives, and the list it fills.
function check.recorder()
  local list, recorder, seen = {}, {}, {}

  local function keep(entry)
    if type(entry.name) ~= "string" or seen[entry.name] then
      fault.script("every check needs a name of its own, a text, before its values; got '%s'%s", tostring(entry.name),
        seen[entry.name] and " twice" or "")
    end
    seen[entry.name] = true
    list[#list + 1] = entry
    return entry.pass
  end

  local function record(name, value, expected, tolerance, pass)
    return keep { name = name, value = value, expected = expected, tolerance = tolerance, pass = pass }
  end

  --- |value - expected| <= tolerance; numbers in SI or quantities.
  function recorder.equal(name, value, expected, tolerance)
    local v, e, t = number(value), number(expected), number(tolerance)
    check_bounds(name, "a tolerance", e, t)
    check_alike(name, { v and value or 0, expected, tolerance })
    return record(name, v, e, t, v ~= nil and math.abs(v - e) <= t)
  end

  --- |value - expected| <= relative |expected|
  function recorder.close(name, value, expected, relative)
    local e, r = number(expected), number(relative)
    check_bounds(name, "a relative tolerance", e, r)
    return recorder.equal(name, value, expected, r * math.abs(e))
  end

  --- low <= value <= high, written down as the middle and half the width.
  function recorder.within(name, value, low, high)
    local v, l, h = number(value), number(low), number(high)
    if not l or not h or l ~= l or h ~= h or l > h then
      fault.script("check '%s' needs two bounds, low <= high", tostring(name))
    end
    check_alike(name, { v and value or 0, low, high })
    return record(name, v, (l + h) / 2, (h - l) / 2, v ~= nil and l <= v and v <= h)
  end

  --- A statement: true, or false or nil; also what text:find() gives.
  function recorder.holds(name, held)
    if type(held) == "string" or type(held) == "function" or held == 0 then
      fault.script("check '%s' needs true or false, not %s", tostring(name),
        type(held) == "function" and "a function" or ("%q"):format(held))
    end
    return record(name, held and true or false, true, 0, held and true or false)
  end

  --- Nil of a single value, as where --set leaves one case of a sweep; that is told.
  local function largest_drop(name, values, sign)
    if #values == 1 then
      report.line("check '%s' left out: of one value nothing rises or falls", tostring(name))
      return nil
    end
    check_alike(name, values)
    local drop = -math.huge
    for i = 2, #values do
      local step = sign * (units.si(values[i - 1]) - units.si(values[i]))
      drop = step == step and math.max(drop, step) or step -- one that is no number stays
    end
    if #values < 2 then
      fault.script("check '%s' needs at least two values", tostring(name))
    end
    return drop
  end

  --- No value is below the one before it by more than the tolerance; the value is the largest such drop.
  function recorder.non_decreasing(name, values, tolerance)
    local drop, t = largest_drop(name, values, 1), number(tolerance or 0)
    return drop and record(name, drop > 0 and drop or 0 * drop, 0, t, drop <= t)
  end

  --- The same, downwards.
  function recorder.non_increasing(name, values, tolerance)
    local rise, t = largest_drop(name, values, -1), number(tolerance or 0)
    return rise and record(name, rise > 0 and rise or 0 * rise, 0, t, rise <= t)
  end

  --- Every value exceeds the one before it; the value is the smallest rise.
  function recorder.increasing(name, values)
    local drop = largest_drop(name, values, 1)
    return drop and record(name, -drop, 0, 0, drop < 0)
  end

  --- Every step's sum of energies equals the work put in less the scheme's own loss as its formulas predict it, to
  --- `tolerance` (default 1e-6) of the largest term. The scene needs probe.energy { audit = true }, called "energy"
  --- unless `probe` names it.
  function recorder.ledger(case, tolerance, probe)
    local open, largest = ledger.open(case, probe or "energy")
    local t = number(tolerance or 1e-6)
    return record(("%s: ledger closes, over its largest term"):format(case.id), numeric.share(open, largest), 0, t,
      open < math.huge and open <= t * largest)
  end

  --- A table for the report: {title =, columns = {...}, rows = {{key, ...}, ...}}; no claim, so no verdict. Tables of one
  --- title from several studies are joined by their first column.
  function recorder.table(t)
    return keep(tables.read(t))
  end

  --- A row of the report of proofs; see stiction.proof.
  function recorder.proof(t)
    return keep(proof.read(t))
  end

  calls.functions(recorder, "check")
  setmetatable(recorder, {
    __index = function(_, name)
      fault.script("there is no check.%s%s; study.check is given (cases, check)", tostring(name),
        fault.meant(name, { "equal", "close", "within", "holds", "non_decreasing", "non_increasing", "increasing", "ledger",
          "proof", "table" }))
    end,
  })
  return recorder, list
end

--- Names of results that the study does not have are told where checks ask for them.
local function guard_results(study, cases)
  local known = numeric.map(study.results, function(result) return result.name end)
  local guard = {
    __index = function(_, name)
      if not numeric.first_where(known, function(own) return own == name end) then
        fault.script("the study has no result '%s'%s; results: %s", tostring(name), fault.meant(name, known),
          table.concat(known, ", "))
      end
    end,
  }
  for _, case in ipairs(cases) do
    setmetatable(case.results, guard)
  end
end

--- Runs a study's checks on its cases, and those of the accuracy asked for (or nil), as accuracy.choose gives it.
function check.run(study, cases, asked)
  local recorder, list = check.recorder()
  if study.check then
    guard_results(study, cases)
    study.check(cases, recorder)
  end
  if asked then
    accuracy.check(asked, cases, recorder)
  end
  return list
end

return check
