-- Finds a study's file and runs it in its own sandbox.
local copy = require "stiction.copy"
local engine = require "stiction.engine"
local fault = require "stiction.fault"
local ordered = require "stiction.ordered"

local loader = {}

local plain = { "assert", "error", "getmetatable", "ipairs", "next", "pcall", "rawequal", "rawget", "rawlen", "rawset",
  "select", "setmetatable", "tonumber", "tostring", "type", "xpcall", "_VERSION" }
local libraries = { "coroutine", "math", "string", "table", "utf8" }

local silent = false

--- f(...) with nothing of what scripts print.
function loader.silently(f, ...)
  silent = true
  local answers = table.pack(engine.call(f, ...))
  silent = false
  if not answers[1] then
    error(answers[2], 0)
  end
  return table.unpack(answers, 2, answers.n)
end

local function print_to_output(...)
  if silent then
    return
  end
  local words = {}
  for i = 1, select("#", ...) do
    words[i] = tostring((select(i, ...)))
  end
  engine.write(table.concat(words, "\t") .. "\n")
end

--- Notes that the source has read this text from the file.
local function note_read(source, path, text)
  if not source.hashes[path] then
    source.files[#source.files + 1], source.hashes[path] = path, engine.hash(text)
  end
end

--- io whose files count as read by the study; those that it writes do not.
local function watched_io(source)
  local watched, written = copy(io), {} -- luacheck: ignore
  local function note(name, mode)
    local path = type(name) == "string" and engine.absolute(name)
    if path and (mode or "r"):find("[wa+]") then
      written[path] = true
    elseif path and not written[path] then
      note_read(source, path, engine.read_file(path) or "")
    end
  end
  function watched.open(name, mode)
    note(name, mode)
    return io.open(name, mode) -- luacheck: ignore
  end
  function watched.lines(name, ...)
    note(name)
    return io.lines(name, ...) -- luacheck: ignore
  end
  return watched
end

local trust_words = "a study is kept from running programs, from files of its own and from the clock, so that it can be "
  .. "shared and repeats; 'stiction run STUDY --trust' gives it io and os"
local closed_words = {
  load = "text cannot be run as Lua in a study", loadstring = "text cannot be run as Lua in a study",
  dofile = "a study reads its own modules with require 'NAME' (NAME.lua beside it)",
  loadfile = "a study reads its own modules with require 'NAME' (NAME.lua beside it)",
  collectgarbage = "memory looks after itself", debug = "a study cannot look into the library",
  package = "a study reads its own modules with require 'NAME' (NAME.lua beside it)",
}

--- Stands for a library that scripts do not have, and says why at its first use.
local function closed_library(name, words)
  local function refuse(_, key)
    fault.script("%s.%s is not there: %s", name, tostring(key), words)
  end
  return setmetatable({}, { __index = refuse, __newindex = refuse, __metatable = "closed" })
end

local function close_doors(names, trust)
  for _, name in ipairs { "load", "loadstring", "dofile", "loadfile", "collectgarbage" } do
    names[name] = function()
      fault.script("%s is not there: %s", name, closed_words[name])
    end
  end
  names.math.randomseed = function()
    fault.script("math.randomseed is not there: math.random gives the same numbers in every run, so that runs repeat")
  end
  names.debug, names.package = closed_library("debug", closed_words.debug), closed_library("package", closed_words.package)
  if not trust then
    names.io, names.os = closed_library("io", trust_words), closed_library("os", trust_words)
  end
end

--- The globals of a script: copies, so that no script can reach into the library. `trust` adds io and os.
function loader.environment(trust, source)
  local names = {}
  for _, name in ipairs(plain) do
    names[name] = _G[name]
  end
  for _, name in ipairs(libraries) do
    names[name] = copy(_G[name])
  end
  if trust then
    names.io, names.os = source and watched_io(source) or io, os -- luacheck: ignore
  end
  close_doors(names, trust)
  names.pairs, names.print, names._G = ordered.pairs, print_to_output, names
  return names
end

--- The files that wait for each other, "a.lua -> b.lua -> a.lua".
local function circle(underway, path)
  local names, inside = {}, false
  for _, waiting in ipairs(underway) do
    inside = inside or waiting == path
    names[#names + 1] = inside and waiting:match("[^/]+$") or nil
  end
  names[#names + 1] = path:match("[^/]+$")
  return table.concat(names, " -> ")
end

local function run_file(source, path, name)
  local underway = source.underway
  for _, waiting in ipairs(underway) do
    if waiting == path then
      fault.script("%s is required while it is being read itself (%s): move what both need into a module of its own", name,
        circle(underway, path))
    end
  end
  local text, reason = engine.read_file(path)
  if not text then
    fault.input("%s", reason)
  end
  note_read(source, path, text)
  local script, complaint = engine.load_script(text, name, source.environment)
  if not script then
    fault.input("%s", complaint)
  end
  underway[#underway + 1] = path
  local _ <close> = setmetatable({}, { __close = function() underway[#underway] = nil end }) -- by an error, too
  local value = script()
  return value
end

--- Another study named by its path from this one, in a sandbox of its own; the files that it reads, then or later,
--- count as this study's.
local function load_other(source, path)
  local file = source.folder .. "/" .. path
  if not engine.kind_of_path(file) and engine.kind_of_path(file .. ".lua") == "file" then
    fault.script("require '%s': a name with / is another study's, of its folder or of its file, '%s.lua'; a module beside this one "
      .. "has dots: require '%s'", path, path, (path:gsub("^%./", ""):gsub("/", ".")))
  end
  return (loader.load(file, source.trust, source))
end

--- `require` as scripts see it: "stiction", modules beside the study, and other studies by their path ("../other").
local function make_require(source)
  local loaded = {}
  return function(name)
    if name == "stiction" then
      source.stiction = source.stiction or require "stiction.api"(source.folder, function(...) note_read(source, ...) end)
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
  if engine.kind_of_path(path) == "file" then
    fault.input("%s is no study: a .lua file or a folder with study.lua is", path)
  end
  if engine.kind_of_path(path) == "folder" then
    fault.input("'%s' is a folder %s: a study is a .lua file or a folder with study.lua", path,
      engine.kind_of_path(path .. "/summary.csv") == "file" and "of results, not the study they are of" or "without study.lua")
  end
  local parent, name = path:match("^(.*)/([^/]+)/*$")
  local siblings = {}
  for i, sibling in ipairs(engine.list(parent or ".", false)) do
    siblings[i] = sibling:match("[^/]+$")
  end
  fault.input("there is no study at '%s': neither a .lua file nor a folder with study.lua%s", path,
    fault.meant(name or path, siblings))
end

--- The folder of a study that comes with the program, wherever that is started or installed.
function loader.own_study(name)
  return engine.absolute(engine.library_root() .. "/../studies/" .. name)
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

--- Runs the script; its value, and the source with the files read so far: `files` in their order, `hashes` by their
--- paths. `reader`: the source of the study that this one is part of.
function loader.load(path, trust, reader)
  local source = loader.find(path)
  source.files, source.hashes, source.trust = reader and reader.files or {}, reader and reader.hashes or {}, trust
  source.underway = reader and reader.underway or {} -- files that are being read, the outermost first
  source.environment = loader.environment(trust, source)
  source.environment.require = make_require(source)
  return run_file(source, source.file, source.name), source
end

--- Text that changes when one of the files that the source has read so far had another content: its own, then the
--- others in the order of their paths.
function loader.identity(source)
  local others, hashes = table.move(source.files, 2, #source.files, 1, {}), { source.hashes[source.file] }
  table.sort(others)
  for i, file in ipairs(others) do
    hashes[i + 1] = source.hashes[file]
  end
  return engine.hash(table.concat(hashes, " "))
end

local hash_of = {} -- by path: a file counts as this process found it first

--- Hash of a file's content; of a missing one that of an empty one.
function loader.file_hash(path)
  hash_of[path] = hash_of[path] or engine.hash(engine.read_file(path) or "")
  return hash_of[path]
end

--- Text that changes when the content of one of the files does.
function loader.hash(files)
  local hashes = {}
  for i, file in ipairs(files) do
    hashes[i] = loader.file_hash(file)
  end
  return engine.hash(table.concat(hashes, " "))
end

return loader
