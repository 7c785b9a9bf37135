-- stiction trade: what accuracy costs in a study.
local copy = require "stiction.copy"
local trade = require "stiction.trade"

return function(options)
  local own = copy(options)
  own.no_figures = options["no-figures"]
  return trade(own)
end
