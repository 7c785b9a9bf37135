-- All rungs of one contact: a sphere pressed into a block by elements in space, as a section, by points of a half space, and by
-- Hertz's formula. What each leaves out, beside the error of its resolution.
--
--             .-'''-.
--            |   R   |           space and section: the block that it is, `block` times a high and wide, held below
--      _______'-._.-'_______     half_space, formula: an endless one
--
--     ./stiction trade studies/trade/all_rungs
local stiction = require "stiction"
local units = stiction.units
local mm, s = units.mm, units.s
local proof = require "../../proofs/hertz_3d"

local function by_points(p)
  local size, points = p.extent * p.a, p.extent * p.cells
  return stiction.scene {
    kinematics = "three_dimensional",
    bodies = { block = stiction.body.half_space { young = p.young, poisson = p.poisson, size = { size, size },
      points = { points, points }, boundary = "free" } },
    obstacles = { sphere = stiction.obstacle.height_map { surface = stiction.surface.sphere { radius = p.a / p.slope },
      times = { 0*s, 1*s }, z = { 0*mm, -p.a * p.slope } } },
    pairs = { touch = stiction.pair { secondary = "block.surface", primary = "sphere" } },
    scheme = stiction.scheme.quasi_static {},
    schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = 1 } } },
    probes = { touch = stiction.probe.contact { pair = "touch" } },
    model = p.model,
  }
end

--- Force that presses at the end, N; a quarter of it in space.
local function force(run, p)
  local values = run:series("touch", p.model == "section" and "force_y" or "force_z")
  return (p.model == "space" and 4 or 1) * math.abs(values[#values])
end

return proof:variant {
  title = "What accuracy costs: space, section, half space or formula",
  question = "What does each model of a sphere on a block leave out, beside the error of its resolution?",
  check = false, figures = false, case_id = false,
  scene = function(p) return (p.model == "section" or p.model == "space") and proof.scene(p) or by_points(p) end,
  chosen = { model = { "section", "the rung" }, cells = { 8, "and points, over a" }, slope = { 0.005, "a / R" },
    block = { 20, "height and radius over a" }, extent = { 4, "of the points over a" } },
  sweep = {}, quick = {},
  results = { { name = "force", unit = "N", meaning = "that presses, on the whole circle", force } },
  trade = {
    quantities = { "force" },
    knobs = { { "cells", { 4, 8, 16 } }, { "model", { "formula", "half_space", "section", "space" } } },
    quick = { knobs = { { "cells", { 3, 6 } }, { "model", { "formula", "half_space", "section" } } }, set = { cells = 6 } },
  },
}
