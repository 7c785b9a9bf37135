-- stiction trade: runs a ladder of settings of one scene and tells what accuracy costs.
local campaign = require "stiction.campaign"
local case_module = require "stiction.case"
local claim = require "stiction.trade.claim"
local copy = require "stiction.copy"
local drawing = require "stiction.drawing"
local engine = require "stiction.engine"
local exchange = require "stiction.trade.exchange"
local fault = require "stiction.fault"
local hold = require "stiction.hold"
local ladder = require "stiction.ladder"
local numeric = require "stiction.numeric"
local output = require "stiction.output"
local pictures = require "stiction.trade.pictures"
local quantity_module = require "stiction.trade.quantity"
local record = require "stiction.trade.record"
local reference = require "stiction.trade.reference"
local report = require "stiction.report"
local sampled = require "stiction.trade.sampled"
local study_module = require "stiction.study"
local sweep = require "stiction.sweep"

local combinations = 6 -- of knobs, run after the first round unless the study says otherwise

--- The first judged quantity that is no number in a finished run, nil if there is none.
local function missing(quantities, results)
  for _, quantity in ipairs(quantities) do
    if not quantity.curve and not quantity.watched and not numeric.is_finite(results[quantity.name]) then
      return quantity.name
    end
  end
end

local function case_of(trade, row)
  return case_module.new(row.case.id, row.case.p, output.case_folder(trade.folder, row.case))
end

local function curves_of(trade, row)
  local case, curves = case_of(trade, row), {}
  for _, quantity in ipairs(trade.quantities) do
    curves[quantity.name] = quantity.curve and quantity_module.curve(quantity, case) or nil
  end
  return curves
end

--- A run as the analysis sees it; one without all its quantities counts as unfinished.
local function run_of(trade, row)
  local result = row.result
  local run = { id = row.case.id, levels = row.case.levels, verdict = result.verdict, reason = result.reason,
    counts = {}, default = false, front = false }
  for _, name in ipairs(record.counts) do
    run.counts[name] = result[name] or (result.counters or {})[name]
  end
  if result.verdict ~= "finished" then
    return run
  end
  local absent = missing(trade.quantities, result.results)
  if absent then
    run.verdict = "no " .. absent
    return run
  end
  run.values, run.curves = copy(result.results), curves_of(trade, row)
  run.lacking = sampled.lacking(trade.study, case_of(trade, row), result.results)
  run.work, run.seconds = result.counters.work, result.counters.cpu_seconds
  return run
end

local function cases_at(all, wanted)
  local by_levels, list = {}, {}
  for _, case in ipairs(all) do
    by_levels[ladder.key(case.levels)] = case
  end
  for i, levels in ipairs(wanted) do
    list[i] = by_levels[ladder.key(levels)]
  end
  return list
end

