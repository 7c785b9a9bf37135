-- stiction figures: a study's figures again, from the output of its finished cases.
local case_module = require "stiction.case"
local drawing = require "stiction.drawing"
local engine = require "stiction.engine"
local evaluation = require "stiction.evaluation"
local fault = require "stiction.fault"
local hold = require "stiction.hold"
local output = require "stiction.output"
local report = require "stiction.report"
local study_module = require "stiction.study"
local sweep = require "stiction.sweep"

--- Text of the case's finished mark, which goes with the first word of a run anew.
local function mark(case_folder)
  return engine.read_file(case_folder .. "/manifest.json")
end

--- The cases whose folders hold a finished run, with results made anew where what makes them has changed; the number of
--- all, and whether what they ran has changed since.
local function finished(study, options, folder)
  local list, changed = {}, false
  local all = sweep.cases(study, options)
  for _, case in ipairs(all) do
    local row = evaluation.row(study, folder, case)
    local name = output.case_name(folder, case)
    local known = row.computed or output.key_in(folder .. "/" .. name) == output.key(case)
    local marked = mark(folder .. "/" .. name)
    if row.stale then
      evaluation.anew(study, folder, row)
    end
    if row.result and known and row.result.verdict == "finished" then
      changed = changed or not row.computed
      local entry = case_module.new(case.id, case.p, folder .. "/" .. name, name)
      entry.results, entry.mark = row.result.results, marked
      list[#list + 1] = entry
    end
  end
  return case_module.list(list, options.quick), #all, changed
end

--- False, and told, if a case was run anew since it was listed: figures may show what was half written.
local function still_the_same(cases)
  for _, case in ipairs(cases) do
    if mark(case.folder) ~= case.mark then
      engine.complain(("stiction: case %s was run anew while it was drawn; draw again when that has ended\n"):format(
        case.id))
      return false
    end
  end
  return true
end

local function draw(study, options, folder)
  local cases, count, changed = finished(study, options, folder)
  if not study.figures then
    fault.input("the study '%s' has no figures", study.name)
  elseif #cases == 0 then
    fault.input("no finished case in %s with these parameters; run the study first", folder)
  end
  if #cases < count then
    report.line("%d of %d cases finished with these parameters; the figures show these", #cases, count)
  end
  if changed then
    report.line("scenes, files in them or the program have changed since; the figures show what was run")
  end
  local drawn = drawing.draw(study, cases, folder)
  report.line("figures: %s/figures", folder)
  return still_the_same(cases) and drawn and 0 or 1
end

return function(options)
  local study = study_module.load(options.study, options.trust)
  sweep.tell_quick(study, options)
  local folder = output.folder(study, options)
  if engine.kind_of_path(folder) ~= "folder" then
    fault.input("no finished case in %s with these parameters; run the study first", folder)
  end
  hold.check_owner(folder, study)
  return drawing.alone(folder, draw, study, options, folder)
end
