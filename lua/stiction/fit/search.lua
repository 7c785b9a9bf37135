-- The search for least squares: trust-region steps between bounds, derivatives by differences that are kept as long as they do.
-- Trial points that fail are steps too long. Derivatives between two differences: Broyden (1965), with the projections of
-- Gay (1978).
local engine = require "stiction.engine"
local exact = require "stiction.fit.exact"
local linear = require "stiction.fit.linear"
local loss_module = require "stiction.fit.loss"
local numeric = require "stiction.numeric"
local space = require "stiction.fit.space"

local search = {}

local poor = 0.25 -- of what a step was to gain: less, and the derivatives are made anew
local most_refused = 1 -- trial points without a gain before old derivatives are made anew
local cut, most_cuts = 0.25, 3 -- of a step that gains nothing with new derivatives; how often
local penalty = 100 -- times the squares of the best: what a failed case counts
local worth = 3 -- times what is enough: a round of steps with new derivatives that gains less is the last
local farthest = 8 -- sizes of differences, by which a step still tells a derivative
local most_rounds = 40 -- of steps with one set of bounds
local apart = 0.02 -- in a coordinate: two minima
local news = 0.2 -- of a step: less that is new, and the steps before it are forgotten
local longest = 0.3 -- step between bounds, in coordinates: farther away derivatives tell little, and what has no effect there stays there
local edge = 1e-12 -- coordinates so near to a bound are on it

-- A problem: {parameters =, loss = name, evaluate = function(points, word) -> list of {r = residuals, J = {derivatives by place, where
-- they are known} | failed = reason},
-- step = function(k, z) -> size of differences, known = whether errors are known, enough = gain in squares of standard errors
-- at which it ends, most = evaluations, refusals = trial points in vain after new derivatives, always = derivatives by differences
-- at each step, central = by central ones}.

local Search = {}
Search.__index = Search

local function key_of(z)
  return table.concat(numeric.map(z, function(x) return ("%a"):format(x) end), " ")
end

--- An answer with what the loss makes of it.
local function weighed(self, answer)
  if answer.r then
    answer.own, answer.slopes, answer.cost = loss_module.of(self.problem.loss, answer.r)
  end
  return answer
end

