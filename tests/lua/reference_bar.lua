-- The falling bar against the published numbers, its own series, the balance of momentum and of energy.
local test, _, fails = ...
local bar = require("stiction").reference.bar

local numbers = { young = 900, density = 1, length = 10, gravity = 10, height = 5 }
local bounce = bar.bounce(numbers)

local function near(got, wanted, tolerance)
  if got ~= got or math.abs(got - wanted) > tolerance then
    error(("got %.15g, wanted %.15g"):format(got, wanted), 2)
  end
end

local function integral(f, from, to, count)
  local sum, h = 0, (to - from) / count
  for i = 1, count do
    sum = sum + f(from + (i - 0.5) * h) * h
  end
  return sum
end

test("the impact of the published bar: 300 Pa for 2/3 s", function()
  local impact = bar.impact { young = 900, density = 1, length = 10, speed = 10 }
  near(impact.pressure, 300, 1e-12)
  near(impact.duration, 2 / 3, 1e-15)
end)

test("times of Doyen, Ern and Piperno: t_w = 1/3, t_f = 1, contact from 1 and from 3 + 2 t_w, period 16 t_w", function()
  near(bounce.wave, 1 / 3, 1e-15)
  near(bounce.flight, 1, 1e-15)
  near(bounce.period, 16 / 3, 1e-14)
  local tw, tiny = 1 / 3, 1e-9
  for _, at in ipairs { 1, 3 + 2 * tw } do
    near(bounce.pressure(at - tiny), 0, 0)
    near(bounce.pressure(at + 2 * tw + tiny), 0, 0)
    assert(bounce.pressure(at + tiny) > 200 and bounce.pressure(at + 2 * tw - tiny) > 200)
  end
end)

test("the flight is the published series", function()
  local c, tw = 30, 1 / 3
  for i = 1, 20 do
    local t, sum = 0.1 * i - 0.03, 0
    for n = 1, 40000 do
      local k = n * math.pi / 10
      sum = sum + 4 * 10 / (c ^ 2 * k ^ 2) * math.cos(c * k * t)
    end
    near(bar.flight_series(10, c, 10, t), sum, 2e-5)
    -- the published origin of time is the take-off, t_f = 1 the time to the top
    near(bounce.height(1 + 2 * tw + t), 5 - 10 * (t - 1) ^ 2 / 2 - 2 * 10 * 100 / (3 * 900) + sum, 2e-5)
  end
end)

test("the path is continuous, above the floor, periodic and its own mirror image", function()
  for i = 0, 4000 do
    local t = i * bounce.period / 4000
    local height = bounce.height(t)
    assert(height >= -1e-12, ("below the floor at %g"):format(t))
    near(bounce.height(t + bounce.period), height, 1e-9)
    near(bounce.height(bounce.period - t), height, 1e-9)
    near(bounce.height(t + 1e-7), height, 1e-5)
  end
  near(bounce.height(0), 5, 0)
end)

test("the impulse of the floor turns the momentum about and carries the weight", function()
  local mass = 10
  near(integral(bounce.pressure, 0.9, 1.8, 900000), mass * (2 * 10 + 10 * 2 / 3), 0.01)
  near(integral(bounce.pressure, 0, bounce.period, 1600000), mass * 10 * bounce.period, 0.01)
end)

test("the pressure of the two contacts is the same with the time reversed", function()
  near(bounce.pressure(1.0001), 300, 0.1)
  near(bounce.pressure(1.6666), 500, 0.1)
  near(bounce.pressure(3.6667), 500, 0.1)
  near(bounce.pressure(4.3332), 300, 0.1)
end)

test("other bars than those that come back to rest are refused", function()
  local function make(height)
    return function()
      return bar.bounce { young = 900, density = 1, length = 10, gravity = 10, height = height }
    end
  end
  fails("whole number of wave times", make(4))
  fails("whole number of wave times", make(5 / 9)) -- t_f = t_w: it never leaves
end)
