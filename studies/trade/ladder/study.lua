-- What a rung costs and brings: Mindlin's formula, or the points of a half space, for a sphere moved along under friction.
--
--     ./stiction trade studies/trade/ladder
local proof = require "../../proofs/half_space_formula"

--- The force along where the sphere turns round, N.
local function along(run)
  for k, time in ipairs(run.time) do
    if time >= 2 - 1e-9 then
      return run:series("touch", "force_x")[k]
    end
  end
end

return proof:variant {
  title = "What accuracy costs: a formula or points",
  question = "How far is the formula of Cattaneo and Mindlin off, which leaves out slip across the motion, beside the error of points?",
  check = false, figures = false, case_id = false,
  chosen = { kind = { "mindlin", "a sphere pressed, moved along and back" }, model = { "half_space", "the rung" },
    points = { 64, "along each side" } },
  sweep = {}, quick = {},
  results = {
    { name = "along", unit = "N", meaning = "force along where it turns round", along },
    { name = "force", unit = "N", meaning = "force that presses", function(run) return run:max("sphere", "force_z") end },
  },
  trade = {
    quantities = { "along", "force" },
    knobs = { { "points", { 16, 32, 64, 128 } }, { "model", { "formula", "half_space" } } },
    quick = { knobs = { { "points", { 16, 32, 64 } }, { "model", { "formula", "half_space" } } } },
  },
}
