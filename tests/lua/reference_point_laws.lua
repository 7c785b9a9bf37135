-- Laws of one point: numbers known beforehand, limits, and energies.
local test = ...
local laws = require("stiction.reference").point_laws
local numeric = require "stiction.numeric"
local rcc = laws.rcc

local function near(got, wanted, tolerance)
  if got ~= got or math.abs(got - wanted) > (tolerance or 1e-12) * math.abs(wanted) then
    error(("got %.17g, wanted %.17g"):format(got, wanted), 2)
  end
end

test("opening: peak and work at V* = 0.1 and 1", function()
  for _, known in ipairs { { 0.1, 1.01326, 1.0274, 1.07261 }, { 1, 1.10795, 1.2075, 1.51453 } } do
    local c = rcc.opening(known[1], 10, 2000)
    local peak, at = numeric.max(c.traction)
    near(peak, known[2], 1e-5)
    near(c.s[at], known[3], 1e-3)
    local work = c.work[#c.work] + 1 / (2 * 10 ^ 2) -- beyond, the traction is s^-3
    near(work, known[4], 2e-5)
    near(work, 1 + c.loss[#c.loss], 2e-5)
  end
end)

test("opening: work is the rise of psi over w plus the loss, at every s", function()
  local c = rcc.opening(1, 4, 400)
  for _, k in ipairs { 200, 800, 1601 } do
    local psi = c.beta[k] ^ 2 * c.s[k] ^ 2 / 2 - c.beta[k] + 1
    near(c.work[k], psi + c.loss[k], 1e-9)
  end
end)

test("opening: V* = 0 has work 1 - 1/(2 s^2) and no loss, and small V* tends to it", function()
  local c = rcc.opening(0, 5, 200)
  near(c.work[#c.work], 1 - 1 / 50, 1e-9)
  near(c.traction[401], 1 / 8)
  assert(c.loss[#c.loss] == 0)
  near(rcc.opening(1e-3, 5, 4000).work[20001], c.work[#c.work], 5e-3)
end)

test("at rest beta grows to 1 and no further, and the loss is what psi gives", function()
  local beta, loss = rcc.at_rest(2, 4, 0.1, 1)
  near(beta, 0.6)
  near(loss, 1)
  near(loss, 4 * 0.5 ^ 2 * 1) -- b beta'^2 t
  assert(rcc.at_rest(2, 4, 0.1, 10) == 1)
end)

test("shear: peak 1 + m, and the dip of damaged friction", function()
  near(rcc.shear("full", 0.5, 1), 1.5)
  near(rcc.shear("full", 0.5, 1e4), 0.5, 1e-9)
  near(rcc.shear("damage", 1, 1.5), 0.8519, 1e-4)
  assert(rcc.shear("damage", 1, 1.49) > rcc.shear("damage", 1, 1.5))
  assert(rcc.shear("damage", 1, 1.51) > rcc.shear("damage", 1, 1.5))
end)

test("orthotropic: equal stiffnesses are isotropic, and q = w at the peak along an axis", function()
  local t1, t2 = rcc.orthotropic(1, 4, 4, 0.3, 0.4)
  near(t1, 1.2)
  near(t2, 1.6)
  near((rcc.orthotropic(1, 4, 9, 0.5, 0)), 2)
  near((rcc.orthotropic(1, 4, 9, 1, 0)), 4 * 1 / 16)
end)

test("in series: no jump from 3 C on, and the curve solves equilibrium", function()
  assert(rcc.jump(4) < 1e-6 and rcc.jump(3) < 1e-3)
  local s = rcc.in_series(2, 1.5 * (1 + 1e-15))
  near(s + s ^ -3 / 2, 1.5)
  near(rcc.jump(2), 1 - s ^ -3)
  near(rcc.in_series(2, 0.75), 0.5)
  near(rcc.in_series(4, 2) + rcc.in_series(4, 2) ^ -3 / 4, 2)
end)

test("bilinear: pure modes and the work under the curve", function()
  local law = { K = 1e9, sigma_n = 1e4, sigma_t = 2e4, G_I = 1, G_II = 3, exponent = 2 }
  local start, finish = laws.bilinear.openings(law, 0)
  near(start, 1e-5)
  near(finish, 2e-4)
  start, finish = laws.bilinear.openings(law, math.huge)
  near(start, 2e-5)
  near(finish, 3e-4)
  local G
  start, finish, G = laws.bilinear.openings(law, 1)
  near(G, 1.5)
  near(law.K * start * finish / 2, G)
  near((start / math.sqrt(2) * law.K / 1e4) ^ 2 + (start / math.sqrt(2) * law.K / 2e4) ^ 2, 1)
  law.exponent = nil
  near(select(3, laws.bilinear.openings(law, 1)), 1.5)
  near(laws.bilinear.traction(law, 0, 1.05e-4), 5e3)
  assert(laws.bilinear.traction(law, 0, 1) == 0)
end)

test("exponential: tractions are derivatives of the energy; strengths of the pure modes", function()
  local law = { phi_n = 2, delta_n = 1e-3, delta_t = 2e-3, q = 0.6, r = 0.2 }
  local x, y, h = 0.7e-3, 0.9e-3, 1e-7
  local normal, along = laws.exponential.traction(law, x, y)
  local e = laws.exponential.energy
  near((e(law, x + h, y) - e(law, x - h, y)) / (2 * h), normal, 1e-7)
  near((e(law, x, y + h) - e(law, x, y - h)) / (2 * h), along, 1e-7)
  near((laws.exponential.traction(law, 1e-3, 0)), 2 / (math.exp(1) * 1e-3))
  near(select(2, laws.exponential.traction(law, 0, 2e-3 / math.sqrt(2))), 1.2 * math.sqrt(2 / math.exp(1)) / 2e-3)
  assert(math.abs(e(law, 0, 0)) < 1e-15)
  near(e(law, 1, 0), 2)
end)

test("Dugdale and the short potential: strength and work", function()
  near(laws.dugdale.traction(5, 2, 0.1, 1), 5)
  near(laws.dugdale.traction(5, 2, 0.1, 0.1), 2.5)
  near(laws.dugdale.traction(5, 2, 0.1, 2.1), 2.5)
  assert(laws.dugdale.traction(5, 2, 0.1, 3) == 0)
  near(laws.potential.traction(2, 0.1, 0.1), 20 / math.exp(1))
  near(laws.attraction.traction(2, 0.1, 0), 20)
  near(laws.attraction.traction(2, 0.1, 0.1), 20 / math.exp(1))
end)

test("friction: the borders of each law", function()
  local f = laws.friction
  near(f.tresca(0.5, 3, 4), 2)
  near(f.tresca(0.5, 3, 40), 3)
  near(f.pressure(0.8, 0.2, 10, "exponential", 1e-9), 0.8e-9, 1e-9)
  near(f.pressure(0.8, 0.2, 10, "thirion", 10), 5)
  near(f.pressure(0.8, 0.2, 10, "exponential", 1e4), 2e3)
  near(f.velocity(0.8, 0.2, 1, 0), 0.8)
  near(f.velocity(0.8, 0.2, 1, 1), 0.2 + 0.6 / math.exp(1))
end)
