-- stiction solve: a saved contact problem again, with any solver, judged by the one residual.
local engine = require "stiction.engine"
local fault = require "stiction.fault"
local report = require "stiction.report"

local default_tolerance = 1e-10

return function(options)
  if engine.kind_of_path(options.file) ~= "file" then
    fault.input("solve: there is no file '%s'", options.file)
  end
  local answer = engine.solve(options.file, options.with or "all", options.tolerance or default_tolerance)
  if options.json then
    answer.text = nil
    engine.write(engine.encode_json(answer, 2) .. "\n")
  else
    report.line("%s", (answer.text:gsub("%s+$", "")))
  end
  return answer.converged and 0 or 1
end
