-- stiction results: results and checks of what has run, anew from the histories; no case runs.
local run_study = require "stiction.run"

return function(options)
  options.anew, options.no_figures = true, true
  return (run_study(options))
end
