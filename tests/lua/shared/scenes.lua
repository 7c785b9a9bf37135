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

--- Does explain warn in these words?
function scenes.warned(scene, words)
  for _, warning in ipairs(engine.explain(scene).warnings) do
    if warning.text:find(words, 1, true) then
      return true
    end
  end
  return false
end

return scenes
