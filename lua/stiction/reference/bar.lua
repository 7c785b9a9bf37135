-- An elastic bar that falls on a rigid floor: impact and bouncing in closed form (d'Alembert). SI numbers.
--
-- Young's modulus E, density rho, length L; c = sqrt(E / rho). The lower end is followed, its height is that of an
-- undeformed bar at rest before the fall, less its way.
local bar = {}

--- Speed of waves along the bar, sqrt(E / rho), m/s.
function bar.wave_speed(young, density)
  return math.sqrt(young / density)
end

--- The impact without gravity at the speed v0: {pressure = rho c v0, duration = 2 L / c}; the bar leaves at v0.
function bar.impact(t)
  local c = bar.wave_speed(t.young, t.density)
  return { pressure = t.density * c * t.speed, duration = 2 * t.length / c }
end

--- sum over n of 4 g cos(c k t) / (c^2 k^2), k = n pi / L: a parabola in each period 2 L / c,
--- since sum cos(n x) / n^2 = pi^2 / 6 - pi x / 2 + x^2 / 4 on [0, 2 pi].
function bar.flight_series(g, c, length, t)
  local x = math.pi * c * t / length % (2 * math.pi)
  return 4 * g * length ^ 2 / (c ^ 2 * math.pi ^ 2) * (math.pi ^ 2 / 6 - math.pi * x / 2 + x ^ 2 / 4)
end

local function check_flight(t, flight, wave)
  local turns = flight / wave
  if math.abs(turns - math.floor(turns + 0.5)) > 1e-9 or t.speed <= 2 * t.gravity * wave then
    error("the closed form needs a whole number of wave times in the fall, and sqrt(2 g h) > 2 g L / c", 3)
  end
end

-- Height of the lower end `time` after the bar took off with its speed v0 and the strain -2 g (L - x) / c^2.
local function flight_height(t, c, time)
  return t.speed * time - t.gravity * time ^ 2 / 2 - 2 * t.gravity * t.length ^ 2 / (3 * c ^ 2)
    + bar.flight_series(t.gravity, c, t.length, time)
end

--- The bar that bounces for ever (Doyen, Ern and Piperno 2011, 3.2): dropped undeformed from
--- `height` under `gravity`. {wave =, flight =, period =, height = function(t), pressure = function(t)}: t_w = L / c,
--- t_f = sqrt(2 h / g); contact on [t_f, t_f + 2 t_w] under rho c (v0 + g s), free flight of 2 t_f in which the bar
--- vibrates t_f / t_w times, contact again with the time reversed, and a rise to where it was: period 4 t_f + 4 t_w.
function bar.bounce(t)
  local c, g = bar.wave_speed(t.young, t.density), t.gravity
  local wave, flight = t.length / c, math.sqrt(2 * t.height / g)
  local all = { young = t.young, density = t.density, length = t.length, gravity = g, speed = g * flight }
  check_flight(all, flight, wave)
  local period, contact = 4 * flight + 4 * wave, 2 * wave
  -- s: the period folded about its middle, which is the top of the flight between the contacts
  local function folded(time)
    local s = time % period
    return math.min(s, period - s), s > period / 2
  end
  local function height(time)
    local s = folded(time)
    if s <= flight then
      return t.height - g * s ^ 2 / 2
    elseif s <= flight + contact then
      return 0
    end
    return flight_height(all, c, s - flight - contact)
  end
  local function pressure(time)
    local s = folded(time)
    local inside = s >= flight and s <= flight + contact
    return inside and t.density * c * (all.speed + g * (s - flight)) or 0
  end
  return { wave = wave, flight = flight, period = period, contact = contact, height = height, pressure = pressure,
    speed = all.speed }
end

return bar
