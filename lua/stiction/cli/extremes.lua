-- stiction extremes: small scenes driven to their limits, and a map of how each ends.
local copy = require "stiction.copy"
local extremes = require "stiction.extremes"

return function(options)
  local own = copy(options)
  own.no_figures = options["no-figures"]
  return extremes(own)
end
