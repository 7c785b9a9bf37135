-- Laws of one contact point under a given motion: closed curves of adhesion and friction. Openings in m, SI numbers,
-- unless a function says that it takes them in the scales of the law.
local point_laws = { rcc = {}, bilinear = {}, exponential = {}, dugdale = {}, potential = {}, attraction = {}, friction = {} }

local rcc = point_laws.rcc

-- Nodes and weights of Gauss' rule of three points on 0 .. 1.
local gauss = {
  { 0.5 - math.sqrt(0.15), 5 / 18 }, { 0.5, 8 / 18 }, { 0.5 + math.sqrt(0.15), 5 / 18 },
}

--- Bond that is opened from contact, beta = 1, at the constant rate number V = v b/(w u0) to s_end, s = x/u0: the
--- solution of V dbeta/ds = 1 - s^2 beta beyond s = 1 (before, beta stays 1) by its integrating factor,
---   beta(s) = exp(-(s^3 - 1)/3V) [1 + 1/V int_1^s exp((y^3 - 1)/3V) dy],
--- and for V = 0 its limit min(1, s^-2). Lists over s with n intervals on 0 .. 1 and as many a unit beyond:
--- {s =, beta =, traction = s beta^2 (over sigma0), work =, loss =} (over w); the loss is int (1 - s^2 beta)^2/V ds.
--- An interval should be short beside V/s_end^2.
--- Source: Raous, Cangemi and Cocu 1999; physics.md 2.
function rcc.opening(V, s_end, n)
  local c = { s = { 0 }, beta = { 1 }, traction = { 0 }, work = { 0 }, loss = { 0 } }
  local beta, work, loss, h = 1, 0, 0, 1 / n
  local function advance(from, value, to)
    if to <= 1 then return 1 elseif V == 0 then return to ^ -2 end
    local sum, width = 0, to - from
    for _, g in ipairs(gauss) do sum = sum + g[2] * math.exp(((from + g[1] * width) ^ 3 - to ^ 3) / (3 * V)) end
    return value * math.exp((from ^ 3 - to ^ 3) / (3 * V)) + sum * width / V
  end
  for k = 1, math.floor(s_end * n + 0.5) do
    local from, to = (k - 1) * h, k * h
    for _, g in ipairs(gauss) do
      local s = from + g[1] * h
      local at = advance(from, beta, s)
      work = work + g[2] * h * s * at ^ 2
      loss = loss + (V > 0 and s > 1 and g[2] * h * (1 - s ^ 2 * at) ^ 2 / V or 0)
    end
    beta = advance(from, beta, to)
    c.s[k + 1], c.beta[k + 1], c.traction[k + 1], c.work[k + 1], c.loss[k + 1] = to, beta, to * beta ^ 2, work, loss
  end
  return c
end

--- Intensity of a bond at rest in contact, beta0 + w t/b up to 1, and what its growth takes, int b beta'^2 dt.
function rcc.at_rest(w, b, beta0, t)
  local beta = math.min(1, beta0 + w * t / b)
  return beta, w * (beta - beta0)
end

--- Shear over sigma0 of a bond (b = 0) under constant pressure, m = mu p/sigma0, s = x_t/u0 > 0; friction = "full" (mu)
--- or "damage" (mu (1 - beta)).
function rcc.shear(friction, m, s)
  local beta = math.min(1, s ^ -2)
  return s * beta ^ 2 + m * (friction == "damage" and 1 - beta or 1)
end

--- Traction {along t1, along t2} of a bond (b = 0) with two stiffnesses under the stretch x1, x2, Pa.
function rcc.orthotropic(w, C1, C2, x1, x2)
  local q = C1 * x1 ^ 2 + C2 * x2 ^ 2
  local beta = math.min(1, w / q)
  return C1 * x1 * beta ^ 2, C2 * x2 * beta ^ 2
end

-- Root of f between low, where f < 0, and high, where f > 0.
local function root(f, low, high)
  for _ = 1, 200 do
    local middle = 0.5 * (low + high)
    if f(middle) < 0 then low = middle else high = middle end
  end
  return 0.5 * (low + high)
end

--- Opening s of a bond (b = 0) in series with a bar of stiffness k C whose end moved by D u0, opened from 0: up to
--- D = 1 + 1/k the bond is whole; beyond, s + s^-3/k = D on the outer branch, whose least D is at s^4 = 3/k.
function rcc.in_series(k, D)
  if D <= 1 + 1 / k then return D / (1 + 1 / k) end
  return root(function(s) return s + s ^ -3 / k - D end, math.max(1, (3 / k) ^ 0.25), D + 1)
