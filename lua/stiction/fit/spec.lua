-- What a study declares as its fit: parameters with bounds, curves, settings; checked before anything runs.
local copy = require "stiction.copy"
local curve_module = require "stiction.fit.curve"
local declared = require "stiction.declared"
local engine = require "stiction.engine"
local fault = require "stiction.fault"
local loss = require "stiction.fit.loss"
local numeric = require "stiction.numeric"
local ordered = require "stiction.ordered"
local sweep = require "stiction.sweep"
local units = require "stiction.units"

local spec = {}

local keys = { parameters = "table", data = "table", loss = "string", starts = "number", noise = "number", profiles = "boolean",
  finer = "table", further = "table", most = "number", quick = "table" }
local parameter_keys = { scale = true, start = true, [1] = true, [2] = true }
local scales = { log = true, linear = true }
local most_per_parameter = 60 -- evaluations, unless the study says otherwise

local function check_needs(t)
  for _, key in ipairs { "parameters", "data" } do
    if type(t[key]) ~= "table" or next(t[key]) == nil then
      fault.script("study.fit needs %s = { name = { ... }, ... }; see 'stiction help fit'", key)
    end
  end
end

--- A quantity of the dimension of `like` (or a plain number) with this value in SI.
function spec.quantity(like, value)
  if not units.is_quantity(like) then
    return value
  end
  return value * units.units(engine.dimension_text(like.metre, like.kilogram, like.second))
end

local function is_number(x)
  return type(units.si(x)) == "number"
end

local function same(a, b)
  return is_number(a) and is_number(b) and (units.same_dimension(a, b) or not units.is_quantity(a) and not units.is_quantity(b))
end

--- A parameter {name =, label =, from =, to =, log =, start =, like = (a quantity), curve = (its own, or nil), setting = whether the
--- study has it}; standing: its value in the study, or nil.
local function read_parameter(what, name, t, standing)
  if type(t) ~= "table" or units.is_quantity(t) or not (is_number(t[1]) and same(t[1], t[2])) then
    fault.script("%s must be { from, to, scale = \"log\" or \"linear\", start = ... }, from and to of one dimension", what)
  end
  for _, key in ipairs(ordered.keys(t)) do
    if not parameter_keys[key] then
      fault.script("%s: unknown key '%s'; it has from and to first, then scale and start", what, tostring(key))
    end
  end
  local own = { name = name, from = units.si(t[1]), to = units.si(t[2]), log = (t.scale or "linear") == "log", like = t[1],
    setting = standing ~= nil }
  if t.scale and not scales[t.scale] then
    fault.script("%s: scale = %s; it is \"log\" or \"linear\"", what, tostring(t.scale))
  elseif own.from >= own.to then
    fault.script("%s: from %s to %s; the first must be less", what, tostring(t[1]), tostring(t[2]))
  elseif own.log and own.from <= 0 then
    fault.script("%s: a logarithmic parameter begins above 0, not at %s", what, tostring(t[1]))
  elseif standing ~= nil and not same(standing, t[1]) then
    fault.script("%s goes from %s, but the study's own value is %s: the dimensions differ", what, tostring(t[1]), tostring(standing))
  end
  local start = t.start or standing
  if start ~= nil and not same(start, t[1]) then
    fault.script("%s: start = %s is not like its bounds", what, tostring(start))
  end
  own.start = units.si(start) or own.log and math.sqrt(own.from * own.to) or 0.5 * (own.from + own.to)
  if own.start < own.from or own.start > own.to then
    fault.input("%s: the search would begin at %s%s, which is not between its bounds %s and %s; widen them, or give start = ...", what,
      tostring(start), t.start == nil and " (the study's own value)" or "", tostring(t[1]), tostring(t[2]))
  end
  return own
end

--- The value that the study itself has for a name, nil if there is none.
local function standing_of(values, study, name)
  if values[name] ~= nil then
    return values[name]
  end
  local sweep_of = study.sweep
  for _, axis in ipairs(sweep_of.axes or {}) do
    if axis.name == name then
      return axis.values[1]
    end
  end
  return sweep_of.cases and sweep_of.cases[1] and sweep_of.cases[1][name]
