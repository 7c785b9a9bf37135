-- The constructors of everything a scene holds, made from the engine's catalog.
local copy = require "stiction.copy"
local engine = require "stiction.engine"
local fault = require "stiction.fault"
local half_space = require "stiction.half_space"
local ordered = require "stiction.ordered"

local files_of = setmetatable({}, { __mode = "k" }) -- the files that a part names, by the part

--- Lets file names stand from `folder` on, and remembers them.
local function place_files(part, names, folder)
  for _, name in ipairs(names) do
    local path = part[name]
    if type(path) == "string" then
      part[name] = path:sub(1, 1) == "/" and path or folder .. "/" .. path
      files_of[part] = files_of[part] or {}
      table.insert(files_of[part], part[name])
    end
  end
end

local meta_of = setmetatable({}, { __mode = "k" }) -- the metatable of each part

local function is(part, tag)
  return meta_of[part] and meta_of[part].tag == tag
end

--- The part with another value for `key`; the other stays as it is, as other scenes may hold it.
local function with(part, key, value)
  local meta = meta_of[part]
  local changed = copy(part)
  changed[key] = value
  meta_of[changed] = meta
  return setmetatable(changed, meta)
end

local function is_function(surface)
  return is(surface, "surface.map") and type(surface.heights) == "function"
end

--- Heights that are functions of x and y as numbers at the points of a rigid height map or a relief.
local function sample_map(map)
  if is_function(map.surface) then
    map.surface = with(map.surface, "heights", half_space.sample(map.surface.heights, map))
  end
end

--- The same at the points of the scene's half space.
local function sample_heights(scene)
  for _, body in pairs(type(scene.bodies) == "table" and scene.bodies or {}) do
    if is(body, "body.half_space") then
      for name, map in pairs(type(scene.obstacles) == "table" and scene.obstacles or {}) do
        if is(map, "obstacle.height_map") and is_function(map.surface) then
          local surface = with(map.surface, "heights", half_space.sample(map.surface.heights, body))
          scene.obstacles = copy(scene.obstacles)
          scene.obstacles[name] = with(map, "surface", surface)
        end
      end
    end
  end
end

--- kind: {tag =, files = names of the parameters that name files}
local function construct(kind, t, folder)
  if type(t) ~= "table" or getmetatable(t) ~= nil then
    fault.script("%s takes one table: %s{ ... }", kind.tag, kind.tag)
  end
  local part = copy(t) -- a copy: one table of the script may serve several parts
  if folder then
    place_files(part, kind.files, folder)
  end
  if kind.tag == "scene.scene" then
    sample_heights(part)
  elseif kind.tag == "rigid.height_map" or kind.tag == "relief.relief" then
    sample_map(part)
  end
  meta_of[part] = { tag = kind.tag, place = engine.where(), __metatable = "part" }
  return setmetatable(part, meta_of[part])
end

local function names_of(list)
  local names = {}
  for i, entry in ipairs(list) do
    names[i] = entry.name
  end
  return names
end

local function file_parameters(kind)
  local names = {}
  for _, parameter in ipairs(kind.parameters) do
    names[#names + 1] = parameter.kind == "file" and parameter.name or nil
  end
  return names
end

local function category_table(category, folder)
  local kinds = names_of(category.kinds)
  local constructors = {}
  for _, kind in ipairs(category.kinds) do
    local made = { tag = category.name .. "." .. kind.name, files = file_parameters(kind) }
    constructors[kind.name] = function(t)
      return construct(made, t, folder)
    end
  end
  local own = constructors[category.name] -- what stiction.body{ ... } makes, of several kinds
  return setmetatable(constructors, {
    __index = function(_, kind)
      fault.script("there is no %s.%s%s; kinds: %s", category.name, tostring(kind), fault.meant(kind, kinds),
        table.concat(kinds, ", "))
    end,
    __call = function(_, t)
      if own then
        return own(t)
      end
      fault.script("%s needs a kind, e.g. %s.%s{ ... }; kinds: %s", category.name, category.name, tostring(kinds[1]),
        table.concat(kinds, ", "))
    end,
    __metatable = "category",
  })
end

local parts = {}
local catalog = engine.catalog()

--- The constructors by category; file names stand from `folder` on (nil: from the current one).
function parts.constructors(folder)
  local made = {}
  for _, category in ipairs(catalog) do
    made[category.name] = category_table(category, folder)
  end
  return made
end

--- The files that the parts of a scene name, in the order of the scene's keys.
function parts.files(scene)
  local files, seen = {}, {}
  local function visit(x)
    if type(x) ~= "table" or seen[x] then
      return
    end
    seen[x] = true
    table.move(files_of[x] or {}, 1, #(files_of[x] or {}), #files + 1, files)
    for _, key in ipairs(ordered.keys(x)) do
      visit(x[key])
    end
  end
  visit(scene)
  return files
end

return parts
