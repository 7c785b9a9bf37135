-- A plate dragged over a half-cylinder with much friction: forces that turn with their normals make its tangent
-- indefinite, and the steps need it all the same. Left out, steps were cut and took ten times the work.
local units = require "stiction".units
local paper = require "../../../studies/paper/plate_on_cylinder"

return paper:variant {
  title = "A plate dragged with much friction", question = "Does the step go on with the whole tangent?",
  sweep = { v = { 1000*units.mm/units.s }, mu = { 0.6 } },
  quick = false, figures = false, trade = false,
  check = function(cases, check)
    local cost = cases[1].cost
    check.within("steps cut", cost.cuts, 0, 20)
    check.within("iterations of a step", cost.iterations / cost.steps, 0, 8)
  end,
}
