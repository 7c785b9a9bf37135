-- A folder of studies: each run in turn, what they prove gathered in one report.
local engine = require "stiction.engine"
local fault = require "stiction.fault"
local loader = require "stiction.loader"
local ordered = require "stiction.ordered"
local proof_report = require "stiction.proof_report"
local report = require "stiction.report"
local run_study = require "stiction.run"

local collection = {}

local function is_study(folder)
  return engine.kind_of_path(folder .. "/study.lua") == "file"
end

--- The folders that path/collection.lua lists, relative to `path`.
local function listed(path)
  local list = loader.load(path .. "/collection.lua")
  local folders = {}
  for i, name in ipairs(type(list) == "table" and list or {}) do
    folders[i] = tostring(path .. "/" .. name):gsub("/[^/]+/%.%./", "/")
    if not is_study(folders[i]) then
      fault.input("%s/collection.lua: there is no study in %s", path, folders[i])
    end
  end
  return folders
end

--- The studies of a folder: those its collection.lua lists, else all directly below it, sorted; nil if `path` is a
--- study itself or holds none.
function collection.find(path)
  if engine.kind_of_path(path) ~= "folder" or is_study(path) then
    return nil
  end
  path = engine.absolute(path)
  if engine.kind_of_path(path .. "/collection.lua") == "file" then
    return listed(path)
  end
  local folders = {}
  for _, below in ipairs(engine.list(path, false)) do
    if is_study(below) then
      folders[#folders + 1] = below
    end
  end
  table.sort(folders)
  return #folders > 0 and folders or nil
end

local function refuse_single(options)
  for _, name in ipairs { "accuracy", "check-accuracy", "of", "case", "where", "set", "worker", "on" } do
    if options[name] then
      fault.input("--%s is for one study; %s holds several", name, options.study)
    end
  end
end

local function options_for(folder, options)
  local own = {}
  for _, key in ipairs(ordered.keys(options)) do
    own[key] = options[key]
  end
  own.study = folder
  own.out = options.out and options.out .. "/" .. folder:match("[^/]+$")
  return own
end

--- Where the report goes.
local function report_folder(options)
  local path = engine.absolute(options.study)
  return options.out or "out/" .. (path:match(".*/studies/(.+)$") or path:match("[^/]+$") or "studies")
end

local function run_one(folder, options, parts)
  report.line("\n== %s", folder)
  local before = engine.clock()
  local code, out, study = run_study(options_for(folder, options))
  local checks = out and engine.read_file(out .. "/checks.json")
  parts[#parts + 1] = {
    study = study, out = out, code = code, seconds = engine.clock() - before,
    checks = checks and engine.decode_json(checks) or {},
  }
  return code
end

--- Runs the studies and writes report.md beside their outputs; the worst exit code of all.
function collection.run(studies, options)
  refuse_single(options)
  local parts, worst = {}, 0
  for _, folder in ipairs(studies) do
    worst = math.max(worst, run_one(folder, options, parts))
    if engine.stopped() then
      return worst
    end
  end
  if not options.list then
    local folder = report_folder(options)
    proof_report.write(folder, parts, options.quick)
    report.line("\nreport: %s/report.md", folder)
  end
  return worst
end

return collection
