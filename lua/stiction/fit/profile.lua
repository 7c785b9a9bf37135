-- Intervals by profile likelihood: how far a parameter may go, all others at their best for it, until the data say no.
local follow = require "stiction.fit.follow"
local linear = require "stiction.fit.linear"
local numeric = require "stiction.numeric"
local space = require "stiction.fit.space"

local profile = {}

local beyond, short = 1.3, 1.1 -- by which the root of the rise of squares may pass its mark, or miss it: its slope then tells the end
local narrow = 0.05 -- of the way: places on both sides of the mark that are no farther apart tell the end, too
local most_places, most_cut = 14, 4 -- of a side; how often its way is halved where cases fail or the others do not settle
local farthest, least = 3, 1.1 -- times as far as the place before
local doubtful = 0.5 -- of the root: the slope at the best that is farther off tells no end
local margin = 0.1 -- of the way between two places, that the next one keeps from both
local lower = 0.05 -- of the unit: a point so much lower than the best is another minimum
local widest = 0.5 -- relative standard error of a first step: wider, and it tells little

-- A side: {k =, way = -1 | 1, limit = (how far it may go in the coordinate), places = {{t = (how far), place =, root = (of the rise of
-- squares), slope = (of that over t)}, nearest first, the best itself first of all}, at_bound = whether it begins at a bound}.

--- Root of the rise of squares over the best at a place of a side, and its slope; the others being at their best, they tell none of it.
local function measured(self, side, t, place)
  local excess, sum = place.cost - self.found.at.cost, 0
  for i, own in ipairs(place.own) do
    sum = sum + own * place.slopes[i] * place.J[side.k][i]
  end
  local root = math.sqrt(math.max(excess, 0))
  return { t = t, place = place, excess = excess, root = root, slope = root > 0 and side.way * sum / root or 0 }
end

local function insert(side, entry)
  local at = numeric.first_where(side.places, function(other) return other.t > entry.t end) or #side.places + 1
  table.insert(side.places, at, entry)
end

