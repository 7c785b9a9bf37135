-- Impact of an elastic bar on a rigid wall: the classical test of what a time scheme does at contact.
--
--     |  bar, length L, falls at v0   exact: touches from gap / v0 for 2 L / c, presses with rho c v0,
--     |                               leaves at +v0 with all its energy
--     v
--   ----- wall
--
--     ./stiction run studies/proofs/bar_impact
local stiction = require "stiction"
local units = stiction.units
local m, s, kg, Pa = units.m, units.s, units.kg, units.Pa

local bar, schemes = stiction.reference.bar, stiction.schemes

local title = "All schemes: order on a smooth problem, energy of an oscillator, impact of a bar"

--- At their very limit central differences let the highest mode of the chain grow, linearly in time.
local function stable(p) return schemes.about(p.scheme).kind == "central_difference" and 0.95 or 1 end

local function scene(p)
  local cell = p.length / p.cells
  local step = stable(p) * p.courant * cell.si / bar.wave_speed(p.young.si, p.density.si)
  return stiction.scene {
    bodies = {
      bar = stiction.body {
        mesh = stiction.mesh.block { origin = { 0*m, p.gap }, size = { cell, p.length }, cells = { 1, p.cells } },
        material = stiction.material.linear_elastic { young = p.young, poisson = 0 },
        density = p.density, velocity = { 0*m/s, -p.speed },
      },
    },
    obstacles = { wall = stiction.obstacle { shape = stiction.rigid.plane {} } },
    pairs = { impact = stiction.pair { secondary = "bar.bottom", primary = "wall" } },
    motions = { stiction.motion.fix { set = "bar.all", y = false } },
    scheme = schemes.make(p.scheme),
    schedule = stiction.schedule {
      stages = { stiction.stage { to = p.duration, steps = math.floor(p.duration.si / step + 0.5) } },
    },
    output = stiction.output { frames = 0 },
    probes = {
      foot = stiction.probe.contact_point { pair = "impact", near = { 0*m, p.gap } },
      energy = stiction.probe.energy { audit = true },
    },
  }
end

local function exact(p)
  return bar.impact { young = p.young.si, density = p.density.si, length = p.length.si, speed = p.speed.si }
end

--- Mean pressure and its rms deviation from the exact one, from 0.1 s after the bar touches to 0.1 s before it leaves.
local function pressed(run, p)
  local answer, touch = exact(p), p.gap.si / p.speed.si
  local sum, square, count = 0, 0, 0
  local pressure = run:series("foot", "pressure")
  for i, t in ipairs(run.time) do
    if t > touch + 0.1 and t < touch + answer.duration - 0.1 then
      sum, square, count = sum + pressure[i], square + (pressure[i] - answer.pressure) ^ 2, count + 1
    end
  end
  return sum / count, math.sqrt(square / count)
end

local function mechanical(run, i)
  return run:series("energy", "kinetic")[i] + run:series("energy", "strain")[i]
end

local refined = { default = true, paper = true, paper_055 = true, backward_euler = true, massless = true }

