-- Beams that peel: closed solutions of slender double cantilever specimens. SI numbers, per unit depth.
local beam = {}

--- Moment per depth on each of two arms of height h at which a bond of energy w between them runs, whatever the length
--- of the crack: M^2 / (E' I) = w with I = h^3 / 12, N. plane_modulus: E' = E / (1 - nu^2) in plane strain, Pa.
function beam.dcb_moment(w, plane_modulus, height)
  return math.sqrt(w * plane_modulus * height ^ 3 / 12)
end

return beam
