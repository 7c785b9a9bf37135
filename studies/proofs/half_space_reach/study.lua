-- How far a half space is off in place of a block: a map, and whether what `explain` promises of it holds.
--
--          .-'''-.          a sphere, a punch whose edge is rounded, or a sphere drawn off under Dugdale's adhesion; contact
--         |   R   |         radius a, on a block of thickness h and radius L, stuck to its base or sliding on it, sides free
--     .____'-._.-'____.
--     |     a   a     | h   error: force at the same approach (and pull-off) over that of the half space, less 1
--     |_______________|
--     0               L
--
--     ./stiction run studies/proofs/half_space_reach
local stiction = require "stiction"
local scenes, design, reading = require "scenes", require "design", require "reading"

local quick = { every = 29, finer = 7, dice = 5 }

return stiction.study {
  title = "Where a half space would do",
  question = "Where is a half space right to 1, 3, 10 %, and does explain's bound of its error hold, in scenes it was not made from, too?",
  chosen = {
    cells = { 16, "over a, on the coarser of two meshes; the finer has twice as many" },
    growth = { 1.22, "of cells away from the contact, on the coarser; on the finer its root" },
    steps = { 4, "down; the answer does not depend on them" }, up = { 23, "a tenth of Maugis' unit each; block and half space the same" },
    depth = { 0.5, "over Maugis' unit, before it is drawn off" }, above = { 1.8, "beyond the largest force" },
    ramp = { 0.5, "of Dugdale's traction, the same in block and half space" },
  },
  sweep = design.sweep { every = 1, finer = 11, dice = 80 },
  quick = { sweep = design.sweep(quick) },
  case_id = function(p) return ("%s_%d_mesh_%d"):format(p.set, p.number, p.level) end,
  scene = scenes.scene,
  results = {
    { name = "force", unit = "1", meaning = "force at the largest approach over that of the half space; of a pull over pi w R",
      reading.force },
    { name = "stiffness", unit = "1", meaning = "its change with the approach over Maugis' unit, of a pull", reading.stiffness },
    { name = "pull_off", unit = "1", meaning = "largest force that is held, over pi w R", reading.pull_off },
    { name = "bound", unit = "1", meaning = "of the error, by explain", function(_, p)
      return p.level == 0 and p.set ~= "endless" and scenes.bound(p) or 0
    end },
  },
  check = function(cases, check)
    local all = reading.scenes(cases)
    for _, set in ipairs { "map", "dice" } do
      local wrong = reading.wrong(all[set])
      for _, share in ipairs(reading.shares) do
        check.equal(("%s: scenes promised to %g %% and off by more"):format(set, 100 * share), wrong[share], 0, 0)
      end
    end
    check.within("largest change of a measured error by a third mesh, over its bar", reading.change_by_third(cases), 0, 1)
    reading.check_leading(all.map, check)
  end,
  figures = function(cases) return reading.figures(reading.scenes(cases)) end,
}
