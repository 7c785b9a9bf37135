-- Ironing in space: half a ball is pressed into a softer slab and slides over it, half of both by symmetry.
--
--        ________
--       |  ball  |  -->    down by `depth`, then across, held upright
--        \_    _/
--     _____'--'___________
--    |        slab        |  ten times softer, held below; its surface carries the contact points
--    |____________________|
--
-- The forces of steady sliding do not shake, the mesh does; measured as in the plane (studies/proofs/ironing): a
-- parabola over the path is taken off, half of what is left from peak to peak, over the mean normal force.
--
--     ./stiction run studies/proofs/nonmatching_slide
local stiction = require "stiction"
local units = stiction.units
local mm, MPa, s, kg, m = units.mm, units.MPa, units.s, units.kg, units.m
local numeric = stiction.numeric

local function body(p, mesh, young)
  return stiction.body { mesh = mesh, density = p.density,
    material = stiction.material.neo_hookean { young = young, poisson = p.poisson } }
end

local function meshes(p)
  local zero, h = 0*mm, p.cell
  local function count(length) return math.floor(length / h + 0.5) end
  return stiction.mesh.half_ball { centre = { -p.run_in - p.window, zero, p.radius }, radius = p.radius, part = "half",
      fine = { 0.6*mm, 0.2*mm }, fine_size = p.ratio * h, coarse_size = 3 * h },
    stiction.mesh.box { origin = { -p.length / 2, zero, -p.height }, size = { p.length, p.width, p.height },
      cells = { count(p.length), count(p.width), count(p.height / 1.5) }, grading = { 1, 1, 0.4 } }
end

local function scene(p)
  local zero, down = 0*mm, -p.depth
  local ball, slab = meshes(p)
  return stiction.scene {
    kinematics = "three_dimensional",
    bodies = { ball = body(p, ball, p.ball_young), slab = body(p, slab, p.slab_young) },
    pairs = { iron = stiction.pair { secondary = "slab.top", primary = "ball.cap", discretisation = p.method,
      friction = p.mu > 0 and stiction.friction.coulomb { mu = p.mu } or nil } },
    motions = {
      stiction.motion.fix { set = "slab.bottom" },
      stiction.motion.fix { set = "slab.front", x = false, z = false },
      stiction.motion.fix { set = "ball.symmetry_y", x = false, z = false },
      stiction.motion.drive { set = "ball.flat", times = { 0*s, 1*s, 2*s, 3*s },
        x = { zero, zero, p.run_in, p.run_in + 2 * p.window }, z = { zero, down, down, down } },
    },
    scheme = stiction.scheme.quasi_static {},
    schedule = stiction.schedule { stages = {
      stiction.stage { to = 1*s, steps = p.steps_down }, stiction.stage { to = 2*s, steps = p.steps_in },
      stiction.stage { to = 3*s, steps = math.floor(2 * p.window / p.cell * p.per_cell + 0.5) } } },
    probes = { ball = stiction.probe.force { set = "ball.flat" } },
  }
end

