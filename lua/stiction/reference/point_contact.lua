-- Frictionless contact of spheres by Hertz. SI numbers.
-- Source: Johnson 1985, section 4.2.
local line_contact = require "stiction.reference.line_contact"
local point_contact = {}

--- E* of two bodies; leave out the second where it is rigid, Pa.
point_contact.combined_modulus = line_contact.combined_modulus

--- Force P = 4/3 E* sqrt(R) d^(3/2) at the approach d of distant points, N.
function point_contact.force(depth, radius, modulus)
  return depth > 0 and 4 / 3 * modulus * math.sqrt(radius) * depth ^ 1.5 or 0
end

--- Approach d = (9 P^2 / (16 R E*^2))^(1/3), m.
function point_contact.depth(force, radius, modulus)
  return (9 * force ^ 2 / (16 * radius * modulus ^ 2)) ^ (1 / 3)
end

--- Contact radius a = (3 P R / (4 E*))^(1/3), m; it is sqrt(R d) too.
function point_contact.contact_radius(force, radius, modulus)
  return (3 * force * radius / (4 * modulus)) ^ (1 / 3)
end

--- Largest pressure p0 = 3 P / (2 pi a^2), Pa.
function point_contact.peak_pressure(force, radius, modulus)
  return 3 * force / (2 * math.pi * point_contact.contact_radius(force, radius, modulus) ^ 2)
end

--- p0 sqrt(1 - r^2/a^2), 0 outside.
point_contact.pressure = line_contact.pressure

return point_contact
