-- The same contacts computed by finite elements and by half spaces: do they differ by no more than their own error bars?
--
--        .-'''-.                 .-'''-.        sphere: pressed to d = a^2/R, without friction
--     __'-._.-'__     and     __'-._.-'__       pull_off: drawn off under Dugdale's adhesion
--    | elements |            points of a        shear: cylinder pressed, then moved along with Coulomb's friction
--    |__________|            half space
--                                               unlike: sphere pressed with Coulomb's friction, nu = 0
--
-- Each side is refined twice; the block is doubled twice. Slopes are so small, and elasticity linear, that large strains do not
-- enter. What is compared is a pure number: force, pull-off, work of friction.
--
--     ./stiction run studies/proofs/half_space_agreement
local stiction = require "stiction"
local units = stiction.units
local m, MPa = units.m, units.MPa
local line, numeric = stiction.reference.line_contact, stiction.numeric
local maugis = stiction.reference.maugis
local scenes, bars = require "scenes", require "bars"

local main = { sphere = 80, pull_off = 20, shear = 10, unlike = 80 } -- size of the middle block over the length unit
local far = { sphere = 1, pull_off = 2, shear = 2, unlike = 1 } -- order of what a block changes, in a / size: its depth enters at the first
local contacts = { "sphere", "pull_off", "shear", "unlike" }
local meaning = { sphere = "P over 4/3 E* a^2 a/R", pull_off = "pull-off over pi w R", shear = "W E* / (mu P)^2 at Q = 0.6 mu P",
  unlike = "P over 4/3 E* a^2 a/R, mu = 0.5, nu = 0" }

