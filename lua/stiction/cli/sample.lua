-- stiction sample: how sure a study's results are, given how sure its parameters are.
local copy = require "stiction.copy"
local sampling = require "stiction.sampling"

return function(options)
  local own = copy(options)
  own.no_figures = options["no-figures"]
  return sampling(own)
end
