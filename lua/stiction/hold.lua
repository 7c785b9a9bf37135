-- An output folder is written by one process at a time, and belongs to one study.
local engine = require "stiction.engine"
local fault = require "stiction.fault"
local output = require "stiction.output"

local hold = { layout = 1 } -- of output folders; higher where older versions would misread them

local function study_file(folder)
  return folder .. "/study.json"
end

--- What study.json of the folder says, {} if there is none; bad input if it cannot be read, or if a newer version wrote it.
function hold.owner(folder)
  local text = engine.read_file(study_file(folder))
  local kept = text and engine.decode_json(text)
  if text and type(kept) ~= "table" then
    fault.input("%s is damaged, so that it is not known whose the folder is; remove that file if the folder is this study's, "
      .. "or choose another folder with --out", study_file(folder))
  elseif kept and type(kept.layout) == "number" and kept.layout > hold.layout then
    fault.input("%s was written by a newer version of Stiction (layout %g; %s reads up to %d); read it with that one, or "
      .. "choose another folder with --out", folder, kept.layout, engine.version, hold.layout)
  end
  return kept or {}
end

local function read_owner(folder)
  local kept = hold.owner(folder)
  return type(kept.study) == "string" and kept or {}
end

--- Bad input if the folder is that of another study which still is there.
function hold.check_owner(folder, study)
  local owner = read_owner(folder).study
  if owner and owner ~= study.source.file and engine.kind_of_path(owner) == "file" then
    fault.input("%s holds the output of another study, %s; choose another folder with --out, or remove that one",
      folder, owner)
  end
end

local function with_lock(shared, folder, study, command, f, ...)
  output.prepare(folder)
  local lock, words = engine.lock(folder .. "/.lock", ("stiction %s %s"):format(command, study.source.file), shared)
  if not lock then
    fault.input("%s is in use by %s; wait until that ends, stop it, or choose another folder with --out%s", folder, words,
      command == "run" and " (runs that all have --join share one)" or "")
  elseif words then
    engine.complain(("stiction: %s: its file system knows no locks (%s); let nothing else write there\n"):format(folder,
      words))
  end
  local answers = table.pack(engine.call(function(...)
    hold.check_owner(folder, study)
    return f(...)
  end, ...))
  engine.unlock(lock)
  if not answers[1] then
    error(answers[2], 0)
  end
  return table.unpack(answers, 2, answers.n)
end

--- f(...) once nobody else writes into the folder, which is made if it is missing; bad input if somebody does, or if it
--- is another study's. command: the word that is running.
function hold.folder(...)
  return with_lock(false, ...)
end

--- The same together with others that share the folder: what each does there they claim.
function hold.shared(...)
  return with_lock(true, ...)
end

--- Notes whose the folder is, what the study has read so far, and the units of its results.
function hold.note(folder, study)
  local files, results = setmetatable({}, { json = "object" }), {}
  for i, entry in ipairs(study.results) do
    results[i] = { name = entry.name, unit = entry.unit, meaning = entry.meaning }
  end
  for _, file in ipairs(study.source.files) do
    files[engine.relative(file, study.source.folder)] = study.source.hashes[file]
  end
  engine.write_file(study_file(folder), engine.encode_json({ study = study.source.file, name = study.name,
    layout = hold.layout, results = results, files = files,
    drawn = study.sweep.drawn }, 2) .. "\n")
end

--- The first file that the study has read otherwise than the process that noted it in the folder, nil if there is none.
function hold.differing(folder, study)
  local owner = read_owner(folder)
  local noted = owner.study == study.source.file and type(owner.files) == "table" and owner.files or {}
  for _, file in ipairs(study.source.files) do
    local hash = noted[engine.relative(file, study.source.folder)]
    if hash and hash ~= study.source.hashes[file] then
      return file
    end
  end
end

return hold
