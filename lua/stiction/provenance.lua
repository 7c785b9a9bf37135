-- What results were made of, kept beside them: each file that a study read, by content, as source/<hash>/<its name>.
local engine = require "stiction.engine"
local fault = require "stiction.fault"

local provenance = { folder = "source" } -- in the output folder

--- What a case that begins is run with: what the command line asked, the program (its identity), the processor, the
--- time.
function provenance.begin(options, program)
  return { quick = options.quick or false, set = options.set or {}, trade = options.trade, program = program, version = engine.version,
    ranks = options.ranks, processor = engine.processor(), started = engine.utc_now() }
end

--- The same when the case has ended.
function provenance.ended(made)
  made.ended = engine.utc_now()
  return made
end

local function kept_path(folder, file)
  return ("%s/%s/%s/%s"):format(folder, provenance.folder, file.hash, file.path:match("[^/]+$"))
end

--- The path of a file {path =, hash =} as it is kept in the output folder, from there on.
function provenance.name_of(file)
  return kept_path("", file):sub(2)
end

--- The files {path =, hash =} that a case's result says it was made of, the study's own first; nil if it does not say.
function provenance.files_of(ended)
  local files = type(ended.files) == "table" and ended.files or {}
  for _, file in ipairs(files) do
    if type(file) ~= "table" or type(file.path) ~= "string" or type(file.hash) ~= "string"
      or not file.path:find("[^/]$") then
      return nil
    end
  end
  return files[1] and files
end

--- Keeps the files that a case is made of (as output.files_read tells them), once per content; one that has changed
--- since it was read is not that content, and is left out.
function provenance.keep(folder, study, files)
  for _, file in ipairs(files) do
    local path = kept_path(folder, file)
    if not engine.kind_of_path(path) then
      local text = engine.read_file(file.path:sub(1, 1) == "/" and file.path or study.source.folder .. "/" .. file.path)
      if text and engine.hash(text) == file.hash then
        engine.make_folder(path:match("^(.*)/"))
        engine.write_file(path, text)
      end
    end
  end
end

--- Number of folders that paths among the files lead up from that of the study.
local function height(files)
  local most = 0
  for _, file in ipairs(files) do
    local ups = 0
    for part in file.path:gmatch("[^/]+") do
      ups = ups + (part == ".." and 1 or 0)
    end
    most = math.max(most, ups)
  end
  return most
end

--- Lays the kept files of a case out below `place` as they stood around the study; the path of the study's own, or nil
--- and what is missing or is not what was read.
function provenance.lay_out(folder, files, place)
  local own = place .. "/study" .. ("/study"):rep(height(files))
  for _, file in ipairs(files) do
    local text = engine.read_file(kept_path(folder, file))
    if file.path:sub(1, 1) == "/" then
      return nil, ("%s was read by its whole path"):format(file.path)
    elseif not text then
      return nil, ("%s is not kept (%s)"):format(file.path, provenance.name_of(file))
    elseif engine.hash(text) ~= file.hash then
      return nil, ("%s is no longer what was read (%s)"):format(file.path, provenance.name_of(file))
    end
    local target = own .. "/" .. file.path
    engine.make_folder(target:match("^(.*)/"))
    engine.write_file(target, text)
  end
  return own .. "/" .. files[1].path
end

--- f(path of an empty folder, ...), which is removed when that has ended, however it does.
function provenance.in_scratch(f, ...)
  local jobs = require "stiction.jobs"
  local code, printed = jobs.program { "mktemp", "-d", "-t", "stiction.XXXXXX" }
  local path = printed:match("^(/.-)%s*$")
  if code ~= 0 or not path then
    fault.input("cannot make a folder for scratch files (%s); set TMPDIR to a folder that can be written",
      (printed:gsub("^mktemp: ", ""):gsub("%s+$", "")))
  end
  local answers = table.pack(engine.call(f, path, ...))
  engine.remove(path)
  if not answers[1] then
    error(answers[2], 0)
  end
  return table.unpack(answers, 2, answers.n)
end

return provenance
