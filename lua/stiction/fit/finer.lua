-- The simulation's own error in a fit: what one finer level of each setting changes, carried into the parameters.
local claim = require "stiction.trade.claim"
local engine = require "stiction.engine"
local fault = require "stiction.fault"
local linear = require "stiction.fit.linear"
local numeric = require "stiction.numeric"
local ordered = require "stiction.ordered"
local space = require "stiction.fit.space"
local spec = require "stiction.fit.spec"
local sweep = require "stiction.sweep"
local units = require "stiction.units"

local finer = {}

local farthest = 10 -- places that a step may go in a coordinate
local floor = 1e-6 -- of a result: what solvers leave

--- Fewer of what is counted, or larger of what has a length or lasts.
local function is_coarser(value, own)
  local a, b = units.si(value), units.si(own)
  if type(a) ~= "number" or type(b) ~= "number" then
    return false
  elseif units.is_quantity(value) then
    return (units.same_dimension(value, units.units.m) or units.same_dimension(value, units.units.s)) and a > b
  end
  return math.type(own) == "integer" and a < b
end

--- Settings a level finer that the study names, all at once: {settings =, factor =, words =}.
local function of_study(fit, p)
  local settings, factor, words = {}, 1, {}
  local fitted = {}
  for _, own in ipairs(fit.parameters) do
    fitted[own.key] = true
  end
  for _, name in ipairs(ordered.keys(fit.finer)) do
    local value, own = fit.finer[name], p[name]
    if own == nil then
      fault.input("study.fit.finer: the study has no parameter '%s'%s", name, fault.meant(name, ordered.keys(p)))
    end
    local a, b = units.si(value), units.si(own)
    if fitted[name] then
      fault.input("study.fit.finer: '%s' is fitted; finer names settings of the simulation, as steps or the size of cells", name)
    elseif a == b then
      fault.input("study.fit.finer: %s = %s is what the cases have already; a level finer differs from it", name, tostring(value))
    elseif is_coarser(value, own) then
      fault.input("study.fit.finer: %s = %s is coarser than the cases' %s", name, tostring(value), tostring(own))
    end
    local ratio = type(a) == "number" and type(b) == "number" and a > 0 and b > 0 and math.max(a / b, b / a)
    factor = math.max(factor, ratio and ratio > 1 and claim.factor(ratio) or 1)
    settings[name], words[#words + 1] = value, ("%s = %s"):format(name, tostring(value))
  end
  return { { settings = settings, factor = factor, words = table.concat(words, ", ") } }
end

--- Those that the study's trade knows, one at a time.
local function of_trade(study, p)
  local list = {}
  for _, variant in ipairs(claim.variants(claim.knobs(study), p)) do
    list[#list + 1] = { settings = { [variant.knob] = variant.value }, factor = variant.factor,
      words = ("%s = %s"):format(variant.knob, tostring(variant.value)) }
  end
  return list
end

--- What to run beside the best point; nil where the study names nothing.
function finer.variants(fit, study, options)
  local curve = fit.curves[1]
  local values = {}
  for k, own in ipairs(fit.parameters) do
    values[k] = own.start
  end
  local p = sweep.values_at(study, options, curve:cases((spec.values_for(fit, curve, values)))[1], "study.fit")
  if fit.finer then
    return of_study(fit, p)
  end
  local held, list = engine.call(of_trade, study, p)
  return study.trade and held and #list > 0 and list or nil
end

--- Which parameters move together, and of which of them that tells what they may be off by: the free ones; each at its bound with these.
local function sets_of(judged, count)
  local is_free, sets = {}, {}
  for _, k in ipairs(judged.free) do
    is_free[k] = true
  end
  if #judged.free > 0 then
    sets[1] = { places = judged.free, of = is_free }
  end
  for k = 1, count do
    if not is_free[k] then
      sets[#sets + 1] = { places = table.move(judged.free, 1, #judged.free, 2, { k }), of = { [k] = true } }
    end
  end
  return sets
end

--- Adds to the relative errors how far a change of residuals moves the parameters, this many times.
local function add_shifts(relative, found, judged, sets, change, factor)
  for _, set in ipairs(sets) do
    local columns = linear.scaled(numeric.map(set.places, function(k) return found.J[k] end), found.at.slopes)
    local step = linear.step(columns, change, farthest)
    for i, k in ipairs(set.places) do
      relative[k] = (relative[k] or 0) + (set.of[k] and factor * math.abs(step[i] * judged.slopes[k]) or 0)
    end
  end
end

--- Whether some result is another than before by more than solvers leave.
local function differ(before, now)
  for i, own in ipairs(before or {}) do
    for name, value in pairs(own) do
      local other = now[i][name]
      if numeric.is_finite(value) and numeric.is_finite(other) and math.abs(other - value) > floor * math.abs(value) then
        return true
      end
    end
  end
  return false
end

local function is_same(before, now)
  local same, any = true, false
  for i, value in ipairs(before) do
    same, any = same and value == now[i], any or value ~= 0
  end
  return same and any
end

--- Words on curves that a finer level leaves exactly as they are, though it moves others or a result: such ones take steps, and this
--- one has shown nothing of them. nil if there are none.
local function doubt(fit, variant, before, now)
  local names, curves = {}, before.curves or {}
  for i, list in ipairs(curves) do
    names[#names + 1] = is_same(list, now.curves[i]) and fit.curves[i].name or nil
  end
  if variant.factor > 1 and #names > 0 and (#names < #curves or differ(before.results, now.results)) then
    return ("%s moves other results and leaves %s exactly as %s, which may take steps"):format(variant.words, table.concat(names, ", "),
      #names == 1 and "it is" or "they are")
  end
end

--- What these variants change; as finer.of has it.
function finer.shifts(model, found, judged, variants)
  local result, sets = { known = true, variants = {}, relative = {}, changes = {} }, sets_of(judged, #found.z)
  local moved, still = false, nil
  for n, variant in ipairs(variants) do
    local answer = model:evaluate({ found.z }, "finer", variant.settings)[1]
    if answer.failed then
      return { reason = ("with %s: %s"):format(variant.words, answer.failed), variants = result.variants }
    end
    local change, sum = {}, 0
    for i, r in ipairs(answer.r) do
      change[i] = (r - found.at.r[i]) * found.at.slopes[i]
      sum = sum + (r - found.at.r[i]) ^ 2
      result.changes[i] = (result.changes[i] or 0) + math.abs(r - found.at.r[i])
    end
    add_shifts(result.relative, found, judged, sets, change, variant.factor)
    result.variants[n] = { words = variant.words, residual = math.sqrt(sum / #answer.r),
      doubt = doubt(model.fit, variant, found.at, answer) }
    moved, still = moved or sum > 0, still or result.variants[n].doubt
  end
  if still and not moved then
    return { reason = still, variants = result.variants }
  end
  result.values = space.values(model.fit.parameters, found.z)
  return result
end

--- {known =, reason = (where not), variants = {{words =, residual = (rms change in standard errors), doubt = (words on curves left
--- exactly as they are, or nil)}}, relative = {by place of a parameter}}: what the parameters' relative coordinates may be off by, as
--- a level finer moves them, times what claims of a trade allow for.
function finer.of(model, study, options, found, judged)
  local variants = finer.variants(model.fit, study, options)
  if not variants then
    return { reason = "the study has neither fit.finer nor a trade", variants = {} }
  end
  return finer.shifts(model, found, judged, variants)
end

return finer
