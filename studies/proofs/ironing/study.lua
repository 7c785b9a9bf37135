-- Ironing: a round die is pressed into a softer slab and slides over it. How much do the forces shake?
--
--        ________
--       |  die   |  -->    down by `depth`, then across
--        \_    _/
--     _____'--'___________
--    |        slab        |  ten times softer, held below
--    |____________________|
--
-- The forces of steady sliding do not shake. What shakes is the mesh: nodes of one surface pass cells of the other, at a
-- wavelength of a cell. So a parabola over the path (the slab is not endless) is taken off both forces, and half of what
-- is left from peak to peak, over the mean normal force, is the measure. The stretch looked at lies about the slab's
-- middle, so that without friction its mean tangential force is zero.
--
-- "mortar" against node to segment with a smooth primary ("spline") and with a plain one ("polyline"); `secondary` is the
-- body that carries the contact points: the slab, whose points enter and leave the contact, or the die.
--
--     ./stiction run studies/proofs/ironing
local stiction = require "stiction"
local units = stiction.units
local mm, MPa, s, kg, m = units.mm, units.MPa, units.s, units.kg, units.m
local numeric = stiction.numeric

--- Half the stretch that is looked at: whole cells of the slab, to both sides of its middle.
local function window(p)
  return math.min(p.window.si, 4 * p.cell.si) * m
end

local function die_mesh(p)
  local R, x, zero = p.radius, -window(p) - p.run_in, 0*mm
  return stiction.mesh.gmsh { size = p.ratio * p.cell, kind = p.kind, start = { x - R, R }, edges = {
    stiction.edge { to = { x, zero }, centre = { x, R }, name = "arc" },
    stiction.edge { to = { x + R, R }, centre = { x, R }, name = "arc" },
    stiction.edge { to = { x - R, R }, name = "top" },
  } }
end

--- Cells are squares at the top and three times as high below.
local function slab_mesh(p)
  local nx = math.floor(p.length / p.cell + 0.5)
  local ny = math.floor(p.height / (2 * p.cell) + 0.5)
  return stiction.mesh.block { origin = { -p.length / 2, -p.height }, size = { p.length, p.height }, cells = { nx, ny },
    grading = { 1, 1 / 3 }, kind = p.kind }
end

local function body(p, mesh, young)
  return stiction.body { mesh = mesh, density = p.density,
    material = stiction.material.neo_hookean { young = young, poisson = p.poisson } }
end

local discretisations = {
  mortar = { discretisation = "mortar" },
  spline = { discretisation = "node_to_segment", smoothing = "spline" },
  polyline = { discretisation = "node_to_segment", smoothing = "polyline" },
}

local function iron(p)
  local its, slab, die = discretisations[p.method], "slab.top", "die.arc"
  return stiction.pair { secondary = p.secondary == "slab" and slab or die, primary = p.secondary == "slab" and die or slab,
    discretisation = its.discretisation, smoothing = its.smoothing,
    friction = p.mu > 0 and stiction.friction.coulomb { mu = p.mu } or nil }
end

local function scene(p)
  local half, zero = window(p), 0*mm
  local path, down = { zero, zero, p.run_in, p.run_in + 2 * half }, -p.depth
  local samples = math.floor(2 * half / p.cell * p.per_cell + 0.5)
  return stiction.scene {
    bodies = { die = body(p, die_mesh(p), p.die_young), slab = body(p, slab_mesh(p), p.slab_young) },
    pairs = { iron = iron(p) },
    motions = {
      stiction.motion.fix { set = "slab.bottom" },
      stiction.motion.drive { set = "die.top", times = { 0*s, 1*s, 2*s, 3*s }, x = path, y = { zero, down, down, down } },
    },
    scheme = stiction.scheme.quasi_static {},
    schedule = stiction.schedule { stages = {
      stiction.stage { to = 1*s, steps = p.steps_down }, stiction.stage { to = 2*s, steps = p.steps_in },
      stiction.stage { to = 3*s, steps = samples } } },
    probes = { die = stiction.probe.force { set = "die.top" } },
  }
end

