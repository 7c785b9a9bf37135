-- A mesh made anew from the error of its stress against ladders of equal cells, on example 4.1 of the paper.
--
-- Equal cells are the paper's structured block; the others come from gmsh, which starts with coarse cells and is asked
-- for others until the recovered stress is as exact as the target and three cells lie on the cohesive length.
--
--     ./stiction run studies/trade/adaptive_mesh
local stiction = require "stiction"
local sphere = require "../../paper/sphere_indentation"
local units = stiction.units
local mm, ms = units.mm, 1e-3 * units.s

local function parameters(p)
  local q = {}
  for _, part in ipairs { "given", "chosen" } do
    for name, entry in pairs(sphere.definition[part]) do q[name] = entry[1] end
  end
  q.model, q.set, q.frames = "rigid", "A", 0
  q.mesh_size = p.size
  return q
end

local function outline(q, size)
  local r, h, zero = q.block_radius, q.block_height, 0*mm
  local edge = stiction.edge
  return stiction.mesh.gmsh {
    start = { zero, -h }, size = size,
    edges = {
      edge { to = { r, -h }, name = "bottom" }, edge { to = { r, zero }, name = "right" },
      edge { to = { zero, zero }, name = "top" }, edge { to = { zero, -h }, name = "left" },
    },
  }
end

local function scene(p)
  local q = parameters(p)
  local made = sphere.scene(q)
  made.schedule.accuracy = stiction.accuracy { tolerance = 1e-3, beta_change = 1, events = 1*ms }
  if p.target > 0 then
    made.bodies.block.mesh = outline(q, p.size)
    made.bodies.block.remesh = stiction.remesh {
      target = p.target, passes = p.passes, smallest = p.smallest, cohesive_cells = p.cohesive_cells,
    }
  end
  return made
end

local results = {}
for i, name in ipairs { "force_depth", "pull_off", "traction_A" } do
  for _, entry in ipairs(sphere.results) do
    if entry.name == name then
      results[i] = { name = name, unit = entry.unit, meaning = entry.meaning,
        function(run, p) return entry.compute(run, parameters(p)) end }
    end
  end
end

local cases = {}
for _, size in ipairs { 1*mm, 0.5*mm, 0.4*mm, 0.25*mm, 0.2*mm, 0.1*mm } do
  cases[#cases + 1] = { size = size, target = 0 }
end
for _, target in ipairs { 0.4, 0.3, 0.2, 0.1 } do cases[#cases + 1] = { size = 1*mm, target = target } end

return stiction.study {
  title = "A mesh made anew from its error against ladders of equal cells",
  question = "How many cells does the force at depth and the pull-off take, equal or where the stress asks for them?",
  chosen = {
    passes = { 5, "meshes at most" }, smallest = { 0.05*mm, "a fortieth of the contact radius" },
    cohesive_cells = { 3, "the default" },
  },
  sweep = cases,
  case_id = function(p)
    return p.target > 0 and "target_" .. p.target or ("equal_%gmm"):format(p.size / mm)
  end,
  scene = scene, results = results,
}
