-- What would notice a wrong momentum of a rigid ball that flies, spins and lands.
local function vectors(case, group, name)
  local x, y, z, list = case:series(group, name .. "_x"), case:series(group, name .. "_y"), case:series(group, name .. "_z"), {}
  for i = 1, #x do
    list[i] = { x[i], y[i], z[i] }
  end
  return list
end

local function cross(a, b)
  return { a[2] * b[3] - a[3] * b[2], a[3] * b[1] - a[1] * b[3], a[1] * b[2] - a[2] * b[1] }
end

--- Momentum of the ball, and angular momentum about its centre, change in each step by what its contact gives.
local function impulses(case, q, say)
  local p, l, at = vectors(case, "momentum", "ball_p"), vectors(case, "momentum", "ball_l"), vectors(case, "ball", "u")
  local given, turned = {}, {}
  for name, list in pairs { impulse = given, angular_impulse = turned } do
    local bed, both = vectors(case, "momentum", "touch_" .. name), vectors(case, "momentum", "touch_" .. name:gsub("impulse", "sum"))
    for i = 1, #bed do
      list[i] = { both[i][1] - bed[i][1], both[i][2] - bed[i][2], both[i][3] - bed[i][3] }
    end
  end
  local off, off_l, most, most_l, old = 0, 0, 0, 0, nil
  for i = 1, #p do
    local x = at[i]
    x[3] = x[3] + (q.gap + q.size) * q.L
    local orbit, own = cross(x, p[i]), {}
    for k = 1, 3 do
      own[k] = l[i][k] - orbit[k]
      most, most_l = math.max(most, math.abs(p[i][k])), math.max(most_l, math.abs(own[k]))
    end
    if old then
      local step, moment = {}, {}
      for k = 1, 3 do
        step[k], moment[k] = given[i][k] - given[i - 1][k], turned[i][k] - turned[i - 1][k]
        off = math.max(off, math.abs(p[i][k] - p[i - 1][k] - step[k]))
      end
      local about = cross(x, step)
      for k = 1, 3 do
        off_l = math.max(off_l, math.abs(own[k] - old[k] - moment[k] + about[k]))
      end
    end
    old = own
  end
  most_l = math.max(most_l, 1e-3 * most * q.size * q.L) -- without spin
  say("momentum that no contact gave, over the largest", off / math.max(most, 1e-300), 1e-6)
  say("angular momentum that no contact gave, over the largest", off_l / math.max(most_l, 1e-300), 1e-6)
end

return impulses
