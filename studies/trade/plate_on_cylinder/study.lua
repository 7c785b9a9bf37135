-- What accuracy costs in example 4.2: mesh, steps, scheme, discretisation and solver of one case of the paper's study.
--
--     ./stiction trade studies/trade/plate_on_cylinder
local stiction = require "stiction"
local paper = require "../../paper/plate_on_cylinder"
local mm, um, s = stiction.units.mm, stiction.units.um, stiction.units.s

local function scene(p)
  local still = p.scheme == "quasi_static" -- not one of the paper's schemes
  local made = paper.scene(setmetatable({ scheme = still and "default" or p.scheme }, { __index = p }))
  made.pairs.contact.discretisation = p.discretisation
  made.solver = stiction.solver[p.solver] { tolerance = p.tolerance }
  if still then
    made.scheme = stiction.scheme.quasi_static {}
  end
  return made
end

return paper:variant {
  title = "What accuracy costs: a plate on a half-cylinder",
  question = "Which mesh, step, scheme, discretisation and solver give the peaks of example 4.2 at the least cost?",
  scene = scene, check = false, figures = false,
  chosen = {
    discretisation = { "node_to_segment", "the default" },
    solver = { "newton", "the default" }, tolerance = { 1e-10, "of the contact solver, the default" },
    travel = { 2*mm, "the peak at mu = 0.4 comes after 1.3 mm" },
    frames = { 0, "no pictures" },
  },
  sweep = { { "v", { 1000*mm/s } }, { "mu", { 0.4 } } }, quick = {},
  trade = {
    quantities = { "beta_peak", "adhesion_t_peak", "force_x_max", { name = "crown", series = "crown/adhesion_t" } },
    knobs = {
      { "mesh_size", { 1*mm, 0.5*mm, 0.25*mm, 0.125*mm }, label = "h" },
      { "descent_steps", { 25, 50, 100, 200 }, label = "down" },
      { "sliding_step", { 40*um, 20*um, 10*um, 5*um, 2.5*um }, label = "slide" },
      { "scheme", { "default", "backward_euler", "half_one", "massless", "quasi_static" } },
      { "discretisation", { "node_to_segment", "mortar" } },
      { "solver", { "newton", "gauss_seidel" } },
      { "tolerance", { 1e-8, 1e-10, 1e-12 }, label = "tol" },
    },
    quick = {
      set = { mesh_size = 0.5*mm, descent_steps = 50, sliding_step = 20*um },
      knobs = {
        { "mesh_size", { 1*mm, 0.5*mm, 0.25*mm } }, { "sliding_step", { 40*um, 20*um, 10*um } },
        { "discretisation", { "node_to_segment", "mortar" } },
      },
    },
  },
}
