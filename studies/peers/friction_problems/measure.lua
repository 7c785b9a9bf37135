-- An answer to a friction problem u = W r + q, r and u point by point (n, t1, t2): its error in Siconos' measure and what does not
-- depend on how forces share out where there is more than one answer.
local measure = {}

--- Of x on the cone |x_t| <= mu x_n.
local function project(n, t1, t2, mu)
  local t = math.sqrt(t1 * t1 + t2 * t2)
  if t <= mu * n then
    return n, t1, t2
  elseif mu * t <= -n then
    return 0, 0, 0
  end
  local a = (mu * t + n) / (1 + mu * mu)
  return a, mu * a / t * t1, mu * a / t * t2
end

local function squares(list)
  local sum = 0
  for _, x in ipairs(list) do
    sum = sum + x * x
  end
  return sum
end

--- |r - P(r - (u + mu |u_t| n))| / |q|
function measure.error(r, u, q, mu)
  local sum = 0
  for i = 1, #r, 3 do
    local slip = mu * math.sqrt(u[i + 1] ^ 2 + u[i + 2] ^ 2)
    local n, t1, t2 = project(r[i] - u[i] - slip, r[i + 1] - u[i + 1], r[i + 2] - u[i + 2], mu)
    sum = sum + (r[i] - n) ^ 2 + (r[i + 1] - t1) ^ 2 + (r[i + 2] - t2) ^ 2
  end
  return math.sqrt(sum / squares(q))
end

--- |u| / |q|
function measure.slip(u, q)
  return math.sqrt(squares(u) / squares(q))
end

--- r . W r / |q|^2
function measure.energy(r, u, q)
  local sum = 0
  for i = 1, #r do
    sum = sum + r[i] * (u[i] - q[i])
  end
  return sum / squares(q)
end

return measure
