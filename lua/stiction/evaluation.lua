-- Results of cases that have run, made from their histories: when they end, and anew when what makes them has changed.
local case_module = require "stiction.case"
local derivatives = require "stiction.derivatives"
local engine = require "stiction.engine"
local identity = require "stiction.identity"
local output = require "stiction.output"
local provenance = require "stiction.provenance"

local evaluation = {}

--- Writes into the result of a case that ran to its end what study.results makes of `run`: numbers, or the verdict that
--- one failed, with the places; and what that was made from.
function evaluation.fill(study, case, result, run)
  rawset(run, "cost", case_module.cost_of(result))
  local results, failures, missing = case_module.compute(study, run)
  result.results, result.missing = results, missing or nil
  result.derivatives = result.beside and derivatives.of_results(study, run, result.beside)
  result.verdict = #failures > 0 and "result failed" or "finished"
  result.reason = table.concat(failures, "\n")
  evaluation.note(study, case, result)
end

--- Notes what the case was made from.
function evaluation.note(study, case, result)
  result.case, result.parameters = case.id, output.plain(case.p)
  result.sources, result.files = identity.of_sources(study, case), identity.files_read(study, case)
end

--- A row as evaluation.row gives it, without its case's scene, of what output.read_result has read.
local function row_of(study, folder, case, result, mark, name)
  local of_sources = output.is_of_sources(study, case, result)
  local same = of_sources and not study.source.trust
  local row = { case = case, result = result, mark = mark, place = name,
    fingerprint = same and result.fingerprint or identity.of(study, case) }
  row.computed = output.is_computed(result, row.fingerprint)
    and (study.problem or engine.kind_of_path(folder .. "/" .. name .. "/series.h5") == "file") and true or false
  if row.computed then
    row.damaged, row.cut = output.damaged(folder .. "/" .. name, result)
    row.computed = not row.damaged
  end
  row.stale = row.computed and not study.problem and not of_sources
  row.adopted = row.stale and output.key_in(folder .. "/" .. name) ~= output.key(case) and name or nil
  row.done = row.computed and (row.stale or result.verdict == "finished")
  return row
end

--- What stands of a case in the folder: {case =, fingerprint =, result = nil | table, mark = of its file, place = name of
--- its folder, damaged, cut = its manifest, its history, where that is no longer as it was written, computed = it need not run
--- again, done = and has all its results, stale = these must be made anew, adopted = the folder of other parameters that it takes over}.
function evaluation.row(study, folder, case, many)
  local row = row_of(study, folder, case, output.read_result(folder, case))
  case.scene = not many and case.scene or nil -- thousands of them fill memory
  return row
end

--- The same of a case that has ended, nil of one that has not: its scene need not be made.
function evaluation.row_of_ended(study, folder, case)
  local result, mark, name = output.read_result(folder, case)
  if result and result.verdict ~= "stopped" then
    local row = row_of(study, folder, case, result, mark, name)
    case.scene = nil
    return row
  end
end

--- Notes in the case's folder, and what they were made of beside it, results made anew under these options.
local function keep(study, folder, row, options)
  local result = row.result
  result.run = result.run or {}
  result.run.quick, result.run.set = options.quick or false, options.set or {}
  provenance.keep(folder, study, result.files)
  output.write_result(folder, row.case, result)
end

--- Of what results may be off by, what a value tells to be still of it: not of curves, which may be others now.
local function numeric_errors(errors)
  local list = {}
  for name, its in pairs(errors) do
    list[name] = type(its) == "table" and its.value ~= nil and its or nil
  end
  return list
end

--- Makes the results of a row anew; with `options` also in its folder.
function evaluation.anew(study, folder, row, options)
  local case_folder, result = output.case_folder(folder, row.case), row.result
  result.errors = result.errors and numeric_errors(result.errors)
  local run = case_module.new(row.case.id, row.case.p, case_folder)
  local readable, reason = engine.call(engine.read_series, case_folder .. "/series.h5")
  if readable then
    evaluation.fill(study, row.case, result, run)
  elseif reason.kind == "stopped" then
    error(reason, 0)
  else
    result.results, result.verdict = {}, "result failed"
    result.reason = ("%s; 'stiction run STUDY --case %s --force' runs the case anew"):format(tostring(reason), row.case.id)
    options = nil -- what its folder holds cannot be made again
  end
  row.stale, row.done = false, result.verdict == "finished"
  if options then
    keep(study, folder, row, options)
  end
end

return evaluation
