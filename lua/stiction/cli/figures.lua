-- stiction figures: a study's figures again, from the output of its finished cases.
local case_module = require "stiction.case"
local drawing = require "stiction.drawing"
local fault = require "stiction.fault"
local output = require "stiction.output"
local report = require "stiction.report"
local study_module = require "stiction.study"
local sweep = require "stiction.sweep"

local function finished(study, options, folder)
  local list = {}
  local all = sweep.cases(study, options)
  for _, case in ipairs(all) do
    local result = output.read_result(folder, case)
    if result and result.verdict == "finished" then
      local entry = case_module.new(case.id, case.p, output.case_folder(folder, case))
      entry.results = result.results
      list[#list + 1] = entry
    end
  end
  return case_module.list(list, options.quick), #all
end

return function(options)
  local study = study_module.load(options.study, options.trust)
  local folder = output.folder(study, options)
  local cases, count = finished(study, options, folder)
  if not study.figures then
    fault.input("the study '%s' has no figures", study.name)
  elseif #cases == 0 then
    fault.input("no finished case in %s; run the study first", folder)
  elseif #cases < count then
    report.line("%d of %d cases finished; the figures show these", #cases, count)
  end
  local drawn = drawing.draw(study, cases, folder)
  report.line("figures: %s/figures", folder)
  return drawn and 0 or 1
end
