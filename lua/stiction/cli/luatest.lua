-- Runs a file of unit tests of this library; it receives test(name, function), equal, fails and shared(name), what the file of that
-- name in its folder `shared` returns, as `...`.
local engine = require "stiction.engine"
local fault = require "stiction.fault"

--- Fails unless the two are equal.
local function equal(got, wanted)
  if got ~= wanted then
    error(("got %s, wanted %s"):format(tostring(got), tostring(wanted)), 2)
  end
end

--- Fails unless f fails with a message that contains `part`.
local function fails(part, f, ...)
  local held, value = engine.call(f, ...)
  local message = tostring(value)
  if held then
    error("no error, wanted: " .. part, 2)
  elseif not message:find(part, 1, true) then
    error(("the message is '%s', wanted: %s"):format(message, part), 2)
  end
end

local function load(file)
  local text, reason = engine.read_file(file)
  local script = text and engine.load_script(text, file:match("[^/]+$"), _G)
  return script or fault.input("cannot load the tests %s: %s", file, reason or "syntax")
end

return function(options)
  local passed, failed = 0, 0
  local function test(name, f)
    local held, value = engine.call(f)
    if held then
      passed = passed + 1
    else
      failed = failed + 1
      engine.write(("FAILED %s: %s%s\n"):format(name, tostring(value), value.trace or ""))
    end
  end
  local function shared(name)
    return load((options.file:match("^.*/") or "") .. "shared/" .. name .. ".lua")()
  end
  load(options.file)(test, equal, fails, shared)
  engine.write(("%d passed, %d failed\n"):format(passed, failed))
  return failed == 0 and passed > 0 and 0 or 1
end