--- Evaluates points between the bounds, of which none counts twice.
local function evaluate(self, points, word)
  local fresh, found = {}, {}
  for _, z in ipairs(points) do
    local key = key_of(z)
    found[#found + 1] = key
    if not self.seen[key] then
      fresh[#fresh + 1], self.seen[key] = z, true
      self.keys[#fresh] = key
    end
  end
  local answers = #fresh > 0 and self.problem.evaluate(fresh, word) or {}
  for i, answer in ipairs(answers) do
    self.seen[self.keys[i]] = weighed(self, answer)
  end
  self.count = self.count + #fresh
  return numeric.map(found, function(key) return self.seen[key] end)
end

--- The parameter whose derivatives, not known yet, the last step tells once those of the others are: by which it went far beside the size
--- of differences, but not too far; nil if there is none.
local function told_by_step(self, steps, known)
  local best, widest = nil, 0
  for k, h in ipairs(self.last and not self.problem.central and steps or {}) do
    local ratio = known[k] and 0 or math.abs((self.z[k] - self.last.z[k]) / h)
    if ratio > widest then
      best, widest = k, ratio
    end
  end
  return widest >= 1 and widest <= farthest and best or nil
end

--- The derivatives of that parameter.
local function from_step(self, J, m)
  local column = {}
  for n = 1, #self.at.r do
    local change = self.at.r[n] - self.last.at.r[n]
    for k = 1, #self.z do
      change = change - (k ~= m and J[k][n] * (self.z[k] - self.last.z[k]) or 0)
    end
    column[n] = change / (self.z[m] - self.last.z[m])
  end
  return column
end

--- Columns of differences of residuals over coordinates at a point; how many could not be had, and why the last one of these.
local function differences(self, z, at)
  local p, old = #z, self.J
  local steps, J, lost, reason = {}, {}, 0, nil
  for k = 1, p do
    local h = self.problem.step(k, z)
    steps[k] = self.problem.parameters[k].from and z[k] + h > 1 and -h or h
  end
  local known = at.J or {}
  local m = told_by_step(self, steps, known)
  local function moved(k, h)
    local other = table.move(z, 1, p, 1, {})
    other[k] = z[k] + h
    return other
  end
  local function try(ks, sign)
    local answers = evaluate(self, numeric.map(ks, function(k) return moved(k, sign * steps[k]) end), "derivative")
    for i, k in ipairs(ks) do
      local h, answer = sign * steps[k], answers[i]
      local column = answer.r and {}
      reason = answer.failed or reason
      for n = 1, answer.r and #at.r or 0 do
        column[n] = (answer.r[n] - at.r[n]) / h
      end
      local both = J[k] and column
      for n = 1, both and #column or 0 do
        column[n] = 0.5 * (column[n] + J[k][n])
      end
      J[k] = column or J[k]
    end
  end
  local all, rest = {}, {}
  for k = 1, p do
    J[k] = known[k]
    all[#all + 1] = not known[k] and k ~= m and k or nil
  end
  try(all, 1)
  for _, k in ipairs(all) do
    rest[#rest + 1] = (not J[k] or self.problem.central) and k or nil
  end
  try(rest, -1)
  for k = 1, p do
    if not J[k] and k ~= m then
      lost = lost + 1
      J[k] = old and old[k] or numeric.map(at.r, function() return 0 end)
    end
  end
  if m then
    J[m] = from_step(self, J, m)
  end
  return J, lost, reason
end

--- Derivatives made anew where the search stands.
local function refresh(self)
  self.J, self.lost, self.reason = differences(self, self.z, self.at)
  self.fresh, self.refused, self.ways = true, 0, {}
end

--- The direction along which a step is news: without those of the steps before it since derivatives were made.
local function news_of(self, dz)
  local v = table.move(dz, 1, #dz, 1, {})
  for _, way in ipairs(self.ways) do
    local along = linear.dot(way, dz)
    for k = 1, #v do
      v[k] = v[k] - along * way[k]
    end
  end
  local whole, left = math.sqrt(linear.dot(dz, dz)), math.sqrt(linear.dot(v, v))
  if left < news * whole then
    self.ways, v, left = {}, table.move(dz, 1, #dz, 1, {}), whole
  end
  table.insert(self.ways, numeric.map(v, function(x) return x / left end))
  return v
end

--- Brings derivatives along to a new point.
local function follow(self, z, at)
  local dz, square = {}, 0
  for k = 1, #z do
    dz[k] = z[k] - self.z[k]
    square = square + dz[k] ^ 2
  end
  local guess = linear.product(self.J, dz, #at.r)
  local predicted, J = 0, {}
  for i = 1, #at.r do
    predicted = predicted + (self.at.own[i] + self.at.slopes[i] * guess[i]) ^ 2
  end
  local v = square > 0 and news_of(self, dz)
  for k = 1, v and #z or 0 do
    J[k] = {}
    local share = v[k] / linear.dot(v, dz)
    for i = 1, #at.r do
      J[k][i] = self.J[k][i] + (at.r[i] - self.at.r[i] - guess[i]) * share
    end
  end
  local good = self.at.cost - at.cost >= poor * (self.at.cost - predicted)
  self.last = square > 0 and { z = self.z, at = self.at } or self.last
  self.z, self.at = z, at
  if square > 0 then
    self.J, self.fresh, self.refused = J, false, 0
  end
  if square > 0 and (self.problem.always or not good or exact.are_known(at.J, #z)) then
    refresh(self)
  end
end

--- The parameters that may move: all but those at a bound that they would leave.
local function free_ones(self)
  local free = {}
  for k, own in ipairs(self.problem.parameters) do
    local slope = 0
    for i = 1, #self.at.own do
      slope = slope + self.J[k][i] * self.at.slopes[i] * self.at.own[i]
    end
    local held = own.from and (self.z[k] <= edge and slope > 0 or self.z[k] >= 1 - edge and slope < 0)
    free[#free + 1] = not held and k or nil
  end
  return free
end

local function columns_of(self, free)
  return linear.scaled(numeric.map(free, function(k) return self.J[k] end), self.at.slopes)
end

--- What a standard error counts in squares.
local function unit_of(self)
  local each = self.at.cost / math.max(1, #self.at.r - #self.z)
  return self.problem.known and math.max(1, each) or each
end

--- What a whole step of the free parameters would gain.
local function gain_of(self, free)
  return #free > 0 and select(2, linear.step(columns_of(self, free), self.at.own, 1)) or 0
end

--- Whether that is no more than is worth it.
local function is_there(self, free)
  return gain_of(self, free) <= self.problem.enough * unit_of(self)
end

--- Steps with these parameters free, from where the search stands, until there is reason to look anew.
local function walk(self, free)
  local problem = self.problem
  local function whole(x)
    local z = table.move(self.z, 1, #self.z, 1, {})
    for i, k in ipairs(free) do
      z[k] = x[i]
    end
    local inside, moved = space.clipped(problem.parameters, z)
    local widest = 0
    for k, own in ipairs(problem.parameters) do
      widest = math.max(widest, own.from and math.abs(inside[k] - self.z[k]) or 0)
    end
    for k = 1, widest > longest and #z or 0 do
      inside[k] = self.z[k] + longest / widest * (inside[k] - self.z[k])
    end
    return inside, moved or widest > longest
  end
  local function residuals(x)
    local z = whole(x)
    if self.count >= problem.most then
      self.spent = true
      return nil
    end
    local answer = evaluate(self, { z }, "step")[1]
    local gained = answer.r and answer.cost <= self.at.cost
    self.refused, self.trial = gained and self.refused or self.refused + 1, z
    if not gained and self.refused >= (self.fresh and problem.refusals or most_refused) then
      return nil
    elseif answer.r then
      return answer.own
    end
    local share = math.sqrt(penalty * math.max(self.at.cost, 1e-300) / #self.at.own)
    return numeric.map(self.at.own, function() return share end)
  end
  local function jacobian(x)
    local z = whole(x)
    follow(self, z, evaluate(self, { z }, "step")[1])
    return columns_of(self, free)
  end
  local function each(x)
    local _, outside = whole(x)
    return outside or is_there(self, free) or #free_ones(self) ~= #free
  end
  local start = numeric.map(free, function(k) return self.z[k] end)
  return select(2, engine.least_squares(start, #self.at.r, residuals, jacobian, each, problem.most))
end

--- Shorter steps towards a trial point that gained nothing; whether one gains.
local function shorten(self)
  local z, towards = self.z, self.trial
  for i = 1, self.trial and most_cuts or 0 do
    local point = {}
    for k in ipairs(z) do
      point[k] = z[k] + cut ^ i * (towards[k] - z[k])
    end
    local answer = evaluate(self, { point }, "step")[1]
    if answer.r and answer.cost < self.at.cost then
      follow(self, point, answer)
      return true
    end
  end
  return false
end

--- The nearest minimum from a point whose answer is known: {z =, at = (answer), J =, free =, lost = (derivatives that could
--- not be had), ended = "there" | "stuck" | "most", promised = (squares that derivatives still promise to gain, of standard errors)}.
local function descend(self, z, at)
  self.z, self.at, self.J, self.last = z, at, nil, nil
  self.spent = false
  refresh(self)
  local word
  for _ = 1, most_rounds do
    local free = free_ones(self)
    if is_there(self, free) then
      word = self.fresh and "there"
    else
      local from, fresh = self.at.cost, self.fresh
      local how = walk(self, free)
      if fresh and self.at.cost >= from and how == "ended" and not self.spent then
        how = shorten(self) and how or "stuck"
      end
      local little = from - self.at.cost <= worth * self.problem.enough * unit_of(self)
      word = self.spent and "most" or fresh and little and (how == "stuck" or not self.problem.always) and "stuck"
    end
    if word then
      break
    elseif not self.fresh then
      refresh(self)
    end
  end
  if not self.fresh then
    refresh(self)
  end
  local free = free_ones(self)
  return { z = self.z, at = self.at, J = self.J, free = free, lost = self.lost, reason = self.reason, ended = word or "most",
    promised = gain_of(self, free) / math.max(unit_of(self), 1e-300) }
end

local function same(one, other)
  for k = 1, #one.z do
    if math.abs(one.z[k] - other.z[k]) > apart then
      return false
    end
  end
  return true
end

--- Minima from these points, the lowest first, each found once; nil and the answers where every one of the points failed.
--- few: from how many of the best points it is looked for. known: answers of the points, where there are any.
function search.run(problem, starts, few, known)
  local self = setmetatable({ problem = problem, seen = {}, keys = {}, count = 0 }, Search)
  for i, answer in ipairs(known or {}) do
    self.seen[key_of(starts[i])] = weighed(self, answer)
  end
  local answers, order = evaluate(self, starts, "start"), {}
  for i, answer in ipairs(answers) do
    order[#order + 1] = answer.r and i or nil
  end
  if #order == 0 then
    return nil, answers
  end
  table.sort(order, function(a, b)
    local one, other = answers[a].cost, answers[b].cost
    return one == other and a < b or one < other
  end)
  local minima = {}
  for i = 1, math.min(few, #order) do
    local found = descend(self, starts[order[i]], answers[order[i]])
    local old = numeric.first_where(minima, function(other) return same(found, other) end)
    if old and found.at.cost < minima[old].at.cost then
      minima[old] = found
    end
    minima[#minima + 1] = not old and found or nil
  end
  table.sort(minima, function(a, b) return a.at.cost < b.at.cost end)
  minima.count = self.count
  return minima
end

return search
