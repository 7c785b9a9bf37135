-- Who does what in a folder that several runs share, on one machine or on several. A worker has a file of its own, which
-- it rewrites every few seconds; a claim is a link to it, so that it holds on file systems without locks too and shows
-- whether its worker lives. No clock is compared with another machine's: a worker elsewhere is dead once its file has not
-- changed for a minute by the clock of whom that concerns.
local engine = require "stiction.engine"
local fault = require "stiction.fault"

local claims = { between_beats = 5, patience = 60 } -- s; patience: with a worker elsewhere whose file does not change

local place = "/.claims"
local offices = {} -- of this process, by folder

--- This machine as long as it is up, and the numbers of its processes that this one sees.
local function host()
  local name = engine.read_file "/proc/sys/kernel/hostname" or "unknown"
  local boot = engine.read_file "/proc/sys/kernel/random/boot_id" or ""
  local numbers = (engine.link_target "/proc/self/ns/pid" or ""):match("%d+") or ""
  return ("%s+%s%s"):format(name:gsub("[^%w.-]", ""), boot:sub(1, 8), numbers)
end

--- Process id and the clock tick in which that process started.
local function process(id)
  local stat = engine.read_file(("/proc/%s/stat"):format(id)) or ""
  local own, rest = stat:match("^(%d+).*%) (.*)$")
  local count, started = 0, nil
  for word in (rest or ""):gmatch("%S+") do
    count = count + 1
    started = count == 20 and word or started
  end
  return own, started
end

--- Whether a process here was started for this worker, as those of cases are.
local function has_children(worker)
  for _, path in ipairs(engine.list("/proc", false)) do
    local words = path:find("/%d+$") and engine.read_file(path .. "/cmdline")
    if words and words:find("\0" .. worker .. "\0", 1, true) then
      return true
    end
  end
  return false
end

local function lives_here(worker, id, started)
  return select(2, process(id)) == started or has_children(worker)
end

--- Where a worker is, its process id, when that started; nil if it is no worker's name.
local function parts(worker)
  return worker:match("^%a+%+(.*)%+(%d+)%+(%d+)$")
end

--- Whose a claim is: the first line of its file, nil if there is none.
local function holder_in(path)
  local text = engine.read_file(path)
  return text and text:match("^[^\n]*")
end

--- An environment variable of this process, nil if it is not set.
local function variable(name)
  return ("\0" .. (engine.read_file "/proc/self/environ" or "")):match("%z" .. name .. "=(%Z+)")
end

--- Job and task of Slurm that this process belongs to; nil if to none.
function claims.batch_job()
  return variable "SLURM_ARRAY_JOB_ID", variable "SLURM_ARRAY_TASK_ID"
end

local Office = {}
Office.__index = Office

local function path_of(office, name)
  return office.folder .. place .. "/" .. name
end

--- "lives", "dead" or "unknown": that can be seen at once of processes here, of others once their file changes or does not.
function Office:verdict(worker)
  local where, id, started = parts(worker)
  if where == self.host then
    return lives_here(worker, id, started) and "lives" or "dead"
  end
  local now, text = engine.clock(), engine.read_file(path_of(self, worker)) or ""
  local known = self.seen[worker]
  if not known or known.text ~= text then
    self.seen[worker] = { text = text, since = now, beats = known ~= nil }
    return known and "lives" or "unknown"
  elseif now - known.since > claims.patience then
    return "dead"
  end
  return known.beats and "lives" or "unknown"
end

--- Takes away a claim of a dead worker, but no other that stands there by then.
local function bury(office, name, worker)
  local grave = path_of(office, ("dead.%s.%s"):format(name, office.worker))
  if not engine.call(engine.rename, path_of(office, name), grave) then
    return -- somebody else did
  end
  if holder_in(grave) ~= worker then
    engine.link(grave, path_of(office, name))
  elseif parts(worker) ~= office.host then
    office.inherited[name] = true
  end
  engine.remove(grave)
end

--- This worker's file, anew if who took it for dead has removed it.
local function enter(office)
  local path = path_of(office, office.worker)
  if not office.heart or not engine.kind_of_path(path) then
    office.heart = engine.heart(path, office.worker, office.between)
  end
end

--- Whose claim it is, nil if nobody's.
function Office:holder(name)
  return holder_in(path_of(self, name))
end

--- True if the claim is this worker's from now on; else nil and the worker whose it is.
function Office:take(name)
  for _ = 1, 3 do
    local worker = self:holder(name)
    if worker == self.worker then
      return true -- also if the answer to its link was lost
    elseif worker and self:verdict(worker) ~= "dead" then
      return nil, worker
    elseif worker then
      bury(self, name, worker)
    else
      enter(self)
      engine.link(path_of(self, self.worker), path_of(self, name))
    end
  end
  return self:owns(name) or nil, "another worker"
end

--- True if the claim still is this worker's: one that slept too long counts as dead.
function Office:owns(name)
  return self:holder(name) == self.worker
end

function Office:release(name)
  if self:owns(name) then
    engine.remove(path_of(self, name))
  end
end

--- f(...) while this worker has the claim, if it can have it at once; whether it had.
function Office:try(name, f, ...)
  if not self:take(name) then
    return false
  end
  local answers = table.pack(engine.call(f, ...))
  self:release(name)
  if not answers[1] then
    error(answers[2], 0)
  end
  return table.unpack(answers, 1, answers.n)
end

--- The same, waiting for the claim; what f returns.
function Office:alone(name, f, ...)
  local pause, answers = 0.02, table.pack(self:try(name, f, ...)) -- s
  while not answers[1] do
    engine.await({}, pause)
    pause = math.min(1.5 * pause, 1)
    if engine.stopped() then
      fault.run("stopped by the user")
    end
    answers = table.pack(self:try(name, f, ...))
  end
  return table.unpack(answers, 2, answers.n)
