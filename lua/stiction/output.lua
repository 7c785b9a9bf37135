-- A study's output folder: case folders with their finished mark, the summary, the checks.
local csv = require "stiction.csv"
local engine = require "stiction.engine"
local fault = require "stiction.fault"
local loader = require "stiction.loader"
local ordered = require "stiction.ordered"
local parts = require "stiction.parts"
local problem = require "stiction.problem"
local units = require "stiction.units"

local output = {}

--- Default folder, or the one asked for.
function output.folder(study, options)
  return options.out or "out/" .. study.name
end

--- Makes the folder; bad input if that fails or nothing can be written there.
function output.prepare(folder)
  local made, reason = engine.make_folder(folder)
  if not made then
    fault.input("%s; choose another folder with --out", reason)
  end
end

--- Parameters as plain values for JSON: SI numbers with their dimension.
function output.plain(parameters)
  local plain = setmetatable({}, { json = "object" })
  for _, name in ipairs(ordered.keys(parameters)) do
    local value = parameters[name]
    if units.is_quantity(value) then
      plain[name] = { value = value.si, unit = engine.dimension_text(value.metre, value.kilogram, value.second) }
    else
      plain[name] = value
    end
  end
  return plain
end

--- Text that tells the parameters of a case apart from those of all others.
local function key_of(parameters)
  return engine.hash(engine.encode_json(parameters))
end

--- That of a case: as its parameters read back from a file.
local function key(case)
  return key_of(engine.decode_json(engine.encode_json(output.plain(case.p))))
end

--- That of the parameters which a case's folder holds the data of; nil if it does not say.
local function key_in(folder)
  for _, name in ipairs { "/case.json", "/result.json", "/outcome.json" } do
    local kept = engine.decode_json(engine.read_file(folder .. name) or "")
    if type(kept) == "table" and type(kept.parameters) == "table" then
      return key_of(kept.parameters)
    end
  end
end

--- Name of a case's folder: its id; while that holds other parameters (of --set, --quick, or without them), what was
--- kept of its own stands beside, its id followed by "@" and their key.
function output.case_name(folder, case)
  local own, there = key(case), key_in(folder .. "/" .. case.id)
  local aside = case.id .. "@" .. own
  return there and there ~= own and engine.kind_of_path(folder .. "/" .. aside) and aside or case.id
end

function output.case_folder(folder, case)
  return folder .. "/" .. output.case_name(folder, case)
end

--- Gives each of the cases, about to run or to be shown, the folder of its id: what it holds of other parameters is put
--- aside, what was put aside of its own comes back.
function output.settle(folder, cases)
  for _, case in ipairs(cases) do
    local own_folder, own = folder .. "/" .. case.id, key(case)
    local there = key_in(own_folder)
    if there and there ~= own then
      local aside = own_folder .. "@" .. there
      engine.remove(aside)
      engine.rename(own_folder, aside)
    end
    if (not there or there ~= own) and engine.kind_of_path(own_folder .. "@" .. own) then
      engine.remove(own_folder)
      engine.rename(own_folder .. "@" .. own, own_folder)
    end
  end
end

--- A case begins anew in its folder: its parameters are noted, its mark of having finished is gone.
function output.begin(folder, case)
  local own_folder = folder .. "/" .. case.id
  output.settle(folder, { case })
  output.prepare(own_folder)
  engine.remove(own_folder .. "/result.json")
  engine.write_file(own_folder .. "/case.json",
    engine.encode_json({ case = case.id, parameters = output.plain(case.p) }, 2) .. "\n")
end

--- The files that the scene or the saved problem of a case consists of.
local function data_files(study, case)
  if study.problem then
    return { problem.read(study, case.p).file }
  end
  local made, scene = engine.call(study.scene_of, study, case)
  if not made and scene.kind == "stopped" then
    error(scene, 0)
  end
  return made and parts.files(scene) or {} -- a scene that cannot be made is told before it runs
end

--- Text that changes when one of them does; "" if there are none.
function output.data_identity(study, case)
  if study.problem then
    return problem.identity(study, case.p)
  end
  local files = data_files(study, case)
  return #files > 0 and loader.hash(files) or ""
end

