-- Adhesion of elastic bodies by Johnson, Kendall and Roberts (1971): sphere, and cylinder per length; SI numbers.
local jkr = { sphere = {}, cylinder = {} }

--- E* = (sum (1 - nu_i^2)/E_i)^-1 of one deformable body on a rigid one, Pa.
function jkr.modulus(young, poisson)
  return young / (1 - poisson ^ 2)
end

--- Least C_n at which the law RCC with b = 0 is taken for JKR, N/m^3: (5 E*^2/3 / (R^1/3 w^1/6))^2.
function jkr.stiffness(modulus, radius, w)
  return (5 * modulus ^ (2 / 3) / (radius ^ (1 / 3) * w ^ (1 / 6))) ^ 2
end

--- Force (pressing > 0) of a sphere over the contact radius a, N: 4 E* a^3/3R - sqrt(8 pi w E* a^3).
function jkr.sphere.force(modulus, radius, w, a)
  return 4 * modulus * a ^ 3 / (3 * radius) - math.sqrt(8 * math.pi * w * modulus * a ^ 3)
end

--- Approach of a sphere over the contact radius a, m: a^2/R - sqrt(2 pi w a/E*).
function jkr.sphere.depth(modulus, radius, w, a)
  return a ^ 2 / radius - math.sqrt(2 * math.pi * w * a / modulus)
end

--- Largest force that a sphere holds, N: 3/2 pi w R.
function jkr.sphere.pull_off(radius, w)
  return 1.5 * math.pi * w * radius
end

--- Contact radius at that force, m: (9 pi w R^2 / (8 E*))^1/3.
function jkr.sphere.pull_off_radius(modulus, radius, w)
  return (9 * math.pi * w * radius ^ 2 / (8 * modulus)) ^ (1 / 3)
end

--- Force per length (pressing > 0) of a cylinder over the half width a, N/m: pi E* a^2/4R - sqrt(2 pi E* w a).
function jkr.cylinder.force(modulus, radius, w, a)
  return math.pi * modulus * a ^ 2 / (4 * radius) - math.sqrt(2 * math.pi * modulus * w * a)
end

--- Largest force per length that a cylinder holds, N/m: 3 (pi E* w^2 R/16)^1/3.
function jkr.cylinder.pull_off(modulus, radius, w)
  return 3 * (math.pi * modulus * w ^ 2 * radius / 16) ^ (1 / 3)
end

--- Half width at that force, m: (2 w R^2/(pi E*))^1/3.
function jkr.cylinder.pull_off_radius(modulus, radius, w)
  return (2 * w * radius ^ 2 / (math.pi * modulus)) ^ (1 / 3)
end

return jkr