--- Over the stretch looked at: places of the ball's middle, the forces that press and drag the whole ball.
local function steady(run, p)
  local fx, fz = run:series("ball", "force_x"), run:series("ball", "force_z")
  local x, normal, tangential = {}, {}, {}
  for i, t in ipairs(run.time) do
    if t > 2 - 1e-9 then
      x[#x + 1], normal[#normal + 1], tangential[#tangential + 1] = (2 * t - 5) * p.window.si, -2 * fz[i], 2 * fx[i]
    end
  end
  return x, normal, tangential
end

--- Amplitude of what a parabola over x leaves of a force, over the scale.
local function amplitude(x, force, scale)
  return numeric.amplitude(numeric.without_trend(x, force, 2)) / scale
end

local function cases_of(mu, cell)
  return { { mu = mu, cell = cell, method = "node_to_segment" }, { mu = mu, cell = cell, method = "mortar" } }
end

local function joined(a, b)
  local all = table.move(a, 1, #a, 1, {})
  return table.move(b, 1, #b, #all + 1, all)
end

local function percents(cases, name)
  return table.concat(numeric.map(cases, function(case) return ("%.3g %%"):format(100 * case.results[name]) end), ", ")
end

local words = { shake_n = "shaking of the normal force", shake_t = "shaking of the tangential force" }

local function row(check, cases, quantity, result, tolerance, note)
  check.proof { case = ("Ironing in space, hex8, mortar, mu = %g"):format(cases[1].p.mu), quantity = quantity,
    kind = "exact", source = "steady sliding, symmetry", reference = 0, scale = 1, tolerance = tolerance,
    resolution = "m cell", run = cases[#cases], note = note,
    values = numeric.map(cases, function(case) return { case.p.cell, case.results[result] } end) }
end

local function force_figure(cases, what)
  local curves = {}
  for _, case in ipairs(cases:where { mu = 0.3 }) do
    local x, normal, tangential = steady(case, case.p)
    local mortar = case.p.method == "mortar"
    curves[#curves + 1] = { x = x, y = what == "normal" and normal or tangential, colour = case.p.cell.si > 1.5e-4 and 1 or 2,
      style = mortar and "solid" or "dash",
      label = ("%s, %g mm"):format(mortar and "mortar" or "node to segment", case.p.cell:to("mm")) }
  end
  return stiction.figure.lines { name = what, curves = curves, legend = "below", title = "mu = 0.3",
    x = { label = "place of the ball", unit = "mm" }, y = { label = what .. " force", unit = "N" } }
end

local function stress_figure(cases)
  local its = cases:where { mu = 0.3, method = "mortar" }
  return stiction.figure.field { name = "stress", case = its[#its], time = "last", array = "von_mises", unit = "MPa",
    label = "von Mises stress", deformed = true, mesh = true, view = { azimuth = -60, elevation = 20 },
    range = { 0*MPa, 0.3*MPa }, title = "mortar, mu = 0.3" }
end

return stiction.study {
  title = "Ironing in space",
  question = "How much do the forces of a sliding ball shake with the mesh?",
  given = { density = { 1000*kg/m^3, "not used in statics" } },
  chosen = {
    radius = { 1*mm, "of the ball" }, length = { 3.2*mm, "of the slab" }, width = { 1.2*mm, "of half of it" },
    height = { 0.8*mm, "of the slab" }, ball_young = { 10*MPa, "ten times the slab's, both deform" },
    slab_young = { 1*MPa, "the soft one" }, poisson = { 0.3, "no locking" }, depth = { 0.15*mm, "of the order of the plane study" },
    run_in = { 0.3*mm, "sliding before forces are looked at" }, window = { 0.2*mm, "looked at to both sides of the middle" },
    steps_down = { 4, "to full depth" }, steps_in = { 6, "of the run-in" },
    per_cell = { 8, "steps while the ball passes a cell" },
    allowed = { 0.002, "shaking of the finest mesh over the mean normal force; ours" },
    ratio = { 0.83, "size of the ball's cells over the slab's; no simple fraction" },
  },
  sweep = joined(cases_of(0, 0.2*mm), joined(cases_of(0.3, 0.2*mm), cases_of(0.3, 0.1*mm))),
  quick = { sweep = joined({ cases_of(0, 0.2*mm)[2] }, cases_of(0.3, 0.2*mm)), set = { allowed = 0.01 } },
  case_id = function(p) return ("mu%g_%g_%s"):format(p.mu, p.cell:to("um"), p.method == "mortar" and "mortar" or "nts") end,
  scene = scene,
  results = {
    { name = "normal", unit = "N", meaning = "mean normal force", function(run, p)
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
    local mortar = cases:where { method = "mortar", mu = 0.3 }
    local nodes = cases:where { method = "node_to_segment", mu = 0.3 }
    for _, result in ipairs { "shake_n", "shake_t" } do
      row(check, mortar, words[result] .. " over the mean normal one", result, mortar[1].p.allowed,
        "node to segment: " .. percents(nodes, result))
      for i, case in ipairs(mortar) do
        check.holds(("%s: %s less than with node to segment"):format(case.id, words[result]),
          case.results[result] < nodes[i].results[result])
      end
      if #mortar > 1 then
        check.non_increasing(words[result] .. " falls with the cell", mortar:values(result))
      end
    end
    row(check, cases:where { method = "mortar", mu = 0 }, "mean tangential over mean normal force", "ratio_of_forces", 1e-3)
  end,
  figures = function(cases)
    return { force_figure(cases, "normal"), force_figure(cases, "tangential"), stress_figure(cases) }
  end,
}
