-- What accuracy costs in a line contact: cell size, cell order, discretisation of NAFEMS CGS-1.
--
--     ./stiction trade studies/trade/hertz
local stiction = require "stiction"
local proof = require "../../proofs/hertz_2d"
local mm = stiction.units.mm

local function scene(p)
  local made = proof.scene(p)
  made.pairs.touch.discretisation = p.discretisation
  return made
end

return proof:variant {
  title = "What accuracy costs: a cylinder on a block",
  question = "Small linear cells or larger quadratic ones, nodes or mortar?",
  scene = scene, check = false, figures = false, case_id = false,
  chosen = {
    cell = { 0.5*mm, "12 cells to the half width" }, kind = { "quad4", "the default" },
    discretisation = { "node_to_segment", "the default" },
  },
  sweep = {}, quick = {},
  trade = {
    quantities = { "peak", "half_width", "sinking" },
    knobs = {
      { "cell", { 2*mm, 1*mm, 0.5*mm, 0.25*mm } },
      { "kind", { "quad4", "quad8" } },
      { "discretisation", { "node_to_segment", "mortar" } },
    },
    quick = { set = { cell = 1*mm }, knobs = {
      { "cell", { 2*mm, 1*mm, 0.5*mm } }, { "kind", { "quad4", "quad8" } },
      { "discretisation", { "node_to_segment", "mortar" } },
    } },
  },
}
