-- stiction figures: a study's figures again, from the output of its finished cases.
local case_module = require "stiction.case"
local drawing = require "stiction.drawing"
local engine = require "stiction.engine"
local fault = require "stiction.fault"
local output = require "stiction.output"
local report = require "stiction.report"
local study_module = require "stiction.study"
local sweep = require "stiction.sweep"

--- True if the result is one of the case's present parameters.
local function is_of(case, result)
  local present = engine.decode_json(engine.encode_json(output.plain(case.p)))
  return engine.encode_json(present) == engine.encode_json(result.parameters)
end

--- Text of the case's finished mark, which goes with the first word of a run anew.
local function mark(folder, case)
  return engine.read_file(output.result_file(folder, case))
end

--- The cases that finished with their present parameters, the number of all, and whether what they ran has changed since.
local function finished(study, options, folder)
  local list, changed = {}, false
  local all = sweep.cases(study, options)
  for _, case in ipairs(all) do
    local result = output.read_result(folder, case)
    if result and result.verdict == "finished" and is_of(case, result) then
      changed = changed or not output.is_done(result, output.fingerprint(study, case), study)
      local name = output.case_name(folder, case)
      local entry = case_module.new(case.id, case.p, folder .. "/" .. name, name)
      entry.results, entry.mark = result.results, mark(folder, case)
      list[#list + 1] = entry
    end
  end
  return case_module.list(list, options.quick), #all, changed
end

--- False, and told, if a case was run anew since it was listed: figures may show what was half written.
local function still_the_same(cases, folder)
  for _, case in ipairs(cases) do
    if mark(folder, case) ~= case.mark then
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
    report.line("the study, a file that it reads or the program has changed since; the figures show what was run")
  end
  local drawn = drawing.draw(study, cases, folder)
  report.line("figures: %s/figures", folder)
  return still_the_same(cases, folder) and drawn and 0 or 1
end

return function(options)
  local study = study_module.load(options.study, options.trust)
  local folder = output.folder(study, options)
  if engine.kind_of_path(folder) ~= "folder" then
    fault.input("no finished case in %s with these parameters; run the study first", folder)
  end
  return drawing.alone(folder, draw, study, options, folder)
end
