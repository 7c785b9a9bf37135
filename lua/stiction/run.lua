-- One study from its script to its checks: its cases, its summary, its figures.
local accuracy = require "stiction.trade.accuracy"
local batch = require "stiction.batch"
local campaign = require "stiction.campaign"
local case_module = require "stiction.case"
local check = require "stiction.check"
local drawing = require "stiction.drawing"
local engine = require "stiction.engine"
local fault = require "stiction.fault"
local hold = require "stiction.hold"
local numeric = require "stiction.numeric"
local output = require "stiction.output"
local report = require "stiction.report"
local selection = require "stiction.selection"
local sharing = require "stiction.sharing"
local study_module = require "stiction.study"
local sweep = require "stiction.sweep"

local most_missing = 8 -- cases named

local function list_cases(plan)
  for _, row in ipairs(campaign.survey(plan)) do
    local wanted = not plan.options.where or plan.wanted[row.case.id]
    local line = wanted and report.line or function() end
    line("%s  %s", row.case.id, row.done and "finished" or row.computed and row.result.verdict or "to run")
  end
  return 0
end

--- Cases as checks and figures see them, finished ones only.
local function finished_cases(plan, rows)
  local list = {}
  for _, row in ipairs(rows) do
    if row.done then
      local case = case_module.new(row.case.id, row.case.p, plan.folder .. "/" .. row.place)
      case.results = row.result.results
      list[#list + 1] = case
    end
  end
  return case_module.list(list, plan.options.quick)
end

--- Has the case come to an end of its own? Where none is run (`anew`) also in an earlier run.
local function has_ended(row, anew)
  local before = anew and row.result and row.result.fingerprint == row.fingerprint and row.result.verdict ~= "stopped"
  return row.fresh or row.computed or row.elsewhere or before
end

local function any_failed(rows, anew)
  for _, row in ipairs(rows) do
    if has_ended(row, anew) and not row.done then
      return true
    end
  end
  return false
end

--- "mu0 (to run), mu0.4 (not converged)"
local function words_missing(rows, anew)
  local words = {}
  for _, row in ipairs(rows) do
    if not row.done then
      words[#words + 1] = ("%s (%s)"):format(row.case.id, has_ended(row, anew) and row.result.verdict or "to run")
    end
  end
  local shown = table.concat(words, ", ", 1, math.min(#words, most_missing))
  return #words > most_missing and ("%s and %d more"):format(shown, #words - most_missing) or shown
end

local function draw(plan, cases)
  return drawing.alone(plan.folder, drawing.draw, plan.study, cases, plan.folder)
end

--- f(...), which may not manage with cases missing; then says so. False if it went wrong otherwise.
local function try(what, f, ...)
  local held, value = engine.call(f, ...)
  if not held and value.kind == "stopped" then
    error(value, 0)
  elseif not held then
    report.line("no %s with cases missing: %s", what, tostring(value))
  end
  return held and value or nil
end

--- Figures of what there is, and checks of it once all have ended, although not all finished; whether that went well.
local function judge_part(plan, cases, rows)
  local anew = plan.options.anew
  local ended = numeric.first_where(rows, function(row) return not has_ended(row, anew) end) == nil
  report.line("%d of %d cases finished: %s; missing: %s", #cases, #rows,
    ended and "checks and figures of these" or "no checks until all are", words_missing(rows, anew))
  if #cases == 0 or plan.options.case then
    return true
  end
  local checks = ended and try("checks", check.run, plan.study, cases, plan.accuracy)
  if checks then
    output.write_checks(plan.folder, checks)
    report.checks(checks)
  end
  if plan.study.figures and not plan.options.no_figures then
    try("figures", draw, plan, cases)
  end
  return not ended
end

--- Checks and figures when every case of the sweep is there; whether all went well.
local function judge(plan, rows)
  local cases = finished_cases(plan, rows)
  if #cases < #rows then
    return judge_part(plan, cases, rows)
  end
  local held, checks = engine.call(check.run, plan.study, cases, plan.accuracy)
  local good = false
  if not held and checks.kind == "stopped" then
    error(checks, 0)
  elseif held then
    output.write_checks(plan.folder, checks)
    good = report.checks(checks) == 0
  end
  if not plan.options.no_figures then -- of these cases, even if checks went wrong
    good = draw(plan, cases) and good
  end
  if not held then
    error(checks, 0)
  end
  return good
end

--- The set of ids that --case and --where choose, nil for all.
local function chosen(study, cases, options)
  if options.case and options.where then
    fault.input("--case and --where both choose cases; give one of them")
  elseif options.case then
    return { [sweep.find(cases, options.case).id] = true }
  elseif not options.where then
    return nil
  end
  local ids = {}
  for _, case in ipairs(selection.filter(selection.of_parameters(study.name, cases), options.where)) do
    ids[case.name] = true
  end
  if not next(ids) then
    fault.input("--where '%s' holds for none of the %d cases; --list shows them", options.where, #cases)
  end
  return ids
end

--- Outputs are only written for a plan: {study =, cases =, names =, folder =, options =, wanted = ids to run, nil: all};
--- where accuracy is asked for also {accuracy =, claims =}.
local function make_plan(options)
  local study, own = study_module.load(options.study, options.trust), nil
  if options.accuracy or options.check_accuracy then
    options, own = accuracy.choose(study, options)
  elseif options.of then
    fault.input("--of names what --accuracy or --check-accuracy is about; give one of them")
  end
  local cases, names = sweep.cases(study, options)
  return { study = study, cases = cases, names = names, folder = output.folder(study, options),
    options = options, wanted = chosen(study, cases, options), accuracy = own, claims = own and accuracy.known(own, cases, options) }
end

--- Submits workers to a batch system once nothing is wrong with the cases to come; the exit code.
local function submit(plan)
  return batch.submit(plan, campaign.check(plan, campaign.survey(plan)))
end

--- What --check-accuracy asks for, what is known of errors kept, and the summary with it; what ended it early, if anything.
local function settle_errors(plan, rows)
  local stopped = plan.options.check_accuracy and accuracy.recheck(plan, rows)
  accuracy.keep(plan, rows)
  campaign.write_summary(plan, rows)
  return stopped
end

--- What a worker did that leaves the rest to others; the exit code.
local function left(rows)
  local done, failed = 0, 0
  for _, row in ipairs(rows) do
    done, failed = done + (row.fresh and 1 or 0), failed + (row.fresh and not row.done and 1 or 0)
  end
  report.line("this worker did %d case%s, %d failed", done, done == 1 and "" or "s", failed)
  return failed == 0 and 0 or 1
end

--- Runs what is to run, judges and shows it; the exit code.
local function run(plan)
  local rows = campaign.survey(plan)
  engine.remove(plan.folder .. "/checks.json") -- of an earlier run: this one may not come so far
  local stopped = campaign.run(plan, rows)
  if campaign.bad_input(rows) then
    return 2
  elseif stopped == "left" then
    plan.office.hasty = true
    return left(rows)
  end
  report.cases(plan.study, campaign.rows_with_result(rows))
  stopped = stopped or plan.claims and settle_errors(plan, rows)
  if stopped then
    engine.complain("stiction: stopped; finished cases are kept, the same command goes on from here\n")
    return 1
  end
  local good = judge(plan, rows)
  report.line("output: %s", plan.folder)
  return good and not any_failed(rows) and 0 or 1
end

local function complain_nothing_ran(plan)
  fault.input("no finished case of these scenes in %s; 'stiction why' says why, 'stiction run' runs them", plan.folder)
end

--- Results and checks of what has run, anew; the exit code.
local function revisit(plan)
  local rows = campaign.survey(plan)
  local known = campaign.rows_with_result(rows)
  if #known == 0 then
    complain_nothing_ran(plan)
  end
  engine.remove(plan.folder .. "/checks.json")
  campaign.revisit(plan, rows)
  report.cases(plan.study, known)
  local good = judge(plan, rows)
  report.line("output: %s", plan.folder)
  return good and not any_failed(rows, true) and 0 or 1
end

--- Whether others may run in the folder meanwhile.
local function is_shared(options)
  for _, name in ipairs(options.join and { "force", "check-accuracy" } or {}) do
    if options[name] then
      fault.input("--%s: a sweep that is shared takes no --%s; give that to a run of its own",
        options.on and "on" or options.worker and "worker" or "join", name)
    end
  end
  return options.join or options.case and not options.anew and not options.check_accuracy
end

--- Bad input where ranks are asked for and cannot be started.
local function check_ranks(options)
  if options.ranks and (options.accuracy or options.check_accuracy) then
    fault.input("--ranks is for the cases of a study; give no --accuracy or --check-accuracy with it")
  end
  local reason = options.ranks and not options.list and engine.why_no_ranks()
  if reason then
    fault.input("--ranks: %s", reason)
  end
end

--- Runs a study; its exit code, its output folder and its study table.
return function(options)
  batch.check(options)
  check_ranks(options)
  options.join = options.join or options.worker or options.on ~= nil
  options.jobs = options.jobs or options.worker and 1 or nil
  local plan = make_plan(options)
  sweep.tell_quick(plan.study, options)
  sweep.tell_twice(plan.study)
  local code
  if options.list then
    hold.check_owner(plan.folder, plan.study)
    code = list_cases(plan)
  elseif is_shared(options) and options.on then
    code = hold.shared(plan.folder, plan.study, "run", sharing.with, plan, submit)
  elseif is_shared(options) then
    code = hold.shared(plan.folder, plan.study, "run", sharing.with, plan, run)
  elseif options.anew then
    if engine.kind_of_path(plan.folder) ~= "folder" then
      complain_nothing_ran(plan)
    end
    code = hold.folder(plan.folder, plan.study, "results", revisit, plan)
  else
    code = hold.folder(plan.folder, plan.study, "run", run, plan)
  end
  return code, plan.folder, plan.study
end
