-- The constructors of everything a scene holds, made from the engine's catalog.
local copy = require "stiction.copy"
local engine = require "stiction.engine"
local fault = require "stiction.fault"

local function construct(tag, t)
  if type(t) ~= "table" or getmetatable(t) ~= nil then
    fault.script("%s takes one table: %s{ ... }", tag, tag)
  end
  -- a copy: one table of the script may serve several parts
  return setmetatable(copy(t), { tag = tag, place = engine.where(), __metatable = "part" })
end

local function names_of(list)
  local names = {}
  for i, entry in ipairs(list) do
    names[i] = entry.name
  end
  return names
end

local function category_table(category)
  local kinds = names_of(category.kinds)
  local constructors = {}
  for _, kind in ipairs(kinds) do
    local tag = category.name .. "." .. kind
    constructors[kind] = function(t)
      return construct(tag, t)
    end
  end
  local alone = #kinds == 1 and kinds[1] == category.name
  return setmetatable(constructors, {
    __index = function(_, kind)
      fault.script("there is no %s.%s%s; kinds: %s", category.name, tostring(kind), fault.meant(kind, kinds),
        table.concat(kinds, ", "))
    end,
    __call = function(_, t)
      if alone then
        return construct(category.name .. "." .. category.name, t)
      end
      fault.script("%s needs a kind, e.g. %s.%s{ ... }; kinds: %s", category.name, category.name, tostring(kinds[1]),
        table.concat(kinds, ", "))
    end,
    __metatable = "category",
  })
end

local parts = {}
for _, category in ipairs(engine.catalog()) do
  parts[category.name] = category_table(category)
end

return parts
