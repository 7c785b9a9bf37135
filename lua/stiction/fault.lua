-- Errors with a kind, and the place in the user's script that caused them.
local engine = require "stiction.engine"

local fault = {}

local function raise(kind, message)
  error(setmetatable({ kind = kind, message = message }, engine.error_metatable), 0)
end

--- Bad input: one message, exit code 2.
function fault.input(format, ...)
  raise("input", format:format(...))
end

--- What was loaded is no longer what is there: exit code 2, and nothing more is started.
function fault.changed(format, ...)
  raise("changed", format:format(...))
end

--- Bad input in the script: the message starts with the line of the script that is running.
function fault.script(format, ...)
  local place = engine.where()
  local message = format:format(...)
  error(place == "" and message or place .. ": " .. message, 0)
end

--- The run cannot go on: exit code 1.
function fault.run(format, ...)
  raise("run", format:format(...))
end

--- "; did you mean 'x'?" or "", for a word not in the list `known`.
function fault.meant(word, known)
  local near = engine.nearest(tostring(word), known)
  return near and ("; did you mean '%s'?"):format(near) or ""
end

return fault
