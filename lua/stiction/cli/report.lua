-- stiction report: one page on a study and what its output holds, which needs nothing else.
local engine = require "stiction.engine"
local fault = require "stiction.fault"
local outcomes = require "stiction.outcomes"
local report = require "stiction.report"
local study_page = require "stiction.study_page"

--- The folder itself, or that of a fit or a sample in it where nothing else was run.
local function folder_of(folder)
  for _, name in ipairs { "fit", "sample" } do
    local own = folder .. "/" .. name
    if not engine.kind_of_path(folder .. "/summary.csv") and engine.kind_of_path(("%s/%s.json"):format(own, name)) then
      return own
    end
  end
  return folder
end

return function(options)
  local outcome = outcomes.read(folder_of(outcomes.folder(options.study, options.out)))
  local file = options.to or outcome.folder .. "/report.html"
  if not file:find("%.html?$") then
    fault.input("--to: a page's name ends in .html, unlike %s", file)
  end
  local written, reason = engine.call(engine.write_file, file, study_page.write(outcome))
  if not written and not options.to and reason.kind ~= "stopped" then
    fault.input("cannot write %s; --to FILE puts the page elsewhere", file)
  elseif not written then
    error(reason, 0)
  end
  report.line("%s", file)
  return 0
end
