-- What accuracy costs in example 4.1: mesh, steps and the model of the scene.
--
--     ./stiction trade studies/trade/sphere_indentation
local stiction = require "stiction"
local paper = require "../../paper/sphere_indentation"
local mm = stiction.units.mm

--- The block's force on the sphere over time; a quarter in space carries a quarter of it.
local function force(run, p)
  local space, values = p.model == "space", {}
  for i, f in ipairs(run:series("contact", space and "force_z" or "force_y")) do
    values[i] = -f * (space and 4 or 1)
  end
  return run.time, values
end

return paper:variant {
  title = "What accuracy costs: a sphere pressed into an adhesive block",
  question = "Which mesh, step and model of the scene give the pull-off and the peak traction at the least cost?",
  check = false, figures = false, case_id = false,
  chosen = {
    model = { "rigid", "the sphere is 14000 times stiffer than the block" }, set = { "A", "one of the three" },
    mesh_size_3d = { 0.5*mm, "of the quarter in space; at the paper's 0.34 mm it costs several times more" },
    frames = { 0, "no pictures" },
  },
  sweep = {}, quick = {},
  trade = {
    quantities = { "pull_off", "traction_A", "force_depth", { name = "force", curve = force } },
    knobs = {
      { "mesh_size", { 1*mm, 0.5*mm, 0.2*mm, 0.1*mm }, label = "h" },
      { "steps_down", { 40, 75, 150, 300, 600 }, label = "steps" },
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
