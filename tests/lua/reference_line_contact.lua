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