end

--- Values of given and chosen by name.
local function own_values(study)
  local values = {}
  for _, section in ipairs { study.given, study.chosen } do
    for name, entry in pairs(section) do
      values[name] = entry.value
    end
  end
  return values
end

--- Whether the study's cases have a parameter of this name.
function spec.has(study, name)
  return standing_of(own_values(study), study, name) ~= nil
end

--- Bad input where a curve's cases are given a value of what is fitted.
local function check_cases_of(curves, fit)
  for _, curve in ipairs(curves) do
    for _, name in ipairs(ordered.keys(curve.case)) do
      if fit.parameters[name] or curve.own[name] then
        fault.script("%s: case.%s = %s stands beside the fit's own '%s'; leave it in one of them, or give start = ... there", curve.what,
          name, tostring(curve.case[name]), name)
      end
    end
  end
end

--- options: of the command, whose --set says where to begin.
local function all_parameters(fit, study, curves, options)
  local values, list, told = own_values(study), {}, sweep.settings_of(study, options)
  local function read(what, name, key, entry)
    if told[key] ~= nil and type(entry) == "table" then
      entry = copy(entry)
      entry.start = told[key]
    end
    list[#list + 1] = read_parameter(what, name, entry, standing_of(values, study, key))
    list[#list].key = key
    return list[#list]
  end
  check_cases_of(curves, fit)
  for _, name in ipairs(ordered.keys(fit.parameters)) do
    read("study.fit.parameters." .. name, name, name, fit.parameters[name])
  end
  for _, curve in ipairs(curves) do
    for _, name in ipairs(ordered.keys(curve.own)) do
      if fit.parameters[name] then
        fault.script("%s: own.%s is shared by all curves already (study.fit.parameters)", curve.what, name)
      end
      read(("%s.own.%s"):format(curve.what, name), curve.name .. "." .. name, name, curve.own[name]).curve = curve.name
    end
  end
  return list
end

--- Values that a curve's runs have, of the parameters' values in SI: those of the study, and those that its comparison takes.
function spec.values_for(fit, curve, values)
  local settings, others = {}, {}
  for k, own in ipairs(fit.parameters) do
    if not own.curve or own.curve == curve.name then
      local target = own.setting and settings or others
      target[own.key] = spec.quantity(own.like, values[k])
    end
  end
  return settings, others
end

--- The meshes in what a scene says of its bodies, as texts.
local function meshes_of(node, list)
  for _, key in ipairs(type(node) == "table" and ordered.keys(node) or {}) do
    if key == "mesh" then
      list[#list + 1] = engine.encode_json(node[key])
    else
      meshes_of(node[key], list)
    end
  end
  return list
end

--- The case that a curve, by default the first one, begins with at the parameters' starts, the k-th of them at a value.
function spec.case_at(fit, study, options, curve, k, value)
  local values = numeric.map(fit.parameters, function(parameter) return parameter.start end)
  values[k or 0] = value
  curve = curve or fit.curves[1]
  return (sweep.point(study, options, sweep.point_text(curve:cases((spec.values_for(fit, curve, values)))[1])))
end

--- What the scene of a curve's first case is at both bounds and the start of the k-th parameter, as texts; where it can be.
local function scenes_of(fit, study, options, k)
  local own, texts = fit.parameters[k], {}
  local curve = fit.curves[1]
  for _, other in ipairs(fit.curves) do
    curve = other.name == own.curve and other or curve
  end
  for _, value in ipairs { own.from, own.start, own.to } do
    local held, text = engine.call(function()
      return engine.scene_text(study:scene_of(spec.case_at(fit, study, options, curve, k, value)))
    end)
    texts[#texts + 1] = held and text or nil -- a scene that cannot be there is no reason yet
  end
  return texts
end

--- Whether the scene of a curve's first case changes with the k-th parameter; nil where that is not known.
function spec.is_used(fit, study, options, k)
  local texts = scenes_of(fit, study, options, k)
  for i = 2, #texts do
    if texts[i] ~= texts[1] then
      return true
    end
  end
  if #texts > 1 then
    return false
  end
end

--- Bad input if the meshes of a curve's first case change with the k-th parameter.
local function check_mesh(fit, study, options, k)
  local own = fit.parameters[k]
  local texts = numeric.map(scenes_of(fit, study, options, k), function(text)
    return table.concat(meshes_of(engine.decode_json(text), {}), " ")
  end)
  for i = 2, #texts do
    if texts[i] ~= texts[1] then
      fault.input("study.fit: '%s' changes the mesh: results then jump with it, and no derivative is right; let the mesh be the same "
        .. "from %s to %s, or leave it out of the fit", own.name, tostring(spec.quantity(own.like, own.from)),
        tostring(spec.quantity(own.like, own.to)))
    end
  end
end

local function check_settings(fit)
  loss.check(fit.loss)
  for _, key in ipairs { "starts", "most" } do
    if math.type(fit[key]) ~= "integer" or fit[key] < 1 then
      fault.script("study.fit: %s = %s; a whole number above 0 is wanted", key, tostring(fit[key]))
    end
  end
  if fit.noise and not (fit.noise > 0 and fit.noise < 1) then
    fault.script("study.fit: noise = %g; it is the relative noise of a run's results, between 0 and 1", fit.noise)
  end
end

local function count_points(fit)
  local count = 0
  for _, curve in ipairs(fit.curves) do
    curve.first, curve.last = count + 1, count + #curve.y
    count = curve.last
  end
  if count <= #fit.parameters then
    fault.input("study.fit: %d measured points for %d parameters; there must be more points than parameters", count, #fit.parameters)
  end
  return count
end

--- Bad input where a further measurement is of a parameter that there is none of.
local function check_further(further, study)
  for _, key in ipairs(ordered.keys(further)) do
    local entry = further[key]
    local names = type(key) == "string" and { key } or type(entry) == "table" and not units.is_quantity(entry) and ordered.keys(entry) or {}
    for _, name in ipairs(names) do
      if type(name) == "string" and not spec.has(study, name) then
        fault.script("study.fit.further: the study has no parameter '%s'%s", name, fault.meant(name, ordered.keys(own_values(study))))
      end
    end
  end
end

--- Whether the errors of measured values are known: those that are not told are then estimated from the values themselves.
local function is_known(curves)
  for _, curve in ipairs(curves) do
    if curve.told then
      return true
    end
  end
  return false
end

--- The fit of a study: {parameters =, curves =, count = (of points), known =, loss =, starts =, noise =, profiles =, finer =, further =,
--- most =, files = {{path =, hash =}}}; bad input where something is wrong with it.
function spec.read(study, options)
  local t = declared(study, options, "fit", keys, "{ parameters =, data = }")
  check_needs(t)
  local fit = { curves = {}, files = {}, loss = t.loss or "squares", starts = t.starts or 1, noise = t.noise, finer = t.finer,
    profiles = t.profiles ~= false, further = t.further }
  local function note(path, text)
    fit.files[#fit.files + 1] = { path = engine.relative(path, study.source.folder), hash = engine.hash(text) }
  end
  for i, name in ipairs(ordered.keys(t.data)) do
    fit.curves[i] = curve_module.read(tostring(name), t.data[name], study.source.folder, note)
  end
  fit.parameters = all_parameters(t, study, fit.curves, options)
  check_further(t.further or {}, study)
  fit.most = t.most or most_per_parameter * #fit.parameters
  check_settings(fit)
  fit.count, fit.known = count_points(fit), is_known(fit.curves)
  for k, own in ipairs(fit.parameters) do
    local _ = own.setting and check_mesh(fit, study, options, k)
  end
  return fit
end

return spec
