-- Points of a study's parameters as cases: run several at a time, kept by their values, never run twice; what fit and sample share.
local campaign = require "stiction.campaign"
local case_module = require "stiction.case"
local engine = require "stiction.engine"
local fault = require "stiction.fault"
local output = require "stiction.output"
local sweep = require "stiction.sweep"
local warnings = require "stiction.warnings"

local points = {}

local Points = {}
Points.__index = Points

local accidents = { stopped = true, crashed = true, hung = true, ["bad input"] = true, ["output failed"] = true } -- not of the physics

--- What is known of a case that ended otherwise than well and would do so again.
local function is_failure(row)
  local result = row.result
  return result and not row.computed and not accidents[result.verdict] and result.fingerprint == row.fingerprint
end

--- The rows of new cases, beside all there were.
local function add(self, cases)
  local rows = campaign.survey { study = self.study, cases = cases, names = self.names, folder = self.folder,
    options = self.options, points = true }
  for i, row in ipairs(rows) do
    self.rows[#self.rows + 1], self.by_id[row.case.id] = row, row
    local kept = not self.options.force and (row.computed or is_failure(row))
    row.number, self.known = #self.rows, self.known + (kept and 1 or 0)
    cases[i].scene = nil
  end
  return rows
end

--- Bad input if the scene of none of these can be; tells what is known against the first that can.
local function validate(self, rows)
  local complaint
  for _, row in ipairs(rows) do
    if row.computed or is_failure(row) then
      return
    end
    local held, value = engine.call(campaign.validate, self.study, row.case)
    row.case.scene = nil
    if held then
      warnings.show { { id = row.case.id, warnings = value } }
      return
    elseif value.kind == "stopped" then
      error(value, 0)
    end
    complaint = complaint or value
  end
  error(complaint, 0)
end

--- Runs what has not run of these new rows; nothing is told but what is wrong with the very first ones.
local function run(self, rows)
  local wanted = {}
  for _, row in ipairs(rows) do
    wanted[row.case.id] = (self.options.force or not is_failure(row)) or nil
  end
  if not self.tried then
    validate(self, rows)
    self.tried = true
  end
  local began = engine.clock()
  local plan = { study = self.study, cases = self.cases, names = self.names, folder = self.folder, options = self.options,
    points = true, tried = true, wanted = wanted }
  local stopped = campaign.run(plan, self.rows)
  self.seconds = self.seconds + engine.clock() - began
  if stopped then
    fault.run("stopped; finished cases are kept, the same command goes on from here")
  end
  for _, row in ipairs(rows) do
    if row.fresh and row.result.kind == "changed" then
      fault.input("%s", row.result.reason)
    end
    self.ran = self.ran + (row.fresh and 1 or 0)
  end
end

--- The rows (as of evaluation.row) of points, each values by name, in their order. A row that did not end well has no `done`
--- and no `computed`; points.reason says why.
function Points:run(list)
  local fresh, ids, new = {}, {}, {}
  for i, values in ipairs(list) do
    local case = sweep.point(self.study, self.options, sweep.point_text(values))
    ids[i] = case.id
    if not self.by_id[case.id] and not new[case.id] then
      fresh[#fresh + 1], new[case.id] = case, true
      self.cases[#self.cases + 1] = case
    end
  end
  if #fresh > 0 then
    run(self, add(self, fresh))
  end
  local rows = {}
  for i, id in ipairs(ids) do
    rows[i] = self.by_id[id]
  end
  return rows
end

--- Why a row has no results.
function points.reason(row)
  local result = row.result or {}
  local words = (result.reason or ""):match("^[^\n]*")
  return (result.verdict or "not run") .. (words ~= "" and ": " .. words or "")
end

--- The run of a row that is computed, as results see it.
function Points:run_of(row)
  local case = case_module.new(row.case.id, row.case.p, output.case_folder(self.folder, row.case))
  case.results = row.result.results
  return case
end

--- Seconds that the cases themselves took, of all processors: of those that ran now.
function Points:cost()
  local sum = 0
  for _, row in ipairs(self.rows) do
    sum = sum + (row.fresh and row.result.seconds or 0)
  end
  return sum
end

--- Points of the study in this folder; names: of the parameters that change, for its summary.
function points.open(study, options, folder, names)
  return setmetatable({ study = study, options = options, folder = folder, names = names, cases = {}, rows = {}, by_id = {},
    known = 0, ran = 0, seconds = 0 }, Points)
end

return points
