-- Maugis-Dugdale: its limits DMT and JKR, a published fit between them, and its defining equation.
local test = ...
local reference = require "stiction.reference"
local maugis, jkr = reference.maugis, reference.jkr

local E, R, w = 6.497e6, 5e-3, 1

local function near(got, wanted, tolerance)
  if got ~= got or math.abs(got - wanted) > (tolerance or 1e-12) * math.abs(wanted) then
    error(("got %.17g, wanted %.17g"):format(got, wanted), 2)
  end
end

test("lambda and the traction are each other's inverse", function()
  near(maugis.lambda(E, R, w, maugis.traction(E, R, w, 0.7)), 0.7)
  near(maugis.lambda(E, R, w, 1e5), 2e5 * (9 * R / (16 * math.pi * w * E ^ 2)) ^ (1 / 3))
end)

test("the pull-off goes from 2 to 3/2", function()
  near(maugis.pull_off(1e-3), 2, 5e-3)
  near(maugis.pull_off(50), 1.5, 1e-3)
  local last = 2
  for _, lambda in ipairs { 0.01, 0.03, 0.1, 0.3, 1, 3, 10 } do
    local now = maugis.pull_off(lambda)
    assert(now < last and now > 1.5, ("at lambda %g it is %g"):format(lambda, now))
    last = now
  end
end)

test("the pull-off is near the fit of Carpick, Ogletree and Salmeron 1999", function()
  for _, lambda in ipairs { 0.05, 0.1, 0.3, 1, 2, 5 } do
    local x = 4.04 * lambda ^ 1.4
    near(maugis.pull_off(lambda), 1.75 - 0.25 * (x - 1) / (x + 1), 0.02)
  end
end)

test("at a point contact m a* solves a quadratic", function()
  for _, lambda in ipairs { 0.1, 0.5, 1 } do -- pi/4 lambda c^2 + 4/3 (pi/2 - 1) lambda^2 c = 1, P* = - pi/2 lambda c^2
    local A, B = math.pi / 4 * lambda, 4 / 3 * (math.pi / 2 - 1) * lambda ^ 2
    local c = (math.sqrt(B ^ 2 + 4 * A) - B) / (2 * A)
    near(maugis.force(lambda, 1e-6), -math.pi / 2 * lambda * c ^ 2, 1e-5)
  end
end)

test("a large lambda is JKR over all contact radii", function()
  local length, force, depth = maugis.units(E, R, w)
  for _, a in ipairs { 0.9, 1.2, 2 } do
    near(maugis.force(100, a) * force, jkr.sphere.force(E, R, w, a * length), 5e-3)
  end
  for _, a in ipairs { 1.5, 2 } do
    near(maugis.depth(100, a) * depth, jkr.sphere.depth(E, R, w, a * length), 2e-2)
  end
end)

test("the opening at the zone's end is the range, in SI", function()
  local length = maugis.units(E, R, w)
  for _, lambda in ipairs { 0.3, 1, 2 } do
    local sigma0 = maugis.traction(E, R, w, lambda)
    for _, dimensionless in ipairs { 0.5, 1.5 } do
      local a, m = dimensionless * length, maugis.ratio(lambda, dimensionless)
      local root, angle = math.sqrt(m * m - 1), math.acos(1 / m)
      local opening = a ^ 2 / (math.pi * R) * (root + (m * m - 2) * angle)
        + 4 * sigma0 * a / (math.pi * E) * (root * angle + 1 - m)
      near(opening, w / sigma0, 1e-9)
    end
  end
end)
