-- Runs a file of unit tests of this library: test(name, function), expect(...) and fails(...) inside.
local engine = require "stiction.engine"
local fault = require "stiction.fault"

--- The value, or the message of the error, of a protected call.
local function message_of(f, ...)
  local held, value = engine.call(f, ...)
  return held, tostring(value)
end

local tools = setmetatable({}, { __index = _G })

--- Fails unless the two are equal.
function tools.equal(got, wanted)
  if got ~= wanted then
    error(("got %s, wanted %s"):format(tostring(got), tostring(wanted)), 2)
  end
end

--- Fails unless f fails with a message that contains `part`.
function tools.fails(part, f, ...)
  local held, message = message_of(f, ...)
  if held then
    error("no error, wanted: " .. part, 2)
  elseif not message:find(part, 1, true) then
    error(("the message is '%s', wanted: %s"):format(message, part), 2)
  end
end

return function(options)
  local passed, failed = 0, 0
  function tools.test(name, f)
    local held, value = engine.call(f)
    if held then
      passed = passed + 1
    else
      failed = failed + 1
      engine.write(("FAILED %s: %s%s\n"):format(name, tostring(value), value.trace or ""))
    end
  end
  local text, reason = engine.read_file(options.file)
  if not text then
    fault.input("%s", reason)
  end
  local script, complaint = engine.load_script(text, options.file:match("[^/]+$"), tools)
  if not script then
    fault.input("%s", complaint)
  end
  script()
  engine.write(("%d passed, %d failed\n"):format(passed, failed))
  return (failed == 0 and passed > 0) and 0 or 1
end
