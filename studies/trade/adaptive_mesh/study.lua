-- A mesh made anew from the error of its stress against ladders of equal cells, on example 4.1 of the paper.
--
-- Equal cells are the paper's structured block; the others come from gmsh, which starts with coarse cells and is asked
-- for others until the recovered stress is as exact as the target and three cells lie on the cohesive length.
--
--     ./stiction run studies/trade/adaptive_mesh            11 cases
--     ./stiction run studies/trade/adaptive_mesh --quick    6 cases
local stiction = require "stiction"
local sphere = require "../../paper/sphere_indentation"
local units = stiction.units
local mm, ms = units.mm, 1e-3 * units.s

local function parameters(p)
  local q = {}
  for _, part in ipairs { "given", "chosen" } do
    for name, entry in pairs(sphere.definition[part]) do q[name] = entry[1] end
  end
  q.model, q.set, q.frames = "rigid", "A", p.target > 0 and 1 or 0
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

local function case_list(sizes, targets)
  local list = {}
  for _, size in ipairs(sizes) do list[#list + 1] = { size = size, target = 0 } end
  for _, target in ipairs(targets) do list[#list + 1] = { size = 1*mm, target = target } end
  return list
end


local function evaluated(case)
  return case.cost.cells_evaluated_in_all_passes or case.cost.cells_evaluated
end

-- The finest equal cells, the other equal ones, those that were made anew; each with rising number of cells.
local function sorted(list)
  local equal, remeshed = {}, {}
  for _, case in ipairs(list) do
    local kind = case.p.target > 0 and remeshed or equal
    kind[#kind + 1] = case
  end
  local function fewer(a, b) return a.cost.cells < b.cost.cells end
  table.sort(equal, fewer)
  table.sort(remeshed, fewer)
  return table.remove(equal), equal, remeshed
end

local function error_of(case, reference, names)
  local worst = 0
  for _, name in ipairs(names) do
    worst = math.max(worst, math.abs(case.results[name] / reference.results[name] - 1))
  end
  return worst
end

-- The first from which on all are within the share: a smaller error before a larger one is luck.
local function settled(list, reference, names, share)
  local first
  for _, case in ipairs(list) do
    if error_of(case, reference, names) > share then first = nil else first = first or case end
  end
  return first
end

local groups = {
  { title = "force at depth", names = { "force_depth" } },
  { title = "pull-off", names = { "pull_off" } },
  { title = "peak traction", names = { "traction_A" } },
  { title = "both forces", names = { "force_depth", "pull_off" } },
  { title = "all three", names = { "force_depth", "pull_off", "traction_A" } },
}

-- What is wanted, and at most how many cells, and evaluations of them on all meshes, over those of equal cells; the
-- meshes before the last one are a price that a small gain does not pay: at 1 % of all three there is no bound.
local claims = {
  { group = groups[4], share = 0.015, cells = 0.6, evaluated = 1 },
  { group = groups[5], share = 0.01, cells = 0.6 },
  { group = groups[5], share = 0.003, cells = 0.3, evaluated = 0.5, full = true },
}

-- The smallest meshes of both kinds that keep a claim.
local function pair_of(claim, list)
  local reference, equal, remeshed = sorted(list)
  return settled(equal, reference, claim.group.names, claim.share),
    settled(remeshed, reference, claim.group.names, claim.share)
end

local function ratios_of(list)
  local rows = {}
  for _, claim in ipairs(claims) do
    local even, anew = pair_of(claim, list)
    if even and anew and not (claim.full and list.quick) then
      rows[#rows + 1] = { ("%s within %g %%"):format(claim.group.title, 100 * claim.share), even.id, anew.id,
        anew.cost.cells / even.cost.cells, anew.cost.cells_evaluated / even.cost.cells_evaluated,
        evaluated(anew) / evaluated(even) }
    end
  end
  return { title = "Counts over those of equal cells", rows = rows, columns = { "wanted", "equal", "remeshed", "cells",
    "evaluated on the last mesh", "evaluated on all meshes" } }
end

local function table_of(list)
  local reference, equal, remeshed = sorted(list)
  local rows = {}
  for _, kind in ipairs { equal, remeshed, { reference } } do
    for _, case in ipairs(kind) do
      local row = { case.id, case.cost.cells, case.cost.mesh_passes, case.cost.mesh_error }
      for i = 1, 3 do
        row[i + 4] = ("%+.2f %%"):format(100 * (case.results[results[i].name] / reference.results[results[i].name] - 1))
      end
      row[8] = evaluated(case)
      rows[#rows + 1] = row
    end
  end
  return { title = "Errors against " .. reference.id, rows = rows, columns = { "mesh", "cells", "meshes made",
    "error of stress", "force at depth", "pull-off", "peak traction", "cells evaluated, all meshes" } }
end

local function error_figure(list)
  local reference, equal, remeshed = sorted(list)
  local curves = {}
  for i = 1, 3 do
    for k, kind in ipairs { equal, remeshed } do
      local x, y = {}, {}
      for n, case in ipairs(kind) do
        x[n], y[n] = case.cost.cells, math.max(error_of(case, reference, groups[i].names), 1e-5)
      end
      curves[#curves + 1] = { label = groups[i].title .. (k == 1 and ", equal" or ", remeshed"), x = x, y = y,
        colour = i, style = k == 1 and "dash" or "solid" }
    end
  end
  return stiction.figure.lines { name = "error_cells", legend = "below", title = "Errors against " .. reference.id,
    x = { label = "cells", unit = "1", log = true }, y = { label = "relative error", unit = "1", log = true },
    curves = curves }
end

return stiction.study {
  title = "A mesh made anew from its error against ladders of equal cells",
  question = "How many cells do force, pull-off and traction take, equal or where the stress asks for them?",
  chosen = {
    passes = { 5, "meshes at most" }, smallest = { 0.05*mm, "a fortieth of the contact radius" },
    cohesive_cells = { 3, "the default" },
  },
  sweep = case_list({ 1*mm, 0.5*mm, 0.4*mm, 0.25*mm, 0.2*mm, 0.1*mm }, { 0.25, 0.2, 0.15, 0.1, 0.05 }),
  quick = { sweep = case_list({ 1*mm, 0.5*mm, 0.25*mm, 0.2*mm }, { 0.25, 0.15 }) },
  case_id = function(p)
    return p.target > 0 and "target_" .. p.target or ("equal_%gmm"):format(p.size / mm)
  end,
  scene = scene, results = results,

  check = function(list, check)
    local reference, _, remeshed = sorted(list)
    for _, case in ipairs(remeshed) do
      check.within(case.id .. ": error of the stress", case.cost.mesh_error, 0, case.p.target)
    end
    for i = 1, 3 do
      check.holds(groups[i].title .. ": a mesh made anew reaches 1 %",
        settled(remeshed, reference, groups[i].names, 0.01) ~= nil)
    end
    for _, claim in ipairs(claims) do
      local even, anew = pair_of(claim, list)
      local title = ("%s within %g %%: "):format(claim.group.title, 100 * claim.share)
      if not (claim.full and list.quick) then
        check.holds(title .. "both kinds reach it", even ~= nil and anew ~= nil)
        check.within(title .. "cells over equal cells", even and anew and anew.cost.cells / even.cost.cells, 0,
          claim.cells)
        if claim.evaluated then
          check.within(title .. "cells evaluated on all meshes over those of equal cells",
            even and anew and evaluated(anew) / evaluated(even), 0, claim.evaluated)
        end
      end
    end
    check.table(table_of(list))
    check.table(ratios_of(list))
  end,

  figures = function(list)
    local _, _, remeshed = sorted(list)
    local finest = remeshed[#remeshed]
    local q = parameters(finest.p)
    return {
      error_figure(list),
      stiction.figure.field {
        name = "mesh", title = ("the last mesh of %s, full depth"):format(finest.id), case = finest,
        time = q.depth / q.speed, array = "von_mises", label = "von Mises stress", unit = "MPa", deformed = true,
        mesh = true, window = { 0*mm, 10*mm, -4*mm, 0.5*mm }, window_unit = "mm",
      },
    }
  end,
}
