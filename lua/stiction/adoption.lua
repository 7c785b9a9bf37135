-- Cases that ran under another name: what has the very scene of a case counts as its own, wherever in the folder it lies.
local engine = require "stiction.engine"
local output = require "stiction.output"

local adoption = {}

--- Names of the folders of cases that ended well and are whole, by their fingerprint, but for those that `used` names.
local function homeless(folder, used)
  local found = {}
  for _, path in ipairs(engine.list(folder, false)) do
    local name = path:match("[^/]+$")
    local result = not used[name] and output.read_result_in(path)
    if result and type(result.fingerprint) == "string" and output.is_computed(result, result.fingerprint)
      and engine.kind_of_path(path .. "/series.h5") == "file" and not output.damaged(path, result) then
      found[result.fingerprint] = { name = name, result = result }
    end
  end
  return found
end

--- Lets rows that would run take the folders of others that have run their scenes: row.adopted is that folder's name.
function adoption.find(plan, rows)
  local used, open = {}, {}
  for _, row in ipairs(rows) do
    used[row.computed and row.place or row.case] = true
    open[#open + 1] = not row.computed and row or nil
  end
  if #open == 0 or plan.study.problem then
    return
  end
  local found = homeless(plan.folder, used)
  for _, row in ipairs(open) do
    local other = found[row.fingerprint]
    if other then
      row.adopted, row.result, found[row.fingerprint] = other.name, other.result, nil
      row.computed, row.done, row.stale = true, true, true
    end
  end
end

local function in_hand(plan, row) return ("%s/%s@adopted"):format(plan.folder, row.case.id) end

--- Takes the folder that a row adopts out of the way of all others, which may be after each other's.
function adoption.lift(plan, row)
  engine.rename(plan.folder .. "/" .. row.adopted, in_hand(plan, row))
end

--- Gives a row the folder that was lifted for it; its results are to be made anew.
function adoption.take(plan, row)
  local own = plan.folder .. "/" .. row.case.id
  output.settle(plan.folder, { row.case })
  engine.remove(own)
  engine.rename(in_hand(plan, row), own)
  row.result.parameters = output.plain(row.case.p)
  output.write_result_in(own, row.result)
  row.adopted = nil
end

return adoption
