-- What tests make of scenes without running them.
local engine = require "stiction.engine"

local scenes = {}

--- A copy of a table with the keys of another put in.
function scenes.with(base, more)
  local all = {}
  for _, part in ipairs { base, more or {} } do
    for key, value in pairs(part) do
      all[key] = value
    end
  end
  return all
end

--- explain's warning in these words: {text =, change =}; nil if there is none.
function scenes.warning(scene, words)
  for _, warning in ipairs(engine.explain(scene).warnings) do
    if warning.text:find(words, 1, true) then
      return warning
    end
  end
end

--- Does explain warn in these words?
function scenes.warned(scene, words)
  return scenes.warning(scene, words) ~= nil
end

return scenes
