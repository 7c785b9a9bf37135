-- Functions of scripts that are called with the wrong one of colon and dot say so.
local fault = require "stiction.fault"
local ordered = require "stiction.ordered"

local calls = {}

local mistakes = { "(...), with a colon, not ", "(...), with a dot, not " }

--- Whether a message is of such a call.
function calls.is_mistake(message)
  return message:find(mistakes[1], 1, true) or message:find(mistakes[2], 1, true)
end

local function pass(...)
  return ...
end

local function wrap(t, allowed, message)
  for _, name in ipairs(ordered.keys(t)) do
    local f = t[name]
    if type(f) == "function" then
      t[name] = function(first, ...)
        if not allowed(first) then
          fault.script(message, name, name)
        end
        return pass(f(first, ...)) -- no tail call: places are found by the frames that are there
      end
    end
  end
  return t
end

--- The table's functions, wrapped: they want what is_self holds for before the colon. word: what scripts call it.
function calls.methods(t, word, is_self)
  return wrap(t, is_self, ("write %s:%%s%s%s.%%s(...)"):format(word, mistakes[1], word))
end

--- The table's functions, wrapped: they stand behind a dot.
function calls.functions(t, word)
  local function is_other(first)
    return not rawequal(first, t)
  end
  return wrap(t, is_other, ("write %s.%%s%s%s:%%s(...)"):format(word, mistakes[2], word))
end

return calls
