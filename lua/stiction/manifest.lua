-- The manifest of a case, as its run has written it.
local engine = require "stiction.engine"
local fault = require "stiction.fault"

local manifest = {}

--- The manifest in a case's folder, {} if there is none; bad input if it cannot be read.
function manifest.read(folder)
  local path = folder .. "/manifest.json"
  local text = engine.read_file(path)
  local value = text and engine.decode_json(text)
  if text and type(value) ~= "table" then
    fault.input("%s is damaged; 'stiction run STUDY --case ... --force' runs the case anew and writes it again", path)
  end
  return value or {}
end

return manifest
