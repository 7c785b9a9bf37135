-- A case that has run: its parameters, histories and results; and the list of all cases.
local calls = require "stiction.calls"
local derivatives = require "stiction.derivatives"
local engine = require "stiction.engine"
local fault = require "stiction.fault"
local numeric = require "stiction.numeric"
local ordered = require "stiction.ordered"
local output = require "stiction.output"
local units = require "stiction.units"

local case_module = {}

local Case = {}

local function columns(case)
  return rawget(case, "pretended") and ordered.keys(case.pretended.columns) or engine.series_columns(case.history)
end

local function read_column(case, name, component)
  if rawget(case, "pretended") then
    return case.pretended.columns[name] and table.move(case.pretended.values, 1, #case.pretended.values, 1, {}), "1"
  end
  return engine.series_column(case.history, name, component)
end

local function column(case, name, component)
  local values, unit = read_column(case, name, component)
  if not values then
    local known = columns(case)
    rawset(case, "missing", ("case %s has no series '%s'%s; series: %s"):format(case.id, name, fault.meant(name, known),
      table.concat(known, ", ")))
    fault.script("%s", case.missing)
  end
  return values, unit
end

--- Values of a history over `time`, SI; component (1, 2, ...) of a vector-valued one. Also its unit.
function Case:series(group, name, component)
  return column(self, group .. "/" .. name, component)
end

--- Names "group/name" of all its histories, sorted.
function Case:columns()
  return columns(self)
end

--- Of these values by `find`, and its time; a case that has one is told by its `at_extreme` of each.
local function extreme(case, find, values)
  local value, at = find(values)
  local tell = rawget(case, "at_extreme")
  if tell then
    tell(values, at)
  end
  return value, case.time[at]
end

--- Largest value of a history, and its time.
function Case:max(group, name, component)
  return extreme(self, numeric.max, (self:series(group, name, component)))
end

--- Smallest value of a history, and its time.
function Case:min(group, name, component)
  return extreme(self, numeric.min, (self:series(group, name, component)))
end

--- Value of a history at a time (number in s, or a quantity), interpolated; before the start or past the end, what it is there.
function Case:at(time, group, name, component)
  if units.is_quantity(time) and not units.same_dimension(time, units.units.s) then
    fault.script("run:at takes a time, not %s", tostring(time))
  end
  return numeric.interpolate(self.time, self:series(group, name, component), units.si(time))
end

--- Value of a history at the end.
function Case:last(group, name, component)
  local values = self:series(group, name, component)
  return values[#values]
end

--- The run beside it in which a parameter that the study names in its `derivatives` is a little smaller, and by how much, SI.
function Case:beside(name)
  local folder, p, step = self.folder .. "/derivatives/" .. name, derivatives.shifted(self.p, name)
  if not p then
    fault.script("case %s has no derivatives with respect to '%s', which is 0 in it", self.id, name)
  elseif engine.kind_of_path(folder .. "/series.h5") ~= "file" then
    fault.script("case %s has no derivatives with respect to '%s'; the study asks for them: derivatives = { \"%s\" }", self.id, name, name)
  end
  local other = case_module.new(self.id, p, folder)
  if #other.time < #self.time then
    fault.script("case %s: derivatives with respect to '%s' end at %g s", self.id, name, other.time[#other.time])
  end
  return other, step
end

local function quotient(a, b, step)
  if type(a) == "table" and not units.is_quantity(a) then
    local list = {}
    for i, value in ipairs(a) do
      list[i] = quotient(value, b[i], step)
    end
    return list
  end
  return (units.si(b) - units.si(a)) / step
end

--- The derivative of f(run), a number, a quantity or a list of them, with respect to a parameter that the study names in its
--- `derivatives`; SI. From a run beside the case's own, exact to about five digits where no point changes between sticking,
--- slipping and open within the shift.
function Case:derivative(name, f)
  local other, step = self, 1
  if not rawget(self, "pretended") then
    other, step = self:beside(name)
  end
  return quotient(f(self), f(other), step)
end

--- What a run took, of its result: its counters, seconds, steps, iterations, factorizations and cuts; seconds_in_<phase>.
function case_module.cost_of(result)
  local cost = {}
  for name, value in pairs(result.phases or {}) do
    cost["seconds_in_" .. name] = value
  end
  for name, value in pairs(result.counters or {}) do
    cost[name] = value
  end
  for _, name in ipairs { "seconds", "steps", "iterations", "factorizations", "cuts" } do
    cost[name] = result[name]
  end
  return cost
end

local lazy = {
  history = function(case)
    return engine.read_series(case.folder .. "/series.h5")
  end,
  time = function(case)
    return engine.series_time(case.history)
  end,
  cost = function(case)
    local result = output.read_result_in(case.folder)
    if not result or type(result.counters) ~= "table" then
      fault.input("%s/manifest.json has no result, or is damaged; run the case again", case.folder)
    end
    return case_module.cost_of(result)
  end,
}

local case_meta = {
  __index = function(case, name)
    if Case[name] then
      return Case[name]
    elseif lazy[name] then
      local value = lazy[name](case)
      rawset(case, name, value)
      return value
    end
    fault.script("a case has no '%s'; it has id, p, results, time, series, max, min, at, last, cost", tostring(name))
  end,
}

calls.methods(Case, "run", function(first) return getmetatable(first) == case_meta end)

--- {id =, p =, folder =, place = name of that folder, results = (later)}; histories are read when asked for.
function case_module.new(id, p, folder, place)
  return setmetatable({ id = id, p = p, folder = folder, place = place or id }, case_meta)
end

local function one()
  return 1
end

--- A case that has not run, with these columns, of which each holds `values` at `times`.
function case_module.pretend(case, names, times, values)
  local run = case_module.new(case.id, case.p, "")
  rawset(run, "pretended", { columns = names, values = values })
  rawset(run, "time", times)
  rawset(run, "cost", setmetatable({}, { __index = one }))
  return run
end

local function result_number(entry, value)
  if units.is_quantity(value) then
    value = value:to(entry.unit) * engine.parse_unit(entry.unit)
  end
  if type(value) ~= "number" then
    fault.script("it must be a number%s",
      value == nil and "; its function gave nothing: is its `return` missing?" or ", not a " .. type(value))
  elseif not numeric.is_finite(value) then
    fault.script("it is %s: its function divides by zero, or takes a root or logarithm of what has none; a finite number is wanted",
      value ~= value and "not a number" or "infinite")
  end
  return value
end

--- Results of a case by name, plain SI numbers; those that failed, as a list of messages with their places; whether one
--- of them asked for a column that is not there.
function case_module.compute(study, case)
  local results, failures, missing = {}, {}, false
  for _, entry in ipairs(study.results) do
    local held, value = engine.call(function() return result_number(entry, entry.compute(case, case.p)) end)
    if held then
      results[entry.name] = value
    elseif value.kind == "stopped" then
      error(value, 0)
    else
      failures[#failures + 1] = ("result %s: %s%s"):format(entry.name, tostring(value), value.trace or "")
      missing = missing or (rawget(case, "missing") ~= nil and tostring(value):find(case.missing, 1, true) ~= nil)
    end
  end
  return results, failures, missing
end

local function close(a, b)
  if units.is_quantity(a) or units.is_quantity(b) then
    return units.same_dimension(a, b) and close(a.si, b.si)
  elseif type(a) == "number" and type(b) == "number" then
    return math.abs(a - b) <= 1e-9 * math.max(math.abs(a), math.abs(b))
  end
  return a == b
end

local function agrees(case, wanted)
  for _, name in ipairs(ordered.keys(wanted)) do
    if not close(case.p[name], wanted[name]) then
      return false
    end
  end
  return true
end

local Cases = {}
Cases.__index = Cases

--- The cases whose parameters are as given: cases:where{ mu = 0.4 }.
function Cases:where(wanted)
  local kept = {}
  for _, case in ipairs(self) do
    if agrees(case, wanted) then
      kept[#kept + 1] = case
    end
  end
  return case_module.list(kept, self.quick)
end

--- The one case with these parameters, nil if there is none (the quick form has fewer).
function Cases:find(wanted)
  local kept = self:where(wanted)
  if #kept > 1 then
    fault.script("%d cases fit, not one; name more parameters", #kept)
  end
  return kept[1]
end

--- One result of every case, as a list.
function Cases:values(name)
  local list = {}
  for i, case in ipairs(self) do
    list[i] = case.results[name]
  end
  return list
end

calls.methods(Cases, "cases", function(first) return getmetatable(first) == Cases end)

--- List of cases with where, find, values and the flag `quick`.
function case_module.list(cases, quick)
  local list = { quick = quick or false }
  for i, case in ipairs(cases) do
    list[i] = case
  end
  return setmetatable(list, Cases)
end

return case_module
