-- Where a search begins: the study's own start, and points of Sobol's sequence between the bounds.
local sample = require "stiction.sample"
local space = require "stiction.fit.space"

local starts = {}

local seed = 1

--- `count` points in coordinates: first that of the parameters' own starts.
function starts.of(parameters, count)
  local own, axes, points = {}, {}, {}
  for k, parameter in ipairs(parameters) do
    own[k], axes[("p%03d"):format(k)] = parameter.start, { 0, 1 }
  end
  points[1] = space.inner(parameters, own)
  local drawn = count > 1 and sample.sobol { count = count - 1, seed = seed, of = axes } or {}
  for i = 1, count - 1 do
    points[i + 1] = {}
    for k in ipairs(parameters) do
      points[i + 1][k] = drawn[i][("p%03d"):format(k)]
    end
  end
  return points
end

return starts
