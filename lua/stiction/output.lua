-- A study's output folder: case folders with their finished mark, the summary, the checks.
local csv = require "stiction.csv"
local engine = require "stiction.engine"
local fault = require "stiction.fault"
local identity = require "stiction.identity"
local ordered = require "stiction.ordered"

local output = {}

--- The file of an output folder that tells whose it is.
function output.study_file(folder)
  return folder .. "/study.json"
end

--- True if the owner that a folder tells is another study which still is there; file: of the study that asks.
function output.is_another(owner, file)
  return type(owner) == "string" and owner ~= file and engine.kind_of_path(owner) == "file"
end

--- Where the study of that name in that file has its output unless told otherwise: its name, and what tells it from another
--- study of that name which was there before it.
function output.default_folder(name, file)
  local own = "out/" .. name
  local beside = own .. "-" .. engine.hash(file):sub(1, 8)
  local noted = output.read_file(output.study_file(own)) or {}
  return (engine.kind_of_path(beside) or output.is_another(noted.study, file)) and beside or own
end

--- Default folder, or the one asked for.
function output.folder(study, options)
  return options.out or output.default_folder(study.name, study.source.file)
end

--- Makes the folder; bad input if that fails or nothing can be written there.
function output.prepare(folder)
  local made, reason = engine.make_folder(folder)
  if not made then
    fault.input("%s; choose another folder with --out", reason)
  end
end

output.plain, output.fingerprint, output.files_read = identity.plain, identity.of, identity.files_read

--- A table that a file holds as JSON, nil if it holds none.
function output.read_file(path)
  local value = engine.decode_json(engine.read_file(path) or "")
  return type(value) == "table" and value or nil
end

--- Text that tells parameters apart.
local function key_of(parameters)
  return engine.hash(engine.encode_json(parameters))
end

--- That of a case: as its parameters read back from a file.
function output.key(case)
  local own = rawget(case, "key") or key_of(engine.decode_json(identity.parameters_text(case)))
  rawset(case, "key", own)
  return own
end

--- The manifest of a case is JSON whose first line, once the case has ended, holds its result alone: that of thousands of
--- cases is read without the rest.
local first_line = '^{"result":(.*),$'
local result_line = '^{"result":([^\n]*),\n'

local function manifest_in(case_folder)
  return case_folder .. "/manifest.json"
end

--- The result in the text of a manifest, nil if there is none; whatever it is.
local function result_of(text)
  local line = text:match(result_line)
  local result = line and engine.decode_json(line)
  if result == nil and text:find('"result"', 1, true) then
    local whole = engine.decode_json(text) -- as some other program has written it anew
    result = type(whole) == "table" and whole.result or nil
  end
  return result
end

--- That of the parameters which a case's folder holds the data of; nil if it does not say.
function output.key_in(folder)
  local text = engine.read_file(manifest_in(folder))
  local kept = text and (result_of(text) or (output.read_file(manifest_in(folder)) or {}).made_of)
    or output.read_file(folder .. "/outcome.json")
  return type(kept) == "table" and type(kept.parameters) == "table" and key_of(kept.parameters) or nil
end

--- Name of a case's folder: its id; while that holds other parameters (of --set, --quick, or without them), what was
--- kept of its own stands beside, its id followed by "@" and their key.
function output.case_name(folder, case)
  local own, there = output.key(case), output.key_in(folder .. "/" .. case.id)
  local aside = case.id .. "@" .. own
  return there ~= own and engine.kind_of_path(folder .. "/" .. aside) and aside or case.id
end

function output.case_folder(folder, case)
  return folder .. "/" .. output.case_name(folder, case)
end

--- Gives each of the cases, about to run or to be shown, the folder of its id: what it holds of other parameters is put
--- aside, what was put aside of its own comes back.
function output.settle(folder, cases)
  for _, case in ipairs(cases) do
    local own_folder, own = folder .. "/" .. case.id, output.key(case)
    local there = output.key_in(own_folder)
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

--- What a case is made of, JSON: its parameters, the program, its scene.
function output.made_of(case, study)
  local scene = not study.problem and identity.scene_text(study, case) or "null"
  return (engine.encode_json({ parameters = identity.plain(case.p), program = identity.program(), scene = "@" })
    :gsub('"scene":"@"', function() return '"scene":' .. scene end))
end

