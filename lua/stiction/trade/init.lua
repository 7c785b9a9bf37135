-- stiction trade: runs a ladder of settings of one scene and tells what accuracy costs.
local campaign = require "stiction.campaign"
local case_module = require "stiction.case"
local copy = require "stiction.copy"
local drawing = require "stiction.drawing"
local engine = require "stiction.engine"
local exchange = require "stiction.trade.exchange"
local fault = require "stiction.fault"
local ladder = require "stiction.trade.ladder"
local output = require "stiction.output"
local pictures = require "stiction.trade.pictures"
local record = require "stiction.trade.record"
local report = require "stiction.report"
local study_module = require "stiction.study"
local sweep = require "stiction.sweep"
local units = require "stiction.units"

local combinations = 6 -- of knobs, run after the first round unless the study says otherwise

--- {name =, scale =} of each entry of study.trade.quantities, a name or { name =, scale = }.
local function read_quantities(study)
  local known, list = {}, {}
  for _, entry in ipairs(study.results) do
    known[entry.name] = true
  end
  for i, entry in ipairs(study.trade.quantities or {}) do
    local whole = type(entry) == "table"
    local name = whole and (entry.name or entry[1]) or entry
    if not known[name] then
      fault.input("study.trade.quantities: the study has no result '%s'", tostring(name))
    end
    list[i] = { name = name, scale = whole and units.si(entry.scale) or nil }
  end
  if #list == 0 then
    fault.input("study.trade.quantities lists no result of the study")
  end
  return list
end

--- A run as the analysis sees it.
local function run_of(row)
  local result = row.result
  local counts, finished = {}, result.verdict == "finished"
  for _, name in ipairs(record.counts) do
    counts[name] = result[name] or (result.counters or {})[name]
  end
  return {
    id = row.case.id, levels = row.case.levels, verdict = result.verdict, reason = result.reason,
    values = finished and result.results or nil, work = finished and result.counters.work or nil,
    seconds = finished and result.counters.cpu_seconds or nil, counts = counts, default = false, front = false,
  }
end

local function cases_at(all, wanted)
  local by_levels, list = {}, {}
  for _, case in ipairs(all) do
    by_levels[table.concat(case.levels, " ")] = case
  end
  for i, levels in ipairs(wanted) do
    list[i] = by_levels[table.concat(levels, " ")]
  end
  return list
end

--- Runs the cases at these levels, beside those of the rounds before, unless they are finished; gathers trade.runs.
--- What ended it early, if anything did.
local function run_round(trade, wanted)
  table.move(wanted, 1, #wanted, #trade.wanted + 1, trade.wanted)
  local plan = { study = trade.study, cases = cases_at(trade.all, trade.wanted), names = trade.names, folder = trade.folder,
    options = trade.options }
  local rows = campaign.survey(plan)
  local stopped = campaign.run(plan, rows)
  if campaign.bad_input(rows) then
    return "bad input"
  end
  trade.options.force, trade.runs = nil, {} -- one round runs anew what another did
  for i, row in ipairs(campaign.rows_with_result(rows)) do
    trade.runs[i] = run_of(row)
  end
  return stopped
end

local function is_valid(study, case)
  return (engine.call(campaign.validate, study, case))
end

--- Judges all runs so far against the reference made of them.
local function judge(trade)
  local references, reason = exchange.references(trade.knobs, trade.runs, trade.quantities)
  if not references then
    fault.run("%s", reason)
  end
  trade.references = references
  exchange.judge(trade.runs, references, trade.quantities)
  local default = table.concat(ladder.levels(trade.knobs), " ")
  for _, run in ipairs(trade.runs) do
    run.default, run.front = table.concat(run.levels, " ") == default, false
  end
  for _, run in ipairs(exchange.front(trade.runs)) do
    run.front = true
  end
end

local function second_round(trade, count)
  local wanted = exchange.promising(trade.knobs, trade.runs, trade.references, trade.quantities, count)
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

local function show(trade)
  local rows = { { "case", "verdict", "error/%", "bound/%", "work", "CPU s", "" } }
  for _, run in ipairs(trade.runs) do
    local words = (run.default and "default " or "") .. (run.front and "front" or "")
    rows[#rows + 1] = { run.id, run.verdict, percent(run.error), percent(run.bound),
      run.work and ("%.3g"):format(run.work) or "-", run.seconds and ("%.2f"):format(run.seconds) or "-", words }
  end
  report.line()
  report.table(rows)
  for _, quantity in ipairs(trade.quantities) do
    local reference = trade.references[quantity.name]
    report.line("%s: reference %.6g +- %.2g", quantity.name, reference.value, reference.uncertainty)
  end
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
  return {
    study = study, options = options, all = all, names = names, knobs = knobs, wanted = {}, runs = {},
    quick = options.quick or false, quantities = read_quantities(study), folder = options.out or output.folder(study, options) .. "/trade",
  }
end

--- Runs the ladder of a study's trade; its exit code.
return function(options)
  local trade = open_trade(options)
  output.prepare(trade.folder)
  local ended = run_round(trade, ladder.first_round(trade.knobs))
  if not ended then
    judge(trade)
    ended = second_round(trade, trade.study.trade.combinations or combinations)
  end
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
