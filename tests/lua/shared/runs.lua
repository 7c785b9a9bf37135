-- Cases of scenes that tests run one by one.
local case_module = require "stiction.case"
local engine = require "stiction.engine"
local stiction = require "stiction"

local runs = {}

--- run(scene): its case, with the result as `result` and without fields, in a folder of its own below this one.
function runs.below(folder)
  local count = 0
  return function(scene)
    count = count + 1
    local place = folder .. "/" .. count
    engine.make_folder(place)
    scene.output = stiction.output { frames = 0 }
    local result = engine.run(scene, { out = place, case_id = "case", manifest = "{}" }, function() end)
    local case = case_module.new("case", {}, place)
    rawset(case, "result", result)
    return case
  end
end

--- The same of scenes without inertia, which must finish.
function runs.quasi_static(folder)
  local run = runs.below(folder)
  return function(scene)
    scene.scheme = stiction.scheme.quasi_static {}
    local case = run(scene)
    if case.result.verdict ~= "finished" then
      error(("%s: %s"):format(case.result.verdict, case.result.reason), 2)
    end
    return case
  end
end

return runs