--- Runs the cases at these levels, beside those of the rounds before, unless they are finished; gathers trade.runs.
--- What ended it early, if anything did.
local function run_round(trade, wanted)
  table.move(wanted, 1, #wanted, #trade.wanted + 1, trade.wanted)
  local plan = { study = trade.study, cases = cases_at(trade.all, trade.wanted), names = trade.names,
    folder = trade.folder, options = trade.options, curves = trade.quantities }
  local rows = campaign.survey(plan)
  claim.require_read(trade.study, trade.knobs)
  local stopped = campaign.run(plan, rows)
  if campaign.bad_input(rows) then
    return "bad input"
  end
  trade.options.force, trade.runs = nil, {} -- one round runs anew what another did
  for i, row in ipairs(campaign.rows_with_result(rows)) do
    trade.runs[i] = run_of(trade, row)
  end
  return stopped
end

local function is_valid(study, case)
  return (engine.call(campaign.validate, study, case))
end

--- Quantities of which every finished run has a number: all that are judged, the watched ones where they exist.
local function present(trade)
  local list = {}
  for _, quantity in ipairs(trade.quantities) do
    local everywhere = true
    for _, run in ipairs(quantity.watched and trade.runs or {}) do
      everywhere = everywhere and (not run.values or numeric.is_finite(run.values[quantity.name]))
    end
    list[#list + 1] = everywhere and quantity or nil
  end
  return list
end

--- Judges all runs so far against the reference made of them.
local function judge(trade)
  trade.quantities = present(trade)
  for _, quantity in ipairs(trade.quantities) do
    if quantity.curve then
      quantity_module.align(quantity, trade.runs)
    end
  end
  local references, reason = reference.all(trade.knobs, trade.runs, trade.quantities)
  if not references then
    fault.run("%s", reason)
  end
  trade.references = references
  exchange.judge(trade.runs, references, trade.quantities)
  local default = ladder.key(ladder.levels(trade.knobs))
  for _, run in ipairs(trade.runs) do
    run.default, run.front = ladder.key(run.levels) == default, false
  end
  for _, run in ipairs(exchange.front(trade.runs)) do
    run.front = true
  end
end

local function promising(trade, count)
  return exchange.promising(trade.knobs, trade.runs, trade.references, trade.quantities, count)
end

local function neighbours(trade, count)
  return exchange.neighbours(trade.knobs, trade.runs, count)
end

--- Judges the runs so far and runs the combinations that choose(trade, count) wants and that are valid scenes; what
--- ended it early, if anything did.
local function combine(trade, choose)
  judge(trade)
  local wanted = choose(trade, trade.study.trade.combinations or combinations)
  local valid = {}
  for i, case in ipairs(cases_at(trade.all, wanted)) do
    if is_valid(trade.study, case) then
      valid[#valid + 1] = wanted[i]
    end
  end
  return #valid > 0 and run_round(trade, valid) or nil
end

local function percent(x)
  return x and ("%.3g"):format(100 * x) or "-"
end

local function show_references(trade)
  for _, quantity in ipairs(trade.quantities) do
    local its = trade.references[quantity.name]
    local value = quantity.curve and "a curve" or ("%.6g"):format(its.value)
    local doubt = quantity.curve and percent(its.uncertainty / its.scale) .. " %" or ("%.2g"):format(its.uncertainty)
    if not quantity.watched then
      report.line("%s: reference %s%s", quantity.name, value, quantity.exact and ", exact" or " +- " .. doubt)
    end
  end
  for _, quantity in ipairs(trade.quantities) do
    local its = trade.references[quantity.name]
    if its.doubt and not quantity.watched then
      report.line("remark: the uncertainty of %s is not known: %s", quantity.name, its.doubt)
    end
  end
end

--- Where the scene's model is a knob: what each rung is off by with the other settings at their default.
local function show_rungs(trade)
  local by_levels = ladder.index(trade.runs)
  for _, knob in ipairs(trade.knobs) do
    for level, model in ipairs(knob.name == "model" and knob.levels or {}) do
      local run = by_levels[ladder.key(ladder.levels(trade.knobs, { model = level }))]
      if run and run.error then
        report.line("model %s: off by %s %%, %s", tostring(model), percent(run.error),
          model == "formula" and "the error of the model alone" or "those of the model and of its resolution")
      end
    end
  end
end

local function show(trade)
  local rows = { { "case", "verdict", "error/%", "bound/%", "work", "CPU s", "" } }
  for _, run in ipairs(trade.runs) do
    local words = (run.default and "default " or "") .. (run.front and "front" or "")
    rows[#rows + 1] = { run.id, run.verdict, percent(run.error), percent(run.bound),
      run.work and ("%.3g"):format(run.work) or "-", run.seconds and ("%.2f"):format(run.seconds) or "-", words }
  end
  report.line()
  report.table(rows)
  show_rungs(trade)
  show_references(trade)
end

local function finished_cases(trade)
  local list = {}
  for i, run in ipairs(trade.runs) do
    list[i] = case_module.new(run.id, {}, trade.folder .. "/" .. run.id)
  end
  return case_module.list(list, trade.quick)
end

local function open_trade(options)
  local study = study_module.load(options.study, options.trust)
  options = copy(options)
  options.trade = true
  local all, names, knobs = sweep.trade(study, options)
  local default = cases_at(all, { ladder.levels(knobs) })[1]
  return {
    study = study, options = options, all = all, names = names, knobs = knobs, wanted = {}, runs = {},
    quick = options.quick or false, quantities = quantity_module.list(study, default.p),
    folder = options.out or output.folder(study, options) .. "/trade",
  }
end

local function run(trade, options)
  local ended = run_round(trade, ladder.first_round(trade.knobs))
  ended = ended or combine(trade, promising) or combine(trade, neighbours)
  if ended then
    return ended == "bad input" and 2 or 1
  end
  judge(trade)
  record.write_csv(trade)
  record.write_json(trade, not trade.quick and not options.set)
  show(trade)
  local drawn = options.no_figures
    or drawing.draw({ figures = function() return pictures.of(trade) end }, finished_cases(trade), trade.folder)
  report.line("output: %s", trade.folder)
  return drawn and 0 or 1
end

--- Runs the ladder of a study's trade; its exit code.
return function(options)
  local trade = open_trade(options)
  return hold.folder(trade.folder, trade.study, "trade", run, trade, options)
end
