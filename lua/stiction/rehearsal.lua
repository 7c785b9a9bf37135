-- A study's results tried before anything runs, on histories made up: which of them ask for a column that is not there?
local calls = require "stiction.calls"
local case_module = require "stiction.case"
local engine = require "stiction.engine"
local loader = require "stiction.loader"
local numeric = require "stiction.numeric"

local rehearsal = {}

local instructions = 1e6 -- that a result may take: made-up values may keep it from ending

-- Two of five values: what a script makes of the values themselves should not name the columns that it asks for.
local values = { { 1, 2, 3, 4, 5 }, { 9, 3.5, 2, 0.25, -1 } }

--- The message of this result on these values if it misses a column or takes a dot for a colon; nil if it does neither.
--- entry: {name =, compute =, unplaced = whether that may not be the script's own}.
local function mistake(entry, case, preview, list)
  local times = numeric.map({ 0, 1, 2, 3, 4 }, function(k) return preview.end_time * k / 4 end)
  local run = case_module.pretend(case, preview.columns, times, list)
  local held, fault = engine.call_within(math.tointeger(instructions), entry.compute, run, case.p)
  local message = held and "" or tostring(fault)
  local missing = rawget(run, "missing") and message:find(run.missing, 1, true)
  if missing and entry.unplaced then
    return run.missing
  end
  return (missing or calls.is_mistake(message)) and message .. (fault.trace or "") or nil
end

--- The message if it is the same whatever the values are.
local function lasting(what, entry, case, preview)
  local first = loader.silently(mistake, entry, case, preview, values[1])
  return first and loader.silently(mistake, entry, case, preview, values[2]) == first
    and ("%s %s: %s"):format(what, entry.name, first) or nil
end

--- The message of the first result of the case, or of the first of `curves` of a trade ({name =, curve =}), that makes
--- such a mistake whatever the values are; nil if none does.
function rehearsal.mistake(study, case, preview, curves)
  for _, entry in ipairs(study.results) do
    local message = lasting("result", entry, case, preview)
    if message then
      return message
    end
  end
  for _, entry in ipairs(curves or {}) do
    local curve = { name = entry.name, compute = entry.curve, unplaced = true }
    local message = entry.curve and lasting("curve", curve, case, preview)
    if message then
      return message
    end
  end
end

return rehearsal
