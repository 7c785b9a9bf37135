-- Hertz and Cattaneo-Mindlin: known values, totals by quadrature, limits.
local test, equal = ...
local stiction = require "stiction"
local hertz = stiction.reference.line_contact

local function near(got, wanted, relative)
  local error_now = math.abs(got - wanted)
  if error_now ~= error_now or error_now > relative * math.abs(wanted) then
    error(("got %.12g, wanted %.12g"):format(got, wanted), 2)
  end
end

local function total(f, a)
  local xs, ys, n = {}, {}, 20000
  for i = 0, n do
    xs[i + 1] = -a + 2 * a * i / n
    ys[i + 1] = f(xs[i + 1])
  end
  return stiction.numeric.integral(xs, ys)
end

test("NAFEMS CGS-1: a and p0", function()
  local modulus = hertz.combined_modulus(210e9, 0.3, 70e9, 0.3)
  near(hertz.half_width(35e6, 0.05, modulus), 6.2146e-3, 1e-4)
  near(hertz.peak_pressure(35e6, 0.05, modulus), 3585.4e6, 1e-4)
end)

test("a rigid partner adds nothing", function()
  near(hertz.combined_modulus(1e9, 0), 1e9, 1e-15)
  near(hertz.combined_modulus(1e9, 0.5), 1e9 / 0.75, 1e-15)
end)

test("pressure and shear sum to the forces", function()
  local P, Q, mu, R, E = 1e6, 2e5, 0.4, 0.02, 3e9
  local a, p0 = hertz.half_width(P, R, E), hertz.peak_pressure(P, R, E)
  local c = hertz.stick_half_width(a, Q, mu, P)
  near(total(function(x) return hertz.pressure(x, a, p0) end, a), P, 1e-5)
  near(total(function(x) return hertz.shear(x, a, p0, c, mu) end, a), Q, 1e-4)
end)

test("the stick zone ends where everything slides", function()
  equal(hertz.stick_half_width(1, 0.4, 0.4, 1), 0)
  equal(hertz.stick_half_width(1, 0, 0.4, 1), 1)
  equal(hertz.shear(0.5, 1, 10, 0, 0.4), 0.4 * hertz.pressure(0.5, 1, 10))
end)

test("slip: none where it sticks, its gradient is that of the two half ellipses", function()
  local a, p0, c, mu, E = 2e-3, 5e8, 1e-3, 0.4, 3e9
  equal(hertz.slip(0.9 * c, a, p0, c, mu, E), 0)
  equal(hertz.slip(1.1 * a, a, p0, c, mu, E), 0)
  local x, h = 1.6e-3, 1e-8
  local gradient = (hertz.slip(x + h, a, p0, c, mu, E) - hertz.slip(x - h, a, p0, c, mu, E)) / (2 * h)
  near(gradient, 2 * mu * p0 / (E * a) * math.sqrt(x ^ 2 - c ^ 2), 1e-6)
  near(hertz.slip(-x, a, p0, c, mu, E), hertz.slip(x, a, p0, c, mu, E), 1e-15)
end)

test("work of friction: pi (mu p0 a)^2 / (8 E*) at the onset of sliding, none without shear", function()
  local a, p0, mu, E = 2e-3, 5e8, 0.4, 3e9
  near(hertz.friction_work(a, p0, 0, mu, E), math.pi * (mu * p0 * a) ^ 2 / (8 * E), 1e-5)
  equal(hertz.friction_work(a, p0, a, mu, E), 0)
end)

test("going back: nothing at first, the mirror image at the end, Q in between", function()
  local P, mu, R, E = 1e6, 0.4, 0.02, 3e9
  local a, p0 = hertz.half_width(P, R, E), hertz.peak_pressure(P, R, E)
  local c = hertz.stick_half_width(a, 3e5, mu, P)
  local function back(now)
    return function(x) return hertz.shear_back(x, a, p0, mu, { normal = P, forward = 3e5, now = now }) end
  end
  near(back(3e5)(0.9 * a), hertz.shear(0.9 * a, a, p0, c, mu), 1e-12)
  near(back(-3e5)(0.3 * a), -hertz.shear(0.3 * a, a, p0, c, mu), 1e-12)
  near(total(back(1e5), a), 1e5, 1e-3)
end)

test("sliding: Hertz without coupling; with it the force is held and the surface follows the cylinder", function()
  local P, R, E = 1e3, 0.02, 3e6
  local alone, p0 = hertz.sliding(P, R, E, 0), hertz.peak_pressure(P, R, E)
  near(alone.half_width, hertz.half_width(P, R, E), 1e-12)
  equal(alone.centre, 0)
  near(alone.pressure(0.3 * alone.half_width), hertz.pressure(0.3 * alone.half_width, alone.half_width, p0), 1e-12)

  local coupled = hertz.sliding(P, R, E, 0.4)
  local a, e, n = coupled.half_width, coupled.centre, 20000
  --- The integral of p(t) / (x - t) by midpoints of the angle, which lie evenly about the point X.
  local function conjugate(X)
    local sum = 0
    for i = 1, n do
      local at, width = a * math.cos(math.pi * (i - 0.5) / n), math.pi / n * a * math.sin(math.pi * (i - 0.5) / n)
      sum = sum + coupled.pressure(e + at) / (X - at) * width
    end
    return sum
  end
  local function slope(k) -- of the surface where the k-th and the next midpoint are equally far in angle
    local X = a * math.cos(math.pi * k / n)
    return (conjugate(X) / math.pi - 0.4 * coupled.pressure(e + X)) * 2 / E, (e + X) / R
  end
  for _, k in ipairs { n // 5, n // 2, 4 * n // 5 } do
    local found, known = slope(k)
    near(found, known, 1e-3)
  end
  near(total(function(x) return coupled.pressure(x + e) end, a), P, 1e-3)
end)
