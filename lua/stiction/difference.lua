-- What differs between two scenes, as JSON tells them: paths with the value there before and now.
local engine = require "stiction.engine"
local ordered = require "stiction.ordered"

local difference = {}

local maker = "(made by)"

--- "1000 kg m^-3", "true", "a text"
local function words(value)
  if type(value) == "table" then
    return words(value.value) .. " " .. value.unit
  end
  return type(value) == "number" and engine.number_text(value) or tostring(value)
end

local function extended(path, key)
  if type(key) == "number" then
    return ("%s[%d]"):format(path, key)
  elseif key == maker then
    return path == "" and "scene" or path
  end
  return path == "" and key or path .. "." .. key
end

--- Adds the values of nested tables to `found`, as texts under their paths: "bodies.block.material.young".
local function flatten(value, path, found)
  if type(value) ~= "table" or type(value.unit) == "string" and type(value.value) == "number" then
    found[path] = words(value)
    return
  end
  for _, key in ipairs(ordered.keys(value)) do
    flatten(value[key], extended(path, key), found)
  end
end

--- List of {path, before, now}, in the order of the paths.
function difference.list(before, now)
  local one, other, all, list = {}, {}, {}, {}
  flatten(before, "", one)
  flatten(now, "", other)
  for _, found in ipairs { one, other } do
    for path in pairs(found) do
      all[path] = true
    end
  end
  for _, path in ipairs(ordered.keys(all)) do
    if one[path] ~= other[path] then
      list[#list + 1] = { path, one[path] or "none", other[path] or "none" }
    end
  end
  return list
end

return difference
