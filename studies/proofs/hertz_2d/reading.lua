-- What is read off a run of the line contact: when it carries the benchmark's force, and the pressure then.
local numeric = require("stiction").numeric

local reading = {}

--- The time at which the benchmark's force is reached; it must have been.
function reading.load_time(run, p)
  local force = numeric.map(run:series("force", "force_y"), function(f) return -f end)
  local wanted = p.force.si
  local last = numeric.first_where(force, function(f) return f >= wanted end)
  if not last then
    error(("the force only reaches %g N/m; drive deeper"):format(force[#force]))
  end
  local part = (wanted - force[last - 1]) / (force[last] - force[last - 1])
  return run.time[last - 1] + part * (run.time[last] - run.time[last - 1])
end

--- Pressures over x at that time: {x, p} of all points.
function reading.profile(run, p)
  local at, x, pressure = reading.load_time(run, p), {}, {}
  for k = 1, math.maxinteger do
    local found, X = pcall(run.series, run, "line", "X", k)
    if not found then
      break
    end
    x[k] = X[1]
    pressure[k] = run:at(at, "line", "pressure", k)
  end
  return x, pressure
end

return reading