end

--- Fall of the traction over sigma0 at the end D = 1 + 1/k: none where k >= 3.
function rcc.jump(k)
  return 1 - rcc.in_series(k, (1 + 1 / k) * (1 + 1e-15)) ^ -3
end

--- Openings at which damage begins and ends along the ray x_t = r x_n, m (Camanho and Davila 2002): quadratic onset of the
--- strengths; law = {K, sigma_n, sigma_t, G_I, G_II, exponent} mixes by Benzeggagh and Kenane 1996, without exponent
--- linearly: 1/G = (1 - B)/G_I + B/G_II. r may be math.huge.
function point_laws.bilinear.openings(law, r)
  local first_n, first_t = law.sigma_n / law.K, law.sigma_t / law.K
  local B = r == math.huge and 1 or r ^ 2 / (1 + r ^ 2)
  local start = first_t
  if r < math.huge then
    start = first_n * first_t * math.sqrt((1 + r ^ 2) / (first_t ^ 2 + (r * first_n) ^ 2))
  end
  local G = 1 / ((1 - B) / law.G_I + B / law.G_II)
  if law.exponent then G = law.G_I + (law.G_II - law.G_I) * B ^ law.exponent end
  return start, 2 * G / (law.K * start), G
end

--- Traction along the ray at the opening d = |(x_n, x_t)|, Pa.
function point_laws.bilinear.traction(law, r, d)
  local start, finish = point_laws.bilinear.openings(law, r)
  if d <= start then return law.K * d elseif d >= finish then return 0 end
  return law.K * start * (finish - d) / (finish - start)
end

--- Normal and tangential traction of the potential of Xu and Needleman 1994, Pa; law = {phi_n, delta_n, delta_t, q, r}.
function point_laws.exponential.traction(law, x_n, x_t)
  local u, v, r, q = x_n / law.delta_n, (x_t / law.delta_t) ^ 2, law.r, law.q
  local eu, ev = math.exp(-u), math.exp(-v)
  local normal = law.phi_n / law.delta_n * eu * (u * ev + (1 - q) / (r - 1) * (1 - ev) * (r - u))
  local along = 2 * law.phi_n * x_t / law.delta_t ^ 2 * (q + (r - q) / (r - 1) * u) * eu * ev
  return normal, along
end

--- Its potential over the state of rest, J/m^2.
function point_laws.exponential.energy(law, x_n, x_t)
  local u, v, r, q = x_n / law.delta_n, (x_t / law.delta_t) ^ 2, law.r, law.q
  return law.phi_n * (1 + math.exp(-u) * ((1 - r + u) * (1 - q) / (r - 1)
    - (q + (r - q) / (r - 1) * u) * math.exp(-v)))
end

--- Dugdale's traction with ramps of `ramp` h0 from contact and beyond h0, Pa.
function point_laws.dugdale.traction(sigma0, h0, ramp, x)
  return sigma0 * math.max(0, math.min(1, x / (ramp * h0), 1 + (h0 - x) / (ramp * h0)))
end

--- w/delta (x/delta) exp(-x/delta) of Rose, Ferrante and Smith 1981, Pa.
function point_laws.potential.traction(w, delta, x)
  return w * x / delta ^ 2 * math.exp(-x / delta)
end

--- w/range exp(-x/range) of the contact mechanics challenge (Muser 2017), Pa.
function point_laws.attraction.traction(w, range, x)
  return w / range * math.exp(-x / range)
end

--- min(mu p, tau_max) (Orowan 1943), Pa.
function point_laws.friction.tresca(mu, tau_max, p)
  return math.min(mu * p, tau_max)
end

--- Shear with a coefficient that goes from mu_0 to mu_inf with the pressure; decay is "exponential" or "thirion", Pa.
function point_laws.friction.pressure(mu_0, mu_inf, p_ref, decay, p)
  local part = decay == "thirion" and p_ref / (p_ref + p) or math.exp(-p / p_ref)
  return p * (mu_inf + (mu_0 - mu_inf) * part)
end

--- Coefficient at the speed v, mu_k + (mu_s - mu_k) exp(-v/v_ref) (Tustin 1947).
function point_laws.friction.velocity(mu_s, mu_k, v_ref, v)
  return mu_k + (mu_s - mu_k) * math.exp(-v / v_ref)
end

return point_laws
