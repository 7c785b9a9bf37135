-- stiction run: a study, or all studies of a folder and one report of what they prove.
local collection = require "stiction.collection"
local run_study = require "stiction.run"

return function(options)
  options.no_figures, options.check_accuracy = options["no-figures"], options["check-accuracy"]
  local studies = collection.find(options.study)
  if studies then
    return collection.run(studies, options)
  end
  return (run_study(options))
end
