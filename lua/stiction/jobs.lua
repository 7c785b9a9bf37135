-- Cases as child processes of this program, several at a time.
local engine = require "stiction.engine"
local fault = require "stiction.fault"
local progress = require "stiction.progress"

local jobs = {}

local record_separator = "\x1e"
local patience = 15 -- s that a child told to stop may take to close its files, unless the pool has its own

--- Command line of the child that runs one case.
local function words_for(case, options, threads)
  local words = { engine.program(), "case", options.study, "--case", case.id, "--out", options.folder }
  if options.fingerprints then
    words[#words + 1], words[#words + 2] = "--fingerprint", options.fingerprints[case.id]
  end
  if options.worker then
    words[#words + 1], words[#words + 2] = "--for", options.worker
  end
  if options.problems then
    words[#words + 1], words[#words + 2] = "--problems", ("%d"):format(options.problems)
  end
  words[#words + 1], words[#words + 2] = "--threads", ("%d"):format(threads)
  if options.checkpoint then
    words[#words + 1], words[#words + 2] = "--checkpoint", ("%.17g"):format(options.checkpoint)
  end
  if options.force then
    words[#words + 1] = "--force"
  end
  if options.quick then
    words[#words + 1] = "--quick"
  end
  if options.trust then
    words[#words + 1] = "--trust"
  end
  if options.trade then
    words[#words + 1] = "--trade"
  end
  if case.point then
    words[#words + 1], words[#words + 2] = "--point", case.point
  end
  if options.alone then
    words[#words + 1] = "--alone"
  end
  if options.ranks then
    words[#words + 1], words[#words + 2] = "--ranks", ("%d"):format(options.ranks)
  end
  for _, setting in ipairs(options.set or {}) do
    words[#words + 1] = "--set"
    words[#words + 1] = setting
  end
  return words
end

--- A process that has loaded the library and runs cases one by one, each in a child of its own: one that waits, or new.
local function server(pool)
  local words = { engine.program(), "cases" }
  if pool.options.worker then -- by these its children are known
    words[#words + 1], words[#words + 2] = "--for", pool.options.worker
  end
  if pool.options.trust then
    words[#words + 1] = "--trust"
  end
  local waiting = table.remove(pool.idle)
  local alive = waiting and select(3, engine.collect(waiting)) == nil
  return alive and waiting or engine.spawn(words, { "OPENBLAS_NUM_THREADS=1" }, true)
end

--- Of a case that begins, or each of its ranks, with so many others still to begin: as asked for, or the cores that nobody
--- else needs.
local function threads_of(pool, waiting)
  local at_once = math.min(pool.options.jobs, #pool.running + 1 + waiting) * (pool.options.ranks or 1)
  return math.floor(pool.options.threads or math.max(1, engine.cores() // at_once))
end

local function start(pool, case, waiting)
  local process = server(pool)
  engine.request(process, words_for(case, pool.options, threads_of(pool, waiting)))
  pool.running[#pool.running + 1] = { case = case, process = process, text = "", noted = engine.clock(),
    began = engine.clock() }
end

local function read_message(pool, job, line)
  local message = engine.decode_json(line) or {}
  if message.note then
    pool.display:note(job.case.id .. "  " .. message.note)
  end
  job.progress = message.progress or job.progress
  job.ended = message.ended or job.ended
  job.fault, job.kind = message.fault or job.fault, message.kind or job.kind
  job.code, job.over = message.code or job.code, message.over or job.over
end

--- Hands complete lines of what the script printed on; ranks send their messages among these.
local function show_text(pool, job, text)
  job.text = job.text .. text
  for line in job.text:gmatch("([^\n]*)\n") do
    if line:sub(1, 1) == record_separator then
      read_message(pool, job, line:sub(2))
    else
      pool.display:note(job.case.id .. ": " .. line)
    end
  end
  job.text = job.text:match("[^\n]*$")
end

local verdict_of = { stopped = "stopped", run = "failed", bug = "crashed" } -- by kind of fault; else bad input
local words_of_signal = {
  [9] = "by signal 9 (killed), as the system ends a process when memory runs out: a coarser mesh or fewer cases at a time "
    .. "(--jobs) take less",
}
local signals_to_stop = { [2] = true, [10] = true, [15] = true } -- SIGINT, SIGUSR1 (of ranks), SIGTERM

local function outcome(job, code)
  local signal = code > 128 and code - 128
  if job.fault then
    return { verdict = verdict_of[job.kind] or "bad input", reason = job.fault, bad_input = code == 2, kind = job.kind }
  elseif job.ended then
    return job.ended
  elseif signals_to_stop[signal] and engine.stopped() then
    return { verdict = "stopped", reason = "stopped by the user before it began" }
  end
  local how = signal and (words_of_signal[signal] or ("by signal %d"):format(signal)) or ("with exit code %d"):format(code)
  return { verdict = "crashed", reason = ("its process ended %s%s"):format(how, job.text ~= "" and ": " .. job.text or "") }
end

--- True if a job has used more time than a case may take; then its process is killed.
local function overdue(pool, job)
  local limit = pool.options.limit
  if not limit or engine.clock() - job.began < limit then
    return false
  end
  engine.kill(job.process)
  return true
end

--- Reads news of every running job; jobs that have ended leave the list.
local function gather(pool, on_end)
  local still = {}
  for _, job in ipairs(pool.running) do
    local lines, text, code = engine.collect(job.process)
    for _, line in ipairs(lines) do
      read_message(pool, job, line)
    end
    show_text(pool, job, text)
    if not code and job.code and not job.over and not job.lost then
      pool.idle[#pool.idle + 1] = job.process
    end
    code = job.code or code
    if job.lost then
      engine.kill(job.process)
    elseif code then
      on_end(job.case, outcome(job, code))
    elseif overdue(pool, job) then
      on_end(job.case, { verdict = "hung", reason = ("it did not end within %g s"):format(pool.options.limit) })
    else
      still[#still + 1] = job
    end
  end
  pool.running = still
end

local function await(pool)
  local processes = {}
  for i, job in ipairs(pool.running) do
    processes[i] = job.process
  end
  engine.await(processes, 0.2)
end

local function stop_all(pool, on_end)
  for _, job in ipairs(pool.running) do
    engine.terminate(job.process)
  end
  local deadline = engine.clock() + (pool.options.patience or patience)
  while #pool.running > 0 and engine.clock() < deadline do
    await(pool)
    gather(pool, on_end)
  end
  for _, job in ipairs(pool.running) do
    engine.kill(job.process)
    on_end(job.case, { verdict = "stopped", reason = "it did not end in time" })
  end
  pool.running = {}
end

--- Ends all at once, without a word.
local function kill_all(pool)
  for _, job in ipairs(pool.running) do
    engine.kill(job.process)
  end
  for _, job in ipairs(pool.running) do
    while not select(3, engine.collect(job.process)) do
      engine.await({ job.process }, 0.01)
    end
  end
  pool.running = {}
end

--- Starts a case unless it is not this run's.
local function begin(pool, cases, place)
  local case, take = cases[place], pool.options.take
  if take and not take(case) then
    return
  elseif not pool.display.width then
    pool.display:note_good(("%s  started (%d of %d)"):format(case.id, place, #cases))
  end
  start(pool, case, #cases - place)
end

local function how_it_ended(result)
  if result.verdict == "result failed" then
    return ": " .. result.reason
  end
  return result.seconds and (" in %s, %d steps"):format(progress.duration(result.seconds), result.steps) or ""
end

--- Tells and counts that a case has ended.
local function note_end(display, case, result)
  local good = result.verdict == "finished"
  local note = good and display.note_good or display.note
  note(display, ("%s  %s%s"):format(case.id, result.verdict, how_it_ended(result)))
  display.tally.done, display.tally.failed = display.tally.done + 1, display.tally.failed + (good and 0 or 1)
end

--- Runs the pool's cases; "stopped" if the user asked to stop.
local function work(pool, cases, on_end)
  local options = pool.options
  local next_case, bad, some_good = 1, false, false
  local function ended(case, result)
    some_good = some_good or result.verdict == "finished"
    if result.missing and not some_good then
      result.bad_input = true -- so it will be in all cases
    end
    bad = bad or (result.bad_input and (result.kind == "changed" or not options.tolerant))
    note_end(pool.display, case, result)
    on_end(case, result)
  end
  while (next_case <= #cases and not bad) or #pool.running > 0 do
    while next_case <= #cases and #pool.running < options.jobs and not bad do
      begin(pool, cases, next_case)
      next_case = next_case + 1
    end
    if options.tick then
      options.tick(pool.running)
    end
    await(pool)
    if engine.stopped() then
      stop_all(pool, ended)
      return "stopped"
    end
    gather(pool, ended)
    pool.display:update(pool.running)
  end
end

--- Runs the cases, `options.jobs` at a time; on_end(case, result) after each. Bad input in one stops the rest.
--- Returns "stopped" if the user asked to stop. options: study, folder, quick, set, trust, jobs, quiet (no progress),
--- limit (s that a case may take), tolerant (bad input stops nothing), fingerprints (by the case's id, which its process
--- must find too; nil: any), threads (of each case; nil: the cores that no other case needs), take(case) (or nil: whether
--- this run may begin it), tick(running) (or nil: called now and then; a job that it marks `lost` is ended without a
--- word), worker (name of what this process has in the folder).
function jobs.run(cases, options, on_end)
  local pool = { options = options, running = {}, idle = {}, display = progress.display(options.quiet, #cases) }
  local held, value = engine.call(work, pool, cases, on_end)
  for _, process in ipairs(pool.idle) do
    engine.kill(process)
  end
  pool.display:finish()
  if not held then
    kill_all(pool)
    error(value, 0)
  end
  return value
end

--- Runs a program to its end and returns its exit code, what it printed, its processor time in s and its peak memory in
--- bytes. variables: {"NAME=value", ...} or nil.
function jobs.program(words, variables)
  local process, printed = engine.spawn(words, variables or {}), {}
  while true do
    engine.await({ process }, 0.2)
    local _, text, code, seconds, memory = engine.collect(process)
    printed[#printed + 1] = text
    if code then
      return code, table.concat(printed), seconds, memory
    elseif engine.stopped() then
      engine.terminate(process)
      fault.run("stopped by the user")
    end
  end
end

return jobs
