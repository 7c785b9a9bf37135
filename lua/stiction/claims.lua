-- Who does what in a folder that several runs share: a claim is a file that one of them linked there, so that it also holds
-- on file systems without locks. It names its worker, whose own file changes every few seconds as long as that lives.
local engine = require "stiction.engine"
local fault = require "stiction.fault"

local claims = {}

local between_beats, patience = 5, 60 -- s; patience: with a worker elsewhere whose file does not change
local place = "/.claims"

local function host()
  local name = engine.read_file "/proc/sys/kernel/hostname" or "unknown"
  local boot = engine.read_file "/proc/sys/kernel/random/boot_id" or ""
  return (name:gsub("[^%w.-]", "") .. "+" .. boot:sub(1, 8))
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

local Office = {}
Office.__index = Office

local function path_of(office, name)
  return office.folder .. place .. "/" .. name
end

--- Shows that this worker lives, now and then; true if it did.
function Office:beat()
  local now = engine.clock()
  if self.beaten and now - self.beaten < between_beats then
    return false
  end
  self.beaten, self.beats = now, self.beats + 1
  engine.make_folder(self.folder .. place)
  engine.write_file(path_of(self, self.worker), ("%d\n"):format(self.beats))
  return true
end

--- True if the worker lives, as far as can be seen: its process here, its file elsewhere.
local function lives(office, worker)
  local where, id, started = worker:match("^worker%+(.*)%+(%d+)%+(%d+)$")
  if where == office.host then
    return select(2, process(id)) == started
  end
  local now, beats = engine.clock(), engine.read_file(path_of(office, worker)) or ""
  local known = office.seen[worker]
  if not known or known.beats ~= beats then
    office.seen[worker] = { beats = beats, since = now }
    return true
  end
  return now - known.since < patience
end

--- Takes away a claim of a dead worker, but no other that stands there by then.
local function bury(office, name, worker)
  local grave = path_of(office, ("dead.%s.%s"):format(name, office.worker))
  if not engine.call(engine.rename, path_of(office, name), grave) then
    return -- somebody else did
  end
  if engine.read_file(grave) ~= worker then
    engine.link(grave, path_of(office, name))
  end
  engine.remove(grave)
end

--- True if the claim is this worker's from now on; else nil and the worker whose it is.
function Office:take(name)
  self:beat()
  local draft = path_of(self, "draft." .. self.worker)
  engine.write_file(draft, self.worker)
  for _ = 1, 3 do
    if engine.link(draft, path_of(self, name)) then
      engine.remove(draft)
      return true
    end
    local worker = engine.read_file(path_of(self, name))
    if worker == self.worker or worker and lives(self, worker) then
      engine.remove(draft)
      return worker == self.worker or nil, worker -- this one's: the answer to its link was lost
    elseif worker then
      bury(self, name, worker)
    end
  end
  engine.remove(draft)
  return nil, "another worker"
end

--- True if the claim still is this worker's: one that slept too long counts as dead.
function Office:owns(name)
  return engine.read_file(path_of(self, name)) == self.worker
end

function Office:release(name)
  if self:owns(name) then
    engine.remove(path_of(self, name))
  end
end

--- f(...) while this worker has the claim, for which it waits.
function Office:alone(name, f, ...)
  while not self:take(name) do
    engine.await({}, 0.02)
    if engine.stopped() then
      fault.run("stopped by the user")
    end
  end
  local answers = table.pack(engine.call(f, ...))
  self:release(name)
  if not answers[1] then
    error(answers[2], 0)
  end
  return table.unpack(answers, 2, answers.n)
end

--- Leaves: nothing of this worker's stays, and nothing of dead ones.
function Office:close()
  engine.remove(path_of(self, self.worker))
  for _, path in ipairs(engine.list(self.folder .. place, false)) do
    local name = path:match("[^/]+$")
    local is_worker = name:find("^worker%+")
    local worker = is_worker and name or engine.read_file(path) or ""
    if is_worker and not lives(self, worker) then
      engine.remove(path)
    elseif worker:find("^worker%+") and not lives(self, worker) then
      bury(self, name, worker)
    end
  end
end

--- "process 12 on host", of a worker's name.
function claims.words(worker)
  local where, id = worker:match("^worker%+([^+]*)%+.*%+(%d+)%+%d+$")
  return where and ("process %s on %s"):format(id, where) or worker
end

--- The folder's claims as this process sees them.
function claims.open(folder)
  local id, started = process("self")
  local own = host()
  return setmetatable({ folder = folder, host = own, beats = 0, seen = {},
    worker = ("worker+%s+%s+%s"):format(own, id, started) }, Office)
end

return claims
