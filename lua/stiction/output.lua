-- A study's output folder: case folders with their finished mark, the summary, the checks.
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

function output.case_folder(folder, case)
  return folder .. "/" .. case.id
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

--- Text that changes when a file does that the scene or the saved problem of a case consists of; "" if none.
function output.data_identity(study, case)
  if study.problem then
    return problem.identity(study, case.p)
  end
  local made, scene = engine.call(study.scene_of, study, case)
  if not made and scene.kind == "stopped" then
    error(scene, 0)
  end
  local files = made and parts.files(scene) or {} -- a scene that cannot be made is told before it runs
  return #files > 0 and loader.hash(files) or ""
end

local function identity_of_program()
  return loader.hash(engine.list(engine.library_root() .. "/stiction", true)) .. loader.hash { "/proc/self/exe" }
end

local own_identity -- as this process found it: what is installed meanwhile did not make its results

--- Fingerprint of a case: of the study's files as they were loaded, the library, the program, the parameters, and the
--- files of its scene or saved problem.
function output.fingerprint(study, case)
  own_identity = own_identity or identity_of_program()
  return engine.hash(study.identity .. own_identity .. case.id .. engine.encode_json(output.plain(case.p))
    .. output.data_identity(study, case))
end

function output.result_file(folder, case)
  return output.case_folder(folder, case) .. "/result.json"
end

local function is_result(value)
  local function may_be(kind, name)
    return value[name] == nil or type(value[name]) == kind
  end
  return type(value) == "table" and type(value.verdict) == "string" and may_be("string", "reason")
    and may_be("table", "results")
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

--- True if the case ended well with this fingerprint.
function output.is_done(result, fingerprint)
  return result ~= nil and result.verdict == "finished" and result.fingerprint == fingerprint
end

local function csv_word(value)
  value = units.si(value)
  if type(value) == "number" then
    return math.type(value) == "integer" and tostring(value) or engine.number_text(value)
  end
  local text = value == nil and "" or tostring(value)
  return text:find('[,"\n]') and '"' .. text:gsub('"', '""') .. '"' or text
end

--- summary.csv: one row per case with a result; SI. `claims` (or nil): {names =, of = {by case, by name}}, what results may
--- be off by, in last columns; empty where that is not known.
function output.write_summary(folder, study, names, rows, claims)
  local head = { "case" }
  for _, name in ipairs(names) do
    head[#head + 1] = name
  end
  for _, entry in ipairs(study.results) do
    head[#head + 1] = entry.name
  end
  table.move({ "verdict", "steps", "iterations", "seconds" }, 1, 4, #head + 1, head)
  local claimed = claims and claims.names or {}
  for _, name in ipairs(claimed) do
    head[#head + 1] = name .. "_error"
  end
  local lines = { table.concat(head, ",") }
  for _, row in ipairs(rows) do
    local words = { row.case.id }
    for _, name in ipairs(names) do
      words[#words + 1] = csv_word(row.case.p[name])
    end
    for _, entry in ipairs(study.results) do
      words[#words + 1] = csv_word((row.result.results or {})[entry.name])
    end
    for _, field in ipairs { "verdict", "steps", "iterations", "seconds" } do
      words[#words + 1] = csv_word(row.result[field])
    end
    for _, name in ipairs(claimed) do
      words[#words + 1] = csv_word((claims.of[row.case.id] or {})[name])
    end
    lines[#lines + 1] = table.concat(words, ",")
  end
  engine.write_file(folder .. "/summary.csv", table.concat(lines, "\n") .. "\n")
end

function output.write_checks(folder, checks)
  engine.write_file(folder .. "/checks.json", engine.encode_json(checks, 2) .. "\n")
end

return output
