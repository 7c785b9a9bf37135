-- Cook's membrane: a tapered cantilever, sheared at its end, of a material that keeps its volume, or nearly.
--
--              ____(48, 60)
--        _____/    |  ^
--   (0, 44)        |  ^ traction over the end, 1/16 in all
--   |              |  ^
--   | held    ____/ (48, 44)
--   |    ____/
--   (0, 0)
--
-- Bending and shear in cells that are no rectangles. Near nu = 1/2 plain linear cells lock: the tip moves far too
-- little. With the mean dilatation over each cell, or with quadratic cells, it does not.
--
-- "plane_stress": Cook's own, E = 1 and nu = 1/3 in plane stress with 1 over the end, is plane strain with
-- nu' = nu/(1 + nu) and E' = E (1 + 2 nu)/(1 + nu)^2. "nearly_incompressible": E = 240.565, nu = 0.4999, 100 over the end.
-- Strains are small (`linear_elastic`), so the unit of E and of the force only scales the answer.
--
--     ./stiction run studies/proofs/cook_membrane
local stiction = require "stiction"
local units = stiction.units
local m, s, kg, Pa = units.m, units.s, units.kg, units.Pa
local numeric = stiction.numeric

-- Upwards displacement of the end. `middle`: published for Cook's problem by many; for the other ours, by Taylor and
-- Hood's mixed cells (quadratic displacement, linear pressure) in a program of its own, 64 x 64 and graded, digits as
-- converged (the same program gives 23.968 for Cook's problem). `corner`: published, B-bar quads 30 x 30 of OpenGeoSys.
local problems = {
  plane_stress = { young = (1 + 2 / 3) / (1 + 1 / 3) ^ 2, poisson = 1 / 4, force = 1, middle = 23.96, kind = "published",
    source = "Cook 1974 and many since", tolerance = 0.002 },
  nearly_incompressible = { young = 240.565, poisson = 0.4999, force = 100, middle = 7.695, kind = "ours",
    source = "Taylor-Hood cells of another program", tolerance = 0.005, corner = 7.99972 },
}

local cells = {
  quad4 = { kind = "quad4", interpolation = "plain" }, quad8 = { kind = "quad8", interpolation = "plain" },
  tri3 = { kind = "tri3", interpolation = "plain" }, tri6 = { kind = "tri6", interpolation = "plain" },
  quad4_mean = { kind = "quad4", interpolation = "mean_dilatation" },
  quad8_mean = { kind = "quad8", interpolation = "mean_dilatation" },
  tri6_mean = { kind = "tri6", interpolation = "mean_dilatation" },
}

local function scene(p)
  local problem, its = problems[p.problem], cells[p.cells]
  local function edge(x, y, name) return stiction.edge { to = { x * m, y * m }, name = name } end
  return stiction.scene {
    bodies = { plate = stiction.body {
      mesh = stiction.mesh.gmsh { size = 44 / p.across * m, kind = its.kind, start = { 0*m, 0*m }, edges = {
        edge(48, 44, "below"), edge(48, 60, "tip"), edge(0, 44, "above"), edge(0, 0, "held") } },
      material = stiction.material.linear_elastic { young = problem.young * Pa, poisson = problem.poisson },
      interpolation = its.interpolation, density = p.density } },
    motions = { stiction.motion.fix { set = "plate.held" } },
    loads = { stiction.load.traction { set = "plate.tip", times = { 0*s, 1*s }, y = { 0*Pa, problem.force / 16 * Pa } } },
    scheme = stiction.scheme.quasi_static {}, control = stiction.control { force_tolerance = 1e-9 },
    schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = 1 } } },
    probes = {
      corner = stiction.probe.node { set = "plate.tip", near = { 48*m, 60*m } },
      middle = stiction.probe.node { set = "plate.tip", near = { 48*m, 52*m } },
    },
  }
end

local names = { "quad4", "quad4_mean", "quad8", "quad8_mean", "tri3", "tri6", "tri6_mean" }
local locking = { quad4 = true, tri3 = true }

local function misses(cases, reference)
  return numeric.map(cases, function(case) return math.abs(case.results.middle / reference - 1) end)
end

local function percents(list)
  return table.concat(numeric.map(list, function(value) return ("%.3g %%"):format(100 * value) end), ", ")
end