--- Over the stretch looked at: places of the die's middle, the forces that press and drag it.
local function steady(run, p)
  local fx, fy = run:series("die", "force_x"), run:series("die", "force_y")
  local x, normal, tangential = {}, {}, {}
  for i, t in ipairs(run.time) do
    if t > 2 - 1e-9 then
      x[#x + 1], normal[#normal + 1], tangential[#tangential + 1] = (2 * t - 5) * window(p).si, -fy[i], fx[i]
    end
  end
  return x, normal, tangential
end

--- Amplitude of what a parabola over x leaves of a force, over the scale.
local function amplitude(x, force, scale)
  return numeric.amplitude(numeric.without_trend(x, force, 2)) / scale
end

--- All methods of one group; a group is {secondary =, kind =, methods =}, in the order of the report.
local groups = {
  { secondary = "slab", kind = "quad4", methods = { "polyline", "spline", "mortar" }, mu = { 0, 0.3 }, better = { "shake_t" } },
  { secondary = "die", kind = "quad8", methods = { "spline", "mortar" }, mu = { 0, 0.3 }, better = { "shake_t", "shake_n" } },
  { secondary = "slab", kind = "quad8", methods = { "spline", "mortar" }, mu = { 0.3 }, better = {} },
  { secondary = "die", kind = "quad4", methods = { "spline", "mortar" }, mu = { 0.3 }, better = {} },
}

local function cases_of(some, frictions, cells)
  local cases = {}
  for _, group in ipairs(some) do
    for _, mu in ipairs(frictions or group.mu) do
      for _, cell in ipairs(cells) do
        for _, method in ipairs(group.methods) do
          cases[#cases + 1] = { secondary = group.secondary, kind = group.kind, mu = mu, cell = cell, method = method }
        end
      end
    end
  end
  return cases
end

local function percents(cases, name)
  return table.concat(numeric.map(cases, function(case) return ("%.3g %%"):format(100 * case.results[name]) end), ", ")
end

local words = { shake_n = "shaking of the normal force", shake_t = "shaking of the tangential force" }

--- The rows of mortar in one group with one friction; the others by method.
local function check_group(check, group, mu, mortar, others)
  local fine = mortar[#mortar]
  local name = ("Ironing, %s, %s is secondary, mu = %g"):format(group.kind, group.secondary, mu)
  local function row(quantity, result, tolerance, note)
    check.proof { case = name, quantity = quantity, kind = "exact", source = "steady sliding, symmetry", reference = 0,
      scale = 1, tolerance = tolerance, resolution = "m cell", run = fine, note = note,
      values = numeric.map(mortar, function(case) return { case.p.cell, case.results[result] } end) }
  end
  for _, result in ipairs { "shake_n", "shake_t" } do
    local quantity, notes = words[result], {}
    for k, method in ipairs(group.methods) do
      notes[k] = others[method] and ("node to segment, %s: %s"):format(method, percents(others[method], result))
    end
    row(quantity .. " over the mean normal one", result, fine.p.allowed, table.concat(notes, "; "))
    check.non_increasing(("%s, mortar: %s falls with the cell"):format(name, quantity),
      numeric.map(mortar, function(case) return case.results[result] end))
  end
  if mu == 0 then
    row("mean tangential over mean normal force", "ratio_of_forces", 1e-3)
  end
  for _, result in ipairs(group.better) do
    for _, method in ipairs(group.methods) do
      for i, case in ipairs(others[method] or {}) do
        check.holds(("%s: %s less than with %s"):format(mortar[i].id, words[result], method),
          mortar[i].results[result] < case.results[result])
      end
    end
  end
end

--- Shaking over the cell size with friction, all groups.
local function shaking_figure(cases, result)
  local curves = {}
  local styles = { polyline = "dot", spline = "dash", mortar = "solid" }
  for k, group in ipairs(groups) do
    for _, method in ipairs(group.methods) do
      local its = cases:where { secondary = group.secondary, kind = group.kind, mu = 0.3, method = method }
      if #its > 0 then
        curves[#curves + 1] = { label = ("%s, points on the %s, %s"):format(method, group.secondary, group.kind), colour = k,
          style = styles[method], x = numeric.map(its, function(case) return case.p.cell end),
          y = numeric.map(its, function(case) return case.results[result] end) }
      end
    end
  end
  return stiction.figure.lines { name = result, title = words[result] .. ", mu = 0.3", legend = "below",
    x = { label = "cell of the slab", unit = "mm", log = true },
    y = { label = "amplitude / mean normal force", unit = "1", log = true }, curves = curves }
end

--- A force over the path with cells of 0.1 mm and friction.
local function force_figure(cases, what)
  local panels = {}
  for _, group in ipairs { groups[1], groups[2] } do
    local curves = {}
    for k, method in ipairs(group.methods) do
      local case = cases:find { secondary = group.secondary, kind = group.kind, mu = 0.3, cell = 0.1*mm, method = method }
      local x, normal, tangential = steady(case, case.p)
      curves[k] = { label = method, x = x, y = what == "normal" and normal or tangential, colour = method == "mortar" and 1 or k + 1 }
    end
    panels[#panels + 1] = stiction.figure.lines { name = group.secondary, curves = curves, legend = "below",
      title = ("points on the %s, %s, 0.1 mm"):format(group.secondary, group.kind),
      x = { label = "place of the die", unit = "mm" }, y = { label = what .. " force", unit = "N/mm" } }
  end
  return stiction.figure.panel { name = what, columns = 2, figures = panels }
end

local function stress_figure(cases)
  local case = cases:find { secondary = "die", kind = "quad8", mu = 0.3, cell = 0.1*mm, method = "mortar" }
  return stiction.figure.field { name = "stress", case = case, time = "last", array = "von_mises", label = "von Mises stress",
    unit = "MPa", deformed = true, mesh = true, range = { 0*MPa, 0.2*MPa }, title = "mortar, quad8, 0.1 mm, mu = 0.3",
    window = { -1.6*mm, 1.6*mm, -1.55*mm, 0.9*mm }, window_unit = "mm" }
end

return stiction.study {
  title = "Ironing",
  question = "How much do the forces of a sliding die shake with the mesh?",
  given = { density = { 1000*kg/m^3, "not used in statics" } },
  chosen = {
    radius = { 1*mm, "of the die" }, length = { 6*mm, "of the slab" }, height = { 1.5*mm, "of the slab" },
    die_young = { 10*MPa, "ten times the slab's, both deform" }, slab_young = { 1*MPa, "the soft one" },
    poisson = { 0.3, "no locking" }, depth = { 0.15*mm, "some ten cells in contact at 0.1 mm" },
    run_in = { 0.4*mm, "sliding before forces are looked at" },
    window = { 0.4*mm, "looked at to both sides of the slab's middle; at most 4 cells" },
    steps_down = { 5, "to full depth" }, steps_in = { 20, "of the run-in" },
    per_cell = { 10, "steps while the die passes a cell of the slab" },
    allowed = { 0.002, "shaking of the finest mesh over the mean normal force; ours" },
    ratio = { 0.83, "size of the die's cells over the slab's; no simple fraction" },
  },
  sweep = cases_of(groups, nil, { 0.2*mm, 0.1*mm, 0.05*mm }),
  quick = { sweep = cases_of({ groups[1], groups[2] }, { 0.3 }, { 0.2*mm, 0.1*mm }), set = { allowed = 0.005, per_cell = 6 } },
  case_id = function(p) return ("%s_%s_mu%g_%g_%s"):format(p.secondary, p.kind, p.mu, p.cell:to("um"), p.method) end,
  scene = scene,
  results = {
    { name = "normal", unit = "N/mm", meaning = "mean normal force", function(run, p)
      local _, normal = steady(run, p)
      return numeric.mean(normal)
    end },
    { name = "ratio_of_forces", unit = "1", meaning = "mean tangential over mean normal force", function(run, p)
      local _, normal, tangential = steady(run, p)
      return numeric.mean(tangential) / numeric.mean(normal)
    end },
    { name = "shake_n", unit = "1", meaning = "amplitude of the normal force over its mean", function(run, p)
      local x, normal = steady(run, p)
      return amplitude(x, normal, numeric.mean(normal))
    end },
    { name = "shake_t", unit = "1", meaning = "amplitude of the tangential force over the mean normal one", function(run, p)
      local x, normal, tangential = steady(run, p)
      return amplitude(x, tangential, numeric.mean(normal))
    end },
  },
  check = function(cases, check)
    for _, group in ipairs(groups) do
      for _, mu in ipairs(group.mu) do
        local its = cases:where { secondary = group.secondary, kind = group.kind, mu = mu }
        local others = {}
        for _, method in ipairs(group.methods) do
          others[method] = method ~= "mortar" and its:where { method = method } or nil -- mortar is the last
        end
        if #its > 0 then
          check_group(check, group, mu, its:where { method = "mortar" }, others)
        end
      end
    end
  end,
  figures = function(cases)
    return { shaking_figure(cases, "shake_t"), shaking_figure(cases, "shake_n"), force_figure(cases, "tangential"),
      force_figure(cases, "normal"), stress_figure(cases) }
  end,
}