local of_older_layouts = { "result.json", "case.json" } -- files of a case, of what the manifest holds now

--- A case begins anew in its folder: its manifest, this text, has no mark of having finished.
function output.begin(folder, case, manifest)
  local own_folder = folder .. "/" .. case.id
  output.settle(folder, { case })
  output.prepare(own_folder)
  engine.write_file(manifest_in(own_folder), manifest .. "\n")
  for _, name in ipairs(of_older_layouts) do
    engine.remove(own_folder .. "/" .. name)
  end
end

output.data_identity, output.program = identity.of_data, identity.whole_program

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
    and may_be("table", "results") and may_be("table", "counters") and may_be("table", "run") and may_be("string", "sources")
    and may_be("table", "remarks") and may_be("table", "errors") and may_be_list(value.files, "path", "hash")
    and may_be_list(value.warnings, "text", "change")
end

--- The result in a case's folder, nil if there is none or its file is damaged; and what tells whether it is still there.
function output.read_result_in(case_folder)
  local line = (engine.first_line(manifest_in(case_folder)) or ""):match(first_line)
  local text = line or engine.read_file(manifest_in(case_folder)) or ""
  local result = line and engine.decode_json(line)
  if result == nil then
    result = result_of(text)
  end
  return is_result(result) and result or nil, engine.hash(text)
end

--- Whether parameters that a file tells are those of the case.
local function are_of(case, parameters)
  return type(parameters) == "table"
    and (engine.encode_json(parameters) == identity.parameters_text(case) or key_of(parameters) == output.key(case))
end

--- What a case left behind, what tells whether that is still there, and the name of the folder that it is in.
function output.read_result(folder, case)
  local result, mark = output.read_result_in(folder .. "/" .. case.id)
  if result and are_of(case, result.parameters) then
    return result, mark, case.id
  end
  local name = output.case_name(folder, case)
  if name ~= case.id then
    result, mark = output.read_result_in(folder .. "/" .. name)
  end
  return result, mark, name
end

--- What a manifest holds beside the result, without its opening brace.
local function beside_result(text)
  if not text:find(result_line) and result_of(text) ~= nil then
    local whole = engine.decode_json(text)
    whole.result = nil
    text = engine.encode_json(whole, 2) .. "\n"
  end
  return (text:gsub(result_line, "{", 1):gsub("^%s*{%s*\n?", "", 1))
end

