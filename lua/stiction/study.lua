-- The study table a script returns: its keys checked, its parameters gathered.
local calls = require "stiction.calls"
local copy = require "stiction.copy"
local engine = require "stiction.engine"
local fault = require "stiction.fault"
local loader = require "stiction.loader"
local numeric = require "stiction.numeric"
local ordered = require "stiction.ordered"
local parts = require "stiction.parts"
local sample = require "stiction.sample"
local units = require "stiction.units"

local study = {}

local keys = {
  title = "string", question = "string", given = "table", chosen = "table", sweep = "table", case_id = "function",
  scene = "function", problem = "function", results = "table", quick = "table", check = "function", figures = "function",
  trade = "table", fit = "table", sample = "table", derivatives = "table",
}

local function names_of(t)
  return ordered.keys(t)
end

local function check_keys(t)
  for _, key in ipairs(names_of(t)) do
    local want = keys[key]
    if not want then
      fault.script("study: unknown key '%s'%s; keys: %s", tostring(key), fault.meant(key, names_of(keys)),
        table.concat(names_of(keys), ", "))
    elseif type(t[key]) ~= want then
      fault.script("study.%s must be a %s, not a %s", key, want, type(t[key]))
    end
  end
  if t.title == nil then
    fault.script("study.title is missing")
  elseif t.problem and t.derivatives then
    fault.script("study has problem and derivatives; a saved contact problem has none")
  elseif not t.scene == not t.problem then
    fault.script(t.scene and "study has scene and problem; it takes one of them"
      or "study.scene is missing (or study.problem, where a case is a saved contact problem)")
  end
end

--- Is it a number, plain or of a quantity, that is none?
local function is_undefined(x)
  return type(x) == "number" and x ~= x or units.is_quantity(x) and x.si ~= x.si
end

--- A parameter is a number, a quantity, a text or a flag.
function study.is_value(x)
  local kind = type(x)
  return not is_undefined(x) and (kind == "number" or kind == "string" or kind == "boolean" or units.is_quantity(x))
end

--- {name = {value =, note =}} of `given` (a note is welcome) or `chosen` (it must be there).
local function read_parameters(t, section, need_note)
  local parameters = {}
  for _, name in ipairs(names_of(t or {})) do
    local entry = t[name]
    local value, note = entry, nil
    if type(entry) == "table" and not units.is_quantity(entry) then
      value, note = entry[1], entry[2]
    end
    if not study.is_value(value) then
      fault.script("study.%s.%s must be a number, a quantity, a text or a flag%s", section, tostring(name),
        is_undefined(value) and "; it is not a number" or "")
    elseif need_note and (type(note) ~= "string" or note == "") then
      fault.script("study.chosen.%s needs its reason: %s = {%s, \"why\"}", name, name, tostring(value))
    end
    parameters[name] = { value = value, note = note }
  end
  return parameters
end

--- What summary.csv tells of every case beside its parameters and results.
study.measures = { "verdict", "steps", "iterations", "contact", "seconds" }

local function read_result(name, entry)
  if type(name) ~= "string" or name == "" then
    fault.script("study.results: entry %s has no name; give name = \"force\"", tostring(name))
  end
  local odd = name:find("[,\"%c]") -- in the head of summary.csv it would end the name
  if odd then
    fault.script("study.results: the name '%s' holds %s; take another character, as _", (name:gsub("%c", "?")),
      name:find("%c", odd) == odd and "a control character" or "a '" .. name:sub(odd, odd) .. "'")
  end
  local body = type(entry) == "table" and (entry.value or entry[1])
  if type(body) ~= "function" then
    fault.script("study.results.%s must be { unit = ..., meaning = ..., function(run, p) ... end }", tostring(name))
  end
  local unit = entry.unit or "1"
  if type(unit) ~= "string" then
    fault.script("study.results.%s: the unit is a %s; a text is wanted, as \"1\" or \"kPa\"", name, type(unit))
  elseif not engine.parse_unit(unit) then
    fault.script("study.results.%s: unknown unit '%s'; 'stiction help units' lists them", name, tostring(unit))
  end
  return { name = name, unit = unit, meaning = entry.meaning or "", compute = body }
end

