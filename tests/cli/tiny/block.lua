-- The block of the tiny study, in a module of its own.
local stiction = require "stiction"

return function(p)
  return stiction.body {
    mesh = stiction.mesh.block { size = { p.side, p.side }, cells = { p.cells, p.cells } },
    material = stiction.material.neo_hookean { young = p.young, poisson = 0.3 },
    density = p.density,
  }
end
