-- What decides the results of a case: the scene that its script made, in SI, with files by their content, and the program.
local derivatives = require "stiction.derivatives"
local engine = require "stiction.engine"
local loader = require "stiction.loader"
local parts = require "stiction.parts"
local problem = require "stiction.problem"
local units = require "stiction.units"

local identity = {}

--- Parameters as plain values for JSON: SI numbers with their dimension.
function identity.plain(parameters)
  local plain = setmetatable({}, { json = "object" })
  for name, value in next, parameters do
    if units.is_quantity(value) then
      plain[name] = { value = value.si, unit = engine.dimension_text(value.metre, value.kilogram, value.second) }
    else
      plain[name] = value
    end
  end
  return plain
end

--- Parameters of a case as JSON.
function identity.parameters_text(case)
  local text = rawget(case, "parameters_text") or engine.encode_json(identity.plain(case.p))
  rawset(case, "parameters_text", text)
  return text
end

--- f(...), whose faults but a stop come as nil and a message.
local function attempt(f, ...)
  local held, value = engine.call(f, ...)
  if not held and value.kind == "stopped" then
    error(value, 0)
  end
  return held and value or nil, not held and tostring(value) or nil
end

--- All that the case's scene says, as JSON, the files in it by their content; nil and why if it cannot be made.
function identity.scene_text(study, case)
  local scene, reason = attempt(study.scene_of, study, case)
  local text
  if scene then
    text, reason = attempt(engine.scene_text, scene)
  end
  for _, file in ipairs(text and parts.files(scene) or {}) do
    local path = engine.encode_json(file):gsub("%p", "%%%0")
    text = text:gsub(path, ('"content %s"'):format(loader.file_hash(file)))
  end
  return text, reason
end

local own_program, own_library -- as this process found them

--- Whatever computes: this program.
function identity.program()
  own_program = own_program or engine.build_id() or loader.hash { "/proc/self/exe" }
  return own_program
end

local function hash_of_library()
  local files = {}
  for _, file in ipairs(engine.list(engine.library_root() .. "/stiction", true)) do
    files[#files + 1] = file:find("%.lua$") and file or nil
  end
  return loader.hash(files)
end

--- Of the files of the Lua library: they make scenes and results.
local function library()
  own_library = own_library or hash_of_library()
  return own_library
end

--- Whatever computes and whatever makes results of it.
function identity.whole_program()
  return library() .. identity.program()
end

--- Of all from which the results of a case that has run are made anew, and its scene was: the study as it was loaded, the
--- library, the program, the parameters. What is read later, changed_file tells.
function identity.of_sources(study, case)
  return engine.hash(study.identity .. library() .. identity.program() .. identity.parameters_text(case)
    .. (case.problems or ""))
end

--- What a case is reused by. Of a saved problem also what makes its results, as these are made of answers that are not
--- kept.
function identity.of(study, case)
  if study.problem then
    return engine.hash(identity.of_sources(study, case) .. problem.identity(study, case.p))
  end
  local text, reason = identity.scene_text(study, case)
  local beside, refused = "", nil
  if text and #study.derivatives > 0 then
    beside, refused = attempt(derivatives.text, study, case)
  end
  return engine.hash(identity.program() .. (text or "no scene: " .. reason) .. (beside or "no derivatives: " .. refused))
end

--- The files that the scene or the saved problem of a case consists of.
local function data_files(study, case)
  if study.problem then
    return { problem.read(study, case.p).file }
  end
  local scene = attempt(study.scene_of, study, case) -- one that cannot be made is told before it runs
  return scene and parts.files(scene) or {}
end

--- Text that changes when one of them does; "" if there are none.
function identity.of_data(study, case)
  if study.problem then
    return problem.identity(study, case.p)
  end
  local files = data_files(study, case)
  return #files > 0 and loader.hash(files) or ""
end

--- The files that the study has read so far and those that the case's scene or problem consists of: list of {path =,
--- hash =}, the paths as they stand from the study's folder on.
function identity.files_read(study, case)
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
    add(engine.absolute(file), loader.file_hash(file))
  end
  return list
end

local absolute_of = {} -- by path

--- Where a file stands that a result names.
local function path_of(study, file)
  local path = file.path:sub(1, 1) == "/" and file.path or study.source.folder .. "/" .. file.path
  absolute_of[path] = absolute_of[path] or engine.absolute(path)
  return absolute_of[path]
end

--- The first of such files that has another content now, nil if none has.
function identity.changed_file(study, files)
  for _, file in ipairs(files or {}) do
    local path = path_of(study, file)
    if (study.source.hashes[path] or loader.file_hash(path)) ~= file.hash then
      return path
    end
  end
end

return identity