--- Work of friction by Q = share mu P, a parabola through the three steps about it; times E*/(mu P)^2.
local function friction_work(run, p)
  local P, Q, W = run:series("touch", "force_y"), run:series("touch", "force_x"), run:series("energy", "friction_loss")
  local x, y, scale = {}, {}, scenes.modulus(p)
  for k, time in ipairs(run.time) do
    if time >= 1 then
      x[#x + 1] = math.abs(Q[k] / (p.mu * P[k]))
      y[#y + 1] = (W[k] - run:at(1, "energy", "friction_loss")) * scale / (p.mu * P[k]) ^ 2
    end
  end
  local last = numeric.first_where(x, function(share) return share >= p.share end)
  if not last then
    error(("Q only reaches %g mu P; move farther"):format(x[#x]))
  end
  local sum, from = 0, math.max(1, math.min(last - 1, #x - 2))
  for i = from, from + 2 do
    local term = y[i]
    for j = from, from + 2 do
      term = j == i and term or term * (p.share - x[j]) / (x[i] - x[j])
    end
    sum = sum + term
  end
  return sum
end

local function value(run, p)
  local _, force = scenes.scales(p)
  if p.contact == "shear" then
    return friction_work(run, p)
  elseif p.contact == "pull_off" then
    local held, at = run:max("touch", p.side == "mesh" and "force_y" or "force_z")
    if at >= run.time[#run.time] then
      error("the force still rises at the end; draw farther")
    end
    return held / (math.pi * p.bond * scenes.modulus(p) * p.radius.si ^ 2)
  end
  local forces = run:series("touch", p.side == "mesh" and "force_y" or "force_z")
  return math.abs(forces[#forces]) / force
end

--- What theory says, for the figure only.
local function exact(p)
  if p.contact == "sphere" or p.contact == "unlike" then
    return 1
  elseif p.contact == "pull_off" then
    return maugis.pull_off(p.lambda)
  end
  local E, a, P = 1, 1, math.pi / 4 -- with R = a
  local c = line.stick_half_width(a, p.share * p.mu * P, p.mu, P)
  return line.friction_work(a, line.peak_pressure(P, 1, E), c, p.mu, E) / (p.mu * P) ^ 2
end

local by_theory = { pull_off = "Maugis, no ramp", unlike = "without friction" }

--- The least and the largest time of both sides, s.
local function times_of(by)
  local least, most = math.huge, 0
  for _, side in pairs(by) do
    for _, case in ipairs(side.list) do
      least, most = math.min(least, case.results.time), math.max(most, case.results.time)
    end
  end
  return { least, most }
end

--- All cases of one contact: three meshes in the middle block, the finest also in two others, three of points.
local function cases_of(contact, meshes, points)
  local list = {}
  local function add(side, cells, size, dots)
    list[#list + 1] = { contact = contact, side = side, cells = cells, size = size, points = dots, poisson = meshes.poisson }
  end
  for level = 1, 3 do
    add("mesh", meshes[level], main[contact], 0)
    add("points", 0, 0, points[level])
  end
  add("mesh", meshes[3], main[contact] / 2, 0)
  add("mesh", meshes[3], main[contact] * 2, 0)
  return list
end

local function sweep(levels)
  local list = {}
  for _, contact in ipairs(contacts) do
    for _, case in ipairs(cases_of(contact, levels[contact][1], levels[contact][2])) do
      list[#list + 1] = case
    end
  end
  return list
end

--- Both sides of a contact: {value, bar, order} of points, and of the mesh with the change that an endless block makes.
local function sides(cases, contact)
  local function picked(side, size, key)
    local its = cases:where { contact = contact, side = side, size = size }
    table.sort(its, function(one, other) return one.p[key] < other.p[key] end)
    return its
  end
  local function results(its) return numeric.map(its, function(case) return case.results.value end) end
  local meshes, dots = picked("mesh", main[contact], "cells"), picked("points", 0, "points")
  local of_mesh, of_points = results(meshes), results(dots)
  local function in_block(size) return picked("mesh", size, "cells")[1].results.value end
  local blocks = { in_block(main[contact] / 2), of_mesh[3], in_block(main[contact] * 2) }
  local mesh_bar, mesh_order = bars.of(of_mesh, 2)
  local point_bar, point_order = bars.of(of_points, 2)
  local block_bar, block_order = bars.of(blocks, far[contact])
  local rest = blocks[3] - blocks[2]
  local reach = block_order and rest / (2 ^ math.min(block_order, far[contact]) - 1) or 0
  return {
    mesh = { value = of_mesh[3] + rest + reach, bar = mesh_bar + block_bar, cells = mesh_bar, block = block_bar, order = mesh_order,
      block_order = block_order, finest = meshes[3], list = meshes, shift = rest + reach },
    points = { value = of_points[3], bar = point_bar, order = point_order, finest = dots[3], list = dots },
  }
end

local meshes, dots = { 16, 32, 64, poisson = 0.4 }, { 64, 128, 256 }

return stiction.study {
  title = "The same contact by elements and by a half space",
  question = "Do finite elements and half spaces differ by no more than the sum of their own error bars?",
  given = { radius = { 1*m, "" }, young = { 3*MPa, "" }, slope = { 1e-3, "a / R: what a finite slope changes is below all bars" },
    bond = { 1e-9, "w over E* R, of the adhesion: a / R ~ 1e-3" }, lambda = { 0.5, "Maugis' parameter" }, mu = { 0.5, "" },
    share = { 0.6, "of Q over mu P where the work of friction is compared" } },
  chosen = { coarse = { 2.5, "largest cells of the meshes for the cylinder over a, the same in all blocks" },
    growth = { 1.15, "of cells outside the fine zone" }, extent = { 6, "of the points over a" },
    ramp = { 0.1, "the same law on both sides" },
    press = { 2, "the answer does not depend on them" },
    grip = { 16, "while pressed with friction, the same on both sides" },
    down = { 6, "the way down does not matter: the law has no memory" },
    up = { 46, "a twentieth of the depth unit each" }, along = { 36, "between which a parabola is laid" },
    depth = { 0.5, "over Maugis' unit" },
    above = { 1.8, "beyond the largest force, before the mesh lets go, where statics end" },
    sink = { 1.5, "of the cylinder over a^2/R" }, way = { 3, "of the cylinder along, over mu a^2/R" } },
  sweep = sweep { sphere = { meshes, dots }, pull_off = { { 24, 48, 96, poisson = 0.48 }, dots },
    shear = { { 10, 20, 40, poisson = 0.49 }, { 128, 256, 512 } }, unlike = { { 16, 32, 64, poisson = 0 }, { 32, 64, 128 } } },
  quick = { sweep = sweep { sphere = { { 8, 16, 32, poisson = 0.4 }, { 32, 64, 128 } },
    pull_off = { { 16, 32, 64, poisson = 0.48 }, { 32, 64, 128 } }, shear = { { 6, 12, 24, poisson = 0.49 }, { 64, 128, 256 } },
    unlike = { { 8, 16, 32, poisson = 0 }, { 16, 32, 64 } } } },
  case_id = function(p)
    return p.side == "mesh" and ("%s_mesh_%d_in_%d"):format(p.contact, p.cells, p.size) or ("%s_points_%d"):format(p.contact, p.points)
  end,
  scene = scenes.scene,
  results = {
    { name = "value", unit = "1", meaning = "force over Hertz's, pull-off over pi w R, or work of friction E* / (mu P)^2", value },
    { name = "time", unit = "s", meaning = "that it took", function(run) return run.cost.seconds end },
  },
  check = function(cases, check)
    for _, contact in ipairs(contacts) do
      local by = sides(cases, contact)
      check.equal(("%s: %s, elements and half space within both error bars"):format(contact, meaning[contact]), by.mesh.value,
        by.points.value, by.mesh.bar + by.points.bar)
    end
  end,
  figures = function(cases)
    local list = {}
    for k, contact in ipairs(contacts) do
      local by = sides(cases, contact)
      local function curve(label, side, colour)
        local x, y, bar = {}, {}, {}
        for i, case in ipairs(side.list) do
          x[i], y[i], bar[i] = case.results.time, case.results.value + (side.shift or 0), i == #side.list and side.bar or 0
        end
        return { label = label, x = x, y = y, error = bar, style = "points", colour = colour }
      end
      local known = exact(by.mesh.finest.p)
      local curves = { curve("elements, endless block", by.mesh, 1), curve("half space", by.points, 2) }
      curves[3] = { label = by_theory[contact] or "theory", x = times_of(by), y = { known, known },
        style = "dash", colour = 4 }
      list[k] = stiction.figure.lines { name = contact, title = contact:gsub("_", "-"), x = { label = "time", unit = "s", log = true },
        y = { label = meaning[contact] }, curves = curves, legend = "below" }
    end
    return list
  end,
}