--- All of these schemes on 100 cells, some on finer meshes too.
local function sweep_of(names, finer)
  local cases = {}
  for _, name in ipairs(names) do
    cases[#cases + 1] = { scheme = name, cells = 100 }
    for _, cells in ipairs(refined[name] and finer or {}) do
      cases[#cases + 1] = { scheme = name, cells = cells }
    end
  end
  return cases
end

--- A row of one scheme; on all its meshes, or on that of 100 cells, which the values known beforehand stand for.
local function row(cases, check, t)
  local runs, values = cases:where { scheme = t.scheme }, {}
  for _, case in ipairs(runs) do
    if not t.one or case.p.cells == 100 then
      values[#values + 1] = { case.p.length / case.p.cells, case.results[t.result] }
    end
  end
  check.proof { case = "Impact of a bar, " .. t.scheme, quantity = t.quantity, unit = t.unit, kind = t.kind or "ours",
    source = t.source or "converged runs of an independent program, 100 cells", reference = t.reference, values = values,
    resolution = "m cell", tolerance = t.tolerance, scale = t.scale, order = t.order, run = runs[t.one and 1 or #runs],
    note = t.note }
end

local closed = "d'Alembert: 300 Pa, all energy kept"

--- Against the closed answer, on three meshes.
local function check_exact(cases, check)
  local function exactly(scheme, result, quantity, more)
    row(cases, check, { scheme = scheme, result = result, quantity = quantity, kind = "exact", source = closed,
      reference = more.reference or 1, unit = more.unit, tolerance = more.tolerance, order = more.order, note = more.note,
      scale = more.scale })
  end
  exactly("default", "energy_kept", "energy kept", { tolerance = 0.007, order = 0.9,
    note = "loses what the contact cell carries: first order in its size" })
  exactly("default", "pressure_mean", "pressure", { reference = 300, unit = "Pa", tolerance = 1e-3 })
  exactly("massless", "energy_kept", "energy kept", { tolerance = 5e-4, order = 0.9 })
  exactly("massless", "pressure_mean", "pressure", { reference = 300, unit = "Pa", tolerance = 1e-4 })
end

--- Against what was known of 100 cells beforehand.
local function check_known(cases, check)
  local function known(scheme, energy, energy_tolerance, rms, note)
    row(cases, check, { scheme = scheme, result = "energy_kept", quantity = "energy kept, 100 cells", one = true,
      reference = energy, tolerance = energy_tolerance })
    row(cases, check, { scheme = scheme, result = "pressure_rms", quantity = "rms of the pressure about 300 Pa, 100 cells",
      one = true, unit = "Pa", reference = rms, scale = 300, tolerance = 1e-3, note = note })
  end
  known("paper", 0.9987, 1e-3, 173, "the pressure of the paper's plain scheme rings, 300 +- 173")
  known("paper_055", 0.9426, 3e-3, 0.06)
  known("backward_euler", 0.8192, 3e-3, 1.1)
  known("massless", 1, 5e-4, 0)
  for scheme, theta in pairs { paper_055 = 0.55, backward_euler = 1 } do
    row(cases, check, { scheme = scheme, result = "loss_factor", reference = 1.81, tolerance = 0.02,
      quantity = ("loss over sqrt((2 theta - 1) c dt / L), theta = %g"):format(theta) })
  end
end

local function names_in(cases)
  local names = {}
  for i, case in ipairs(cases:where { cells = 100 }) do
    names[i] = case.p.scheme
  end
  return names
end

local function table_of(cases)
  local rows = {}
  for i, case in ipairs(cases:where { cells = 100 }) do
    local r, cost = case.results, case.cost
    rows[i] = { case.p.scheme, r.energy_kept, r.pressure_rms, cost.steps, cost.factorizations, cost.iterations / cost.steps }
  end
  return { title = title, rows = rows, columns = { "scheme", "impact: energy kept", "rms of the pressure, Pa", "steps",
    "factorizations", "iterations per step" } }
end

local shown = { "paper", "backward_euler", "default", "massless", "moreau_jean", "generalised_alpha_full" }

local function curves_of(cases, y_of)
  local curves = {}
  for _, name in ipairs(shown) do
    local case = cases:find { scheme = name, cells = 100 }
    if case then
      curves[#curves + 1] = { label = name, x = case.time, y = y_of(case) }
    end
  end
  return curves
end

local function pressure_figure(cases)
  local curves = curves_of(cases, function(case) return (case:series("foot", "pressure")) end)
  local p = cases[1].p
  local answer, touch = exact(p), p.gap.si / p.speed.si
  local leave = touch + answer.duration
  curves[#curves + 1] = { label = "exact", style = "dash", x = { 0, touch, touch, leave, leave, p.duration.si },
    y = { 0, 0, answer.pressure, answer.pressure, 0, 0 } }
  return stiction.figure.lines { name = "pressure", title = "Pressure under the bar, 100 cells", x = { label = "time", unit = "s" },
    y = { label = "pressure", unit = "Pa", range = { -50*Pa, 700*Pa } }, legend = "below", curves = curves }
end

local function energy_figure(cases)
  local curves = curves_of(cases, function(case)
    local y = {}
    for i = 1, #case.time do
      y[i] = mechanical(case, i) / mechanical(case, 1)
    end
    return y
  end)
  return stiction.figure.lines { name = "energy", title = "Kinetic and strain energy, 100 cells", x = { label = "time", unit = "s" },
    y = { label = "energy over its start", unit = "1", range = { 0.78, 1.06 } }, legend = "below", curves = curves }
end

local few = { "default", "paper", "paper_055", "backward_euler", "massless", "moreau_jean", "newmark_full",
  "generalised_alpha_full", "hht_full", "central_difference" }

return stiction.study {
  title = "Impact of an elastic bar",
  question = "Does the scheme keep the energy, and does the contact pressure ring?",
  given = {
    young = { 900*Pa, "makes c = 30 m/s" }, density = { 1*kg/m^3, "" }, length = { 10*m, "" },
    speed = { 10*m/s, "" }, gap = { 5*m, "touches at 0.5 s" },
  },
  chosen = { courant = { 1, "a step is the time a wave takes through a cell; central differences 0.95 of it" },
    duration = { 1.6*s, "the bar has left for most of a transit" } },
  sweep = sweep_of(schemes.names(), { 200, 400 }),
  quick = { sweep = sweep_of(few, { 200 }) },
  case_id = function(p) return p.cells == 100 and p.scheme or ("%s_%d"):format(p.scheme, p.cells) end,
  scene = scene,
  results = {
    { name = "energy_kept", unit = "1", meaning = "kinetic + strain energy at the end over the start",
      function(run) return mechanical(run, #run.time) / mechanical(run, 1) end },
    { name = "loss_factor", unit = "1", meaning = "energy lost over sqrt((2 theta - 1) c dt / L), where theta > 1/2",
      function(run, p)
        local theta = schemes.about(p.scheme).settings.theta or 0.5
        local lost = 1 - mechanical(run, #run.time) / mechanical(run, 1)
        return theta > 0.5 and lost / math.sqrt((2 * theta - 1) * p.courant / p.cells) or 0
      end },
    { name = "pressure_mean", unit = "Pa", meaning = "mean pressure while the bar surely presses",
      function(run, p) return (pressed(run, p)) end },
    { name = "pressure_rms", unit = "Pa", meaning = "rms deviation of the pressure from the exact 300 Pa",
      function(run, p) return (select(2, pressed(run, p))) end },
  },
  check = function(cases, check)
    check_exact(cases, check)
    check_known(cases, check)
    for _, name in ipairs(names_in(cases)) do
      check.ledger(cases:find { scheme = name, cells = 100 })
    end
    check.table(table_of(cases))
  end,
  figures = function(cases) return { pressure_figure(cases), energy_figure(cases) } end,
}
