-- Intervals by profile likelihood: how far a parameter may go, all others following, until the data say no.
local linear = require "stiction.fit.linear"
local loss_module = require "stiction.fit.loss"
local numeric = require "stiction.numeric"
local space = require "stiction.fit.space"

local profile = {}

local near_enough = 1.3 -- by which the root of the rise of squares may miss its mark: the end is then told by a straight line
local most_rounds, most_cut = 5, 4
local reach = 0.5 -- of coordinates, by which the others are corrected
local lower = 0.01 -- of the unit: a point so much lower than the best is another minimum

--- Where the others go as the k-th parameter's relative coordinate moves by delta, linearly.
local function moved(found, judged, i, delta)
  local z = table.move(found.z, 1, #found.z, 1, {})
  for j, k in ipairs(judged.free) do
    z[k] = z[k] + delta * judged.covariance[j][i] / judged.covariance[i][i] / judged.slopes[k]
  end
  return z
end

--- A point brought between the bounds; whether the k-th is at one.
local function inside(problem, z, k)
  local own = space.clipped(problem.parameters, z)
  return own, own[k] ~= z[k]
end

--- The point where all but the k-th parameter are corrected by the derivatives at the best point.
local function corrected(problem, found, judged, side)
  local others, columns = {}, {}
  for _, k in ipairs(judged.free) do
    others[#others + 1] = k ~= side.k and k or nil
  end
  if #others == 0 then
    return side.z
  end
  local own, slopes = loss_module.of(problem.loss, side.at.r)
  for i, k in ipairs(others) do
    columns[i] = found.J[k]
  end
  local step = linear.step(linear.scaled(columns, slopes), own, reach)
  local z = table.move(side.z, 1, #side.z, 1, {})
  for i, k in ipairs(others) do
    z[k] = z[k] + step[i]
  end
  return (space.clipped(problem.parameters, z))
end

local function cost_of(problem, answer)
  return answer.r and select(3, loss_module.of(problem.loss, answer.r))
end

local function sign(x)
  return x < 0 and -1 or 1
end

--- Evaluates the open sides where they stand, then with the others corrected.
local function look(problem, found, judged, open)
  local answers = problem.evaluate(numeric.map(open, function(side) return side.z end), "profile")
  local good = {}
  for i, side in ipairs(open) do
    side.at, side.cost = answers[i], cost_of(problem, answers[i])
    good[#good + 1] = side.cost and #judged.free > 1 and side or nil
  end
  local points = numeric.map(good, function(side) return corrected(problem, found, judged, side) end)
  local again = #good > 0 and problem.evaluate(points, "profile") or {}
  for i, side in ipairs(good) do
    local cost = cost_of(problem, again[i])
    if cost and cost < side.cost then
      side.z, side.at, side.cost = points[i], again[i], cost
    end
  end
end

--- What the last look at a side means: it is done, or where to look next.
local function settle(problem, found, side, mark)
  local slope = side.slope
  if not side.cost then
    side.cut, side.delta = side.cut + 1, side.delta / 2
    side.done, side.fails = side.cut > most_cut, true
    side.z = numeric.map(found.z, function(x) return x end)
    for k, x in ipairs(found.z) do
      side.z[k] = x + 0.5 * (side.last[k] - x)
    end
    return
  end
  side.delta = (side.z[side.k] - found.z[side.k]) * slope
  local excess = side.cost - found.at.cost
  side.points[#side.points + 1] = { z = side.z, delta = side.delta, excess = excess }
  local ratio = math.sqrt(mark / math.max(excess, 1e-3 * mark))
  if ratio <= near_enough and ratio >= 1 / near_enough then
    side.done = true
  elseif side.bound and ratio > 1 then
    side.done = true
  else
    ratio = math.min(math.max(ratio, 0.3), 3)
    local z = numeric.map(found.z, function(x) return x end)
    for k, x in ipairs(found.z) do
      z[k] = x + ratio * (side.z[k] - x)
    end
    side.z, side.bound = inside(problem, z, side.k)
  end
end

--- How far a side goes until the squares have risen by `mark`: by straight lines of the root of their rise; nil where they do not.
local function finish_of(side, mark)
  local points = table.move(side.points, 1, #side.points, 1, {})
  table.sort(points, function(a, b) return math.abs(a.delta) < math.abs(b.delta) end)
  local before = { delta = 0, root = 0 }
  local level = math.sqrt(mark)
  for _, point in ipairs(points) do
    local own = { delta = point.delta, root = math.sqrt(math.max(point.excess, 0)) }
    if own.root >= level then
      return before.delta + (own.delta - before.delta) * (level - before.root) / (own.root - before.root)
    end
    before = own
  end
  return not side.bound and before.root * near_enough >= level and before.delta * level / before.root or nil
end

local function value_at(problem, found, k, z)
  local all = table.move(found.z, 1, #found.z, 1, {})
  all[k] = z
  return space.values(problem.parameters, all)[k]
end

--- By place of each free parameter {low =, high = (SI; nil where the data set no end), points = {{value =, excess =}}, reasons =}; and
--- a point that is lower than the best one, if any was met.
function profile.of(problem, found, judged)
  local unit = problem.known and problem.loss == "squares" and 1 or judged.factor
  local mark, sides = judged.t ^ 2 * unit, {}
  for i, k in ipairs(judged.free) do
    for _, way in ipairs { -1, 1 } do
      local delta = way * judged.t * math.min(judged.relative[k], 1e3)
      local side = { k = k, i = i, way = way, delta = delta, slope = judged.slopes[k], cut = 0, points = {} }
      side.z, side.bound = inside(problem, moved(found, judged, i, delta), k)
      side.done = side.z[k] == found.z[k]
      side.last = side.z
      sides[#sides + 1] = side
    end
  end
  for _ = 1, most_rounds do
    local open = {}
    for _, side in ipairs(sides) do
      open[#open + 1] = not side.done and side or nil
      side.last = side.z
    end
    if #open == 0 then
      break
    end
    look(problem, found, judged, open)
    for _, side in ipairs(open) do
      settle(problem, found, side, mark)
    end
  end
  local intervals, best = {}, nil
  for _, side in ipairs(sides) do
    local own = intervals[side.k] or { points = {}, k = side.k }
    intervals[side.k] = own
    for _, point in ipairs(side.points) do
      own.points[#own.points + 1] = { value = value_at(problem, found, side.k, point.z[side.k]), excess = point.excess / unit }
      if point.excess < -lower * unit and (not best or point.excess < best.excess) then
        best = point
      end
    end
    local finish = finish_of(side, mark)
    if finish and sign(finish) == side.way then
      own[side.way < 0 and "low" or "high"] = value_at(problem, found, side.k, found.z[side.k] + finish / side.slope)
    end
    own.fails = own.fails or side.fails
  end
  for _, own in pairs(intervals) do
    table.sort(own.points, function(a, b) return a.value < b.value end)
  end
  return intervals, best and best.z
end

return profile
