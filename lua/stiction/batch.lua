-- Workers that a batch system starts: one job array, each task a worker that pulls cases from the shared folder.
local engine = require "stiction.engine"
local fault = require "stiction.fault"
local jobs = require "stiction.jobs"
local output = require "stiction.output"
local report = require "stiction.report"

local batch = {}

local most_by_default = 16 -- workers
local notice = 60 -- s before its time limit that Slurm tells a worker to end

--- A word as the shell reads it back.
local function quoted(word)
  return word:find("^[%w%./_=+,:@-]+$") and word or "'" .. word:gsub("'", "'\\''") .. "'"
end

--- Command line of a worker, paths whole.
local function worker_words(plan)
  local options = plan.options
  local words = { engine.program(), "run", engine.absolute(options.study), "--worker", "--out",
    engine.absolute(plan.folder) }
  for _, name in ipairs { "quick", "trust", "strict", "no-figures" } do
    words[#words + 1] = options[name] and "--" .. name or nil
  end
  for _, setting in ipairs(options.set or {}) do
    words[#words + 1], words[#words + 2] = "--set", setting
  end
  for _, name in ipairs { "where", "case", "accuracy", "of" } do
    if options[name] then
      words[#words + 1], words[#words + 2] = "--" .. name, options[name]
    end
  end
  for _, name in ipairs { "problems", "jobs", "threads", "ranks" } do
    if options[name] then
      words[#words + 1], words[#words + 2] = "--" .. name, ("%d"):format(options[name])
    end
  end
  for i, word in ipairs(words) do
    words[i] = quoted(word)
  end
  return table.concat(words, " ")
end

local function sbatch_words(plan, count, folder)
  local options = plan.options
  local words = { "sbatch", "--parsable", "--requeue", "--open-mode=append", ("--ntasks=%d"):format(options.ranks or 1),
    ("--cpus-per-task=%d"):format((options.jobs or 1) * (options.threads or 1)),
    ("--signal=B:TERM@%d"):format(notice), ("--array=1-%d"):format(count),
    "--job-name=" .. plan.study.name, ("--output=%s/%%A_%%a.log"):format(folder) }
  for _, name in ipairs { "time", "partition" } do
    words[#words + 1] = options[name] and ("--%s=%s"):format(name, options[name]) or nil
  end
  table.move(options.sbatch or {}, 1, #(options.sbatch or {}), #words + 1, words)
  words[#words + 1] = folder .. "/worker.sh"
  return words
end

--- Id of the job that sbatch made; bad input, with its own words, if it made none.
local function submit(words)
  local held, code, text = engine.call(jobs.program, words)
  if not held and code.kind == "stopped" then
    error(code, 0)
  elseif not held then
    fault.input("--on slurm: there is no sbatch here to submit jobs with (%s); run this on a login node of the cluster, or "
      .. "start workers by hand: stiction run STUDY --worker", tostring(code))
  end
  local id = text:match("(%d+)[;%w%s_.-]*$")
  if code ~= 0 or not id then
    fault.input("--on slurm: sbatch refused the job (exit code %d): %s", code, (text:gsub("%s+$", "")))
  end
  return id
end

--- Bad input if options are there that say nothing without --on, or if that names no batch system that is known.
function batch.check(options)
  for _, name in ipairs { "workers", "time", "partition", "sbatch" } do
    if options[name] and not options.on then
      fault.input("--%s is about workers that a batch system starts; give --on slurm too", name)
    end
  end
  if options.on and options.on ~= "slurm" then
    fault.input("--on %s: only slurm is known; any other system can start 'stiction run STUDY --worker'", options.on)
  elseif options.on and options.worker then
    fault.input("--on submits workers, --worker is one; give one of them")
  end
end

--- Submits workers for so many cases that are to run; the exit code.
function batch.submit(plan, count)
  if count == 0 then
    report.line("nothing to submit: all cases have ended; 'stiction run STUDY' judges them")
    return 0
  end
  local folder = engine.absolute(plan.folder) .. "/slurm"
  output.prepare(folder)
  engine.write_file(folder .. "/worker.sh", ("#!/bin/sh\nexec %s\n"):format(worker_words(plan)))
  local workers = math.floor(math.min(plan.options.workers or most_by_default, count))
  local id = submit(sbatch_words(plan, workers, folder))
  local where = plan.options.out and " --out " .. quoted(plan.options.out) or ""
  report.line("job %s: %d worker%s for %d case%s", id, workers, workers == 1 and "" or "s", count, count == 1 and "" or "s")
  report.line("  watch   stiction status %s%s", quoted(plan.options.study), where)
  report.line("  queue   squeue --job %s", id)
  report.line("  stop    scancel %s", id)
  report.line("  logs    %s/%s_*.log", folder, id)
  report.line("The same command submits further workers, also when these have reached their time limit.")
  return 0
end

return batch
