-- Impact of a mass with a round tip on an elastic half-space, slow beside its waves; SI numbers.
-- Source: Johnson 1985, 11.4.
local hertz_impact = {}

--- Force at the approach d, N: 4/3 E* sqrt(R) d^3/2; none when apart.
function hertz_impact.force(modulus, radius, d)
  return d > 0 and 4 / 3 * modulus * math.sqrt(radius) * d ^ 1.5 or 0
end

--- Largest approach of the mass m that arrives at the speed v, m: (15 m v^2/(16 E* sqrt R))^2/5.
function hertz_impact.depth(modulus, radius, mass, v)
  return (15 * mass * v ^ 2 / (16 * modulus * math.sqrt(radius))) ^ 0.4
end

--- 2 int_0^1 dx/sqrt(1 - x^5/2) = 4/5 sqrt(pi) Gamma(2/5)/Gamma(9/10): 2.943.
hertz_impact.constant = 2.9432751843247

--- Time in contact, s: constant d/v.
function hertz_impact.duration(modulus, radius, mass, v)
  return hertz_impact.constant * hertz_impact.depth(modulus, radius, mass, v) / v
end

--- Approach and force over n equal intervals of the time in contact {t =, d =, force =}: m d'' = - force(d) from d = 0
--- at v, by the rule of Runge and Kutta of fourth order.
function hertz_impact.history(modulus, radius, mass, v, n)
  local h = hertz_impact.duration(modulus, radius, mass, v) / n
  local function pull(d) return -hertz_impact.force(modulus, radius, d) / mass end
  local d, u, list = 0, v, { t = { 0 }, d = { 0 }, force = { 0 } }
  for k = 1, n do
    local u1, a1 = u, pull(d)
    local u2, a2 = u + h / 2 * a1, pull(d + h / 2 * u1)
    local u3, a3 = u + h / 2 * a2, pull(d + h / 2 * u2)
    local u4, a4 = u + h * a3, pull(d + h * u3)
    d, u = d + h / 6 * (u1 + 2 * u2 + 2 * u3 + u4), u + h / 6 * (a1 + 2 * a2 + 2 * a3 + a4)
    list.t[k + 1], list.d[k + 1], list.force[k + 1] = k * h, d, hertz_impact.force(modulus, radius, d)
  end
  return list
end

return hertz_impact
