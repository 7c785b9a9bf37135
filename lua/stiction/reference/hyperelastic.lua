-- Isotropic solids in homogeneous states, from their energy in the principal stretches; SI numbers.
-- A law has energy(l1, l2, l3), J/m^3, and kirchhoff(l1, l2, l3): three numbers l_i dW/dl_i, Pa.
-- Source: Ogden 1984, chapters 4 and 7.
local hyperelastic = {}

--- G and K of Young's modulus and Poisson's ratio, Pa.
function hyperelastic.moduli(young, poisson)
  return young / (2 * (1 + poisson)), young / (3 * (1 - 2 * poisson))
end

-- The stretches without the change of volume, l_i J^-1/3, and J.
local function distortion(l1, l2, l3)
  local J = l1 * l2 * l3
  local scale = J ^ (-1 / 3)
  return { l1 * scale, l2 * scale, l3 * scale }, J
end

local function sum_of_powers(l, power)
  return l[1] ^ power + l[2] ^ power + l[3] ^ power
end

-- W = energy(l') + K/2 (J - 1)^2, where slopes(l') = {l'_i dW/dl'_i}: the chain rule leaves their deviator, and the
-- volume adds K J (J - 1).
local function split(bulk, energy, slopes)
  return {
    energy = function(l1, l2, l3)
      local l, J = distortion(l1, l2, l3)
      return energy(l) + bulk / 2 * (J - 1) ^ 2
    end,
    kirchhoff = function(l1, l2, l3)
      local l, J = distortion(l1, l2, l3)
      local t = slopes(l)
      local level = bulk * J * (J - 1) - (t[1] + t[2] + t[3]) / 3
      return t[1] + level, t[2] + level, t[3] + level
    end,
  }
end

-- A function of I1' alone, with its derivative: l dW/dl = 2 W' l^2.
local function of_first_invariant(bulk, energy, slope)
  return split(bulk, function(l) return energy(sum_of_powers(l, 2)) end, function(l)
    local twice = 2 * slope(sum_of_powers(l, 2))
    return { twice * l[1] ^ 2, twice * l[2] ^ 2, twice * l[3] ^ 2 }
  end)
end

