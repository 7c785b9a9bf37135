-- What an audited ledger leaves open: the sum of energies against work put in and the scheme's predicted loss.
local fault = require "stiction.fault"

local ledger = {}

local terms = { "kinetic", "strain", "bond", "potential", "motion_work", "load_work", "damping_loss", "friction_loss",
  "bonding_loss" }
local if_any = { "spring", "dashpot_loss", "relaxation_loss", "surface" } -- springs, bodies that relax, surface stress

local function largest_of(values)
  local largest = 0
  for _, value in ipairs(values) do
    -- not a number must not pass
    largest = value == value and math.max(largest, math.abs(value)) or math.huge
  end
  return largest
end

--- Largest energy that the account of a case leaves open over its run, and its largest term.
function ledger.open(case, probe)
  local largest, there = 0, {}
  for _, column in ipairs(case:columns()) do
    there[column] = true
  end
  if not there[probe .. "/unaccounted"] then
    fault.script("case %s: its account says nothing of what is left open: %s must be stiction.probe.energy { audit = true }, which "
      .. "half spaces and formulas do not have; of those hold scheme_loss against motion_work", case.id, probe)
  end
  local function look(name)
    largest = math.max(largest, largest_of(case:series(probe, name)))
  end
  for _, name in ipairs(terms) do
    look(name)
  end
  for _, name in ipairs(if_any) do
    if there[probe .. "/" .. name] then
      look(name)
    end
  end
  if largest == 0 then
    fault.script("case %s: every term of its ledger is zero, there is nothing to hold it against", case.id)
  end
  return largest_of(case:series(probe, "unaccounted")), largest
end

return ledger