--- A row for one kind of cells, or, where they lock, that they do.
local function check_cells(check, cases, notes)
  local p = cases[1].p
  local problem = problems[p.problem]
  if locking[p.cells] and problem.poisson > 0.49 then
    notes[#notes + 1] = ("%s, plain: %s"):format(p.cells, percents(misses(cases, problem.middle)))
    check.holds(("%s: %s locks"):format(p.problem, p.cells), misses(cases, problem.middle)[#cases] > 0.1)
    return
  end
  check.proof { case = ("Cook's membrane, %s, %s"):format(p.problem, p.cells), quantity = "middle of the end", unit = "m",
    kind = problem.kind, source = problem.source, reference = problem.middle, resolution = "m cell",
    values = numeric.map(cases, function(case) return { 44 / case.p.across, case.results.middle } end),
    tolerance = problem.tolerance * 60 / cases[#cases].p.across, run = cases[#cases] }
end

--- The corner with the same number of cells along a side as the published B-bar quads.
local function check_corner(check, cases, notes)
  local its = {}
  for _, case in ipairs(cases:where { problem = "nearly_incompressible", cells = "quad4_mean" }) do
    if case.p.across <= 30 then
      its[#its + 1] = case
    end
  end
  check.proof { case = "Cook's membrane, nearly_incompressible, quad4_mean", quantity = "corner of the end, 30 cells a side",
    unit = "m", kind = "published", source = "OpenGeoSys, CooksMembrane with B-bar",
    reference = problems.nearly_incompressible.corner, resolution = "m cell", run = its[#its], tolerance = 0.005,
    values = numeric.map(its, function(case) return { 44 / case.p.across, case.results.corner } end),
    note = "at the same resolution, not converged (8.075 m is); locked, middle of the end: " .. table.concat(notes, "; ") }
end

local function convergence_figure(cases, name)
  local curves, middle = {}, problems[name].middle
  for k, word in ipairs(names) do
    local its = cases:where { problem = name, cells = word }
    if #its > 0 then
      curves[#curves + 1] = { label = (word:gsub("_mean", ", mean dilatation")), colour = k,
        style = word:find("mean") and "dash" or "solid", y = numeric.map(its, function(case) return case.results.middle end),
        x = numeric.map(its, function(case) return case.p.across end) }
    end
  end
  local widest = cases[#cases].p.across
  curves[#curves + 1] = { label = "reference", x = { 15, widest }, y = { middle, middle }, style = "dot", colour = 6 }
  return stiction.figure.lines { name = name, curves = curves, legend = "below",
    title = name == "plane_stress" and "Cook's own" or "nu = 0.4999", x = { label = "cells along a side", unit = "1" },
    y = { label = "middle of the end, upwards", unit = "m" } }
end

--- The stress along y of the plain and of the averaged cells.
local function pressure_figure(cases)
  local panels = {}
  for k, word in ipairs { "quad4", "quad4_mean" } do
    local case = cases:find { problem = "nearly_incompressible", cells = word, across = 15 }
    panels[k] = stiction.figure.field { name = word, case = case, time = "last", array = "cauchy_stress", component = 2,
      label = "stress in y", unit = "Pa", deformed = true, mesh = true, range = { -30*Pa, 30*Pa },
      title = word == "quad4" and "quad4, plain" or "quad4, mean dilatation" }
  end
  return stiction.figure.panel { name = "stress", columns = 2, figures = panels }
end

return stiction.study {
  title = "Cook's membrane",
  question = "Which cells lock when the material keeps its volume?",
  given = { density = { 1*kg/m^3, "not used in statics" } },
  sweep = { problem = { "plane_stress", "nearly_incompressible" }, cells = names, across = { 15, 30, 60 } },
  quick = { sweep = { problem = { "plane_stress", "nearly_incompressible" }, cells = { "quad4", "quad4_mean", "tri6" },
    across = { 15, 30 } } },
  case_id = function(p) return ("%s_%s_%d"):format(p.problem, p.cells, p.across) end,
  scene = scene,
  results = {
    { name = "corner", unit = "m", meaning = "displacement of the upper corner of the end, upwards",
      function(run) return run:last("corner", "u_y") end },
    { name = "middle", unit = "m", meaning = "displacement of the middle of the end, upwards",
      function(run) return run:last("middle", "u_y") end },
  },
  check = function(cases, check)
    local notes = {}
    for _, problem in ipairs { "plane_stress", "nearly_incompressible" } do
      for _, name in ipairs(names) do
        local its = cases:where { problem = problem, cells = name }
        if #its > 0 then
          check_cells(check, its, notes)
        end
      end
    end
    check_corner(check, cases, notes)
  end,
  figures = function(cases)
    local panels = {}
    for k, name in ipairs { "plane_stress", "nearly_incompressible" } do
      panels[k] = convergence_figure(cases, name)
    end
    return { stiction.figure.panel { name = "tip", columns = 2, figures = panels }, pressure_figure(cases) }
  end,
}