--- Results in the order listed, or by name when they are given by name.
local function read_results(t)
  local results = {}
  for _, key in ipairs(names_of(t or {})) do
    local entry = t[key]
    local name = type(key) == "number" and type(entry) == "table" and entry.name or key
    results[#results + 1] = read_result(name, entry)
  end
  return results
end

--- What summary.csv has another column of the same name for: list of {what =, name =, why =}; `swept`: the study's sweeps.
local function doubled(results, swept)
  local list, seen, parameters = {}, {}, {}
  local taken = { case = "names the case" }
  for _, name in ipairs(study.measures) do
    taken[name] = "is told of every case"
  end
  for _, sweep in ipairs(swept) do
    for _, axis in ipairs(sweep.axes or {}) do
      parameters[axis.name] = true
    end
    for _, case in ipairs(sweep.cases or {}) do
      for name in pairs(case) do
        parameters[name] = type(name) == "string" or nil
      end
    end
  end
  for _, name in ipairs(ordered.keys(parameters)) do
    list[#list + 1] = taken[name] and { what = "parameter", name = name, why = taken[name] } or nil
    taken[name] = "is swept"
  end
  for _, result in ipairs(results) do
    if seen[result.name] then
      fault.script("study.results: there are two called '%s'", result.name)
    end
    seen[result.name] = true
    list[#list + 1] = taken[result.name] and { what = "result", name = result.name, why = taken[result.name] } or nil
  end
  return list
end

local function is_table(x)
  return type(x) == "table" and not units.is_quantity(x)
end

--- Quantities of one dimension, or none of them a quantity.
local function are_alike(a, b)
  return not units.is_quantity(a) and not units.is_quantity(b) or units.same_dimension(a, b)
end

local function check_values(name, values)
  if not is_table(values) or #values == 0 then
    fault.script("study.sweep.%s must be a list of values", tostring(name))
  end
  for i = 1, #values do
    if not study.is_value(values[i]) then
      fault.script("study.sweep.%s: value %d is %s; it must be a number, a quantity, a text or a flag",
        tostring(name), i, is_undefined(values[i]) and "not a number" or "a " .. type(values[i]))
    elseif not are_alike(values[1], values[i]) then
      fault.script("study.sweep.%s: value %d, %s, is not of the first's dimension, %s", tostring(name), i, tostring(values[i]),
        tostring(values[1]))
    end
  end
end

local function check_cases(cases)
  for i = 1, #cases do
    if not is_table(cases[i]) then
      fault.script("study.sweep: case %d must be a table of values by name, not a %s", i, type(cases[i]))
    end
    for _, name in ipairs(names_of(cases[i])) do
      if type(name) ~= "string" then
        fault.script("study.sweep: %s stands there without a name; write sweep = { mu = { 0.2, 0.5 } } for values of mu, or a " ..
          "list of cases, { { mu = 0.2 }, { mu = 0.5 } }", tostring(cases[i][name]))
      elseif cases[1][name] ~= nil and not are_alike(cases[1][name], cases[i][name]) then
        fault.script("study.sweep: %s of case %d, %s, is not of the first's dimension, %s", name, i, tostring(cases[i][name]),
          tostring(cases[1][name]))
      end
    end
  end
  return cases
end

--- An axis per swept name, or one list of explicit cases: {axes =} or {cases =}.
function study.read_sweep(t)
  local sweep = { axes = {} }
  local first = t[1]
  if is_table(first) and type(first[1]) ~= "string" then
    local drawn, ids = sample.drawn(t)
    return { cases = check_cases(t), ids = ids, drawn = drawn }
  end
  for _, key in ipairs(names_of(t)) do
    local name, values = key, t[key]
    if type(key) == "number" then
      name, values = key, nil
      if is_table(t[key]) then
        name, values = t[key][1], t[key][2]
      end
    end
    check_values(name, values)
    sweep.axes[#sweep.axes + 1] = { name = name, values = values }
  end
  return sweep
end

local function check_distinct(given, chosen)
  for name in pairs(given) do
    if chosen[name] then
      fault.script("'%s' stands in both given and chosen", name)
    end
  end
end

local methods = {}
local study_mark = { __index = methods }

--- Names of parameters with respect to which results are to have derivatives.
local function read_derivatives(t, known)
  local list = {}
  local seen = {}
  for i, name in ipairs(t or {}) do
    if not known(name) then
      fault.script("study.derivatives: the study has no parameter '%s'; give a list of names", tostring(name))
    elseif seen[name] then
      fault.script("study.derivatives: '%s' stands there twice", name)
    end
    list[i], seen[name] = name, true
  end
  return list
end

--- stiction.study{ ... }
function study.define(t)
  if type(t) ~= "table" then
    fault.script("study takes one table: study{ ... }")
  end
  check_keys(t)
  local given = read_parameters(t.given, "given", false)
  local chosen = read_parameters(t.chosen, "chosen", true)
  check_distinct(given, chosen)
  local swept = study.read_sweep(t.sweep or {})
  local results = read_results(t.results)
  local function known(name)
    local function is(axis) return axis.name == name end
    return given[name] or chosen[name] or numeric.first_where(swept.axes or {}, is)
      or swept.cases and swept.cases[1][name] ~= nil
  end
  return setmetatable({
    title = t.title, question = t.question or "", given = given, chosen = chosen,
    derivatives = read_derivatives(t.derivatives, known), sweep = swept, quick = t.quick or {}, case_id = t.case_id,
    scene = t.scene, problem = t.problem, results = results,
    doubled = doubled(results, { swept, study.read_sweep((t.quick or {}).sweep or {}) }), check = t.check,
    figures = t.figures, trade = t.trade,
    fit = t.fit, sample = t.sample, definition = t,
  }, study_mark)
end

local merged = { given = true, chosen = true }

--- The same study with some keys replaced, or left out where they are false; given and chosen entry by entry.
function methods.variant(self, changes)
  local t = copy(self.definition)
  for _, key in ipairs(ordered.keys(changes)) do
    local new = changes[key]
    if merged[key] and t[key] then
      t[key] = copy(t[key])
      for name, entry in pairs(new) do
        t[key][name] = entry
      end
    else
      t[key] = new or nil
    end
  end
  return study.define(t)
end

--- p as a scene sees it; `read` notes the names that it asks for.
local function watched(p, read)
  return setmetatable({}, {
    __index = function(_, name)
      read[name] = true
      return p[name]
    end,
    __newindex = function(_, name)
      fault.script("the parameter '%s' cannot be changed in a scene: results and the summary have the study's value; "
        .. "use a local variable", tostring(name))
    end,
    __pairs = function()
      for name in ordered.pairs(p) do
        read[name] = true
      end
      return ordered.pairs(p)
    end,
  })
end

--- The swept names that no scene made so far has asked for, sorted; {} before one was made to its end.
function methods.unread(self, names)
  local list = {}
  for _, name in ipairs(names) do
    list[#list + 1] = self.made and not self.read[name] and name or nil
  end
  return list
end

--- The scene of a case, made once.
function methods.scene_of(self, case)
  if not case.scene then
    engine.reseed() -- one case's scene does not depend on whether another's was made before
    self.read = self.read or {}
    engine.watch_returns(true)
    case.scene = self.scene(watched(case.p, self.read))
    engine.watch_returns(false)
    self.made = true
  end
  if type(case.scene) ~= "table" then
    fault.input("study.scene must end with: return stiction.scene{ ... }; it gave %s",
      case.scene == nil and "nothing" or "a " .. type(case.scene))
  end
  if case.problems then
    local own = copy(case.scene.output or {})
    own.problems_every = case.problems
    case.scene.output = parts.constructors().output(own)
  end
  return case.scene
end

calls.methods(methods, "study", function(first) return getmetatable(first) == study_mark end)

--- What a study is called in output folders, of where it stands.
function study.name_of(source)
  local whole = source.whole and source.folder or source.file:gsub("%.lua$", "")
  return whole:match(".*/studies/(.+)$") or whole:match("[^/]+$")
end

--- Loads the study at `path`; it knows its source, the identity of its files, and its name for output folders.
function study.load(path, trust)
  local value, source = loader.load(path, trust)
  if getmetatable(value) ~= study_mark then
    fault.input("%s must end with: return stiction.study{ ... }", source.name)
  end
  value.source, value.identity = source, loader.identity(source)
  value.name = study.name_of(source)
  return value
end

return study
