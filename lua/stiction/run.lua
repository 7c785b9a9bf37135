-- One study from its script to its checks: its cases, its summary, its figures.
local case_module = require "stiction.case"
local check = require "stiction.check"
local drawing = require "stiction.drawing"
local engine = require "stiction.engine"
local fault = require "stiction.fault"
local jobs = require "stiction.jobs"
local output = require "stiction.output"
local problem = require "stiction.problem"
local report = require "stiction.report"
local study_module = require "stiction.study"
local sweep = require "stiction.sweep"

--- Cases with what they left behind: list of {case =, result = nil | table, done =}.
local function survey(plan)
  local fingerprint = output.fingerprinter(plan.study)
  local rows = {}
  for i, case in ipairs(plan.cases) do
    local result = output.read_result(plan.folder, case)
    rows[i] = { case = case, result = result, done = output.is_done(result, fingerprint(case)) }
  end
  return rows
end

local function list_cases(rows)
  for _, row in ipairs(rows) do
    report.line("%s  %s", row.case.id, row.done and "finished" or "to run")
  end
  return 0
end

local function validate_case(study, p)
  if study.problem then
    problem.read(study, p)
  else
    engine.validate(study.scene(p))
  end
end

--- Validates every case to come, so that bad input is told before anything runs.
local function validate(study, cases)
  for _, case in ipairs(cases) do
    local held, value = engine.call(validate_case, study, case.p)
    if not held then
      if value.kind == "input" and #cases > 1 then
        fault.input("%s\n  (in case %s)", value.message, case.id)
      end
      error(value, 0)
    end
  end
end

local function rows_with_result(rows)
  local kept = {}
  for _, row in ipairs(rows) do
    if row.done or row.fresh then
      kept[#kept + 1] = row
    end
  end
  return kept
end

local function pending_cases(plan, rows)
  local pending = {}
  for _, row in ipairs(rows) do
    local wanted = not plan.options.case or row.case.id == plan.options.case
    if wanted and (plan.options.force or not row.done) then
      pending[#pending + 1] = row.case
    end
  end
  return pending
end

--- Runs what is to run, keeping summary.csv up to date; "stopped" if the user asked to stop.
local function run_cases(plan, rows)
  local pending, row_of = pending_cases(plan, rows), {}
  for _, row in ipairs(rows) do
    row_of[row.case.id] = row
  end
  validate(plan.study, pending)
  output.write_summary(plan.folder, plan.study, plan.names, rows_with_result(rows))
  local options = plan.options
  local settings = { study = options.study, folder = plan.folder, quick = options.quick, set = options.set,
    trust = options.trust, jobs = math.floor(options.jobs or engine.cores()) }
  return jobs.run(pending, settings, function(case, result)
    local row = row_of[case.id]
    row.result, row.fresh, row.done = result, true, result.verdict == "finished"
    output.write_summary(plan.folder, plan.study, plan.names, rows_with_result(rows))
  end)
end

--- Cases as checks and figures see them, finished ones only.
local function finished_cases(plan, rows)
  local list = {}
  for _, row in ipairs(rows) do
    if row.done then
      local case = case_module.new(row.case.id, row.case.p, output.case_folder(plan.folder, row.case))
      case.results = row.result.results
      list[#list + 1] = case
    end
  end
  return case_module.list(list, plan.options.quick)
end

--- First reason of bad input that a child reported, printed once.
local function bad_input(rows)
  for _, row in ipairs(rows) do
    if row.fresh and row.result.bad_input then
      engine.complain("stiction: " .. row.result.reason .. "\n")
      return true
    end
  end
end

local function any_failed(rows)
  for _, row in ipairs(rows) do
    if row.fresh and not row.done then
      return true
    end
  end
  return false
end

--- Checks and figures when every case of the sweep is there; whether all went well.
local function judge(plan, rows)
  local cases = finished_cases(plan, rows)
  if #cases < #rows then
    report.line("%d of %d cases finished: no checks, no figures until all are", #cases, #rows)
    return true
  end
  local checks = check.run(plan.study, cases)
  output.write_checks(plan.folder, checks)
  local good = report.checks(checks) == 0
  if not plan.options.no_figures then
    good = drawing.draw(plan.study, cases, plan.folder) and good
  end
  return good
end

--- Outputs are only written for a plan: {study =, cases =, names =, folder =, options =}.
local function make_plan(options)
  local study = study_module.load(options.study, options.trust)
  local cases, names = sweep.cases(study, options)
  if options.case then
    sweep.find(cases, options.case)
  end
  return { study = study, cases = cases, names = names, folder = output.folder(study, options), options = options }
end

--- Runs a study; its exit code, its output folder and its study table.
return function(options)
  local plan = make_plan(options)
  local rows = survey(plan)
  if options.list then
    return list_cases(rows), plan.folder, plan.study
  end
  output.prepare(plan.folder)
  local stopped = run_cases(plan, rows)
  if bad_input(rows) then
    return 2, plan.folder, plan.study
  end
  report.cases(plan.study, rows_with_result(rows))
  if stopped then
    engine.complain("stiction: stopped; finished cases are kept, the same command goes on from here\n")
    return 1, plan.folder, plan.study
  end
  local good = judge(plan, rows)
  report.line("output: %s", plan.folder)
  return good and not any_failed(rows) and 0 or 1, plan.folder, plan.study
end
