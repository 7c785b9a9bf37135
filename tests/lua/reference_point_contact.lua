-- Hertz's sphere: a value by hand, inverse relations, the force by quadrature.
local test, equal = ...
local stiction = require "stiction"
local hertz = stiction.reference.point_contact

local function near(got, wanted, relative)
  local error_now = math.abs(got - wanted)
  if error_now ~= error_now or error_now > relative * math.abs(wanted) then
    error(("got %.12g, wanted %.12g"):format(got, wanted), 2)
  end
end

test("E* = 3/4 Pa, R = 1 m, d = 0.01 m: P, a and p0 by hand", function()
  near(hertz.force(0.01, 1, 0.75), 1e-3, 1e-12)
  near(hertz.contact_radius(1e-3, 1, 0.75), 0.1, 1e-12)
  near(hertz.peak_pressure(1e-3, 1, 0.75), 0.15 / math.pi, 1e-12)
  equal(hertz.force(-1, 1, 0.75), 0)
end)

test("depth undoes force, and a^2 = R d", function()
  local R, E, d = 0.03, 7e9, 2e-5
  local P = hertz.force(d, R, E)
  near(hertz.depth(P, R, E), d, 1e-12)
  near(hertz.contact_radius(P, R, E), math.sqrt(R * d), 1e-12)
end)

test("p0 = 2 E* a / (pi R)", function()
  local R, E, P = 0.03, 7e9, 50
  near(hertz.peak_pressure(P, R, E), 2 * E * hertz.contact_radius(P, R, E) / (math.pi * R), 1e-12)
end)

test("the pressure sums to the force and ends at a", function()
  local R, E, P = 0.03, 7e9, 50
  local a, p0 = hertz.contact_radius(P, R, E), hertz.peak_pressure(P, R, E)
  local r, ring, n = {}, {}, 20000
  for i = 0, n do
    r[i + 1] = a * i / n
    ring[i + 1] = 2 * math.pi * r[i + 1] * hertz.pressure(r[i + 1], a, p0)
  end
  near(stiction.numeric.integral(r, ring), P, 1e-5)
  equal(hertz.pressure(a, a, p0), 0)
  equal(hertz.pressure(1.5 * a, a, p0), 0)
end)

test("two equal bodies halve E*", function()
  near(hertz.combined_modulus(2e9, 0.3, 2e9, 0.3), 0.5 * hertz.combined_modulus(2e9, 0.3), 1e-12)
end)
