-- JKR adhesion: known numbers, the extremum of the force, and the limit without adhesion.
local test = ...
local jkr = require("stiction.reference").jkr

local E, R, w = 6.497e6, 5e-3, 1

local function near(got, wanted, tolerance)
  if got ~= got or math.abs(got - wanted) > (tolerance or 1e-12) * math.abs(wanted) then
    error(("got %.17g, wanted %.17g"):format(got, wanted), 2)
  end
end

test("the pull-off forces of a known case", function()
  near(jkr.sphere.pull_off(R, w), 2.356e-2, 1e-3)
  near(jkr.cylinder.pull_off(E, R, w), 55.64, 1e-3)
  near(jkr.modulus(5e6, 0.48), E, 1e-4)
  near(jkr.stiffness(E, R, w), 1.04e12, 5e-3)
end)

for _, name in ipairs { "sphere", "cylinder" } do
  local shape = jkr[name]
  test("the force of a " .. name .. " is least at the pull-off", function()
    local a = shape.pull_off_radius(E, R, w)
    local least = name == "sphere" and -shape.pull_off(R, w) or -shape.pull_off(E, R, w)
    near(shape.force(E, R, w, a), least)
    local step = 1e-3 * a
    local left, right = shape.force(E, R, w, a - step), shape.force(E, R, w, a + step)
    assert(left > least and right > least)
    assert(math.abs(right - left) < 1e-2 * math.max(right - least, left - least))
  end)
end

test("the energy release rate at the edge is w", function()
  for _, a in ipairs { 1e-4, 2e-4, 4e-4 } do -- (P_hertz - P)^2/(8 pi E* a^3), (P_hertz - P)^2/(2 pi E* a)
    local hertz = 4 * E * a ^ 3 / (3 * R)
    near((hertz - jkr.sphere.force(E, R, w, a)) ^ 2 / (8 * math.pi * E * a ^ 3), w)
    hertz = math.pi * E * a ^ 2 / (4 * R)
    near((hertz - jkr.cylinder.force(E, R, w, a)) ^ 2 / (2 * math.pi * E * a), w)
  end
end)

test("without adhesion a sphere follows Hertz", function()
  local a = 2e-4
  local d = jkr.sphere.depth(E, R, 0, a)
  near(a ^ 2, R * d)
  near(jkr.sphere.force(E, R, 0, a), 4 / 3 * E * math.sqrt(R) * d ^ 1.5)
end)

test("adhesion acts on a sphere as a flat punch of its contact does", function()
  for _, a in ipairs { 1e-4, 4e-4 } do
    local less = 4 * E * a ^ 3 / (3 * R) - jkr.sphere.force(E, R, w, a)
    near(less / (a ^ 2 / R - jkr.sphere.depth(E, R, w, a)), 2 * E * a)
  end
end)
