-- The cases of a study: its sweep, its quick form and what the command line sets, multiplied out.
local copy = require "stiction.copy"
local engine = require "stiction.engine"
local fault = require "stiction.fault"
local identity = require "stiction.identity"
local ladder = require "stiction.ladder"
local numeric = require "stiction.numeric"
local ordered = require "stiction.ordered"
local study_module = require "stiction.study"
local units = require "stiction.units"

local sweep = {}

--- Explicit cases, the first axis varying slowest.
local function multiply(axes)
  local cases = { {} }
  for _, axis in ipairs(axes) do
    local longer = {}
    for _, case in ipairs(cases) do
      for _, value in ipairs(axis.values) do
        local extended = copy(case)
        extended[axis.name] = value
        longer[#longer + 1] = extended
      end
    end
    cases = longer
  end
  return cases
end

local function axis_names(plan)
  local names = {}
  if plan.axes then
    for i, axis in ipairs(plan.axes) do
      names[i] = axis.name
    end
    return names
  end
  return ordered.keys(plan.cases[1] or {})
end

local function base_values(study)
  local values = {}
  for _, section in ipairs { study.given, study.chosen } do
    for name, entry in pairs(section) do
      values[name] = entry.value
    end
  end
  return values
end

--- The value now standing under `name`, for the check of what replaces it.
local function standing(plan, values, name)
  if values[name] ~= nil then
    return values[name]
  end
  return (plan.cases or multiply(plan.axes))[1][name]
end

local function fits(old, new)
  if units.is_quantity(old) or units.is_quantity(new) then
    return units.same_dimension(old, new)
  end
  return type(old) == type(new)
end

--- Replaces one value everywhere; an axis of that name shrinks to it.
local function replace(plan, values, name, value)
  if values[name] ~= nil then
    values[name] = value
  end
  for _, axis in ipairs(plan.axes or {}) do
    if axis.name == name then
      axis.values = { value }
    end
  end
  for _, case in ipairs(plan.cases or {}) do
    if case[name] ~= nil then
      case[name] = value
    end
  end
end

local function known_names(plan, values)
  local names = ordered.keys(values)
  for _, name in ipairs(axis_names(plan)) do
    names[#names + 1] = name
  end
  return names
end

local function set(plan, values, name, value, blame)
  local old = standing(plan, values, name)
  if old == nil then
    fault.input("%s: the study has no parameter '%s'%s; parameters: %s", blame, name,
      fault.meant(name, known_names(plan, values)), table.concat(known_names(plan, values), ", "))
  elseif not fits(old, value) then
    fault.input("%s: '%s' must be like %s, not %s", blame, name, tostring(old), tostring(value))
  end
  replace(plan, values, name, value)
end

--- A number that --set says; bad input where it is beyond all that there are.
local function finite(name, text, number, factor)
  local value = tonumber(number)
  if not numeric.is_finite(value * (factor or 1)) then
    fault.input("--set %s=%s: that is beyond the largest number that there is", name, text)
  end
  return value
end

--- "5 mm", "0.4", "true" or a word, as what stands there now.
local function parse_value(name, text, old)
  local number, unit = text:match("^%s*([-+]?[%d.]+[eE]?[-+]?%d*)%s*%*?%s*(.-)%s*$")
  if type(old) == "boolean" and (text == "true" or text == "false") then
    return text == "true"
  elseif type(old) == "string" or not tonumber(number) then
    return text
  elseif unit == "" then
    return finite(name, text, number)
  elseif unit:find ",%s*[-+]?[%d.]" then
    fault.input("--set %s=%s: one value is wanted; several stand in the study, as sweep = { %s = { ... } }", name, text, name)
  elseif not engine.parse_unit(unit) then
    fault.input("--set: unknown unit '%s'%s", unit, fault.meant(unit, engine.unit_words()))
  end
  return finite(name, text, number, (engine.parse_unit(unit))) * units.units(unit)
end

local function apply_settings(plan, values, settings)
  for _, setting in ipairs(settings) do
    local name, text = setting:match("^%s*([%w_]+)%s*=%s*(.+)$")
    if not name then
      fault.input("--set %s: write NAME=VALUE, e.g. --set 'radius=5 mm'", setting)
    end
    set(plan, values, name, parse_value(name, text, standing(plan, values, name)), "--set " .. setting)
  end
end

local function apply_quick(plan, values, quick)
  for _, key in ipairs(ordered.keys(quick)) do
    if key ~= "sweep" and key ~= "set" then
      fault.input("study.quick: unknown key '%s'; it has sweep and set", tostring(key))
    end
  end
  local replacement = study_module.read_sweep(quick.sweep or {})
  if replacement.cases then
    plan.axes, plan.cases, plan.ids = nil, replacement.cases, replacement.ids
  end
  for _, axis in ipairs(replacement.axes or {}) do
    set(plan, values, axis.name, axis.values[1], "study.quick.sweep")
    for _, own in ipairs(plan.axes or {}) do
      own.values = own.name == axis.name and axis.values or own.values
    end
  end
  for _, name in ipairs(ordered.keys(quick.set or {})) do
    set(plan, values, name, quick.set[name], "study.quick.set")
  end
end

--- "1000" of 1000*mm/s, in the unit of `first`.
local function value_text(value, first)
  local text = tostring(value)
  if units.is_quantity(value) then
    local _, unit = first:display()
    text = ("%.10g"):format(value.si / engine.parse_unit(unit))
  elseif type(value) == "number" then
    text = ("%.10g"):format(value)
  end
  return (text:gsub("[^%w._+-]", "_"))
end

--- Each value in the unit of the study's own first case: what --set or --quick write changes no name.
local function default_id(names, case, first, own)
  local words = {}
  for i, name in ipairs(names) do
    words[i] = name .. value_text(case[name], own and own[name] or first[name])
  end
  return #words > 0 and table.concat(words, "_") or "case"
end

local strict = {
  __index = function(p, name)
    fault.script("there is no parameter '%s'%s; parameters: %s", tostring(name), fault.meant(name, ordered.keys(p)),
      table.concat(ordered.keys(p), ", "))
  end,
}

local function check_case(names, case, values)
  for _, key in ipairs(ordered.keys(case)) do
    if not numeric.first_where(names, function(name) return name == key end) then
      fault.input("study.sweep: a case gives '%s', which the first does not; every case must give the same names",
        tostring(key))
    end
  end
  for _, name in ipairs(names) do
    if not study_module.is_value(case[name]) then
      fault.input("study.sweep: every case must give '%s' a number, a quantity, a text or a flag", name)
    elseif values[name] ~= nil then
      fault.input("'%s' is swept, but stands in given or chosen as well", name)
    end
  end
end

local taken = { figures = true, trade = true, finer = true, source = true, fit = true, sample = true } -- folders beside those of cases

local longest_id = 200 -- with what is put aside behind it, and what file systems take

local function make_case(study, names, swept, first, values, drawn_id)
  check_case(names, swept, values)
  local p = copy(values)
  for _, name in ipairs(names) do
    p[name] = swept[name]
  end
  setmetatable(p, strict)
  local id = study.case_id and study.case_id(p) or drawn_id or default_id(names, swept, first, study.first)
  if type(id) ~= "string" then
    fault.input("study.case_id gave a %s; the case's name, a text, is wanted", type(id))
  elseif #id > longest_id then
    fault.input("study.case_id gave a name of %d characters, more than the %d that a folder's has room for: %s...", #id, longest_id,
      id:sub(1, 40))
  elseif not study.case_id and id:find("[^%w._+-]") then
    fault.input("study.sweep: cases cannot be called by the names that are swept, as in '%s'; name them by letters, digits and "
      .. "_, or give the study a case_id(p)", id)
  elseif not id:find("^[%w._+-]+$") or id:find("^%.") then
    fault.input("study.case_id gave '%s': a case's name is a folder's name of letters, digits and . _ + -", tostring(id))
  elseif taken[id] or id:find("%.json$") or id:find("%.csv$") then
    fault.input("a case cannot be called '%s', as that is a name of the output's own; give the study another case_id(p)",
      id)
  end
  return { id = id, p = p }
end

local function copy_plan(plan)
  local twin = {}
  for part, list in pairs { axes = plan.axes, cases = plan.cases } do
    twin[part] = {}
    for i, entry in ipairs(list) do
      twin[part][i] = copy(entry)
    end
  end
  twin.ids = plan.ids
  return twin
end

--- The study's own plan and values in the form that is asked for.
local function form(study, options)
  local plan, values = copy_plan(study.sweep), base_values(study)
  if options.quick then
    apply_quick(plan, values, study.quick)
  end
  return plan, values
end

--- What --set says, by name.
function sweep.settings_of(study, options)
  local plan, values = form(study, options)
  local told = {}
  apply_settings(plan, values, options.set or {})
  for _, setting in ipairs(options.set or {}) do
    local name = setting:match("^%s*([%w_]+)")
    told[name] = standing(plan, values, name)
  end
  return told
end

--- The swept values that study.trade.set must have brought down to one each, now standing with the others.
local function settle(plan, values, words)
  for _, name in ipairs(axis_names(plan)) do
    local axes, one = plan.axes or {}, nil
    for _, case in ipairs(plan.cases or multiply(axes)) do
      if one ~= nil and one ~= case[name] then
        fault.input("%s", words:format(name))
      end
      one = case[name]
    end
    values[name] = one
  end
end

--- The knobs of study.trade, and all values of its scene by name, those of the knobs among them.
function sweep.knobs(study, options)
  local spec = study.trade or fault.input("the study '%s' has no `trade = { quantities =, knobs = }`; see 'stiction help "
    .. "trade'", study.name)
  local quick = options.quick and spec.quick or {}
  local plan, values = copy_plan(study.sweep), base_values(study)
  for _, replacement in ipairs { spec.set or {}, quick.set or {} } do
    for _, name in ipairs(ordered.keys(replacement)) do
      set(plan, values, name, replacement[name], "study.trade.set")
    end
  end
  apply_settings(plan, values, options.set or {})
  settle(plan, values, "study.trade.set must give '%s' one value: the trade is measured on one scene")
  return ladder.knobs(quick.knobs or spec.knobs or {}, values), values
end

--- All combinations of the knobs of study.trade: cases that also know their `levels`, the knobs' names, the knobs.
function sweep.trade(study, options)
  local knobs, values = sweep.knobs(study, options)
  local names, axes = {}, {}
  for i, knob in ipairs(knobs) do
    names[i], axes[i], values[knob.name] = knob.name, { name = knob.name, values = knob.levels }, nil
  end
  local cases, swept = {}, multiply(axes)
  for i, entry in ipairs(swept) do
    cases[i] = make_case({}, names, entry, swept[1], values)
    cases[i].levels = numeric.map(knobs, function(knob) return ladder.level_of(knob, entry[knob.name]) end)
  end
  return cases, names, knobs
end

--- Values of a point as text, which sweep.point reads to the last bit.
function sweep.point_text(values)
  return engine.encode_json(identity.plain(values))
end

local function value_of(entry)
  return type(entry) == "table" and entry.value * units.units(entry.unit) or entry
end

--- All values by name of a case in which those of `point` (by name) stand in for the study's own; what is swept has to have
--- one value then. word: what is told of it; each(name): of one value, where that is more.
function sweep.values_at(study, options, point, word, each)
  local plan, values = form(study, options)
  apply_settings(plan, values, options.set or {})
  for _, name in ipairs(ordered.keys(point)) do
    set(plan, values, name, point[name], each and each(name) or word)
  end
  settle(plan, values, word .. ": '%s' has several values in the study's sweep; give it one")
  return values
end

--- The case at a point of the parameters, called by all of its values, of a text of sweep.point_text.
function sweep.point(study, options, text)
  local point = {}
  for name, entry in pairs(engine.decode_json(text) or {}) do
    point[name] = value_of(entry)
  end
  local names = ordered.keys(point)
  local case = { p = setmetatable(sweep.values_at(study, options, point, "a point"), strict), point = text, swept = names }
  case.id = "p" .. engine.hash(identity.parameters_text(case))
  return case, names
end

local function differ(p, q)
  return numeric.first_where(ordered.keys(p), function(name) return p[name] ~= q[name] end) ~= nil
end

--- Says once of a study without a quick form that --quick asks for none, and without --quick what is wrong with the one it has.
function sweep.tell_quick(study, options)
  if options.quick and not next(study.quick) then
    engine.complain("stiction: the study has no quick form, which is quick = { sweep = ..., set = ... }: it stands in full\n")
  end
  local held, value = engine.call(apply_quick, copy_plan(study.sweep), base_values(study), study.quick)
  if not held and not options.quick then
    engine.complain(("stiction: %s; --quick is refused for that\n"):format(type(value) == "table" and value.message or value))
  end
end

--- Says once how many cases of a list, as the study has it, stand in it before.
function sweep.tell_twice(study)
  local listed = study.sweep.cases or {}
  local twice = #listed - #sweep.cases(study, {})
  if twice > 0 then
    engine.complain(("stiction: %d of the %d cases of the sweep stand in it twice, and are computed once\n"):format(twice, #listed))
  end
end

--- The cases of `study` under options {quick =, set =, trade =, point =}: list of {id =, p =}, and the names that are swept.
function sweep.cases(study, options)
  if options.trade then
    return sweep.trade(study, options)
  elseif options.point then
    local case, names = sweep.point(study, options, options.point)
    return { case }, names
  end
  local plan, values = form(study, options)
  apply_settings(plan, values, options.set or {})
  local names, swept = axis_names(plan), plan.cases or multiply(plan.axes)
  local own = study.sweep
  study.first = (own.cases or multiply(own.axes))[1]
  local cases, seen = {}, {}
  for i, entry in ipairs(swept) do
    local case = make_case(study, names, entry, swept[1], values, plan.ids and plan.ids[i])
    case.swept = names
    case.problems = options.problems and math.floor(options.problems)
    if not seen[case.id] then
      cases[#cases + 1], seen[case.id] = case, case
    elseif not plan.cases and not differ(case.p, seen[case.id].p) then
      fault.input("the sweep makes case '%s' twice: a value stands in it twice; leave one out", case.id)
    elseif differ(case.p, seen[case.id].p) then
      fault.input("two cases of the sweep are called '%s'; %s", case.id,
        study.case_id and "let case_id(p) tell them apart" or "give the study a case_id(p)")
    end
  end
  return cases, names
end

--- The case of an earlier run that was called `id`, of its parameters as a file tells them; what the study has got since
--- has its own value.
function sweep.recall(study, id, parameters)
  local p = base_values(study)
  for name, value in pairs(parameters) do
    p[name] = type(value) == "table" and value.value * units.units(value.unit) or value
  end
  return { id = id, p = setmetatable(p, strict) }
end

--- The case called `id`, or bad input.
function sweep.find(cases, id)
  local ids = {}
  for i, case in ipairs(cases) do
    if case.id == id then
      return case
    end
    ids[i] = case.id
  end
  fault.input("there is no case '%s'%s; %s", id, fault.meant(id, ids), #ids > 10 and "--list shows the cases"
    or "cases are " .. table.concat(ids, ", "))
end

return sweep
