-- What a sweep makes of how the processes of its cases end.
local test, equal = ...
local engine = require "stiction.engine"
local jobs = require "stiction.jobs"

--- Result of a case whose process is this line of the shell instead.
local function ended(command)
  local spawn, found = engine.spawn, nil
  engine.spawn = function()
    return spawn({ "sh", "-c", command }, {}, true)
  end
  local held, reason = pcall(jobs.run, { { id = "a" } }, { study = "s", folder = "f", jobs = 1, quiet = true },
    function(_, result)
      found = result
    end)
  engine.spawn = spawn
  assert(held, reason)
  return found
end

local function fault(kind, code)
  return ended(([[echo '{ "fault": "the reason", "kind": "%s" }' >&3; exit %d]]):format(kind, code))
end

test("a fault ends a case with the verdict of its kind", function()
  for kind, verdict in pairs { stopped = "stopped", run = "failed", bug = "crashed" } do
    local result = fault(kind, 1)
    equal(result.verdict, verdict)
    equal(result.reason, "the reason")
    equal(result.bad_input, false)
  end
  for _, kind in ipairs { "input", "script", "changed" } do
    local result = fault(kind, 2)
    equal(result.verdict, "bad input")
    equal(result.bad_input, true)
  end
end)

test("a case's own end is told by the process that it came from, which serves on", function()
  local case = [[cat >/dev/null & echo '{ "fault": "the reason", "kind": "run" }' >&3; echo '{ "code": 1, "over": false }' >&3; wait]]
  equal(ended(case).verdict, "failed")
  equal(ended([[echo '{ "code": 139, "over": false }' >&3; exec cat >/dev/null]]).reason, "its process ended by signal 11")
end)

test("a process that ends without a word crashed, also by a signal that the user did not send", function()
  equal(ended("exit 3").reason, "its process ended with exit code 3")
  equal(ended("kill -TERM $$").reason, "its process ended by signal 15")
  equal(ended("kill -TERM $$").verdict, "crashed")
end)

--- The threads that each of so many cases is started with on eight cores.
local function threads_of(count, settings)
  local spawn, request, cores, cases, found = engine.spawn, engine.request, engine.cores, {}, {}
  for i = 1, count do
    cases[i] = { id = "c" .. i }
  end
  engine.spawn = function()
    return spawn({ "sh", "-c", "exit 1" }, {}, true)
  end
  engine.request = function(_, words)
    for i, word in ipairs(words) do
      found[#found + 1] = word == "--threads" and words[i + 1] or nil
    end
  end
  engine.cores = function() return 8 end
  settings.study, settings.folder, settings.quiet = "s", "f", true
  local held, reason = pcall(jobs.run, cases, settings, function() end)
  engine.spawn, engine.request, engine.cores = spawn, request, cores
  assert(held, reason)
  return table.concat(found, " ")
end

test("a case gets the threads that are asked for, or the cores that no other case needs", function()
  equal(threads_of(1, { jobs = 8 }), "8")
  equal(threads_of(2, { jobs = 8 }), "4 4")
  equal(threads_of(4, { jobs = 3 }):sub(1, 5), "2 2 2")
  equal(threads_of(2, { jobs = 1 }), "8 8")
  equal(threads_of(16, { jobs = 16 }):sub(1, 3), "1 1")
  equal(threads_of(2, { jobs = 8, threads = 3 }), "3 3")
end)
