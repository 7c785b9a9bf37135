-- `stiction run --check-accuracy`: the cases again with each setting a level finer, and what they may be off by.
local campaign = require "stiction.campaign"
local case_module = require "stiction.case"
local claim = require "stiction.trade.claim"
local copy = require "stiction.copy"
local engine = require "stiction.engine"
local ladder = require "stiction.ladder"
local numeric = require "stiction.numeric"
local ordered = require "stiction.ordered"
local output = require "stiction.output"
local record = require "stiction.trade.record"
local report = require "stiction.report"
local sweep = require "stiction.sweep"

local recheck = {}

--- The case of `cases` whose parameters are p but for one knob.
local function twin(cases, p, variant)
  return cases[numeric.first_where(cases, function(case)
    return not numeric.first_where(ordered.keys(p), function(name)
      return not ladder.same(case.p[name], name == variant.knob and variant.value or p[name])
    end)
  end)]
end

--- Adds the twins of a row to the groups that share a setting: {setting =, options =, cases =, owners =}.
local function add_twins(plan, entry, groups)
  for i, variant in ipairs(entry.variants) do
    local setting = variant.knob .. "=" .. record.setting(variant.value)
    local group = groups[setting]
    if not group then
      group = { setting = setting, options = copy(plan.options), cases = {}, owners = {} }
      group.options.set = table.move(plan.options.set or {}, 1, #(plan.options.set or {}), 1, {})
      table.insert(group.options.set, setting)
      group.options.case = nil
      group.all, group.names = sweep.cases(plan.study, group.options)
      groups[setting], groups[#groups + 1] = group, group
    end
    group.cases[#group.cases + 1] = twin(group.all, entry.row.case.p, variant)
    group.owners[#group.cases] = { entry = entry, i = i }
  end
end

local function finished(plan, row)
  local case = case_module.new(row.case.id, row.case.p, output.case_folder(plan.folder, row.case))
  case.results = row.result.results
  return case
end

--- Runs one group; its cases land in their entries, or the reason why there is none. What ended it early, if anything.
local function run_group(plan, group)
  local own = { study = plan.study, cases = group.cases, names = group.names, options = group.options,
    folder = plan.folder .. "/finer/" .. group.setting:gsub("[^%w._+=-]", "_") }
  report.line("--check-accuracy: with %s", group.setting)
  output.prepare(own.folder)
  local rows = campaign.survey(own)
  local held, stopped = engine.call(campaign.run, own, rows)
  if not held and stopped.kind ~= "input" then
    error(stopped, 0)
  end
  for k, row in ipairs(rows) do
    local owner = group.owners[k]
    owner.entry.cases[owner.i] = row.done and finished(own, row) or nil
    owner.entry.reason = owner.entry.reason or not row.done
      and ("with %s: %s"):format(group.setting, held and (row.result or {}).reason or tostring(stopped)) or nil
  end
  return held and stopped or nil
end

--- Of rows that have finished, by the id of their case: what claim.judge says, or {reason = why it could not}; and what
--- ended it early, if anything.
function recheck.run(plan, rows)
  local knobs, entries, groups = claim.knobs(plan.study), {}, {}
  claim.require_read(plan.study, knobs)
  for _, row in ipairs(rows) do
    local entry = { row = row, variants = claim.variants(knobs, row.case.p), cases = {} }
    entries[#entries + 1] = entry
    add_twins(plan, entry, groups)
  end
  for _, group in ipairs(groups) do
    local stopped = run_group(plan, group)
    if stopped then
      return {}, stopped
    end
  end
  local claims = {}
  for _, entry in ipairs(entries) do
    local base = finished(plan, entry.row)
    claims[base.id] = entry.reason and { reason = entry.reason }
      or { of = claim.judge(plan.study, base, entry.variants, entry.cases) }
  end
  return claims
end

return recheck
