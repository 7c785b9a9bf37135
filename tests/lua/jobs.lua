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
