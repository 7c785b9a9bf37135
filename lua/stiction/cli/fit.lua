-- stiction fit: a study's parameters from measured curves.
local copy = require "stiction.copy"
local fit = require "stiction.fit"

return function(options)
  local own = copy(options)
  own.no_figures, own.no_profiles = options["no-figures"], options["no-profiles"]
  return fit(own)
end
