-- What lies between the instants of a history at its largest or smallest value, which finer steps at the same instants do not show.
local case_module = require "stiction.case"
local engine = require "stiction.engine"

local sampled = {}

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

--- Share of itself that a result, a function of study.results, may lack as it takes the largest or smallest value of a history by
--- run:max or run:min; 0 if it takes none.
function sampled.share(entry, case)
  local most = 0
  local run = case_module.new(case.id, case.p, case.folder, case.place)
  rawset(run, "at_extreme", function(values, k)
    local size = math.abs(values[k])
    most = size > 0 and math.max(most, sampled.beyond(values, k) / size) or most
  end)
  local held = engine.call(entry.compute, run, run.p)
  return held and most or 0
end

return sampled
