-- Contact of cylinders per unit length: Hertz's pressure and the shear of Cattaneo and Mindlin. SI numbers.
-- Source: Johnson 1985, chapters 4 and 7.
local line_contact = {}

--- E* of two bodies; leave out the second where it is rigid, Pa.
function line_contact.combined_modulus(young_1, poisson_1, young_2, poisson_2)
  local compliance = (1 - poisson_1 ^ 2) / young_1
  if young_2 then
    compliance = compliance + (1 - poisson_2 ^ 2) / young_2
  end
  return 1 / compliance
end

--- Half width a = sqrt(4 P R / (pi E*)) under the force P per length, m.
function line_contact.half_width(force, radius, modulus)
  return math.sqrt(4 * force * radius / (math.pi * modulus))
end

--- Largest pressure p0 = 2 P / (pi a), Pa.
function line_contact.peak_pressure(force, radius, modulus)
  return 2 * force / (math.pi * line_contact.half_width(force, radius, modulus))
end

--- p0 sqrt(1 - x^2/a^2), 0 outside.
function line_contact.pressure(x, half_width, peak)
  local inside = 1 - (x / half_width) ^ 2
  return inside > 0 and peak * math.sqrt(inside) or 0
end

--- Half width c of the zone that sticks: c/a = sqrt(1 - Q / (mu P)).
function line_contact.stick_half_width(half_width, shear_force, mu, force)
  return half_width * math.sqrt(math.max(0, 1 - shear_force / (mu * force)))
end

--- q = mu p0 [sqrt(1 - x^2/a^2) - (c/a) sqrt(1 - x^2/c^2)], the second part where |x| < c only.
function line_contact.shear(x, half_width, peak, stick_half_width, mu)
  local q = mu * line_contact.pressure(x, half_width, peak)
  if math.abs(x) < stick_half_width then
    q = q - mu * line_contact.pressure(x, stick_half_width, peak * stick_half_width / half_width)
  end
  return q
end

--- Slip of two equal bodies at x, m: where c < |x| < a it is mu p0/(E* a) (|x| sqrt(x^2 - c^2) - c^2 arcosh(|x|/c)).
--- From Johnson, section 7.2: a half ellipse mu p0 over a shifts the surfaces by mu p0 x^2/(E* a), that over c by the same
--- inside c, and outside with the gradient of x^2 lessened by 2 sqrt(x^2 - c^2).
function line_contact.slip(x, half_width, peak, stick_half_width, mu, modulus)
  local c, distance = stick_half_width, math.abs(x)
  if distance <= c or distance > half_width then
    return 0
  end
  local root = math.sqrt(distance ^ 2 - c ^ 2)
  local turned = c > 0 and c ^ 2 * math.log((distance + root) / c) or 0
  return mu * peak / (modulus * half_width) * (distance * root - turned)
end

--- Work of friction over the whole contact, J/m, as Q grows from 0: mu p times the slip, by midpoints of
--- t in |x| = a - (a - c) t^2.
function line_contact.friction_work(half_width, peak, stick_half_width, mu, modulus)
  local sum, n, range = 0, 2000, half_width - stick_half_width
  for i = 1, n do
    local t = (i - 0.5) / n
    local x = half_width - range * t ^ 2
    local slip = line_contact.slip(x, half_width, peak, stick_half_width, mu, modulus)
    sum = sum + mu * line_contact.pressure(x, half_width, peak) * slip * 2 * t * range / n
  end
  return 2 * sum
end

--- Shear once Q has grown to forces.forward and gone back to forces.now under forces.normal: a point's friction turns
--- round by 2 mu p, so the change is that of a first loading with twice mu (Johnson, section 7.4).
function line_contact.shear_back(x, half_width, peak, mu, forces)
  local c = line_contact.stick_half_width(half_width, forces.forward, mu, forces.normal)
  local back = line_contact.stick_half_width(half_width, forces.forward - forces.now, 2 * mu, forces.normal)
  return line_contact.shear(x, half_width, peak, c, mu) - line_contact.shear(x, half_width, peak, back, 2 * mu)
end

--- A cylinder that slides along +x over a half space of another stiffness, where pressure and shear couple by Dundurs' beta:
--- {alpha, half_width a, centre e, pressure(x)}, with tan(pi alpha) = beta mu, P = pi E* a^2 (1 - 4 alpha^2) / (4 R),
--- e = -2 alpha a and p = E* cos(pi alpha) / (2 R) (a - X)^(1/2 + alpha) (a + X)^(1/2 - alpha), X = x - e.
--- Source: Bufler 1959; Johnson 1985, section 8.2. Derived in studies/proofs/half_space_unlike/README.md.
function line_contact.sliding(force, radius, modulus, coupled_friction)
  local alpha = math.atan(coupled_friction) / math.pi
  local a = math.sqrt(4 * force * radius / (math.pi * modulus * (1 - 4 * alpha ^ 2)))
  local e = -2 * alpha * a
  local function pressure(x)
    local before, behind = a - (x - e), a + (x - e)
    if before <= 0 or behind <= 0 then
      return 0
    end
    return modulus * math.cos(math.pi * alpha) / (2 * radius) * before ^ (0.5 + alpha) * behind ^ (0.5 - alpha)
  end
  return { alpha = alpha, half_width = a, centre = e, pressure = pressure }
end

return line_contact
