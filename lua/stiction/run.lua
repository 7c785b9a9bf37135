-- One study from its script to its checks: its cases, its summary, its figures.
local accuracy = require "stiction.trade.accuracy"
local campaign = require "stiction.campaign"
local case_module = require "stiction.case"
local check = require "stiction.check"
local drawing = require "stiction.drawing"
local engine = require "stiction.engine"
local fault = require "stiction.fault"
local hold = require "stiction.hold"
local output = require "stiction.output"
local report = require "stiction.report"
local study_module = require "stiction.study"
local sweep = require "stiction.sweep"

local function list_cases(rows)
  for _, row in ipairs(rows) do
    report.line("%s  %s", row.case.id, row.done and "finished" or "to run")
  end
  return 0
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
  local checks = check.run(plan.study, cases, plan.accuracy)
  output.write_checks(plan.folder, checks)
  local good = report.checks(checks) == 0
  if not plan.options.no_figures then
    good = drawing.alone(plan.folder, drawing.draw, plan.study, cases, plan.folder) and good
  end
  return good
end

--- Outputs are only written for a plan: {study =, cases =, names =, folder =, options =}; where accuracy is asked for also
--- {accuracy =, claims =}.
local function make_plan(options)
  local study, own = study_module.load(options.study, options.trust), nil
  if options.accuracy or options.check_accuracy then
    options, own = accuracy.choose(study, options)
  elseif options.of then
    fault.input("--of names what --accuracy or --check-accuracy is about; give one of them")
  end
  local cases, names = sweep.cases(study, options)
  if options.case then
    sweep.find(cases, options.case)
  end
  return { study = study, cases = cases, names = names, folder = output.folder(study, options),
    options = options, accuracy = own, claims = own and accuracy.known(own, cases, options) }
end

--- What --check-accuracy asks for, and the summary with it; what ended it early, if anything.
local function recheck(plan, rows)
  local stopped = accuracy.recheck(plan, rows)
  campaign.write_summary(plan, rows)
  return stopped
end

--- Runs what is to run, judges and shows it; the exit code.
local function run(plan)
  local rows = campaign.survey(plan)
  engine.remove(plan.folder .. "/checks.json") -- of an earlier run: this one may not come so far
  local stopped = campaign.run(plan, rows)
  if campaign.bad_input(rows) then
    return 2
  end
  report.cases(plan.study, campaign.rows_with_result(rows))
  stopped = stopped or plan.options.check_accuracy and recheck(plan, rows)
  if stopped then
    engine.complain("stiction: stopped; finished cases are kept, the same command goes on from here\n")
    return 1
  end
  local good = judge(plan, rows)
  report.line("output: %s", plan.folder)
  return good and not any_failed(rows) and 0 or 1
end

--- Runs a study; its exit code, its output folder and its study table.
return function(options)
  local plan = make_plan(options)
  if options.quick and not next(plan.study.quick) then
    engine.complain("stiction: the study has no quick form, which is quick = { sweep = ..., set = ... }: it runs in full\n")
  end
  local code = options.list and list_cases(campaign.survey(plan)) or hold.folder(plan.folder, plan.study, "run", run, plan)
  return code, plan.folder, plan.study
end
