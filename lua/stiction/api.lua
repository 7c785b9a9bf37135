-- What a study sees of Stiction: made for each study, whose file names stand from its own folder on.
local calls = require "stiction.calls"
local claim = require "stiction.trade.claim"
local copy = require "stiction.copy"
local engine = require "stiction.engine"
local fault = require "stiction.fault"
local figure = require "stiction.figure"
local measured = require "stiction.measured"
local numeric = require "stiction.numeric"
local ordered = require "stiction.ordered"
local parts = require "stiction.parts"
local reference = require "stiction.reference"
local relaxation = require "stiction.relaxation"
local sample = require "stiction.sample"
local schemes = require "stiction.schemes"
local study = require "stiction.study"
local units = require "stiction.units"

local own = {
  version = engine.version,
  units = units.units,
  is_quantity = units.is_quantity,
  study = study.define,
  figure = figure,
  numeric = calls.functions(copy(numeric), "numeric"),
  reference = reference,
  relaxation = calls.functions(copy(relaxation), "relaxation"),
  schemes = calls.functions(copy(schemes), "schemes"),
  claim = claim,
  sample = sample.functions,
  explain = function(scene) return engine.explain(scene) end,
}

--- The table for studies in `folder`; nil: file names stand from the current folder on. note(path, text): told of files
--- that it reads.
return function(folder, note)
  local stiction = parts.constructors(folder)
  stiction.csv = function(t) return measured.read(t, folder, note) end
  for name, value in pairs(own) do
    stiction[name] = value
  end
  return setmetatable(stiction, {
    __index = function(_, name)
      fault.script("stiction has no '%s'%s; 'stiction help' lists what there is", tostring(name),
        fault.meant(name, ordered.keys(stiction)))
    end,
    __metatable = "stiction",
  })
end
