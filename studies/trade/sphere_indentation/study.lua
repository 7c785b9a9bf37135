-- What accuracy costs in example 4.1: mesh, steps and the model of the scene.
--
--     ./stiction trade studies/trade/sphere_indentation
local stiction = require "stiction"
local paper = require "../../paper/sphere_indentation"
local mm = stiction.units.mm

return paper:variant {
  title = "What accuracy costs: a sphere pressed into an adhesive block",
  question = "Which mesh, step and model of the scene give the pull-off and the peak traction at the least cost?",
  check = false, figures = false, case_id = false,
  chosen = {
    model = { "rigid", "the sphere is 14000 times stiffer than the block" }, set = { "A", "one of the three" },
    frames = { 0, "no pictures" },
  },
  sweep = {}, quick = {},
  trade = {
    quantities = { "pull_off", "traction_A", "force_depth" },
    knobs = {
      { "mesh_size", { 1*mm, 0.5*mm, 0.2*mm, 0.1*mm } },
      { "steps_down", { 40, 75, 150, 300 } },
      { "model", { "rigid", "deformable", "space", "plain", "inertia" } },
    },
    quick = {
      set = { mesh_size = 0.5*mm, steps_down = 75 },
      knobs = {
        { "mesh_size", { 1*mm, 0.5*mm, 0.25*mm } }, { "steps_down", { 40, 75, 150 } },
        { "model", { "rigid", "plain" } },
      },
    },
  },
}
