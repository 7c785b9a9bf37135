-- stiction new: a runnable study in a folder of the user's own, from one of the examples that come with the program.
local engine = require "stiction.engine"
local fault = require "stiction.fault"
local loader = require "stiction.loader"
local numeric = require "stiction.numeric"
local report = require "stiction.report"

local default = "sticky_block"
local longest = 255 -- bytes of a name, on all file systems in use

--- Names of the examples, in their order.
local function examples()
  local names = {}
  for _, path in ipairs(engine.list(loader.own_study "examples", false)) do
    if engine.kind_of_path(path .. "/study.lua") == "file" then
      names[#names + 1] = path:match("[^/]+$")
    end
  end
  return #names > 0 and names or fault.input("new: the examples are missing at %s; install the program anew",
    loader.own_study "examples")
end

--- {path = as it stands in the example's folder, text =} of every file that a study consists of.
local function files_of(example)
  local folder, files = loader.own_study("examples/" .. example), {}
  for _, path in ipairs(engine.list(folder, true)) do
    local own = engine.relative(path, folder)
    if own:find("%.lua$") or own:find("%.msh$") then
      files[#files + 1] = { path = own, text = engine.read_file(path) or fault.input("new: cannot read %s", path) }
    end
  end
  return files
end

local function title(example)
  local text = engine.read_file(loader.own_study("examples/" .. example) .. "/study.lua") or ""
  return text:match('title = "([^"]*)"') or ""
end

local function show_list()
  local rows = {}
  for i, name in ipairs(examples()) do
    rows[i] = { name, title(name) .. (name == default and " (what 'stiction new NAME' writes)" or "") }
  end
  report.table(rows)
  return 0
end

--- The path without what is at its end for nothing; refuses one whose last name no folder should have.
local function checked_path(path)
  local plain = path:match("^(.-)/*$")
  local name = plain:match("[^/]*$")
  local function refuse(reason)
    fault.input("new: '%s' is no name for a study's folder: %s", path:gsub("%c", "?"), reason)
  end
  if name == "" or name:find("^%.+$") then
    refuse "a name is wanted, as in 'stiction new tape'"
  elseif not utf8.len(path) or path:find("%c") then
    refuse "it holds characters that cannot be printed"
  elseif name:find("^[%s-]") or name:find("%s$") or name:find("[\\:*?\"<>|]") then
    refuse "it begins with a dash or a blank, ends with a blank, or has one of \\ : * ? \" < > |"
  elseif #name > longest then
    refuse(("it has %d bytes; %d at most"):format(#name, longest))
  end
  return plain
end

local function prepare(path)
  local kind = engine.kind_of_path(path)
  if kind == "file" then
    fault.input("new: there is a file at '%s'; choose another name", path)
  elseif kind == "folder" and #engine.list(path, false) > 0 then
    fault.input("new: the folder '%s' is not empty; choose another name, nothing there was touched", path)
  end
  local made, reason = engine.make_folder(path)
  if not made then
    fault.input("new: %s; choose another place", reason)
  end
end

local function write(path, files)
  for _, file in ipairs(files) do
    local target = path .. "/" .. file.path
    local held, value = engine.call(function()
      engine.make_folder(target:match("^(.*)/"))
      engine.write_file(target, file.text)
    end)
    if not held then
      fault.input("new: %s", (tostring(value):gsub(" with %-%-out", "")))
    end
    report.line("wrote %s", target)
  end
end

--- As a shell takes it for one word.
local function quoted(path)
  return path:find("[^%w_./-]") and "'" .. path:gsub("'", "'\\''") .. "'" or path
end

local function make(path, example)
  local names = examples()
  if not numeric.first_where(names, function(name) return name == example end) then
    fault.input("new: there is no example '%s'%s; there are %s", example, fault.meant(example, names),
      table.concat(names, ", "))
  end
  path = checked_path(path)
  prepare(path)
  write(path, files_of(example))
  report.line("%s. Next:", title(example))
  report.line("  stiction run %s --quick    # seconds; then without --quick", quoted(path))
  report.line("  stiction explain %s        # what it models and costs", quoted(path))
  return 0
end

--- options: {name =, from =, list =}
return function(options)
  if options.list then
    return show_list()
  elseif not options.name then
    fault.input("new: NAME is required: stiction new NAME [--from EXAMPLE], or --list")
  end
  return make(options.name, options.from or default)
end
