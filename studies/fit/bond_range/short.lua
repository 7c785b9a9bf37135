-- The same with bonds of 0.1 um: JKR's limit, where the force knows their work alone.
local study = require "study"
local copy = {}
for key, value in pairs(study.definition.fit) do
  copy[key] = value
end
copy.data = { pull = { file = "short.csv", x = "height", y = "pull", sigma = study.definition.fit.data.pull.sigma,
  against = study.definition.fit.data.pull.against } }

return study:variant { title = "How far short bonds reach: what the pull-off of a sphere does not tell", fit = copy }
