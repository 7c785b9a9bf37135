-- What goes on in an output folder: the workers that have told of themselves there, and the cases that they run.
local claims = require "stiction.claims"
local ordered = require "stiction.ordered"
local output = require "stiction.output"
local progress = require "stiction.progress"

local standing = {}

local function number_or(value, default)
  return type(value) == "number" and value or default
end

--- What a worker told, as old as that is; numbers and lists where they must be.
local function plain(told, age)
  local cases = {}
  for _, own in ipairs(type(told.cases) == "table" and told.cases or {}) do
    if type(own) == "table" and type(own.case) == "string" then
      local left = number_or(own.left)
      cases[#cases + 1] = { case = own.case, seconds = number_or(own.seconds, 0) + age, time = number_or(own.time),
        end_time = number_or(own.end_time), step = number_or(own.step), left = left and math.max(left - age, 0) }
    end
  end
  return { cases = cases, done = math.floor(number_or(told.done, 0)), failed = math.floor(number_or(told.failed, 0)),
    total = math.floor(number_or(told.total, 0)), seconds = number_or(told.seconds, 0) + age, job = told.job, task = told.task }
end

--- "2 s ago", "none for 3 min 05 s: dead"
function standing.sign_of_life(worker)
  local age = worker.age and progress.duration(math.max(worker.age, 0))
  if worker.life == "lives" then
    local late = worker.here and worker.age and worker.age > 3 * claims.between_beats
    return late and ("none for %s, but its process lives"):format(age) or age and age .. " ago" or "its process lives"
  elseif worker.life == "dead" and worker.here then
    return "dead: its process has ended"
  end
  return ("none%s: %s"):format(age and " for " .. age or "", worker.life == "dead" and "dead" or "perhaps dead")
end

--- "t 0.4 of 2 s, step 12", "" where nothing is known.
function standing.progress(own)
  if not own.time or not own.end_time then
    return ""
  end
  return ("t %.3g of %.3g s%s"):format(own.time, own.end_time, own.step and (", step %d"):format(own.step) or "")
end

--- Of what a worker told, only what it still does: that it claims, or, where it shares nothing, that has not ended.
local function keep_current(folder, worker, holders)
  local shares, kept = worker.name:find("^worker%+"), {}
  for _, own in ipairs(worker.told.cases) do
    local result = not shares and output.read_result_in(("%s/%s"):format(folder, own.case))
    if shares and holders[own.case] == worker.name or not shares and not (result and result.verdict ~= "stopped") then
      kept[#kept + 1] = own
    end
  end
  worker.told.cases = kept
end

--- {workers = {{name =, words =, life = "lives" | "silent" | "dead", age = s or nil, here =, told = {cases =, total = (of its
--- run, 0: not told), done =, failed =, seconds =}}}, cases = by name {worker =, life =, own = what its worker told of it, or nil}}
function standing.read(folder)
  local workers, holders = claims.look(folder)
  local known, by_name = { workers = {}, cases = {} }, {}
  for _, worker in ipairs(workers) do
    worker.words = claims.words(worker.name, worker.told)
    worker.told = plain(worker.told, math.max(worker.age or 0, 0))
    by_name[worker.name] = worker
    if worker.name:find("^worker%+") or worker.name:find("^alone%+") then
      known.workers[#known.workers + 1] = worker
    end
    keep_current(folder, worker, holders)
    for _, own in ipairs(worker.told.cases) do
      known.cases[own.case] = { worker = worker, life = worker.life, own = own }
    end
  end
  for _, name in ipairs(ordered.keys(holders)) do
    local worker = by_name[holders[name]]
    local entry = known.cases[name]
    if not entry then
      known.cases[name] = { worker = worker, life = worker and worker.life or "dead" }
      table.insert(worker and worker.told.cases or {}, { case = name })
    end
  end
  return known
end

--- "it runs: process 12 on host, for 3 min 05 s, t 0.4 of 2 s" of an entry of cases; nil if nobody has it.
function standing.words(entry)
  if not entry then
    return nil
  elseif entry.life == "dead" then
    return "its worker is dead" .. (entry.worker and ": " .. entry.worker.words or "")
  end
  local own = entry.own
  local words = { entry.worker.words, own and "for " .. progress.duration(own.seconds), own and standing.progress(own) }
  local line = "it runs: " .. table.concat(words, ", "):gsub(", $", "")
  return entry.life == "silent" and line .. "; no sign of life now" or line
end

return standing
