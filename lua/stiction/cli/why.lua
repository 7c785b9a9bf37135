-- stiction why: of each case whether a run would reuse it, and else what has changed from what to what.
local campaign = require "stiction.campaign"
local difference = require "stiction.difference"
local engine = require "stiction.engine"
local hold = require "stiction.hold"
local identity = require "stiction.identity"
local output = require "stiction.output"
local report = require "stiction.report"
local study_module = require "stiction.study"
local sweep = require "stiction.sweep"

local most = 12 -- changes told of a case

--- Why the results of a case that is reused are made anew.
local function why_anew(study, row)
  local file = identity.changed_file(study, row.result.files)
  if row.adopted then
    return (", from %s"):format(row.adopted)
  elseif file then
    return (", results anew: %s has changed"):format(engine.relative(file, study.source.folder))
  end
  return row.stale and ", results anew: parameters, files read or the library have changed" or ""
end

--- What keeps a result of this very scene from being reused.
local function why_again(row, folder)
  if output.is_computed(row.result, row.fingerprint) then
    return ("%s/series.h5 is gone"):format(folder)
  end
  return ("it ended: %s: %s"):format(row.result.verdict, row.result.reason or "")
end

--- Why a case must run, and a list of what changed.
local function why_run(plan, row)
  local folder = output.case_folder(plan.folder, row.case)
  local manifest = output.read_file(folder .. "/manifest.json")
  local kept = manifest and manifest.made_of
  local damaged = row.damaged or not row.result and output.unreadable(folder)
  if damaged then
    return damaged .. " is damaged", {}
  elseif row.result and row.result.fingerprint == row.fingerprint then
    return why_again(row, folder), {}
  elseif not manifest then
    return "it has not run", {}
  elseif type(kept) ~= "table" then
    return "an older version of the program ran it", {}
  elseif type(kept.scene) ~= "table" then
    return plan.study.problem and "the study, a file that it reads, or the program has changed"
      or "what ran it noted no scene", {}
  end
  local text, reason = identity.scene_text(plan.study, row.case)
  if not text then
    return reason, {}
  end
  local changes = difference.list(kept.scene, engine.decode_json(text))
  local program = identity.program()
  if kept.program ~= program then
    table.insert(changes, 1, { "the program", tostring(kept.program):sub(1, 12), program:sub(1, 12) })
  end
  return #changes > 0 and "it has changed" or "it began and did not end", changes
end

local function tell(plan, row)
  if row.computed then
    return report.line("%s  reused%s%s", row.case.id, why_anew(plan.study, row), row.cut and ("; %s is damaged"):format(row.cut) or "")
  end
  local reason, changes = why_run(plan, row)
  report.line("%s  to run: %s", row.case.id, reason)
  for i = 1, math.min(#changes, most) do
    report.line("  %s: %s -> %s", table.unpack(changes[i]))
  end
  if #changes > most then
    report.line("  and %d more", #changes - most)
  end
end

return function(options)
  local study = study_module.load(options.study, options.trust)
  sweep.tell_quick(study, options)
  local cases = sweep.cases(study, options)
  cases = options.case and { sweep.find(cases, options.case) } or cases
  local plan = { study = study, cases = cases, folder = output.folder(study, options), options = options }
  hold.check_owner(plan.folder, study)
  local rows, reused = campaign.survey(plan), 0
  for _, row in ipairs(rows) do
    tell(plan, row)
    reused = reused + (row.computed and 1 or 0)
  end
  report.line("%d case%s: %d reused, %d to run", #rows, #rows == 1 and "" or "s", reused, #rows - reused)
  return 0
end
