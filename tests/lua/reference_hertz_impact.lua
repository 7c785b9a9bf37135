-- Impact by Hertz: energy at the turn, the known constant, and the equation of motion.
local test = ...
local hertz = require("stiction.reference").hertz_impact
local numeric = require "stiction.numeric"

local E, R, m, v = 1.1e7, 0.01, 0.03, 0.01

local function near(got, wanted, tolerance)
  if got ~= got or math.abs(got - wanted) > tolerance * math.abs(wanted) then
    error(("got %.17g, wanted %.17g"):format(got, wanted), 2)
  end
end

test("at the turn all energy is stored: 2/5 force depth = m v^2/2", function()
  local d = hertz.depth(E, R, m, v)
  near(0.4 * hertz.force(E, R, d) * d, m * v ^ 2 / 2, 1e-12)
end)

test("the constant is 2.943 (Johnson, 11.24), and is the integral", function()
  near(hertz.constant, 2.94, 2e-3)
  local sum, n = 0, 20000 -- x = 1 - y^2 takes the root's singularity away
  for k = 1, n do
    local y = (k - 0.5) / n
    sum = sum + 2 * y / math.sqrt(1 - (1 - y ^ 2) ^ 2.5) / n
  end
  near(hertz.constant, 2 * sum, 1e-7)
end)

test("the history turns at the depth in the middle of the contact, and leaves", function()
  local list = hertz.history(E, R, m, v, 400)
  local d, at = numeric.max(list.d)
  near(d, hertz.depth(E, R, m, v), 1e-4)
  near(at, 201, 1e-12)
  near(1 + list.d[401] / d, 1, 1e-4)
end)

test("faster or heavier: deeper, and a shorter or longer time", function()
  near(hertz.depth(E, R, m, 32 * v), hertz.depth(E, R, m, v) * 16, 1e-12)
  near(hertz.duration(E, R, m, 32 * v), hertz.duration(E, R, m, v) / 2, 1e-12)
  near(hertz.duration(E, R, 32 * m, v), hertz.duration(E, R, m, v) * 4, 1e-12)
end)
