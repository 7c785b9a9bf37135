-- stiction extremes: every cell of a study run in a process of its own, its outcome judged, the map drawn.
local case_module = require "stiction.case"
local check = require "stiction.check"
local engine = require "stiction.engine"
local fault = require "stiction.fault"
local hold = require "stiction.hold"
local identity = require "stiction.identity"
local jobs = require "stiction.jobs"
local loader = require "stiction.loader"
local map = require "stiction.extremes.map"
local outcome = require "stiction.extremes.outcome"
local output = require "stiction.output"
local report = require "stiction.report"
local study_module = require "stiction.study"
local sweep = require "stiction.sweep"

local default_study = "extremes"
local of_a_cell = { "scene", "axis", "level", "want" } -- parameters
local seconds_of_a_cell = { quick = 120, full = 900 }

--- Bad input if these are not the cells of a map.
local function check_cells(study, cases)
  for _, name in ipairs(of_a_cell) do
    for _, case in ipairs(cases) do
      if type(rawget(case.p, name)) ~= "string" then
        fault.input("extremes: '%s' is no study of extremes: its case %s has no parameter '%s' (a text; each cell has %s)"
          .. "; 'stiction run' runs other studies, and without STUDY extremes drives its own", study.name, case.id, name,
          table.concat(of_a_cell, ", "))
      end
    end
  end
end

local function make_plan(options)
  local study = study_module.load(options.study, false)
  local cases, names = sweep.cases(study, options)
  check_cells(study, cases)
  if options.case then
    cases = { sweep.find(cases, options.case) }
  end
  return { study = study, cases = cases, names = names, folder = output.folder(study, options), options = options }
end

local function outcome_file(plan, case)
  return output.case_folder(plan.folder, case) .. "/outcome.json"
end

--- Rows {case =, outcome = nil | what an earlier run with the same files left}.
local function survey(plan)
  local rows = {}
  for i, case in ipairs(plan.cases) do
    local text = engine.read_file(outcome_file(plan, case))
    local kept = text and engine.decode_json(text)
    local fingerprint = output.fingerprint(plan.study, case)
    local whole = engine.hash(fingerprint .. identity.of_sources(plan.study, case))
    local current = kept and output.is_current(plan.study, kept, whole) and not plan.options.force
    rows[i] = { case = case, fingerprint = fingerprint, whole = whole, outcome = current and kept or nil }
  end
  return rows
end

local function run_cells(plan, rows)
  local pending, row_of, fingerprints, changed = {}, {}, {}, nil
  for _, row in ipairs(rows) do
    row_of[row.case.id], fingerprints[row.case.id] = row, row.fingerprint
    pending[#pending + 1] = not row.outcome and row.case or nil
  end
  local options = plan.options
  local limit = seconds_of_a_cell[options.quick and "quick" or "full"]
  local settings = { study = options.study, folder = plan.folder, quick = options.quick,
    jobs = math.floor(options.jobs or engine.cores()), threads = 1, limit = limit, tolerant = true, fingerprints = fingerprints,
    force = true }
  hold.note(plan.folder, plan.study)
  output.settle(plan.folder, plan.cases)
  local stopped = jobs.run(pending, settings, function(case, result)
    local row = row_of[case.id]
    if result.kind == "changed" then
      changed = result.reason
      return
    end
    row.outcome = outcome.of(result)
    row.outcome.fingerprint, row.outcome.files = row.whole, result.files
    engine.make_folder(output.case_folder(plan.folder, case))
    if row.outcome.letter ~= "H" and row.outcome.letter ~= "X" then
      engine.write_file(outcome_file(plan, case), engine.encode_json(row.outcome, 2) .. "\n")
    end
  end)
  if changed then
    fault.input("%s", changed)
  end
  return stopped
end

--- The converged cells as checks see them; holes in any history become the outcome of their cell.
local function converged(plan, rows)
  local list = {}
  for _, row in ipairs(rows) do
    local letter = row.outcome.letter
    local case = case_module.new(row.case.id, row.case.p, output.case_folder(plan.folder, row.case))
    if (letter == "C" or letter == "S") and outcome.holes(case) > 0 then
      row.outcome.letter, row.outcome.reason = "N", "a history holds numbers that are not finite"
    elseif letter == "C" then
      case.results, case.remarks = row.outcome.results, row.outcome.remarks
      list[#list + 1] = case
    end
  end
  return case_module.list(list, plan.options.quick)
end

--- Lets the checks speak: a failed one, or none at all, makes a converged cell a failure.
local function judge(rows, checks)
  local of_cell = {}
  for _, entry in ipairs(checks) do
    local id = entry.name:match("^([^:]+):")
    local own = of_cell[id] or { count = 0, failed = {} }
    own.count = own.count + 1
    if not entry.pass then
      own.failed[#own.failed + 1] = ("%s is %s, within %s"):format(entry.name:sub(#id + 3), tostring(entry.value),
        tostring(entry.tolerance))
    end
    of_cell[id] = own
  end
  for _, row in ipairs(rows) do
    outcome.judge(row, of_cell[row.case.id] or { count = 0, failed = {} })
  end
end

local function tell(rows)
  local counts, failures = outcome.count(rows)
  report.line()
  for _, row in ipairs(failures) do
    report.line("%s: %s: %s", row.case.id, outcome.word(row.outcome.letter), row.outcome.reason or "")
  end
  report.line("%d cells: %s", #rows, counts)
  return #failures == 0
end

local function list_cells(rows)
  for _, row in ipairs(rows) do
    report.line("%s  %s", row.case.id, row.outcome and outcome.word(row.outcome.letter) or "to run")
  end
  return 0
end

local function run(plan)
  local rows, options = survey(plan), plan.options
  if run_cells(plan, rows) then
    engine.complain("stiction: stopped; the cells that ended are kept, the same command goes on from here\n")
    return 1
  end
  local checks = check.run(plan.study, converged(plan, rows))
  output.write_checks(plan.folder, checks)
  judge(rows, checks)
  map.write(plan, rows)
  local drawn = options.no_figures or map.draw(plan, rows)
  local good = tell(rows)
  report.line("output: %s", plan.folder)
  return good and drawn and 0 or 1
end

return function(options)
  options.study = options.study or loader.own_study(default_study)
  local plan = make_plan(options)
  if options.list then
    return list_cells(survey(plan))
  end
  return hold.folder(plan.folder, plan.study, "extremes", run, plan)
end
