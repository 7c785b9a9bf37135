-- summary.csv: the whole truth about what is in an output folder: a row for each case that the study would reuse.
local engine = require "stiction.engine"
local evaluation = require "stiction.evaluation"
local output = require "stiction.output"
local sweep = require "stiction.sweep"

local summary = {}

--- True if the result of a row is of the case as the study has it now, however it ended.
function summary.is_current(row)
  return row.result ~= nil and (row.fresh or row.result.fingerprint == row.fingerprint)
end

--- The case in folder/name as a row, if it is another one than the plan's and the study would still reuse it under some
--- --set or --quick; else nil.
local function other_row(plan, name)
  local result = output.read_result_in(plan.folder .. "/" .. name)
  if not result or type(result.parameters) ~= "table" or type(result.case) ~= "string" then
    return nil
  end
  local held, case = engine.call(sweep.recall, plan.study, result.case, result.parameters)
  if not held or output.case_name(plan.folder, case) ~= name then
    return nil
  end
  local row = evaluation.row(plan.study, plan.folder, case, true)
  row.name = name
  return summary.is_current(row) and row.result.verdict ~= "stopped" and row or nil
end

--- Rows of the cases in the folder that are not among these but still current.
function summary.others(plan, rows)
  local used, others = {}, {}
  for _, row in ipairs(rows) do
    used[row.case.id], used[row.place] = true, true
  end
  for _, path in ipairs(engine.list(plan.folder, false)) do
    local name = path:match("[^/]+$")
    others[#others + 1] = not used[name] and other_row(plan, name) or nil
  end
  return others
end

--- Writes summary.csv: the rows that are current, then others.
function summary.write(plan, rows, others)
  local all = {}
  for _, list in ipairs { rows, others or {} } do
    for _, row in ipairs(list) do
      all[#all + 1] = summary.is_current(row) and row or nil
    end
  end
  output.write_summary(plan.folder, plan.study, plan.names, all, plan.claims)
end

return summary
