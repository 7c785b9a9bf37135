-- The moment of the double cantilever beam against the energy balance it stands for.
local test = ...
local beam = require("stiction").reference.beam

test("the energy that two arms release per length is w", function()
  local w, E, h = 3, 2e9, 4e-3
  local M = beam.dcb_moment(w, E, h)
  local released = 2 * M ^ 2 / (2 * E * h ^ 3 / 12) -- both arms, curvature M / (E I)
  if math.abs(released - w) > 1e-12 * w then
    error(("releases %.15g of %.15g J/m^2"):format(released, w))
  end
end)
