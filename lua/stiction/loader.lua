-- Finds a study's file and runs it in its own sandbox.
local copy = require "stiction.copy"
local engine = require "stiction.engine"
local fault = require "stiction.fault"
local ordered = require "stiction.ordered"

local loader = {}

local plain = { "assert", "error", "getmetatable", "ipairs", "next", "pcall", "rawequal", "rawget", "rawlen", "rawset",
  "select", "setmetatable", "tonumber", "tostring", "type", "xpcall", "_VERSION" }
local libraries = { "coroutine", "math", "string", "table", "utf8" }

local function print_to_output(...)
  local words = {}
  for i = 1, select("#", ...) do
    words[i] = tostring((select(i, ...)))
  end
  engine.write(table.concat(words, "\t") .. "\n")
end

--- The globals of a script: copies, so that no script can reach into the library. `trust` adds io and os.
function loader.environment(trust)
  local names = {}
  for _, name in ipairs(plain) do
    names[name] = _G[name]
  end
  for _, name in ipairs(libraries) do
    names[name] = copy(_G[name])
  end
  if trust then
    names.io, names.os = io, os -- luacheck: ignore
  end
  names.pairs, names.print, names._G = ordered.pairs, print_to_output, names
  return names
end

local function run_file(source, path, name)
  local text, reason = engine.read_file(path)
  if not text then
    fault.input("%s", reason)
  end
  source.files[#source.files + 1] = path
  local script, complaint = engine.load_script(text, name, source.environment)
  if not script then
    fault.input("%s", complaint)
  end
  local value = script()
  return value
end

--- Another study named by its path from this one, in a sandbox of its own; its files count as this study's.
local function load_other(source, path)
  local value, other = loader.load(source.folder .. "/" .. path, source.trust)
  for _, file in ipairs(loader.contents(other)) do
    source.files[#source.files + 1] = file
  end
  return value
end

--- `require` as scripts see it: "stiction", modules beside the study, and other studies by their path ("../other").
local function make_require(source)
  local loaded = {}
  return function(name)
    if name == "stiction" then
      source.stiction = source.stiction or require "stiction.api"(source.folder)
      return source.stiction
    elseif name:find("/", 1, true) then
      return load_other(source, name)
    elseif name:find("^stiction%.") then
      fault.script("'%s' is internal; scripts use require 'stiction'", name)
    elseif loaded[name] == nil then
      local relative = name:gsub("%.", "/")
      for _, file in ipairs { relative .. ".lua", relative .. "/init.lua" } do
        if engine.kind_of_path(source.folder .. "/" .. file) == "file" then
          local value = run_file(source, source.folder .. "/" .. file, file)
          loaded[name] = value == nil and true or value
          return loaded[name]
        end
      end
      fault.script("there is no module '%s' beside the study (%s.lua)", name, relative)
    end
    return loaded[name]
  end
end

local function not_found(path)
  local parent, name = path:match("^(.*)/([^/]+)/*$")
  local siblings = {}
  for i, sibling in ipairs(engine.list(parent or ".", false)) do
    siblings[i] = sibling:match("[^/]+$")
  end
  fault.input("there is no study at '%s': neither a .lua file nor a folder with study.lua%s", path,
    fault.meant(name or path, siblings))
end

--- Where the study stands: {file =, folder =, name = of the file, whole = whether the folder is the study's own}.
function loader.find(path)
  local kind = engine.kind_of_path(path)
  if kind == "folder" and engine.kind_of_path(path .. "/study.lua") == "file" then
    local folder = engine.absolute(path)
    return { file = folder .. "/study.lua", folder = folder, name = "study.lua", whole = true }
  elseif kind ~= "file" or not path:find("%.lua$") then
    not_found(path)
  end
  local file = engine.absolute(path)
  local folder, name = file:match("^(.*)/([^/]+)$")
  return { file = file, folder = folder, name = name, whole = name == "study.lua" }
end

--- Runs the script; its value, and the source with the files read so far.
function loader.load(path, trust)
  local source = loader.find(path)
  source.files, source.trust = {}, trust
  source.environment = loader.environment(trust)
  source.environment.require = make_require(source)
  return run_file(source, source.file, source.name), source
end

--- Files whose content decides a study's results: all in its own folder but prose and its trade, else those it has
--- read; and those of other studies that it has read.
function loader.contents(source)
  local files, known = {}, {}
  local function add(file)
    if not known[file] then
      files[#files + 1], known[file] = file, true
    end
  end
  for _, file in ipairs(source.whole and engine.list(source.folder, true) or {}) do
    if not file:find("%.md$") and not file:find("%.png$") and not file:find("/trade%.json$") then
      add(file)
    end
  end
  for _, file in ipairs(source.files) do
    add(file)
  end
  return files
end

--- Text that changes when the content of one of the files does.
function loader.hash(files)
  local hashes = {}
  for i, file in ipairs(files) do
    hashes[i] = engine.hash(engine.read_file(file) or "")
  end
  return engine.hash(table.concat(hashes, " "))
end

return loader
