-- The length over which noise goes on along a curve, as residuals tell it.
local engine = require "stiction.engine"
local linear = require "stiction.fit.linear"
local loss_module = require "stiction.fit.loss"
local noise = require "stiction.fit.noise"
local numeric = require "stiction.numeric"

local correlation = {}

local shortest = 1 / 6 -- of the least distance of points, to which lengths are looked for: points are independent of each other then
correlation.longest = 0.5 -- of a curve, the same: longer ones are like a misfit of the model's course
correlation.least_points = 10 -- from which a length can be told
local places, bends = 16, 11 -- of the search for a length: a grid in its logarithm, then sections
local golden = 0.5 * (math.sqrt(5) - 1)
local least = 1e-13 -- of the largest singular value
local most_rounds, small = 8, 1e-3 -- of the search for several lengths one after the other; a change of a logarithm that ends it

--- Variance of the third difference of such noise of variance 1 that ends at the i-th point (20 of independent noise).
function correlation.third_difference(xs, length, i)
  local factors, sum = { -1, 3, -3, 1 }, 0
  for a = 1, 4 do
    for b = 1, 4 do
      sum = sum + factors[a] * factors[b] * math.exp(-math.abs(xs[i - 4 + a] - xs[i - 4 + b]) / length)
    end
  end
  return sum
end

--- The lengths between which it is looked for one.
local function bounds(xs)
  local step = math.huge
  for i = 2, #xs do
    step = math.min(step, xs[i] - xs[i - 1])
  end
  return shortest * step, correlation.longest * (xs[#xs] - xs[1])
end

--- Where f is least between two lengths, and what it is there.
local function lowest(f, low, high)
  local from, width = math.log(low), math.log(high / low) / (places - 1)
  local at, best = 0, math.huge
  for i = 0, places - 1 do
    local value = f(math.exp(from + i * width))
    if value < best then
      at, best = i, value
    end
  end
  local a, b = from + math.max(at - 1, 0) * width, from + math.min(at + 1, places - 1) * width
  local c, d = b - golden * (b - a), a + golden * (b - a)
  local fc, fd = f(math.exp(c)), f(math.exp(d))
  for _ = 1, bends do
    if fc < fd then
      b, d, fd = d, c, fc
      c = b - golden * (b - a)
      fc = f(math.exp(c))
    else
      a, c, fc = c, d, fd
      d = a + golden * (b - a)
      fd = f(math.exp(d))
    end
  end
  local inside = math.exp(fc < fd and c or d)
  if math.min(fc, fd) < best then
    return inside, math.min(fc, fd)
  end
  return math.exp(from + at * width), best
end

--- The length that residuals tell of themselves, by largest likelihood at any size of theirs, and the chance that independent ones tell one
--- as surely; nil where they tell none, or xs do not rise.
function correlation.told(xs, residuals)
  for i = 2, #xs do
    if not (type(xs[i]) == "number" and xs[i] > xs[i - 1]) then
      return nil
    end
  end
  if #xs < correlation.least_points then
    return nil
  end
  local function unlikely(length)
    local own, determinant = residuals, 0
    if length then
      local course = noise.along(xs, length)
      own, determinant = course:whitened(residuals), course:log_determinant()
    end
    return #xs * math.log(math.max(linear.dot(own, own), 1e-300)) + determinant
  end
  local length, value = lowest(unlikely, bounds(xs))
  local gain = unlikely(nil) - value
  if gain <= 0 then
    return nil
  end
  return length, 0.5 * engine.beyond(gain, 1)
end

--- The lists of a curve in a longer one, through f, in its place.
local function replaced(list, curve, f)
  local own = f(table.move(list, curve.first, curve.last, 1, {}))
  table.move(own, 1, #own, curve.first, list)
end

local function copied(list)
  return table.move(list, 1, #list, 1, {})
end

--- Lengths of the curves that are to be estimated (curve.estimated), from a minimum with all its parameters free to follow: by largest
--- restricted likelihood (Patterson and Thompson 1971), so that what parameters take of the noise is not missed. problem: {loss =,
--- known =}; found: as search.run has it, whitened by the curves' present lengths. Lists by place of curve: lengths, and whether each
--- is the longest that is looked for.
function correlation.estimate(problem, found, curves)
  local r, columns = copied(found.at.r), numeric.map(found.free, function(k) return copied(found.J[k]) end)
  local lengths, courses, ends = {}, {}, {}
  for i, curve in ipairs(curves) do
    if curve.estimated then
      local known = curve.length and noise.along(curve.x, curve.length, curve.shares)
      for _, list in ipairs(known and { r, table.unpack(columns) } or {}) do
        replaced(list, curve, function(own) return known:coloured(own) end)
      end
      ends[i] = { bounds(curve.x) }
      lengths[i] = curve.length or ends[i][1]
      courses[i] = noise.along(curve.x, lengths[i], curve.shares)
    end
  end
  local function unlikely()
    local own, rows, sum = copied(r), numeric.map(columns, copied), 0
    for i, course in pairs(courses) do
      for _, list in ipairs { own, table.unpack(rows) } do
        replaced(list, curves[i], function(part) return course:whitened(part) end)
      end
      sum = sum + course:log_determinant()
    end
    local losses, slopes, squares = loss_module.of(problem.loss, own)
    if #rows > 0 then
      rows = linear.scaled(rows, slopes)
      squares = squares - select(2, linear.step(rows, losses, math.huge))
      local values = engine.singular(rows)
      for _, value in ipairs(values) do
        sum = sum + 2 * math.log(math.max(value, least * values[1], 1e-150))
      end
    end
    return sum + (problem.known and squares or math.max(1, #r - #rows) * math.log(math.max(squares, 1e-300)))
  end
  for _ = 1, next(courses, next(courses)) and most_rounds or 1 do -- one length alone is found at once
    local change = 0
    for i in pairs(courses) do
      local was = lengths[i]
      lengths[i] = lowest(function(length)
        courses[i] = noise.along(curves[i].x, length, curves[i].shares)
        return unlikely()
      end, ends[i][1], ends[i][2])
      courses[i] = noise.along(curves[i].x, lengths[i], curves[i].shares)
      change = math.max(change, math.abs(math.log(lengths[i] / was)))
    end
    if change < small then
      break
    end
  end
  local at_end = {}
  for i, length in pairs(lengths) do
    at_end[i] = length > 0.999 * ends[i][2]
  end
  return lengths, at_end
end

return correlation
