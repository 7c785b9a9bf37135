-- The best that all other parameters can do where one is held: steps of Gauss and Newton, with derivatives that are brought along from
-- the point before (Broyden 1965) and made anew where they do not tell what residuals do.
local linear = require "stiction.fit.linear"
local loss_module = require "stiction.fit.loss"
local numeric = require "stiction.numeric"
local space = require "stiction.fit.space"

local follow = {}

follow.settled = 0.01 -- of the unit: what the others would still lessen the squares by where they are at their best
local worth = 0.1 -- of that: a direction that gains less is not gone along
local bent = 0.1 -- of what residuals move by: derivatives that miss more are not relied on
local reach = 0.5 -- of coordinates, in one step
local edge = 1e-12 -- coordinates so near to a bound are on it
local cut, most_cuts, most_steps = 0.25, 3, 10

-- A place: {z =, at = (answer), own =, slopes =, cost =, J = (columns by place), sure = whether these may be relied on, fresh = whether
-- they were made here}. A walk: {problem =, unit =, weights = (of coordinates, by which steps are measured), ask = function(points) ->
-- answers}.

--- The place of an answer; J: its derivatives as far as they are known otherwise.
local function place_of(walk, z, at, J)
  local own, slopes, cost = loss_module.of(walk.problem.loss, at.r)
  local columns = {}
  for k = 1, #z do
    columns[k] = at.J and at.J[k] or J[k]
  end
  return { z = z, at = at, own = own, slopes = slopes, cost = cost, J = columns }
end

--- The place where the search ended.
function follow.start(walk, found)
  local place = place_of(walk, found.z, found.at, found.J)
  place.sure, place.fresh = true, true
  return place
end

--- The place of an answer beside another one, whose derivatives are brought along; held: the parameter that is.
local function beside(walk, from, z, at, held)
  local dz, others, square = {}, {}, 0
  for k = 1, #z do
    dz[k] = z[k] - from.z[k]
    others[k] = k == held and 0 or dz[k]
    square = square + (walk.weights[k] * dz[k]) ^ 2
  end
  if square == 0 then
    return from
  end
  local guess, miss, missed = linear.product(from.J, dz, #at.r), {}, 0
  for i = 1, #at.r do
    miss[i] = at.r[i] - from.at.r[i] - guess[i]
    missed = missed + (from.slopes[i] * miss[i]) ^ 2
  end
  local moved = 0
  for _, list in ipairs { guess, linear.product(from.J, others, #at.r) } do
    local sum = 0
    for i = 1, #list do
      sum = sum + (from.slopes[i] * list[i]) ^ 2
    end
    moved = math.max(moved, sum)
  end
  local J = {}
  for k = 1, #z do
    local share = walk.weights[k] ^ 2 * dz[k] / square
    J[k] = {}
    for i = 1, #at.r do
      J[k][i] = from.J[k][i] + share * miss[i]
    end
  end
  local place = place_of(walk, z, at, J)
  place.sure = missed <= math.max(bent ^ 2 * moved, worth * follow.settled * walk.unit)
  return place
end

--- The parameters that may move beside the held one: all but those at a bound that they would leave.
local function free_ones(walk, place, held)
  local free = {}
  for k, own in ipairs(walk.problem.parameters) do
    local slope = 0
    for i = 1, #place.own do
      slope = slope + place.J[k][i] * place.slopes[i] * place.own[i]
    end
    local out = own.from and (place.z[k] <= edge and slope > 0 or place.z[k] >= 1 - edge and slope < 0)
    free[#free + 1] = k ~= held and not out and k or nil
  end
  return free
end

--- Makes the derivatives over all but the held parameter anew by differences, where they did not come with the case.
local function renew(walk, place, held)
  local left, J = {}, table.move(place.J, 1, #place.J, 1, {})
  for k in ipairs(place.z) do
    left[#left + 1] = k ~= held and not (place.at.J and place.at.J[k]) and k or nil
  end
  for _, sign in ipairs { 1, -1 } do
    local points = numeric.map(left, function(k)
      local z, h = table.move(place.z, 1, #place.z, 1, {}), walk.problem.step(k, place.z)
      h = walk.problem.parameters[k].from and z[k] + h > 1 and -h or h
      z[k] = z[k] + sign * h
      return (space.clipped(walk.problem.parameters, z))
    end)
    local answers, failed = #left > 0 and walk.ask(points) or {}, {}
    for n, k in ipairs(left) do
      local h, r = points[n][k] - place.z[k], answers[n].r
      J[k] = r and h ~= 0 and numeric.map(r, function() return 0 end) or J[k]
      for i = 1, r and h ~= 0 and #r or 0 do
        J[k][i] = (r[i] - place.at.r[i]) / h
      end
      failed[#failed + 1] = (not r or h == 0) and k or nil
    end
    left = failed
  end
  local made = place_of(walk, place.z, place.at, J)
  made.sure, made.fresh = true, true
  return made
end

--- The point of a step of the free parameters, so much of it as `part` says, between the bounds; what the whole step is to gain.
local function stepped(walk, place, free, part)
  local columns = linear.scaled(numeric.map(free, function(k) return place.J[k] end), place.slopes)
  local step, gain = {}, 0
  if #free > 0 then
    step, gain = linear.step(columns, place.own, reach, worth * follow.settled * walk.unit)
  end
  local z = table.move(place.z, 1, #place.z, 1, {})
  for i, k in ipairs(free) do
    z[k] = z[k] + part * step[i]
  end
  return (space.clipped(walk.problem.parameters, z)), gain
end

--- The place of a point, brought there from another one; nil and the reason where its cases fail.
local function reached(walk, from, z, held)
  local at = walk.ask({ z })[1]
  if not at.r then
    return nil, at.failed
  end
  return beside(walk, from, z, at, held)
end

--- From a guess the place where all but the held parameter are at their best, with derivatives from another place; nil and the reason
--- where cases fail, or where there is none after so many steps.
function follow.to(walk, from, z, held)
  local place, reason = reached(walk, from, z, held)
  if not place then
    return nil, reason
  end
  local part, cuts = 1, 0
  for _ = 1, most_steps do
    local free = free_ones(walk, place, held)
    local point, gain = stepped(walk, place, free, part)
    local there = gain <= follow.settled * walk.unit
    if there and (place.sure or #free == 0) then
      return place
    elseif there then
      place = renew(walk, place, held)
    else
      local trial = reached(walk, place, point, held)
      if trial and trial.cost < place.cost then
        place, part, cuts = trial, 1, 0
      elseif not place.fresh then
        place = renew(walk, place, held)
      else
        part, cuts = part * cut, cuts + 1
      end
    end
    if cuts > most_cuts then
      break
    end
  end
  return nil, "the other parameters do not settle"
end

return follow