--- Puts a result before what the manifest in the folder holds beside it, and how long that file is then, and the history.
function output.write_result_in(case_folder, result)
  local text = engine.read_file(manifest_in(case_folder)) or '{"made_of":{}}\n'
  local beside = beside_result(text)
  local series = case_folder .. "/series.h5"
  local history = engine.kind_of_path(series) == "file" and engine.file_size(series) or nil
  local function whole(size)
    result.sizes = { manifest = ("%012d"):format(size), history = history }
    return ('{"result":%s,\n'):format(engine.encode_json(result)) .. beside
  end
  engine.write_file(manifest_in(case_folder), whole(#whole(0)))
end

--- Of a case that has run, its history there: the manifest, the history, where that is no longer as it was written, as lengths tell;
--- nil where it is. A manifest that is still JSON may well have been written anew.
function output.damaged(case_folder, result)
  local sizes = type(result.sizes) == "table" and result.sizes or {}
  local manifest, series = manifest_in(case_folder), case_folder .. "/series.h5"
  local cut = sizes.manifest and engine.file_size(manifest) ~= tonumber(sizes.manifest) and not output.read_file(manifest)
  return cut and manifest or nil, sizes.history and engine.file_size(series) ~= sizes.history and series or nil
end

--- The manifest in a case's folder, if there is one that cannot be read.
function output.unreadable(case_folder)
  local manifest = manifest_in(case_folder)
  return engine.kind_of_path(manifest) == "file" and not output.read_file(manifest) and manifest or nil
end

--- Takes away whatever says that a case in this folder has ended.
function output.forget_result(case_folder)
  engine.remove(manifest_in(case_folder))
end

function output.write_result(folder, case, result)
  output.write_result_in(output.case_folder(folder, case), result)
end

--- True if the case ran to its end, whether or not its results could be computed, with this fingerprint.
function output.is_computed(result, fingerprint)
  return result ~= nil and (result.verdict == "finished" or result.verdict == "result failed")
    and result.fingerprint == fingerprint
end

--- True if the case ended well with this fingerprint.
function output.is_done(result, fingerprint)
  return output.is_computed(result, fingerprint) and result.verdict == "finished"
end

--- True if nothing that the case's scene and results are made from has changed since.
function output.is_of_sources(study, case, result)
  return result ~= nil and result.sources == identity.of_sources(study, case)
    and not identity.changed_file(study, result.files)
end

--- True if what an extreme ended with still is of these files.
function output.is_current(study, kept, fingerprint)
  return kept.fingerprint == fingerprint and may_be_list(kept.files, "path", "hash")
    and not identity.changed_file(study, kept.files)
end

--- What the study itself says of parameters that are not swept, by name.
local function own_values(study)
  local own = {}
  for _, section in ipairs { study.given, study.chosen } do
    for name, entry in pairs(section) do
      own[name] = entry.value
    end
  end
  return own
end

--- "cells=8; steps=5": the parameters, apart from swept ones, that are not the study's own; own: those.
local function words_set(own, case)
  local words = {}
  for name, standing in pairs(own) do
    local value = rawget(case.p, name)
    if value ~= nil and value ~= standing then
      words[#words + 1] = ("%s=%s"):format(name, tostring(value))
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

local measures = require "stiction.study".measures

--- Calls visit(result, parameter) for the names of each derivative.
local function each_derivative(study, visit)
  for _, parameter in ipairs(study.derivatives) do
    for _, entry in ipairs(study.results) do
      visit(entry.name, parameter)
    end
  end
end

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
  each_derivative(study, function(result, parameter)
    head[#head + 1] = ("d_%s_d_%s"):format(result, parameter)
  end)
  local seen = {}
  for _, name in ipairs(head) do
    seen[name] = true
  end
  for _, name in ipairs { "set", "warnings" } do
    head[#head + 1] = seen[name] and "run_" .. name or name -- a parameter or result has the plain name
  end
  return head
end

--- What results of a row may be off by, by name: by these claims (or nil) if the row is of their plan, else as was found out earlier
--- for the values that they still have.
local function errors_of(row, claims)
  local own, kept = not row.name and claims and claims.of[row.case.id], {}
  for name, its in pairs(row.result.errors or {}) do
    kept[name] = its.value == (row.result.results or {})[name] and its.error or nil
  end
  return own or kept
end

--- Names of what errors are known of, in some row or by these claims.
local function claimed_names(rows, claims)
  local seen = {}
  for _, name in ipairs(claims and claims.names or {}) do
    seen[name] = true
  end
  for _, row in ipairs(rows) do
    for name in pairs(errors_of(row, claims)) do
      seen[name] = true
    end
  end
  return ordered.keys(seen)
end

--- summary.csv: one row per case with a result; SI. `claims` (or nil): {names =, of = {by case of the plan, by name}}, what results
--- may be off by; empty where that is not known. Then derivatives of results with respect to parameters that the study names, SI.
--- Last: which parameters are not the study's own, and what was known against the
--- case before it ran.
function output.write_summary(folder, study, names, rows, claims)
  local claimed, own = claimed_names(rows, claims), own_values(study)
  local lines = { table.concat(summary_head(study, names, claimed), ",") }
  for _, row in ipairs(rows) do
    local words = { row.name or row.case.id }
    local function add(value)
      words[#words + 1] = csv.word(value)
    end
    for _, name in ipairs(names) do
      add(rawget(row.case.p, name))
    end
    for _, entry in ipairs(study.results) do
      add((row.result.results or {})[entry.name] or "nan")
    end
    for _, field in ipairs(measures) do
      add(row.result[field])
    end
    local errors = errors_of(row, claims)
    for _, name in ipairs(claimed) do
      add(errors[name])
    end
    each_derivative(study, function(result, parameter)
      add(((row.result.derivatives or {})[parameter] or {})[result] or "nan")
    end)
    add(words_set(own, row.case))
    add(words_warned(row.result))
    lines[#lines + 1] = table.concat(words, ",")
  end
  engine.write_file(folder .. "/summary.csv", table.concat(lines, "\n") .. "\n")
end

function output.write_checks(folder, checks)
  engine.write_file(folder .. "/checks.json", engine.encode_json(checks, 2) .. "\n")
end

return output