end

--- Tells others of itself, from its next beat on.
function Office:tell(words)
  self.told = words
  engine.tell_heart(self.heart, engine.encode_json(words))
end

--- The time, a few seconds ago, by the clock of the folder's file system; nil if that cannot be said.
function Office:time()
  return engine.modified(path_of(self, self.worker))
end

--- Names of other workers of this role ("worker", "alone") that have a file in the folder.
function Office:others(role)
  local names = {}
  for _, path in ipairs(engine.list(self.folder .. place, false)) do
    local name = path:match("[^/]+$")
    names[#names + 1] = name ~= self.worker and parts(name) and name:find(role .. "+", 1, true) == 1 and name or nil
  end
  return names
end

--- What ended before this run found it taken over from a worker elsewhere; once.
function Office:inherits(name)
  local is = self.inherited[name]
  self.inherited[name] = nil
  return is or false
end

--- Leaves: nothing of this worker's stays. tidy: nor of dead ones.
function Office:close(tidy)
  offices[self.folder] = nil
  engine.stop_heart(self.heart)
  engine.remove(path_of(self, self.worker))
  for _, path in ipairs(engine.list(self.folder .. place, false)) do
    local name, worker = path:match("[^/]+$"), holder_in(path)
    local is_worker = parts(name) ~= nil
    if worker == self.worker then
      engine.remove(path)
    elseif tidy and worker and self:verdict(is_worker and name or worker) == "dead" then
      if is_worker then
        engine.remove(path)
      else
        bury(self, name, worker)
      end
    end
  end
end

--- "process 12 on host", of a worker's name; "task 3 of job 12" with what it told.
function claims.words(worker, told)
  local where, id = parts(worker)
  local task = told and told.job and ("task %s of job %s, "):format(tostring(told.task), tostring(told.job)) or ""
  return where and ("%sprocess %s on %s"):format(task, id, where:match("^[^+]*")) or worker
end

--- The folder's claims as this process sees them. role: a word, by which Office.others finds it.
function claims.open(folder, role)
  local id, started = process("self")
  local own = host()
  local office = setmetatable({ folder = folder, host = own, seen = {}, inherited = {},
    between = role == "worker" and claims.between_beats or 1, -- s; workers may be many
    worker = ("%s+%s+%s+%s"):format(role, own, id, started) }, Office)
  engine.make_folder(folder .. place)
  enter(office)
  offices[folder] = office
  return office
end

--- What this process opened for the folder, nil if nothing.
function claims.of(folder)
  return offices[folder]
end

--- Whether what this worker made of a case may still be written: nobody else has taken the case over.
function claims.may_write(folder, name, worker)
  local holder = holder_in(folder .. place .. "/" .. name)
  return holder == nil or holder == worker
end

--- The time now by the clock of the folder's file system; nil if nothing can be written there.
local function time_there(folder)
  local path = ("%s/probe.%s"):format(folder, process("self"))
  if not engine.call(engine.write_file, path, "") then
    return nil
  end
  local now = engine.modified(path)
  engine.remove(path)
  return now
end

--- What a worker's file tells of it; {} if that cannot be read.
local function told_in(text)
  local told = engine.decode_json(text:match("^[^\n]*\n%d+\n(.*)$") or "")
  return type(told) == "table" and told or {}
end

--- Waits for a beat of those whose life their files' times do not show; clocks may differ.
local function watch(doubtful)
  local over = engine.clock() + claims.between_beats + 2
  while #doubtful > 0 and engine.clock() < over and not engine.stopped() do
    engine.await({}, 0.25)
    local still = {}
    for _, entry in ipairs(doubtful) do
      local text = engine.read_file(entry.path)
      if text and text ~= entry.text then
        entry.text, entry.age, entry.life = text, 0, "lives"
      else
        still[#still + 1] = entry
      end
    end
    doubtful = still
  end
end

--- One worker as its file shows it. age: s since it last gave a sign of life, nil if that cannot be said.
local function entry_of(path, own_host, now)
  local name = path:match("[^/]+$")
  local where, id, started = parts(name)
  local text, wrote = engine.read_file(path) or "", engine.modified(path)
  local age = now and wrote and now - wrote
  local entry = { name = name, path = path, text = text, age = age, here = where == own_host }
  if entry.here then
    entry.life = lives_here(name, id, started) and "lives" or "dead"
  elseif age and age > -2 and age <= 2 * claims.between_beats then
    entry.life = "lives"
  else
    entry.life = age and age > claims.patience and "dead" or "silent" -- unless it beats while it is watched
  end
  return entry
end

--- Who works in the folder, without entering it: list of {name =, life = "lives" | "silent" | "dead", age =, here =,
--- told =}, and the name of the worker by the claim that it has.
function claims.look(folder)
  local workers, holders, doubtful = {}, {}, {}
  local paths = engine.list(folder .. place, false)
  local now, own_host = #paths > 0 and time_there(folder .. place) or nil, host()
  for _, path in ipairs(paths) do
    local name = path:match("[^/]+$")
    if parts(name) and not name:find("^dead%.") then
      local entry = entry_of(path, own_host, now)
      workers[#workers + 1] = entry
      doubtful[#doubtful + 1] = not entry.here and entry.life ~= "lives" and entry or nil
    elseif not name:find("^[=.]") then
      holders[name] = holder_in(path)
    end
  end
  watch(doubtful)
  for _, entry in ipairs(workers) do
    entry.told = told_in(entry.text)
  end
  return workers, holders
end

return claims
