-- Contact of cylinders per unit length: Hertz's pressure and the shear of Cattaneo and Mindlin. SI numbers.
-- Source: K. L. Johnson, Contact Mechanics, 1985, chapters 4 and 7.
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

return line_contact
