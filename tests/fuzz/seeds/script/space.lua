local stiction = require "stiction"
return stiction.study { title = "space", scene = function()
  return stiction.scene { kinematics = "three_dimensional",
    bodies = { cube = stiction.body { mesh = stiction.mesh.box { size = { 1, 1, 1 }, cells = { 1, 1, 1 } },
      material = stiction.material.linear_elastic { young = 1, poisson = 0.3 }, density = 1 } } }
end }
