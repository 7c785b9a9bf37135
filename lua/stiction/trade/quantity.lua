-- What a trade measures: results of the study, curves over a case, and what either is compared with.
local fault = require "stiction.fault"
local numeric = require "stiction.numeric"
local units = require "stiction.units"

local quantity = {}

local known = { name = "string", scale = true, reference = true, curve = "function", series = "string" }

local function check_keys(entry, name)
  for key, value in pairs(entry) do
    local kind = known[key]
    if not kind and key ~= 1 then
      fault.input("study.trade.quantities: '%s' has an unknown key '%s'; keys: name, scale, reference, curve, series",
        name, tostring(key))
    elseif type(kind) == "string" and type(value) ~= kind then
      fault.input("study.trade.quantities: %s of '%s' must be a %s", key, name, kind)
    end
  end
end

--- Function of a case giving abscissas and ordinates, nil if the entry is no curve.
local function curve_of(entry, name)
  if not entry.series then
    return entry.curve
  end
  local group, column = entry.series:match("^([^/]+)/(.+)$")
  if not group then
    fault.input("study.trade.quantities: series of '%s' is \"probe/column\", not \"%s\"", name, entry.series)
  end
  return function(case)
    return case.time, (case:series(group, column))
  end
end

--- The number known of a result, or for a curve the function of its abscissa; nil if nothing is known.
local function exact_of(entry, name, curved, p)
  local reference = entry.reference
  if reference == nil then
    return nil
  elseif curved then
    if type(reference) ~= "function" then
      fault.input("study.trade.quantities: the reference of the curve '%s' is a function of its abscissa", name)
    end
    return function(x) return units.si(reference(x, p)) end
  end
  local value = units.si(type(reference) == "function" and reference(p) or reference)
  if type(value) ~= "number" then
    fault.input("study.trade.quantities: the reference of '%s' must be a number, a quantity or a function of p", name)
  end
  return value
end

local function read(entry, results, p)
  local whole = type(entry) == "table" and entry or { entry }
  local name = whole.name or whole[1]
  local curve = curve_of(whole, tostring(name))
  if type(name) ~= "string" or not curve and not results[name] then
    fault.input("study.trade.quantities: the study has no result '%s'", tostring(name))
  end
  check_keys(whole, name)
  return { name = name, scale = units.si(whole.scale), curve = curve, exact = exact_of(whole, name, curve, p) }
end

--- {name =, scale =, exact =, curve =} of every entry of study.trade.quantities, `p` being the default settings; the
--- study's other results follow, only watched.
function quantity.list(study, p)
  local results, list, judged = {}, {}, {}
  for _, entry in ipairs(study.results) do
    results[entry.name] = true
  end
  for i, entry in ipairs(study.trade.quantities or {}) do
    list[i] = read(entry, results, p)
    judged[list[i].name] = true
  end
  if #list == 0 then
    fault.input("study.trade.quantities lists no result of the study")
  end
  for _, entry in ipairs(study.results) do
    if not judged[entry.name] then
      list[#list + 1] = { name = entry.name, scale = 1, watched = true }
    end
  end
  return list
end

--- {x =, y =} of a curve in one case, SI, x rising; bad input else.
function quantity.curve(entry, case)
  local x, y = entry.curve(case, case.p)
  if type(x) ~= "table" or type(y) ~= "table" or #x < 2 or #x ~= #y then
    fault.input("study.trade.quantities: curve '%s' must return two lists of one length, at least 2", entry.name)
  end
  local points = { x = numeric.map(x, units.si), y = numeric.map(y, units.si) }
  for i = 1, #x do
    if not numeric.is_finite(points.x[i]) or not numeric.is_finite(points.y[i]) then
      fault.input("study.trade.quantities: point %d of curve '%s' is no number", i, entry.name)
    elseif i > 1 and points.x[i] < points.x[i - 1] then
      fault.input("study.trade.quantities: the abscissas of curve '%s' must rise", entry.name)
    end
  end
  return points
end

--- Curves of all finished runs on the abscissas of the one that has most, as their values; entry.x are these abscissas.
function quantity.align(entry, runs)
  entry.x = {}
  for _, run in ipairs(runs) do
    local own = run.curves and run.curves[entry.name]
    if own and #own.x > #entry.x then
      entry.x = own.x
    end
  end
  for _, run in ipairs(runs) do
    local own = run.curves and run.curves[entry.name]
    if own then
      run.values[entry.name] = numeric.map(entry.x, function(x) return numeric.interpolate(own.x, own.y, x) end)
    end
  end
end

local function combine(a, b, sign)
  if type(a) == "number" then
    return a + sign * b
  end
  local list = {}
  for i = 1, #a do
    list[i] = a[i] + sign * b[i]
  end
  return list
end

function quantity.plus(a, b)
  return combine(a, b, 1)
end

function quantity.minus(a, b)
  return combine(a, b, -1)
end

--- |value|, or the L2 norm of a curve that is linear between its abscissas: sqrt of the integral of y^2.
function quantity.size(entry, value)
  if type(value) == "number" then
    return math.abs(value)
  end
  local x, sum = entry.x, 0
  for i = 2, #x do
    local a, b = value[i - 1], value[i]
    sum = sum + (x[i] - x[i - 1]) * (a * a + a * b + b * b) / 3
  end
  return math.sqrt(sum)
end

function quantity.distance(entry, a, b)
  return quantity.size(entry, combine(a, b, -1))
end

return quantity
