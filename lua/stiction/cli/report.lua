-- stiction report: one page on a study and what its output holds, which needs nothing else.
local engine = require "stiction.engine"
local fault = require "stiction.fault"
local outcomes = require "stiction.outcomes"
local report = require "stiction.report"
local study_page = require "stiction.study_page"

return function(options)
  local outcome = outcomes.read(outcomes.folder(options.study, options.out))
  local file = options.to or outcome.folder .. "/report.html"
  if not file:find("%.html?$") then
    fault.input("--to: a page's name ends in .html, unlike %s", file)
  end
  engine.write_file(file, study_page.write(outcome))
  report.line("%s", file)
  return 0
end
