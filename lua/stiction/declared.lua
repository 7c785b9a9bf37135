-- What a study declares beside its scene, to fit or to sample: a table of known keys, some of them others in the quick form.
local copy = require "stiction.copy"
local fault = require "stiction.fault"
local ordered = require "stiction.ordered"

local function check_keys(name, t, keys)
  for _, key in ipairs(ordered.keys(t)) do
    if not keys[key] then
      fault.script("study.%s: unknown key '%s'%s; keys: %s", name, tostring(key), fault.meant(tostring(key), ordered.keys(keys)),
        table.concat(ordered.keys(keys), ", "))
    elseif keys[key] ~= true and type(t[key]) ~= keys[key] then
      fault.script("study.%s.%s must be a %s, not a %s", name, key, keys[key], type(t[key]))
    end
  end
end

--- The study's table of this name, a copy, with what its own `quick` changes where the form is quick. keys: type by key, true for any;
--- like: what it looks like, for those who lack it.
return function(study, options, name, keys, like)
  local t = study[name] or fault.input("the study '%s' has no `%s = %s`; see 'stiction help %s'", study.name, name, like, name)
  if study.problem then
    fault.input("the study '%s' is of saved contact problems; a %s needs a scene", study.name, name)
  end
  check_keys(name, t, keys)
  t = copy(t)
  for key, value in pairs(options.quick and t.quick or {}) do
    t[key] = value
  end
  check_keys(name, t, keys)
  return t
end
