-- A proof: one quantity against an answer known beforehand, computed at one or more resolutions.
local fault = require "stiction.fault"
local ordered = require "stiction.ordered"
local units = require "stiction.units"

local proof = {}

local kinds = { exact = true, published = true, ours = true }
local known = {}
for word in ("case quantity unit kind source reference values resolution tolerance scale order run note"):gmatch("%S+") do
  known[word] = true
end

local function need(t, key, kind)
  if type(t[key]) ~= kind then
    fault.script("check.proof needs %s, a %s", key, kind)
  end
  return t[key]
end

local function check_words(t)
  for key in pairs(t) do
    if not known[key] then
      fault.script("check.proof: unknown key '%s'%s", tostring(key), fault.meant(key, ordered.keys(known)))
    end
  end
  need(t, "case", "string")
  need(t, "quantity", "string")
  if not kinds[t.kind] then
    fault.script("check.proof '%s: %s': kind is exact, published or ours", t.case, t.quantity)
  end
end

local rounding = 1e-11 -- errors below it say nothing of an order

--- Observed order between the two finest levels, nil where there is but one or an error is no more than rounding.
local function observed_order(levels)
  local coarse, fine = levels[#levels - 1], levels[#levels]
  if not coarse or fine.error == 0 or math.max(coarse.error, fine.error) < rounding or coarse.h == fine.h
    or coarse.error == 0 then
    return nil
  end
  return math.log(coarse.error / fine.error) / math.log(coarse.h / fine.h)
end

--- {h =, value =, error =} of {{resolution, value}, ...}, the finest last; error relative to `scale`.
local function levels_of(t, reference, scale)
  local levels = {}
  for i, pair in ipairs(need(t, "values", "table")) do
    local whole = type(pair) == "table"
    local h, value = units.si(whole and pair[1] or nil), units.si(whole and pair[2] or nil)
    if type(h) ~= "number" or type(value) ~= "number" then
      fault.script("check.proof '%s: %s': values is a list of {resolution, value}", t.case, t.quantity)
    end
    if units.is_quantity(t.reference) and units.is_quantity(pair[2]) and not units.same_dimension(pair[2], t.reference) then
      fault.script("check.proof '%s: %s': the dimensions of %s and %s differ", t.case, t.quantity, tostring(pair[2]),
        tostring(t.reference))
    end
    levels[i] = { h = h, value = value, error = math.abs(value - reference) / scale }
  end
  if #levels == 0 then
    fault.script("check.proof '%s: %s' has no value", t.case, t.quantity)
  end
  if t.order and #levels > 1 and levels[#levels].h == levels[#levels - 1].h then
    fault.script("check.proof '%s: %s': two resolutions are equal, which show no order", t.case, t.quantity)
  end
  return levels
end

--- Does it hold: the finest error within the tolerance, the observed order at least the one claimed.
local function holds(t, levels, order)
  local error = levels[#levels].error
  local claimed = t.order and order
  return error <= t.tolerance and (not claimed or order >= t.order) and error == error
end

--- Reads one proof. Fields: case, quantity, unit (default "1"), kind, source, reference, values =
--- {{resolution, value}, ...} with the finest last, resolution (what is refined), tolerance (relative to
--- |scale|, default |reference|), order (least observed order, tested where two resolutions ran), run (the
--- case whose time and unknowns are told), note.
function proof.read(t)
  check_words(t)
  local reference = units.si(t.reference)
  local scale = math.abs(units.si(t.scale or t.reference) or 0)
  if type(reference) ~= "number" or scale == 0 then
    fault.script("check.proof '%s: %s' needs a reference, and a scale where that is zero", t.case, t.quantity)
  end
  need(t, "tolerance", "number")
  local levels = levels_of(t, reference, scale)
  local order = observed_order(levels)
  local cost = t.run and t.run.cost
  return {
    name = t.case .. ": " .. t.quantity, value = levels[#levels].value, expected = reference,
    tolerance = t.tolerance * scale, pass = holds(t, levels, order),
    proof = {
      case = t.case, quantity = t.quantity, unit = t.unit or "1", kind = t.kind, source = t.source or "",
      scale = scale, resolution = t.resolution or "", levels = levels, order = order, claimed_order = t.order,
      note = t.note, seconds = cost and cost.seconds, unknowns = cost and cost.unknowns,
    },
  }
end

return proof
