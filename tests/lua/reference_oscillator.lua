-- The recursions of the time schemes against what is known of them: what they keep, their order, their limits.
local test = ...
local oscillator = require("stiction").reference.oscillator
local schemes = require("stiction").schemes

local function near(got, wanted, tolerance)
  if got ~= got or math.abs(got - wanted) > tolerance then
    error(("got %.15g, wanted %.15g"):format(got, wanted), 2)
  end
end

test("the trapezium keeps the energy at any step, however it is written", function()
  for _, method in ipairs { { "jean", 0.5, 0.5 }, { "newmark", 0.25, 0.5 }, { "generalised_alpha", 1 }, { "hht", 0 } } do
    for _, phase in ipairs { 0.1, 3, 40 } do
      near(oscillator.energy_kept(method, phase, 50), 1, 1e-11)
    end
  end
end)

test("backward Euler divides the energy by 1 + z in each step", function()
  near(oscillator.energy_kept({ "jean", 1, 1 }, 0.5, 3), 1.25 ^ -3, 1e-14)
end)

test("central differences turn by 2 asin(omega dt / 2)", function()
  local phase, steps = 0.4, 7
  local turn = 2 * math.asin(phase / 2)
  near(oscillator.swing({ "central_difference" }, phase, steps), phase / math.sin(turn) * math.sin(steps * turn), 1e-14)
end)

test("generalised alpha leaves rho_inf of an endless frequency in each step", function()
  local method = { "generalised_alpha", 0.6 }
  local at, later = oscillator.swing(method, 1e7, 40), oscillator.swing(method, 1e7, 41)
  near(math.abs(later / at), 0.6 * 41 / 40, 0.02) -- a double root: n rho^n
end)

test("every scheme of the list with a recursion has the order that the list claims", function()
  local count = 0
  for _, name in ipairs(schemes.names()) do
    local about = schemes.about(name)
    if about.recursion then
      count = count + 1
      local function error_of(steps)
        return math.abs(oscillator.swing(about.recursion, 2 / steps, steps) - math.sin(2))
      end
      near(math.log(error_of(400) / error_of(800)) / math.log(2), about.order, 0.05)
    end
  end
  assert(count > 10)
end)

test("a bar's frequencies tend to the string's, from above and from below", function()
  local exact = 30 * math.pi / 20
  local consistent, lumped = oscillator.bar_frequency(30, 10, 0.1, 1), oscillator.bar_frequency(30, 10, 0.1, 1, true)
  assert(lumped < exact and exact < consistent)
  near(consistent, exact, 1e-4 * exact)
  near(lumped, exact, 1e-4 * exact)
end)

test("the modes of a sag add up to it, and their energies to its own", function()
  for _, lumped in ipairs { false, true } do
    local tip, share = 0, 0
    for _, mode in ipairs(oscillator.sag_modes(30, 10, 5, lumped)) do
      tip, share = tip + mode.tip, share + mode.share
    end
    near(tip, 1, 1e-12)
    near(share, 1, 1e-12)
  end
  near(oscillator.sag_modes(30, 10, 3000)[1].share, 96 / math.pi ^ 4, 1e-4)
end)
