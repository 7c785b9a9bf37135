-- Parameters of a fit as what a sample draws: normal in the fit's relative coordinates, all together by its covariance.
local engine = require "stiction.engine"
local fault = require "stiction.fault"
local fit_spec = require "stiction.fit.spec"
local ordered = require "stiction.ordered"
local output = require "stiction.output"
local units = require "stiction.units"

local fitted = {}

local keys = { file = true, curve = true }

--- Lower factor of the rows and columns `of` of a positive definite matrix, as lists.
local function factor(matrix, of)
  local L = {}
  for i, row in ipairs(of) do
    L[i] = {}
    for j = 1, i do
      local sum = matrix[row][of[j]]
      for k = 1, j - 1 do
        sum = sum - L[i][k] * L[j][k]
      end
      L[i][j] = i == j and math.sqrt(math.max(sum, 0)) or (L[j][j] > 0 and sum / L[j][j] or 0)
    end
  end
  return L
end

--- What study.sample.fit asks for: {file = (nil: what `fit` of the study writes), curve = (whose own parameters are drawn, or nil)}.
local function wanted(entry)
  if entry == true or type(entry) == "string" then
    return { file = entry ~= true and entry or nil }
  elseif type(entry) ~= "table" then
    fault.script("study.sample.fit = %s; it is true, the path of a fit.json, or { curve = \"name\", file = \"fit.json\" }", tostring(entry))
  end
  for _, key in ipairs(ordered.keys(entry)) do
    if not keys[key] then
      fault.script("study.sample.fit: unknown key '%s'%s; it has curve and file", tostring(key),
        fault.meant(tostring(key), ordered.keys(keys)))
    elseif type(entry[key]) ~= "string" then
      fault.script("study.sample.fit: %s = %s; a name is wanted", key, tostring(entry[key]))
    end
  end
  return entry
end

local function path_of(study, file, options)
  if not file then
    return (options.out or output.default_folder(study.name, study.source.file) .. "/fit") .. "/fit.json"
  end
  return file:sub(1, 1) == "/" and file or study.source.folder .. "/" .. file
end

--- What a fit.json holds, its parameters by name in `by_name`.
local function read(path)
  local kept = engine.decode_json(engine.read_file(path) or "")
  if type(kept) ~= "table" or type(kept.parameters) ~= "table" or type(kept.covariance) ~= "table" then
    fault.input("study.sample.fit: there is no fit in %s; 'stiction fit' on the study makes one (with the same --out), or name its file: "
      .. "fit = \"PATH/fit.json\"", path)
  end
  kept.by_name = {}
  for _, own in ipairs(kept.parameters) do
    kept.by_name[type(own) == "table" and own.name or ""] = own
  end
  return kept
end

--- Bad input if there is no such curve, or if a parameter is one of several curves' own, none of them was chosen,
--- and the sample does not have it otherwise.
local function check_curves(kept, study, want, path, others)
  local curves, by_key = {}, {}
  for _, own in ipairs(kept.parameters) do
    if own.curve then
      curves[own.curve] = true
      by_key[own.key] = by_key[own.key] or {}
      table.insert(by_key[own.key], own.curve)
    end
  end
  for _, curve in ipairs(type(kept.curves) == "table" and kept.curves or {}) do
    curves[type(curve) == "table" and curve.name or ""] = true
  end
  if want.curve and not curves[want.curve] then
    fault.input("study.sample.fit: the fit in %s has no curve '%s'%s; its curves: %s", path, want.curve,
      fault.meant(want.curve, ordered.keys(curves)), table.concat(ordered.keys(curves), ", "))
  end
  for _, key in ipairs(ordered.keys(by_key)) do
    if not want.curve and not others[key] and #by_key[key] > 1 and fit_spec.has(study, key) then
      fault.input("study.sample.fit: each of the curves %s has a '%s' of its own; say whose: fit = { curve = \"%s\" }",
        table.concat(by_key[key], ", "), key, by_key[key][1])
    end
  end
end

--- The axis of a parameter, of whose relative coordinate this is the row of the factor.
local function axis(own, row)
  local scale = own.error / own.relative_error
  return { name = own.key, curve = own.curve, like = own.unit == "1" and 1 or units.units(own.unit), kind = "normal", joint = true,
    best = own.best, shown = own.shown or ("%g %s"):format(own.best, own.unit), relative_error = own.relative_error,
    together = function(xi)
      local sum = 0
      for j, x in ipairs(row) do
        sum = sum + x * xi[j]
      end
      return own.log and own.best * math.exp(sum) or own.best + scale * sum
    end }
end

local function damaged(path)
  fault.input("study.sample.fit: %s is damaged; run the fit again", path)
end

--- Whether a parameter is one of the study's cases, of the curve that is wanted.
local function is_wanted(study, own, want)
  return fit_spec.has(study, own.key) and not (own.curve and want.curve and own.curve ~= want.curve)
end

--- The parameters that ended at a bound: {name =, curve =, value = (a quantity), shown =}, without those that the sample has otherwise.
local function held_ones(study, kept, want, path, others)
  local is_free, list = {}, {}
  for _, name in ipairs(kept.free) do
    is_free[name] = true
  end
  for _, own in ipairs(kept.parameters) do
    if type(own) ~= "table" or type(own.best) ~= "number" or type(own.key) ~= "string" then
      damaged(path)
    elseif not is_free[own.name] and is_wanted(study, own, want) and not others[own.key] then
      list[#list + 1] = { name = own.key, curve = own.curve, value = own.unit == "1" and own.best or own.best * units.units(own.unit),
        shown = own.shown or ("%g %s"):format(own.best, own.unit) }
    end
  end
  return list
end

--- {axes = of a fit's parameters that cases have, which move together, by standard normal numbers; source = its file; left_out = names of
--- those that no case has, as its `against` alone takes them; held = {those at a bound}; otherwise = names of those that the sample has
--- otherwise, others[name]; asked = whether a curve was}.
function fitted.read(study, entry, options, others)
  local want = wanted(entry)
  local path = path_of(study, want.file, options)
  local kept = read(path)
  check_curves(kept, study, want, path, others)
  local list, of, seen = {}, {}, {}
  local result = { axes = {}, source = path, left_out = {}, asked = want.curve ~= nil }
  for i, name in ipairs(type(kept.free) == "table" and kept.free or damaged(path)) do
    local own = kept.by_name[name]
    if type(own) ~= "table" or type(own.best) ~= "number" or type(own.key) ~= "string" then
      damaged(path)
    elseif not fit_spec.has(study, own.key) then
      result.left_out[#result.left_out + 1] = name
    elseif others[own.key] then
      seen[own.key] = is_wanted(study, own, want) or seen[own.key] or nil
    elseif is_wanted(study, own, want) then
      if type(own.relative_error) ~= "number" or own.relative_error > 1 then
        fault.input("study.sample.fit: %s was not determined by the fit in %s; give it a distribution in sample.of, or fit without it",
          name, path)
      end
      list[#list + 1], of[#of + 1] = own, i
    end
  end
  result.otherwise = ordered.keys(seen)
  result.held = held_ones(study, kept, want, path, others)
  local good, L = engine.call(factor, kept.covariance, of)
  if not good then
    damaged(path)
  elseif #list == 0 then
    fault.input("study.sample.fit: no parameter of the fit in %s is one of the study's cases; give distributions in sample.of",
      path)
  end
  for n, own in ipairs(list) do
    result.axes[n] = axis(own, L[n])
  end
  return result
end

return fitted
