-- An output folder is written by one process at a time, or by runs that share it, and belongs to one study. Who is in it
-- shows by files there (claims); a lock of the system, where the file system is this machine's own, goes with the last
-- process that a run started.
local claims = require "stiction.claims"
local engine = require "stiction.engine"
local fault = require "stiction.fault"
local output = require "stiction.output"
local report = require "stiction.report"

local hold = { layout = 2 } -- of output folders; higher where older versions would misread them

local alone = "=alone" -- the claim of a run that shares the folder with nobody

--- What study.json of the folder says, {} if there is none; bad input if it cannot be read, or if a newer version wrote it.
function hold.owner(folder)
  local text = engine.read_file(output.study_file(folder))
  local kept = text and engine.decode_json(text)
  if text and type(kept) ~= "table" then
    fault.input("%s is damaged, so that it is not known whose the folder is; remove that file if the folder is this study's, "
      .. "or choose another folder with --out", output.study_file(folder))
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
  if output.is_another(owner, study.source.file) then
    fault.input("%s holds the output of another study, %s; choose another folder with --out, or remove that one",
      folder, owner)
  end
end

local function refuse(folder, words, command)
  fault.input("%s is in use by %s; wait until that ends, stop it, or choose another folder with --out%s", folder, words,
    command == "run" and " (runs that all have --join share one)" or "")
end

--- Bad input if this worker lives; waits where only time can tell.
local function yield_to(office, worker, command)
  local verdict = office:verdict(worker)
  if verdict == "unknown" then
    report.line("%s: %s had it; waiting up to %g s for a sign of life", office.folder, claims.words(worker),
      claims.patience)
  end
  while verdict == "unknown" do
    engine.await({}, 0.5)
    if engine.stopped() then
      fault.run("stopped by the user")
    end
    verdict = office:verdict(worker)
  end
  if verdict == "lives" then
    refuse(office.folder, claims.words(worker), command)
  end
end

--- Bad input if others are in the folder who do not share it with this run.
local function keep_apart(office, shared, command)
  local holder = office:holder(alone)
  if shared then
    return holder and yield_to(office, holder, command)
  end
  while not office:take(alone) do
    holder = office:holder(alone)
    if holder then
      yield_to(office, holder, command)
    end
  end
  for _, worker in ipairs(office:others "worker") do
    yield_to(office, worker, command)
  end
end

local function with_lock(shared, folder, study, command, f, ...)
  output.prepare(folder)
  local lock, words = engine.lock(folder .. "/.lock", ("stiction %s %s"):format(command, study.source.file), shared)
  if not lock then
    refuse(folder, words, command)
  end
  local office = claims.open(folder, shared and "worker" or "alone")
  local answers = table.pack(engine.call(function(...)
    keep_apart(office, shared, command)
    hold.check_owner(folder, study)
    return f(...)
  end, ...))
  office:close(not office.hasty)
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
  engine.write_file(output.study_file(folder), engine.encode_json({ study = study.source.file, name = study.name,
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
