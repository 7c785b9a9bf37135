-- Cases to run, those already finished left out: what `stiction run` and `stiction trade` share.
local engine = require "stiction.engine"
local fault = require "stiction.fault"
local jobs = require "stiction.jobs"
local hold = require "stiction.hold"
local output = require "stiction.output"
local problem = require "stiction.problem"
local rehearsal = require "stiction.rehearsal"
local warnings = require "stiction.warnings"

local campaign = {}

--- Cases with what they left behind: list of {case =, fingerprint =, result = nil | table, done =}.
function campaign.survey(plan)
  local rows = {}
  for i, case in ipairs(plan.cases) do
    local result, fingerprint = output.read_result(plan.folder, case), output.fingerprint(plan.study, case)
    rows[i] = { case = case, fingerprint = fingerprint, result = result,
      done = output.is_done(result, fingerprint, plan.study) }
  end
  return rows
end

--- Bad input if the case's scene, or the problem in its place, cannot be, or if a result asks for a column that its
--- histories will not have; else what is known against the case (a list). curves: of a trade, or nil.
function campaign.validate(study, case, curves)
  if study.problem then
    problem.read(study, case.p)
    return {}
  end
  local preview = engine.preview(study:scene_of(case))
  local mistake = not study.source.trust and rehearsal.mistake(study, case, preview, curves) -- the trusted may write files
  if mistake then
    fault.input("%s", mistake)
  end
  return preview.warnings
end

--- Validates every case to come, so that bad input is told before anything runs; a list of {id =, warnings =}.
local function validate_all(study, cases, curves)
  local told = {}
  for i, case in ipairs(cases) do
    local held, value = engine.call(campaign.validate, study, case, curves)
    if not held then
      if value.kind == "input" and #cases > 1 then
        fault.input("%s\n  (in case %s)", value.message, case.id)
      end
      error(value, 0)
    end
    told[i] = { id = case.id, warnings = value }
  end
  return told
end

--- Tells what is known against the cases to come, once for those alike; bad input with --strict, also for what finished.
local function warn(told, rows, options)
  if options.trade then
    return -- a ladder has its coarse levels
  end
  warnings.show(told)
  if options.strict then
    for _, row in ipairs(rows) do
      told[#told + 1] = row.done and { id = row.case.id, warnings = row.result.warnings } or nil
    end
    warnings.refuse(told)
  end
end

--- The folders of the cases that run or are shown are theirs from now on.
local function settle(plan, rows, pending)
  local cases = table.move(pending, 1, #pending, 1, {})
  for _, row in ipairs(rows) do
    cases[#cases + 1] = row.done and row.case or nil
  end
  output.settle(plan.folder, cases)
end

function campaign.rows_with_result(rows)
  local kept = {}
  for _, row in ipairs(rows) do
    if row.done or row.fresh then
      kept[#kept + 1] = row
    end
  end
  return kept
end

--- The cases to run, and the fingerprints of all by id.
local function pending_cases(plan, rows)
  local pending, fingerprints = {}, {}
  for _, row in ipairs(rows) do
    fingerprints[row.case.id] = row.fingerprint
    local wanted = not plan.options.case or row.case.id == plan.options.case
    if wanted and (plan.options.force or not row.done) then
      pending[#pending + 1] = row.case
    end
  end
  return pending, fingerprints
end

--- summary.csv of what has ended so far.
function campaign.write_summary(plan, rows)
  output.write_summary(plan.folder, plan.study, plan.names, campaign.rows_with_result(rows), plan.claims)
end

--- Runs what is to run, keeping summary.csv up to date; "stopped" if the user asked to stop.
function campaign.run(plan, rows)
  local row_of, pending, fingerprints = {}, pending_cases(plan, rows)
  for _, row in ipairs(rows) do
    row_of[row.case.id] = row
  end
  warn(validate_all(plan.study, pending, plan.curves), rows, plan.options)
  hold.note(plan.folder, plan.study)
  settle(plan, rows, pending)
  campaign.write_summary(plan, rows)
  local options = plan.options
  local settings = { study = options.study, folder = plan.folder, quick = options.quick, set = options.set,
    trust = options.trust, trade = options.trade, problems = options.problems,
    jobs = math.floor(options.jobs or engine.cores()), fingerprints = fingerprints }
  return jobs.run(pending, settings, function(case, result)
    local row = row_of[case.id]
    row.result, row.fresh, row.done = result, true, result.verdict == "finished"
    campaign.write_summary(plan, rows)
  end)
end

--- First reason of bad input that a child reported, printed once.
function campaign.bad_input(rows)
  for _, row in ipairs(rows) do
    if row.fresh and row.result.bad_input then
      engine.complain("stiction: " .. row.result.reason .. "\n")
      return true
    end
  end
end

return campaign
