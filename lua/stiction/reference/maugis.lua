-- Sphere under Dugdale's adhesion, between DMT and JKR: Maugis 1992, as Johnson and Greenwood 1997 write it.
--
-- Dimensionless, with K = 4 E*/3: a* = a (K/(pi w R^2))^1/3, P* = P/(pi w R), d* = d (K^2/(pi^2 w^2 R))^1/3, pressing > 0;
-- m = c/a, contact radius a, traction sigma0 up to the radius c.
local maugis = {}

--- lambda = sigma0 (9 R/(2 pi w E*^2))^1/3.
function maugis.lambda(modulus, radius, w, sigma0)
  return sigma0 * (9 * radius / (2 * math.pi * w * modulus ^ 2)) ^ (1 / 3)
end

--- The traction that gives this lambda, Pa.
function maugis.traction(modulus, radius, w, lambda)
  return lambda / maugis.lambda(modulus, radius, w, 1)
end

local function parts(m)
  local root = math.sqrt(m * m - 1)
  return root, math.acos(1 / m)
end

--- What the surfaces do to each other at m, less 1: zero where the opening at c is the range w/sigma0.
local function excess(lambda, a, m)
  local root, angle = parts(m)
  return lambda * a ^ 2 / 2 * (root + (m * m - 2) * angle)
    + 4 / 3 * lambda ^ 2 * a * (root * angle - m + 1) - 1
end

--- m = c/a over lambda and a* > 0.
function maugis.ratio(lambda, a)
  local low, high = 1, 2
  while excess(lambda, a, high) < 0 do
    low, high = high, 2 * high
  end
  for _ = 1, 200 do
    local middle = 0.5 * (low + high)
    if excess(lambda, a, middle) < 0 then
      low = middle
    else
      high = middle
    end
  end
  return 0.5 * (low + high)
end

--- P* over lambda and a*.
function maugis.force(lambda, a)
  local m = maugis.ratio(lambda, a)
  local root, angle = parts(m)
  return a ^ 3 - lambda * a ^ 2 * (root + m * m * angle)
end

--- d* over lambda and a*.
function maugis.depth(lambda, a)
  return a ^ 2 - 4 / 3 * a * lambda * parts(maugis.ratio(lambda, a))
end

--- Largest force that the sphere holds over pi w R (2 by DMT, 3/2 by JKR), and a* at it.
function maugis.pull_off(lambda)
  local golden, low, high = (math.sqrt(5) - 1) / 2, 1e-4, 2
  local left, right = high - golden * (high - low), low + golden * (high - low)
  local at_left, at_right = maugis.force(lambda, left), maugis.force(lambda, right)
  while high - low > 1e-9 do
    if at_left < at_right then
      high, right, at_right = right, left, at_left
      left = high - golden * (high - low)
      at_left = maugis.force(lambda, left)
    else
      low, left, at_left = left, right, at_right
      right = low + golden * (high - low)
      at_right = maugis.force(lambda, right)
    end
  end
  local a = 0.5 * (low + high)
  return -maugis.force(lambda, a), a
end

--- Units of a (m), P (N) and d (m).
function maugis.units(modulus, radius, w)
  local K = 4 / 3 * modulus
  return (math.pi * w * radius ^ 2 / K) ^ (1 / 3), math.pi * w * radius,
    (math.pi ^ 2 * w ^ 2 * radius / K ^ 2) ^ (1 / 3)
end

return maugis
