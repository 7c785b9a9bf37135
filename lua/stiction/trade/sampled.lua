-- What lies between the instants of a history at its largest or smallest value, which finer steps at the same instants do not show, or
-- between instants that are results themselves.
local case_module = require "stiction.case"
local engine = require "stiction.engine"
local units = require "stiction.units"

local sampled = {}

local same = 1e-12 -- of the run's end: two instants
local abrupt = 10 -- times as much on one side of the extreme as on the other: it ends there by a jump

--- How far beyond its k-th value, an extreme of these, a history may go between two instants: up to the jump that ends it as it came,
--- or by what a parabola through three has at most; nothing at the ends.
function sampled.beyond(values, k)
  if k <= 1 or k >= #values then
    return 0
  end
  local before, after = math.abs(values[k] - values[k - 1]), math.abs(values[k + 1] - values[k])
  if math.max(before, after) <= abrupt * math.min(before, after) then
    return (before + after) / 8
  end
  local way = before < after and -1 or 1 -- to the gentle side
  local next_there = values[k + 2 * way] and math.abs(values[k + 2 * way] - values[k + way]) or 0
  local gentle = math.min(before, after)
  return math.max(gentle, math.abs(next_there - gentle) / 8)
end

--- The longer step beside the instant that is this value; 0 where none is, or at the ends.
local function step_at(times, value)
  for k = 2, #times - 1 do
    if math.abs(times[k] - value) <= same * times[#times] then
      return math.max(times[k] - times[k - 1], times[k + 1] - times[k])
    end
  end
  return 0
end

--- Share of itself that a result, a function of study.results, may lack as it takes the largest or smallest value of a history by
--- run:max or run:min, or is an instant of the run; 0 if it does neither.
function sampled.share(entry, case)
  local most = 0
  local run = case_module.new(case.id, case.p, case.folder, case.place)
  rawset(run, "at_extreme", function(values, k)
    local size = math.abs(values[k])
    most = size > 0 and math.max(most, sampled.beyond(values, k) / size) or most
  end)
  local held, value = engine.call(entry.compute, run, run.p)
  local size = held and math.abs(units.si(value) or 0) or 0
  if size > 0 and entry.unit == "s" then
    most = math.max(most, step_at(run.time, size) / size)
  end
  return held and most or 0
end

--- What the results of a finished case may lack for that, by name, SI; those that lack nothing are not in it.
function sampled.lacking(study, case, results)
  local list = {}
  for _, entry in ipairs(study.results) do
    local share = sampled.share(entry, case)
    list[entry.name] = share > 0 and results[entry.name] and share * math.abs(results[entry.name]) or nil
  end
  return list
end

return sampled
