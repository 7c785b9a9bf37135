-- stiction clean: what no case of the study refers to leaves its output folder.
local campaign = require "stiction.campaign"
local claims = require "stiction.claims"
local engine = require "stiction.engine"
local fault = require "stiction.fault"
local hold = require "stiction.hold"
local output = require "stiction.output"
local provenance = require "stiction.provenance"
local report = require "stiction.report"
local study_module = require "stiction.study"
local summary = require "stiction.summary"
local sweep = require "stiction.sweep"

local function name_of(path)
  return path:match("[^/]+$")
end

--- Names of the folders that some run of the study refers to: those of its cases, and those that --set or --quick would
--- reuse.
local function referred(plan)
  local names, rows = {}, campaign.survey(plan)
  for _, row in ipairs(rows) do
    names[row.case.id], names[output.case_name(plan.folder, row.case)] = true, true
    names[row.adopted or row.case.id] = true
  end
  for _, row in ipairs(summary.others(plan, rows)) do
    names[row.name] = true
  end
  return names
end

--- Adds the files that a case in this folder was made of, by hash.
local function add_sources(path, hashes)
  local manifest = output.read_file(path .. "/manifest.json") or {}
  for _, files in ipairs { manifest.files or {}, type(manifest.result) == "table" and manifest.result.files or {} } do
    for _, file in ipairs(type(files) == "table" and files or {}) do
      hashes[tostring(type(file) == "table" and file.hash)] = true
    end
  end
end

local function is_case(path)
  return engine.kind_of_path(path .. "/outcome.json") == nil
    and engine.kind_of_path(path .. "/manifest.json") ~= nil
end

--- Adds the drafts that killed writers left among the files of a folder.
local function add_drafts(path, list)
  for _, file in ipairs(engine.list(path, false)) do
    local name = name_of(file)
    if name:find("%.%d+%.part$") or name:find("^%.trial%.%d+$") then
      list[#list + 1] = { path = file, reason = "a draft of a run that was killed" }
    end
  end
end

--- What nothing refers to: list of {path =, reason =}.
local function find(plan)
  local list, names, hashes = {}, referred(plan), {}
  add_drafts(plan.folder, list)
  for _, path in ipairs(engine.list(plan.folder, false)) do
    if is_case(path) and not names[name_of(path)] then
      list[#list + 1] = { path = path, reason = "a case that the study no longer has" }
    elseif engine.kind_of_path(path) == "folder" then
      add_sources(path, hashes)
      add_drafts(path, list)
    end
  end
  for _, path in ipairs(engine.list(plan.folder .. "/" .. provenance.folder, false)) do
    if not hashes[name_of(path)] then
      list[#list + 1] = { path = path, reason = "source of no case that is left" }
    end
  end
  for _, path in ipairs(engine.list(plan.folder .. "/.claims", false)) do
    if not claims.of(plan.folder):owns(name_of(path)) then
      list[#list + 1] = { path = path, reason = "a claim of a run that was killed" }
    end
  end
  return list
end

local function size_of(path)
  local size = engine.file_size(path) or 0
  for _, file in ipairs(engine.kind_of_path(path) == "folder" and engine.list(path, true) or {}) do
    size = size + (engine.file_size(file) or 0)
  end
  return size
end

local function clean(plan)
  local list, size = find(plan), 0
  for _, entry in ipairs(list) do
    report.line("%s: %s", entry.path, entry.reason)
    size = size + size_of(entry.path)
    if not plan.options.list then
      engine.remove(entry.path)
    end
  end
  report.line("%s: %d %s, %.3g MB", plan.folder, #list, plan.options.list and "to remove" or "removed", size / 1e6)
  return 0
end

return function(options)
  local study = study_module.load(options.study, options.trust)
  local folder = output.folder(study, options)
  if engine.kind_of_path(folder) ~= "folder" then
    fault.input("there is no output folder %s", folder)
  end
  local cases, names = sweep.cases(study, {})
  local plan = { study = study, cases = cases, names = names, folder = folder, options = options }
  return hold.folder(folder, study, "clean", clean, plan)
end
