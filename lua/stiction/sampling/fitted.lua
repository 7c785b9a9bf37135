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

--- Bad input if there is no such curve, or if a parameter is one of several curves' own and none of them was chosen.
local function check_curves(kept, study, want, path)
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
    if not want.curve and #by_key[key] > 1 and fit_spec.has(study, key) then
      fault.input("study.sample.fit: each of the curves %s has a '%s' of its own; say whose: fit = { curve = \"%s\" }",
        table.concat(by_key[key], ", "), key, by_key[key][1])
    end
  end
end

--- The axis of a parameter, of whose relative coordinate this is the row of the factor.
local function axis(own, row)
  local scale = own.error / own.relative_error
  return { name = own.key, curve = own.curve, like = own.unit == "1" and 1 or units.units(own.unit), kind = "normal", joint = true,
    together = function(xi)
      local sum = 0
      for j, x in ipairs(row) do
        sum = sum + x * xi[j]
      end
      return own.log and own.best * math.exp(sum) or own.best + scale * sum
    end }
end

--- Axes of a fit's parameters that cases have, which move together, by standard normal numbers; the fit's file; names of those that no
--- case has, as its `against` alone takes them.
function fitted.axes(study, entry, options)
  local want = wanted(entry)
  local path = path_of(study, want.file, options)
  local kept = read(path)
  local function damaged()
    fault.input("study.sample.fit: %s is damaged; run the fit again", path)
  end
  check_curves(kept, study, want, path)
  local list, of, left_out = {}, {}, {}
  for i, name in ipairs(type(kept.free) == "table" and kept.free or damaged()) do
    local own = kept.by_name[name]
    if type(own) ~= "table" or type(own.best) ~= "number" or type(own.key) ~= "string" then
      damaged()
    elseif not fit_spec.has(study, own.key) then
      left_out[#left_out + 1] = name
    elseif not (own.curve and want.curve and own.curve ~= want.curve) then
      if type(own.relative_error) ~= "number" or own.relative_error > 1 then
        fault.input("study.sample.fit: %s was not determined by the fit in %s; give it a distribution in sample.of, or fit without it",
          name, path)
      end
      list[#list + 1], of[#of + 1] = own, i
    end
  end
  local held, L = engine.call(factor, kept.covariance, of)
  if not held then
    damaged()
  elseif #list == 0 then
    fault.input("study.sample.fit: no parameter of the fit in %s is one of the study's cases; give distributions in sample.of",
      path)
  end
  local axes = {}
  for n, own in ipairs(list) do
    axes[n] = axis(own, L[n])
  end
  return axes, path, left_out
end

return fitted