--- Where the others may be: along their tangent at the best, bent towards the nearest place, or along the line of the two nearest.
local function guess(self, side, t)
  local near = table.move(side.places, 1, #side.places, 1, {})
  table.sort(near, function(a, b) return math.abs(a.t - t) < math.abs(b.t - t) end)
  local one, other, z = near[1], near[2], {}
  if one.t == 0 then
    one, other = other, one
  end
  for k, best in ipairs(self.found.z) do
    local tangent = side.tangent[k] or 0
    if not one then
      z[k] = best + tangent * t
    elseif other.t == 0 then
      z[k] = best + tangent * t + (one.place.z[k] - best - tangent * one.t) * (t / one.t) ^ 2
    else
      z[k] = one.place.z[k] + (t - one.t) / (other.t - one.t) * (other.place.z[k] - one.place.z[k])
    end
  end
  z[side.k] = self.found.z[side.k] + side.way * t
  return (space.clipped(self.problem.parameters, z)), near[1].place
end

--- The last place below the mark, and the first one above, if there is one.
local function bracket(side, level)
  local at = numeric.first_where(side.places, function(entry) return entry.root >= level end)
  return side.places[at and at - 1 or #side.places], at and side.places[at]
end

--- Where the squares meet their mark on a side that begins at a bound, beyond which they would fall: they rise at once, and the parabola is
--- theirs, with the slope at the outer place.
local function crossing_from_bound(level, inner, outer)
  local gap, off, slope = outer.t - inner.t, level ^ 2 - outer.excess, 2 * outer.root * outer.slope
  local line = outer.t + gap * off / (outer.excess - inner.excess)
  local bend = (inner.excess - outer.excess + slope * gap) / gap ^ 2
  local square = slope ^ 2 + 4 * bend * off
  local t = square > 0 and slope > 0 and outer.t + 2 * off / (slope + math.sqrt(square))
  return t and t > inner.t and t <= math.max(outer.t, least * line) and t or line
end

--- Where the root meets its mark, between two places or a little beyond: by the parabola that has the slope at the best, if that is one
--- of them, else that at the outer one; by a straight line where that does not lead there.
local function crossing(side, level, inner, outer)
  if side.at_bound then
    return crossing_from_bound(level, inner, outer)
  end
  local gap = outer.t - inner.t
  local line = inner.t + gap * (level - inner.root) / (outer.root - inner.root)
  local from, to = outer, inner
  if inner.t == 0 and math.abs(inner.slope * gap - outer.root) <= doubtful * outer.root then
    from, to = inner, outer
  end
  local way, off = to.t - from.t, level - from.root
  local bend = (to.root - from.root - from.slope * way) / way ^ 2
  local square = from.slope ^ 2 + 4 * bend * off
  local t = square > 0 and from.slope > 0 and from.t + 2 * off / (from.slope + math.sqrt(square))
  return t and t > inner.t and t <= math.max(outer.t, least * line) and t or line
end

--- The side's end where it is known (true: it is open), else how far to look next.
local function decide(side)
  local level = side.level
  local below, above = bracket(side, level)
  if above then
    local gap = above.t - below.t
    local t = crossing(side, level, below, above)
    if above.root <= beyond * level or gap <= narrow * above.t then
      return t
    end
    local halve = side.gap and gap > 0.5 * side.gap
    side.gap = gap
    return nil, halve and below.t + 0.5 * gap or math.min(math.max(t, below.t + margin * gap), above.t - margin * gap)
  elseif below.root * short >= level then
    return crossing(side, level, side.places[#side.places - 1], below)
  elseif below.t >= side.limit then
    return true
  end
  local t = below.slope > 0 and below.t + (level - below.root) / below.slope or math.huge
  return nil, math.min(math.max(t, least * below.t), farthest * below.t, side.limit)
end

--- Follows a side to its end: side.finish (nil: open), or side.lost = {t =, reason =} where it cannot be followed any farther.
local function walk(self, side)
  local t, cuts = math.min(side.first, side.limit), 0
  for _ = 1, most_places do
    local z, from = guess(self, side, t)
    local place, reason = follow.to(self, from, z, side.k)
    local finish, next_t
    if place then
      insert(side, measured(self, side, t, place))
      finish, next_t = decide(side)
    else
      side.wall, side.reason, next_t = t, reason, t
    end
    if finish then
      side.finish = finish ~= true and finish or nil
      return
    end
    local below = bracket(side, side.level)
    local halved = side.wall and next_t >= side.wall
    t, cuts = halved and 0.5 * (below.t + side.wall) or next_t, cuts + (halved and 1 or 0)
    if cuts > most_cut then
      break
    end
  end
  local below, above = bracket(side, side.level)
  side.finish = above and crossing(side, side.level, below, above)
  side.lost = not above and { t = below.t, reason = side.reason or "the squares hardly rise", flat = not side.reason } or nil
end

--- Runs all sides beside each other, so that what they ask for is computed in one batch.
local function run_all(self, sides)
  local waiting = {}
  local function resume(thread, answers)
    local held, points = coroutine.resume(thread, answers)
    if not held then
      error(points, 0)
    end
    waiting[#waiting + 1] = points and { thread = thread, points = points } or nil
  end
  for _, side in ipairs(sides) do
    if side.limit > 0 then
      resume(coroutine.create(function() walk(self, side) end))
    end
  end
  while #waiting > 0 do
    local batch, all = waiting, {}
    waiting = {}
    for _, own in ipairs(batch) do
      table.move(own.points, 1, #own.points, #all + 1, all)
    end
    local answers, first = self.problem.evaluate(all, "profile"), 1
    for _, own in ipairs(batch) do
      resume(own.thread, table.move(answers, first, first + #own.points - 1, 1, {}))
      first = first + #own.points
    end
  end
end

--- Adds a side with its first place: {k =, way =, limit =, first =, tangent = (by place), at_bound =}; slope: of its root there.
local function add(self, sides, side, slope)
  local tangent = numeric.map(self.found.z, function() return 0 end)
  for l, x in pairs(side.tangent) do
    tangent[l] = side.way * x
  end
  side.tangent, side.level = tangent, self.level * self.times[side.k]
  side.places = { { t = 0, place = follow.start(self, self.found), excess = 0, root = 0, slope = slope } }
  sides[#sides + 1] = side
end

--- The side of a parameter at a bound, inwards: how far, by derivatives at the best, says a parabola of the squares.
local function add_from_bound(self, sides, judged, k)
  local at, J = self.found.at, self.found.J
  local columns = linear.scaled(numeric.map(judged.free, function(l) return J[l] end), at.slopes)
  local own = linear.scaled({ J[k] }, at.slopes)[1]
  local way = self.found.z[k] < 0.5 and 1 or -1
  local slope, tangent = math.max(2 * way * linear.dot(own, at.own), 0), {}
  local step, gain = {}, 0
  if #columns > 0 then
    step, gain = linear.step(columns, own, math.huge)
  end
  for i, l in ipairs(judged.free) do
    tangent[l] = step[i]
  end
  local bend = math.max(linear.dot(own, own) - gain, 0)
  local level = self.level * judged.times[k]
  local first = 2 * level ^ 2 / (slope + math.sqrt(slope ^ 2 + 4 * bend * level ^ 2))
  add(self, sides, { k = k, way = way, limit = 1, first = first, tangent = tangent, at_bound = true, rise = slope }, 0)
end

--- The sides of all free parameters, and those inwards of the others, which are at a bound.
local function sides_of(self, judged)
  local sides, is_free = {}, {}
  for i, k in ipairs(judged.free) do
    local own, z = self.problem.parameters[k], self.found.z[k]
    local tangent = {}
    is_free[k] = true
    for j, l in ipairs(judged.free) do
      tangent[l] = judged.inverse[j][i] / judged.inverse[i][i] * judged.slopes[k] / judged.slopes[l]
    end
    for _, way in ipairs { -1, 1 } do
      add(self, sides, { k = k, way = way, limit = not own.from and math.huge or way < 0 and z or 1 - z,
        first = judged.t * math.min(judged.relative[k], widest) / judged.slopes[k], tangent = tangent },
        math.sqrt(self.unit) * judged.times[k] * judged.slopes[k] / judged.relative[k])
    end
  end
  for k, own in ipairs(self.problem.parameters) do
    if own.from and not is_free[k] then
      add_from_bound(self, sides, judged, k)
    end
  end
  return sides
end

local function value_at(self, side, t)
  local z = table.move(self.found.z, 1, #self.found.z, 1, {})
  z[side.k] = z[side.k] + side.way * t
  return space.values(self.problem.parameters, z)[side.k]
end

--- By place of each parameter {low =, high = (SI; nil where the data set no end), points = {{value =, excess =}}, lost = {{way =,
--- value =, reason =, flat = (whether the squares hardly rose)}} of sides that could not be followed to their end, from this value on,
--- bound = "low" | "high" (that it is at, where there is no such end) with straight = (share of the rise of squares up to the other end
--- that goes with the way)}; and a point that is lower than the best one, if any was met.
function profile.of(problem, found, judged)
  local unit = problem.known and problem.loss == "squares" and 1 or judged.factor
  local self = { problem = problem, found = found, unit = unit, level = judged.t * math.sqrt(unit), weights = judged.slopes,
    times = judged.times, ask = coroutine.yield }
  local sides = sides_of(self, judged)
  run_all(self, sides)
  local intervals, best = {}, nil
  for _, side in ipairs(sides) do
    local own = intervals[side.k] or { points = {}, lost = {} }
    intervals[side.k] = own
    for i = 2, #side.places do
      local entry = side.places[i]
      own.points[#own.points + 1] = { value = value_at(self, side, entry.t), excess = entry.excess / unit / judged.times[side.k] ^ 2 }
      best = entry.excess < -lower * unit and (not best or entry.excess < best.excess) and entry or best
    end
    own[side.way < 0 and "low" or "high"] = side.finish and value_at(self, side, side.finish)
    if side.at_bound then
      own.bound, own.straight = side.way < 0 and "high" or "low", side.finish and math.min(side.rise * side.finish / side.level ^ 2, 1)
    end
    own.lost[#own.lost + 1] = side.lost and { way = side.way, value = value_at(self, side, side.lost.t), reason = side.lost.reason,
      flat = side.lost.flat } or nil
  end
  for _, own in pairs(intervals) do
    table.sort(own.points, function(a, b) return a.value < b.value end)
  end
  return intervals, best and best.place.z
end

return profile