--- W = G/2 (I1' - 3) + K/2 (J - 1)^2.
function hyperelastic.neo_hookean(young, poisson)
  local G, K = hyperelastic.moduli(young, poisson)
  return of_first_invariant(K, function(I) return G / 2 * (I - 3) end, function() return G / 2 end)
end

--- W = C10 x + C20 x^2 + C30 x^3 + K/2 (J - 1)^2, x = I1' - 3 (Yeoh 1993).
function hyperelastic.yeoh(c10, c20, c30, bulk)
  return of_first_invariant(bulk, function(I) return c10 * (I - 3) + c20 * (I - 3) ^ 2 + c30 * (I - 3) ^ 3 end,
    function(I) return c10 + 2 * c20 * (I - 3) + 3 * c30 * (I - 3) ^ 2 end)
end

--- W = mu sum c_i (I1'^i - 3^i)/N^(i-1), five terms, N = lambda_m^2 (Arruda and Boyce 1993), mu such that the shear
--- modulus at rest, 2 dW/dI1', is G.
function hyperelastic.arruda_boyce(shear, lambda_m, bulk)
  local c, N = { 1 / 2, 1 / 20, 11 / 1050, 19 / 7000, 519 / 673750 }, lambda_m ^ 2
  local function energy(I)
    local sum = 0
    for i = 1, 5 do sum = sum + c[i] * (I ^ i - 3 ^ i) / N ^ (i - 1) end
    return sum
  end
  local function slope(I)
    local sum = 0
    for i = 1, 5 do sum = sum + i * c[i] * (I / N) ^ (i - 1) end
    return sum
  end
  local mu = shear / (2 * slope(3))
  return of_first_invariant(bulk, function(I) return mu * energy(I) end, function(I) return mu * slope(I) end)
end

--- W = C10 (I1' - 3) + C01 (I2' - 3) + K/2 (J - 1)^2; I2' is the sum of l'^-2, as l'1 l'2 l'3 = 1.
function hyperelastic.mooney_rivlin(c10, c01, bulk)
  return split(bulk, function(l) return c10 * (sum_of_powers(l, 2) - 3) + c01 * (sum_of_powers(l, -2) - 3) end,
    function(l)
      local slopes = {}
      for i = 1, 3 do slopes[i] = 2 * c10 * l[i] ^ 2 - 2 * c01 * l[i] ^ -2 end
      return slopes
    end)
end

--- W = sum mu_p/alpha_p (sum l'^alpha_p - 3) + K/2 (J - 1)^2 (Ogden 1972).
function hyperelastic.ogden(mu, alpha, bulk)
  return split(bulk, function(l)
    local sum = 0
    for p = 1, #mu do sum = sum + mu[p] / alpha[p] * (sum_of_powers(l, alpha[p]) - 3) end
    return sum
  end, function(l)
    local slopes = { 0, 0, 0 }
    for p = 1, #mu do
      for i = 1, 3 do slopes[i] = slopes[i] + mu[p] * l[i] ^ alpha[p] end
    end
    return slopes
  end)
end

--- W = G/2 (I2/I3 + 2 J - 5): I2/I3 is the sum of l^-2 (Blatz and Ko 1962).
function hyperelastic.blatz_ko(shear)
  return {
    energy = function(l1, l2, l3)
      return shear / 2 * (sum_of_powers({ l1, l2, l3 }, -2) + 2 * l1 * l2 * l3 - 5)
    end,
    kirchhoff = function(l1, l2, l3)
      local J = l1 * l2 * l3
      return shear * (J - l1 ^ -2), shear * (J - l2 ^ -2), shear * (J - l3 ^ -2)
    end,
  }
end

--- W = lambda/2 (tr E)^2 + G E:E, E_i = (l_i^2 - 1)/2.
function hyperelastic.st_venant_kirchhoff(young, poisson)
  local G, K = hyperelastic.moduli(young, poisson)
  local lame = K - 2 * G / 3
  local function strains(...)
    local E = {}
    for i, l in ipairs { ... } do E[i] = (l ^ 2 - 1) / 2 end
    return E, E[1] + E[2] + E[3]
  end
  return {
    energy = function(l1, l2, l3)
      local E, trace = strains(l1, l2, l3)
      return lame / 2 * trace ^ 2 + G * sum_of_powers(E, 2)
    end,
    kirchhoff = function(l1, l2, l3)
      local E, trace = strains(l1, l2, l3)
      return l1 ^ 2 * (lame * trace + 2 * G * E[1]), l2 ^ 2 * (lame * trace + 2 * G * E[2]),
        l3 ^ 2 * (lame * trace + 2 * G * E[3])
    end,
  }
end

--- Force per reference area under the stretch l with free sides, Pa, and the lateral stretch: the one root of
--- dW/dl2 = 0 at l1 = l, l2 = l3, found by halving an interval.
function hyperelastic.uniaxial(law, l)
  local function side(q) return (select(2, law.kirchhoff(l, q, q))) end
  local low, high = 1, 1
  while side(low) > 0 do low = low * 0.9 end
  while side(high) < 0 do high = high * 1.1 end
  for _ = 1, 200 do
    local middle = 0.5 * (low + high)
    if side(middle) < 0 then low = middle else high = middle end
  end
  local q = 0.5 * (low + high)
  return law.kirchhoff(l, q, q) / l, q
end

--- Cauchy stress {s11, s22, s33, s12} of x1 = X1 + g X2, Pa: principal stretches k, 1/k and 1 with k - 1/k = g, the
--- first along (k, 1)/sqrt(1 + k^2).
function hyperelastic.simple_shear(law, g)
  local k = g / 2 + math.sqrt(1 + g ^ 2 / 4)
  local t1, t2, t3 = law.kirchhoff(k, 1 / k, 1)
  local c, s = k / math.sqrt(1 + k ^ 2), 1 / math.sqrt(1 + k ^ 2)
  return { s11 = t1 * c ^ 2 + t2 * s ^ 2, s22 = t1 * s ^ 2 + t2 * c ^ 2, s33 = t3, s12 = (t1 - t2) * c * s }
end

return hyperelastic
