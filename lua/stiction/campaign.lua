-- Cases to run, those already finished left out: what `stiction run` and `stiction trade` share.
local adoption = require "stiction.adoption"
local claims = require "stiction.claims"
local derivatives = require "stiction.derivatives"
local engine = require "stiction.engine"
local evaluation = require "stiction.evaluation"
local fault = require "stiction.fault"
local jobs = require "stiction.jobs"
local hold = require "stiction.hold"
local numeric = require "stiction.numeric"
local ordered = require "stiction.ordered"
local output = require "stiction.output"
local problem = require "stiction.problem"
local rehearsal = require "stiction.rehearsal"
local report = require "stiction.report"
local sharing = require "stiction.sharing"
local summary = require "stiction.summary"
local warnings = require "stiction.warnings"

local campaign = {}

local patience = 20 -- times what writing the summary took, between two writings
local least = 60 -- s between two of any workers
local between_words = 1 -- s, between what a run tells other processes of itself
local many = 200 -- cases whose scenes are not all kept in memory

--- Says once what is swept and no scene asks for, which is often a slip of the pen, and which columns share a name.
local function tell_slips(plan)
  local study, first = plan.study, plan.cases[1] or {}
  local known = {}
  for _, name in ipairs(first.p and ordered.keys(first.p) or {}) do
    known[#known + 1] = not numeric.first_where(first.swept or {}, function(own) return own == name end) and name or nil
  end
  for _, name in ipairs(not study.told_unread and study:unread(first.swept or {}) or {}) do
    engine.complain(("stiction: no scene reads the swept parameter '%s'%s: all its values give the same scene\n"):format(name,
      fault.meant(name, known)))
    study.told_unread = true
  end
  for _, column in ipairs(study.told_doubled and {} or study.doubled) do
    engine.complain(("stiction: summary.csv has two columns '%s': a %s, and what %s; give the %s another name\n"):format(
      column.name, column.what, column.why, column.what))
    study.told_doubled = true
  end
end

local function is_wanted(plan, row) return not plan.wanted or plan.wanted[row.case.id] end

--- What stands of the plan's cases: rows as evaluation.row gives them.
function campaign.survey(plan)
  local rows, few = {}, #plan.cases <= many
  engine.watch_lines(few) -- of many, scenes are made again before they run
  for i, case in ipairs(plan.cases) do
    rows[i] = evaluation.row(plan.study, plan.folder, case, not few)
  end
  if not plan.points then
    adoption.find(plan, rows)
  end
  engine.watch_lines(true)
  tell_slips(plan)
  return rows
end

--- Makes results anew where what makes them has changed since, and says so. all: of every case that is wanted and has run.
local function evaluate(plan, rows, all)
  local count = 0
  for _, row in ipairs(rows) do
    if row.stale or all and is_wanted(plan, row) and row.computed and not plan.study.problem then
      evaluation.anew(plan.study, plan.folder, row, plan.options)
      count = count + 1
    end
  end
  if count > 0 and not plan.points then
    report.line("results of %d case%s made anew from %s", count, count > 1 and "s" or "",
      count > 1 and "their histories" or "its history")
  end
end

--- Bad input if the case's scene, or the problem in its place, cannot be, or if a result asks for a column that its
--- histories will not have; else what is known against the case (a list). curves: of a trade, or nil. ranks: that are to
--- share it, or nil.
function campaign.validate(study, case, curves, ranks)
  if study.problem and ranks then
    fault.input("a saved contact problem cannot be shared by several ranks; run it without --ranks")
  elseif study.problem then
    problem.read(study, case.p)
    return {}
  end
  local preview = engine.preview(study:scene_of(case))
  if ranks and preview.unfit_for_ranks then
    fault.input("the scene cannot be shared by several ranks: %s; run it without --ranks", preview.unfit_for_ranks)
  end
  if #study.derivatives > 0 then
    engine.check_beside(study:scene_of(case), derivatives.of(study, case))
  end
  local mistake = not study.source.trust and rehearsal.mistake(study, case, preview, curves) -- the trusted may write files
  if mistake then
    fault.input("%s", mistake)
  end
  return preview.warnings
end

--- Validates every case to come, so that bad input is told before anything runs; a list of {id =, warnings =}.
local function validate_all(study, cases, curves, ranks)
  local told = {}
  for i, case in ipairs(cases) do
    local held, value = engine.call(campaign.validate, study, case, curves, ranks)
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
      told[#told + 1] = row.computed and { id = row.case.id, warnings = row.result.warnings } or nil
    end
    warnings.refuse(told)
  end
end

--- Gives a row that has run the folder of its id.
local function settle_row(plan, row)
  if row.adopted then
    adoption.take(plan, row)
  end
  output.settle(plan.folder, { row.case })
  row.place = row.case.id
end

--- The folders of the cases that run or are shown are theirs from now on; of shared ones, those that will run get theirs
--- when they begin.
local function settle(plan, rows, pending)
  local function each(picks, act)
    for _, row in ipairs(rows) do
      if row.computed and picks(row) and plan.office then
        plan.office:alone(row.case.id, act, plan, row)
      elseif row.computed and picks(row) then
        act(plan, row)
      end
    end
  end
  each(function(row) return row.adopted end, adoption.lift)
  if not plan.office then
    output.settle(plan.folder, pending)
  end
  each(function(row) return row.adopted or row.place ~= row.case.id end, settle_row)
end

function campaign.rows_with_result(rows)
  local kept = {}
  for _, row in ipairs(rows) do
    if row.computed or row.fresh or row.elsewhere then
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
    if is_wanted(plan, row) and (plan.options.force or not row.computed) then
      local damaged = row.damaged or not row.result and output.unreadable(output.case_folder(plan.folder, row.case))
      if damaged and not row.told then
        report.line("%s is damaged: %s runs anew", damaged, row.case.id)
        row.told = true
      end
      pending[#pending + 1] = row.case
      if row.adopted then -- it runs anew all the same
        row.adopted, row.computed, row.done, row.stale = nil, false, false, false
      end
    end
  end
  return pending, fingerprints
end

--- Says which histories are no longer whole; they stay until the user says so.
local function tell_cut(plan, rows)
  for _, row in ipairs(rows) do
    if row.computed and row.cut and is_wanted(plan, row) and not plan.options.force then
      report.line("%s is damaged; its results are kept, 'stiction run STUDY --case %s --force' runs the case anew", row.cut, row.case.id)
    end
  end
end

local function write_now(plan, rows)
  local began = engine.clock()
  if plan.office and not engine.stopped() then -- no script runs any more
    sharing.refresh(plan, rows)
  end
  plan.others = not (plan.options.trade or plan.points) and (not plan.office and plan.others or summary.others(plan, rows)) or {}
  summary.write(plan, rows, plan.others)
  plan.written, plan.writing = engine.clock(), engine.clock() - began
end

--- Whether summary.csv is old enough to be written anew: of workers some one writes it, by the times of their files.
local function is_due(plan)
  local enough = patience * plan.writing
  if not plan.options.worker then
    return engine.clock() - plan.written > enough
  end
  local written = engine.modified(plan.folder .. "/summary.csv")
  return not written or (plan.office:time() or 0) - written > math.max(least, enough)
end

--- summary.csv of what there is so far.
function campaign.write_summary(plan, rows)
  if plan.office then
    plan.office:alone("=summary", write_now, plan, rows)
  else
    write_now(plan, rows)
  end
end

--- The same now and then: in a long sweep writing takes a small part of the time.
local function note_summary(plan, rows)
  if not is_due(plan) then
    return
  elseif plan.office then
    plan.office:try("=summary", write_now, plan, rows)
  else
    write_now(plan, rows)
  end
end

--- A function of the running jobs that tells other processes what this run does, now and then; and its tally, to be kept.
local function teller(plan, total)
  local office, job, task = claims.of(plan.folder), claims.batch_job()
  local tally, began, last = { done = 0, failed = 0 }, engine.clock(), -math.huge
  return function(running)
    local now = engine.clock()
    if not office or now - last < between_words then
      return
    end
    last = now
    local cases = {}
    for i, own in ipairs(running) do
      local p = own.progress or {}
      cases[i] = { case = own.case.id, seconds = now - own.began, time = p.time, end_time = p.end_time, step = p.step,
        left = p.seconds_left }
    end
    office:tell { total = total, done = tally.done, failed = tally.failed, seconds = now - began, cases = cases,
      job = job, task = task }
  end, tally
end

--- What a case ended with that could not say so itself is noted for it.
local function note_crash(plan, row)
  local result, folder = row.result, output.case_folder(plan.folder, row.case)
  if result.verdict == "crashed" and not result.fingerprint and output.key_in(folder) == output.key(row.case) then
    evaluation.note(plan.study, row.case, result)
    result.fingerprint = row.fingerprint
    output.write_result_in(folder, result)
  end
end

--- Makes what has run the plan's own, as it stands now.
local function revive(plan, rows, pending, all)
  hold.note(plan.folder, plan.study)
  settle(plan, rows, pending)
  evaluate(plan, rows, all)
  if plan.options.worker then
    plan.written, plan.writing = engine.clock(), 0
    note_summary(plan, rows)
  else
    campaign.write_summary(plan, rows)
  end
end

--- Tells what is wrong with the cases that are to run, as `run` does before it begins; how many they are.
function campaign.check(plan, rows)
  local pending = pending_cases(plan, rows)
  warn(validate_all(plan.study, pending, plan.curves, plan.options.ranks), rows, plan.options)
  return #pending
end

--- Runs what is to run, keeping summary.csv up to date; "stopped" if the user asked to stop, "left" if this worker leaves
--- the rest to another.
function campaign.run(plan, rows)
  local row_of, pending, fingerprints = {}, pending_cases(plan, rows)
  for _, row in ipairs(rows) do
    row_of[row.case.id] = row
  end
  local options = plan.options
  if not plan.tried and (not options.worker or options.strict) then -- cases of workers tell what is wrong with them
    warn(validate_all(plan.study, pending, plan.curves, plan.options.ranks), rows, options)
  end
  tell_cut(plan, rows)
  revive(plan, rows, pending)
  local settings = { study = options.study, folder = plan.folder, quick = options.quick, set = options.set,
    trust = options.trust, trade = options.trade, problems = options.problems,
    checkpoint = options.checkpoint, force = options.force,
    jobs = math.floor(options.jobs or math.max(1, engine.cores() // ((options.threads or 1) * (options.ranks or 1)))),
    threads = options.threads or (plan.office or options.trade) and 1, ranks = options.ranks,
    fingerprints = fingerprints, quiet = plan.points and not engine.terminal_width(), tolerant = plan.tried,
    worker = (claims.of(plan.folder) or {}).worker }
  local tally
  settings.tick, tally = teller(plan, #rows)
  local function on_end(case, result)
    local row = row_of[case.id]
    row.result, row.fresh, row.done, row.place = result, true, result.verdict == "finished", case.id
    row.computed = row.done or result.verdict == "result failed"
    tally.done, tally.failed = tally.done + 1, tally.failed + (row.done and 0 or 1)
    note_crash(plan, row)
    note_summary(plan, rows)
  end
  local stopped
  if plan.office then
    pending = options.worker and sharing.spread(pending, plan.office.worker) or pending
    stopped = sharing.run(plan, row_of, pending, settings, on_end)
  else
    stopped = jobs.run(pending, settings, on_end)
  end
  if (#pending > 0 or options.worker) and not (stopped and options.worker) then -- what others do they tell
    campaign.write_summary(plan, rows)
  end
  return stopped
end

--- Makes the results of all that is wanted and has run anew, and runs nothing.
function campaign.revisit(plan, rows)
  revive(plan, rows, {}, true)
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
