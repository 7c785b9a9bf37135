-- What accuracy costs where meshes do not match: a die sliding over a slab by node to segment and by mortar.
--
--     ./stiction trade studies/trade/sliding_die
local stiction = require "stiction"
local proof = require "../../proofs/ironing"
local mm = stiction.units.mm

return proof:variant {
  title = "What accuracy costs: sliding over a mesh that does not match",
  question = "Is it cheaper to refine the mesh or to take mortar, for forces and for how they shake?",
  check = false, figures = false, case_id = false,
  chosen = {
    secondary = { "slab", "the softer one carries the contact points" }, kind = { "quad4", "the default" },
    cell = { 0.1*mm, "ten cells in contact" }, method = { "spline", "the default" }, mu = { 0.3, "of rubber, low" },
    steps_in = { 10, "of the run-in" }, per_cell = { 6, "steps while the die passes a cell" },
  },
  sweep = {}, quick = {},
  trade = {
    quantities = { "normal", "ratio_of_forces", { name = "shake_n", reference = 0, scale = 1 },
      { name = "shake_t", reference = 0, scale = 1 } }, -- steady sliding does not shake
    knobs = {
      { "cell", { 0.2*mm, 0.1*mm, 0.05*mm } },
      { "method", { "polyline", "spline", "mortar" } },
      { "kind", { "quad4", "quad8" } },
      { "secondary", { "slab", "die" } },
    },
    quick = { set = { cell = 0.2*mm }, knobs = {
      { "cell", { 0.4*mm, 0.2*mm, 0.1*mm } }, { "method", { "polyline", "spline", "mortar" } },
    } },
  },
}
