-- What a case may be off by: the same case with each setting a level finer, and how much that changes it.
local copy = require "stiction.copy"
local fault = require "stiction.fault"
local ladder = require "stiction.ladder"
local numeric = require "stiction.numeric"
local ordered = require "stiction.ordered"
local quantity_module = require "stiction.trade.quantity"
local sampled = require "stiction.trade.sampled"
local sweep = require "stiction.sweep"

local claim = {}

local floor = 1e-6 -- of a value: what solvers leave at their default tolerances

local order = 0.4 -- of the errors: what all but one of 46 changed scenes need (studies/trade/claims); with 1 it is 1 in 6

--- The error of a level over its difference from one finer by `ratio`, if errors fall as h^order.
function claim.factor(ratio)
  return 1 / (1 - ratio ^ -order)
end

--- The knobs of a study's trade.
function claim.knobs(study)
  return (sweep.knobs(study, {}))
end

--- Bad input where none of the scenes made so far has read a knob.
function claim.require_read(study, knobs)
  local unread = study:unread(numeric.map(knobs, function(knob) return knob.name end))
  if unread[1] then
    fault.input("study.trade.knobs: no scene reads '%s', so that all its levels give the same scene and tell nothing of " ..
      "its error; use p.%s in study.scene, or leave it out of the knobs", unread[1], unread[1])
  end
end

--- Parameters of the scene that a study's trade is measured on, `changes` in their place.
function claim.parameters(study, changes)
  local _, p = sweep.knobs(study, {})
  for name, value in pairs(changes) do
    if p[name] == nil then
      fault.input("the study has no parameter '%s'%s", name, fault.meant(name, ordered.keys(p)))
    end
    p[name] = value
  end
  return p
end

--- Parameters p but for one knob.
function claim.with(p, variant)
  p = copy(p)
  p[variant.knob] = variant.value
  return p
end

--- Parameters with every number `levels` finer and every choice the default.
function claim.finer(study, p, levels)
  local knobs = claim.knobs(study)
  for _ = 1, levels do
    for _, variant in ipairs(claim.variants(knobs, p)) do
      p = claim.with(p, variant)
    end
  end
  return p
end

--- What to run beside a case with parameters p: {knob =, value =, factor = (of the difference), choice = true or nil}, one for
--- each number a level finer and each choice that is not the default.
function claim.variants(knobs, p)
  local list = {}
  for _, knob in ipairs(knobs) do
    local value, default = p[knob.name], knob.levels[knob.default]
    if knob.numeric then
      local finer, ratio = ladder.finer(knob, value)
      list[#list + 1] = finer and { knob = knob.name, value = finer, factor = claim.factor(ratio) } or nil
    elseif not ladder.same(value, default) then
      list[#list + 1] = { knob = knob.name, value = default, factor = 1, choice = true }
    end
  end
  return list
end

--- Values of every quantity in a finished case: numbers of its results, curves as points.
local function measure(quantities, case)
  local run = { values = {}, curves = {} }
  for _, quantity in ipairs(quantities) do
    run.values[quantity.name] = not quantity.curve and case.results[quantity.name] or nil
    run.curves[quantity.name] = quantity.curve and quantity_module.curve(quantity, case) or nil
  end
  return run
end

--- What errors of a quantity are relative to.
local function scale_of(quantity, value)
  if quantity.scale and not quantity.watched then
    return quantity.curve and quantity.scale * math.sqrt(quantity.x[#quantity.x] - quantity.x[1]) or quantity.scale
  end
  return quantity_module.size(quantity, value)
end

local function finite(value)
  return type(value) == "table" or numeric.is_finite(value)
end

--- Distances of one quantity from its value in the first run, nil where a run has none.
local function distances(quantity, runs)
  local list, base = {}, runs[1].values[quantity.name]
  for i, run in ipairs(runs) do
    local value = run.values[quantity.name]
    if not finite(value) then
      return nil
    end
    list[i] = quantity_module.distance(quantity, value, base)
  end
  return list, scale_of(quantity, base), quantity_module.size(quantity, base)
end

--- By place of a variant: true where it moves some quantity by more than solvers leave.
local function moving(all, count)
  local moved = {}
  for i = 1, count do
    moved[i] = numeric.first_where(all, function(own)
      return own.scale > 0 and own.list[i + 1] > floor * math.max(own.size, own.scale)
    end) and true
  end
  return moved
end

--- The variant that leaves a quantity exactly as it is, though it moves others: such a result takes steps, of which this one was
--- too small to show anything. nil if there is none, or if the quantity is 0 beside what errors are relative to.
local function without_effect(variants, moved, own)
  for i, variant in ipairs(variants) do
    if own.size > floor * own.scale and moved[i] and not variant.choice and own.list[i + 1] == 0 then
      return variant
    end
  end
end

--- What each result may lack between two steps, by name.
local function between_steps(study, case)
  return rawget(case, "folder") and sampled.lacking(study, case, case.results) or {}
end

--- Of a finished case and its variants in their order, by quantity: {absolute =, relative =, judged =, changes = (of each
--- variant, relative)}, or {unmoved = (a variant that leaves it exactly as it is, as it does not others), relative = infinite, ...};
--- `against`, another run or nil, adds error = (its distance, relative).
function claim.judge(study, case, variants, cases, against)
  local quantities, all = quantity_module.list(study, case.p), { case }
  table.move(cases, 1, #cases, 2, all)
  all[#all + 1] = against
  local runs, known, claims = numeric.map(all, function(one) return measure(quantities, one) end), {}, {}
  for _, quantity in ipairs(quantities) do
    if quantity.curve then
      quantity_module.align(quantity, runs)
    end
    local list, scale, size = distances(quantity, runs)
    known[#known + 1] = list and { quantity = quantity, list = list, scale = scale, size = size } or nil
  end
  local moved, between = moving(known, #variants), between_steps(study, case)
  for _, own in ipairs(known) do
    local list, scale, changes = own.list, own.scale, {}
    local sum = floor * own.size + (between[own.quantity.name] or 0)
    for i, variant in ipairs(variants) do
      sum, changes[i] = sum + variant.factor * list[i + 1], numeric.share(list[i + 1], scale)
    end
    local unmoved = without_effect(variants, moved, own)
    local relative = unmoved and math.huge or numeric.share(sum, scale)
    claims[own.quantity.name] = { absolute = not unmoved and (own.quantity.curve and relative or sum) or nil, relative = relative,
      judged = not own.quantity.watched, changes = changes, unmoved = unmoved, error = against and numeric.share(list[#list], scale) }
  end
  return claims
end

--- The names of --of, each a quantity of `known`, or nil.
function claim.names(text, known)
  local names = {}
  for name in (text or ""):gmatch("[^,%s]+") do
    if not numeric.first_where(known, function(other) return other == name end) then
      fault.input("--of %s: the trade measures no '%s'%s (it measures: %s)", text, name, fault.meant(name, known),
        table.concat(known, ", "))
    end
    names[#names + 1] = name
  end
  if text and #names == 0 then
    fault.input("--of: name what the trade measures: %s", table.concat(known, ", "))
  end
  return text and names
end

return claim