--- What the study has read so far, and what the case's scene or problem consists of: list of {path =, hash =}, the paths
--- as they stand from the study's folder on.
function output.files_read(study, case)
  local list, seen = {}, {}
  local function add(file, hash)
    if not seen[file] then
      list[#list + 1], seen[file] = { path = engine.relative(file, study.source.folder), hash = hash }, true
    end
  end
  for _, file in ipairs(study.source.files) do
    add(file, study.source.hashes[file])
  end
  for _, file in ipairs(data_files(study, case)) do
    local path = engine.absolute(file)
    add(path, loader.file_hash(file))
  end
  return list
end

--- The first of such files that has another content now, nil if none has.
local function changed_file(study, files)
  for _, file in ipairs(files) do
    local path = engine.absolute(file.path:sub(1, 1) == "/" and file.path or study.source.folder .. "/" .. file.path)
    if (study.source.hashes[path] or loader.file_hash(path)) ~= file.hash then
      return path
    end
  end
end

local function identity_of_program()
  local files = {}
  for _, file in ipairs(engine.list(engine.library_root() .. "/stiction", true)) do
    files[#files + 1] = file:find("%.lua$") and file or nil
  end
  return loader.hash(files) .. (engine.build_id() or loader.hash { "/proc/self/exe" })
end

local own_identity -- as this process found it: what is installed meanwhile did not make its results

--- Fingerprint of a case: of the study's files as they were loaded, the library, the program, the parameters, and the
--- files of its scene or saved problem.
function output.fingerprint(study, case)
  own_identity = own_identity or identity_of_program()
  return engine.hash(study.identity .. own_identity .. case.id .. engine.encode_json(output.plain(case.p)) .. (case.problems or "")
    .. output.data_identity(study, case))
end

function output.result_file(folder, case)
  return output.case_folder(folder, case) .. "/result.json"
end

--- True if x is nil or a list of tables, each with a text under every name.
local function may_be_list(x, ...)
  for i = 1, type(x) == "table" and #x or 0 do
    for _, name in ipairs { ... } do
      if type(x[i]) ~= "table" or type(x[i][name]) ~= "string" then
        return false
      end
    end
  end
  return x == nil or type(x) == "table"
end

local function is_result(value)
  local function may_be(kind, name)
    return value[name] == nil or type(value[name]) == kind
  end
  return type(value) == "table" and type(value.verdict) == "string" and may_be("string", "reason")
    and may_be("table", "results") and may_be_list(value.files, "path", "hash")
    and may_be_list(value.warnings, "text", "change")
end

--- What a case left behind, nil if it never ended or its file is damaged.
function output.read_result(folder, case)
  local text = engine.read_file(output.result_file(folder, case))
  local result = text and engine.decode_json(text)
  return is_result(result) and result or nil
end

function output.write_result(folder, case, result)
  engine.write_file(output.result_file(folder, case), engine.encode_json(result, 2) .. "\n")
end

--- True if the case ended well with this fingerprint and, if its study is given, what it read then is still the same.
function output.is_done(result, fingerprint, study)
  return result ~= nil and result.verdict == "finished" and result.fingerprint == fingerprint
    and not (study and changed_file(study, result.files or {}))
end

--- True if what an extreme ended with still is of these files.
function output.is_current(study, kept, fingerprint)
  return kept.fingerprint == fingerprint and may_be_list(kept.files, "path", "hash")
    and not changed_file(study, kept.files or {})
end

--- "cells=8; steps=5": the parameters, apart from swept ones, that are not the study's own.
local function words_set(study, case)
  local words = {}
  for _, section in ipairs { study.given, study.chosen } do
    for _, name in ipairs(ordered.keys(section)) do
      local own, value = section[name].value, rawget(case.p, name)
      if value ~= nil and value ~= own then
        words[#words + 1] = ("%s=%s"):format(name, tostring(value))
      end
    end
  end
  table.sort(words)
  return table.concat(words, "; ")
end

local function words_warned(result)
  local words = {}
  for i, warning in ipairs(result.warnings or {}) do
    words[i] = tostring(warning.text)
  end
  return table.concat(words, " | ")
end

local measures = { "verdict", "steps", "iterations", "contact", "seconds" }

local function summary_head(study, names, claimed)
  local head = { "case" }
  table.move(names, 1, #names, 2, head)
  for _, entry in ipairs(study.results) do
    head[#head + 1] = entry.name
  end
  table.move(measures, 1, #measures, #head + 1, head)
  for _, name in ipairs(claimed) do
    head[#head + 1] = name .. "_error"
  end
  return table.move({ "set", "warnings" }, 1, 2, #head + 1, head)
end

--- summary.csv: one row per case with a result; SI. `claims` (or nil): {names =, of = {by case, by name}}, what results may
--- be off by; empty where that is not known. Last: which parameters are not the study's own, and what was known against the
--- case before it ran.
function output.write_summary(folder, study, names, rows, claims)
  local claimed = claims and claims.names or {}
  local lines = { table.concat(summary_head(study, names, claimed), ",") }
  for _, row in ipairs(rows) do
    local words = { row.case.id }
    local function add(value)
      words[#words + 1] = csv.word(value)
    end
    for _, name in ipairs(names) do
      add(row.case.p[name])
    end
    for _, entry in ipairs(study.results) do
      add((row.result.results or {})[entry.name])
    end
    for _, field in ipairs(measures) do
      add(row.result[field])
    end
    for _, name in ipairs(claimed) do
      add((claims.of[row.case.id] or {})[name])
    end
    add(words_set(study, row.case))
    add(words_warned(row.result))
    lines[#lines + 1] = table.concat(words, ",")
  end
  engine.write_file(folder .. "/summary.csv", table.concat(lines, "\n") .. "\n")
end

function output.write_checks(folder, checks)
  engine.write_file(folder .. "/checks.json", engine.encode_json(checks, 2) .. "\n")
end

return output
