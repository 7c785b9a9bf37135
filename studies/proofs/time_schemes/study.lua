-- Every time scheme on a smooth problem: its order of accuracy, and what it does to the energy of an oscillator.
--
--       ....  wall, never reached: it makes the upper end a contact surface
--
--       |  bar of four cells, let go undeformed under its weight; its upper end bears none, since an end without
--       |  mass would jump at the start. The modes of such a chain are sin(k x) at the nodes, so that each follows
--       |  the recursion of its scheme (reference.oscillator)
--     -----  held
--
--     ./stiction run studies/proofs/time_schemes
local stiction = require "stiction"
local units = stiction.units
local m, s, kg, Pa = units.m, units.s, units.kg, units.Pa
local oscillator, schemes = stiction.reference.oscillator, stiction.schemes

local title = "All schemes: order on a smooth problem, energy of an oscillator, impact of a bar"

local function wave_speed(p) return math.sqrt(p.young.si / p.density.si) end
local function first_period(p) return 4 * p.length.si / wave_speed(p) end
local function duration(p) return p.periods * first_period(p) end

local function scene(p)
  local cell = p.length / p.cells
  local end_weight = p.density * p.gravity * cell / 2
  return stiction.scene {
    gravity = { 0*m/s^2, -p.gravity },
    bodies = { bar = stiction.body {
      mesh = stiction.mesh.block { size = { cell, p.length }, cells = { 1, p.cells } },
      material = stiction.material.linear_elastic { young = p.young, poisson = 0 }, density = p.density,
    } },
    obstacles = { wall = stiction.obstacle { shape = stiction.rigid.plane { point = { 0*m, 10 * p.length }, normal = { 0, -1 } } } },
    pairs = { far = stiction.pair { secondary = "bar.top", primary = "wall" } },
    motions = { stiction.motion.fix { set = "bar.bottom" }, stiction.motion.fix { set = "bar.all", y = false } },
    loads = { stiction.load.traction { set = "bar.top", times = { 0*s, duration(p)*s }, y = { end_weight, end_weight } } },
    scheme = schemes.make(p.scheme),
    schedule = stiction.schedule { stages = { stiction.stage { to = duration(p)*s, steps = p.steps } } },
    output = stiction.output { frames = 0 },
    probes = {
      tip = stiction.probe.node { set = "bar.top", near = { 0*m, p.length } },
      energy = stiction.probe.energy { audit = true },
    },
  }
end

--- Weight of a node between the ends over the stiffness of a cell.
local function stretch(p) return p.density.si * p.gravity.si * (p.length.si / p.cells) ^ 2 / p.young.si end

local function sag(p) return stretch(p) * p.cells * (p.cells - 1) / 2 end

--- Strain energy of the sag, which is the energy of the oscillation about it: the n-th cell from above bears n - 1 nodes.
local function energy_of_sag(p)
  local N = p.cells -- the stiffness of a cell, as wide as high, is Young's modulus
  return 0.5 * p.young.si * stretch(p) ^ 2 * (N - 1) * N * (2 * N - 1) / 6
end

local function oscillation(run, p, i)
  local energy = 0
  for _, name in ipairs { "kinetic", "strain", "potential" } do
    energy = energy + run:series("energy", name)[i]
  end
  return (energy - run:series("energy", "load_work")[i]) / energy_of_sag(p) + 1
end

--- What the recursion of the scheme says of the energy after all steps.
local function predicted_energy(p)
  local recursion, sum = schemes.about(p.scheme).recursion, 0
  for _, mode in ipairs(oscillator.sag_modes(wave_speed(p), p.length.si, p.cells, recursion[1] == "central_difference")) do
    local phase = mode.omega * duration(p) / p.steps
    sum = sum + mode.share * oscillator.energy_kept(recursion, phase, p.steps, true)
  end
  return sum
end

--- The way of the tip by the recursion, over the sag.
local function predicted_tip(p)
  local recursion, sum = schemes.about(p.scheme).recursion, -1
  for _, mode in ipairs(oscillator.sag_modes(wave_speed(p), p.length.si, p.cells, recursion[1] == "central_difference")) do
    sum = sum + mode.tip * oscillator.release(recursion, mode.omega * duration(p) / p.steps, p.steps)
  end
  return sum
end

local short = { 160, 320, 640, 1280 }

local function sweep_of(names, steps)
  local cases = {}
  for _, name in ipairs(names) do
    for _, count in ipairs(steps) do
      cases[#cases + 1] = { scheme = name, steps = count, periods = 0.65 }
    end
    cases[#cases + 1] = { scheme = name, steps = 200, periods = 10 }
  end
  return cases
end

local few = { "default", "paper", "backward_euler", "massless", "moreau_jean", "newmark_full", "generalised_alpha_full",
  "hht_full", "central_difference" }

local function step_of(case) return duration(case.p) / case.p.steps end

--- Root mean square over the coarse run's times of the change of the tip when the step is halved.
local function change(coarse, fine)
  local u, v, sum = coarse:series("tip", "u_y"), fine:series("tip", "u_y"), 0
  for i = 2, #u do
    sum = sum + (u[i] - v[2 * i - 1]) ^ 2
  end
  return math.sqrt(sum / (#u - 1))
end

--- {dt, change} of each step and the one half as long.
local function changes(cases, name)
  local runs, list = cases:where { scheme = name, periods = 0.65 }, {}
  for k = 2, #runs do
    list[k - 1] = { step_of(runs[k - 1]), change(runs[k - 1], runs[k]) }
  end
  return list
end

--- Observed orders {dt, order}, the finest last.
local function orders(cases, name)
  local list, found = changes(cases, name), {}
  for k = 2, #list do
    found[k - 1] = { list[k][1], math.log(list[k - 1][2] / list[k][2]) / math.log(2) }
  end
  return found
end

local function check_scheme(cases, check, name)
  local about = schemes.about(name)
  local long = cases:find { scheme = name, periods = 10 }
  check.proof { case = "Free bar, " .. name, quantity = "order of accuracy", kind = "exact",
    source = "theory of the scheme; change of the tip's path when the step is halved", reference = about.order,
    values = orders(cases, name), resolution = "s step", tolerance = 0.1, run = long }
  check.ledger(long)
  if about.recursion then
    local dt = step_of(long)
    check.proof { case = "Oscillating bar, " .. name, quantity = "energy kept in 10 periods of 20 steps", kind = "exact",
      source = "recursion of the scheme, mode by mode", reference = predicted_energy(long.p), scale = 1,
      values = { { dt, long.results.energy_kept } }, resolution = "s step", tolerance = 1e-7, run = long }
    check.proof { case = "Oscillating bar, " .. name, quantity = "tip after 10 periods", unit = "m", kind = "exact",
      source = "recursion of the scheme, mode by mode", reference = predicted_tip(long.p) * sag(long.p), scale = sag(long.p),
      values = { { dt, long.results.tip } }, resolution = "s step", tolerance = 1e-7, run = long }
  else
    check.within(name .. ": makes no energy", long.results.energy_kept, 0, 1 + 1e-7)
  end
end

local function settings_text(settings)
  local words = {}
  for key, value in pairs(settings) do
    words[#words + 1] = ("%s = %s"):format(key, tostring(value))
  end
  table.sort(words)
  return table.concat(words, ", ")
end

local function names_in(cases)
  local names, seen = {}, {}
  for _, case in ipairs(cases) do
    if not seen[case.p.scheme] then
      names[#names + 1], seen[case.p.scheme] = case.p.scheme, true
    end
  end
  return names
end

local function table_of(cases)
  local rows = {}
  for i, name in ipairs(names_in(cases)) do
    local about, found = schemes.about(name), orders(cases, name)
    rows[i] = { name, about.kind, settings_text(about.settings), about.order, found[#found][2],
      cases:find { scheme = name, periods = 10 }.results.energy_kept }
  end
  return { title = title, rows = rows, columns = { "scheme", "kind", "settings beside the defaults", "claimed order", "observed order",
    "oscillator: energy kept in 10 periods of 20 steps" } }
end

local shown = { "default", "backward_euler", "half_one", "paper_055", "massless", "newmark_full", "generalised_alpha_full", "hht_full",
  "central_difference" }

local function order_figure(cases)
  local curves, finest = {}, nil
  for _, name in ipairs { "default", "backward_euler", "massless", "newmark_full", "hht_full", "central_difference" } do
    local x, y = {}, {}
    for i, pair in ipairs(changes(cases, name)) do
      x[i], y[i] = pair[1]*s, pair[2]*m
    end
    if #x > 0 then
      curves[#curves + 1] = { label = name, x = x, y = y, style = "points" }
      finest = x
    end
  end
  for order, at in ipairs { 1e-2, 1e-3 } do
    local y = {}
    for i, dt in ipairs(finest) do
      y[i] = at * (dt / finest[1]) ^ order * m
    end
    curves[#curves + 1] = { label = ("order %d"):format(order), x = finest, y = y }
  end
  return stiction.figure.lines { name = "order", title = "Change of the tip's path when the step is halved",
    x = { label = "step", unit = "s", log = true }, y = { label = "rms change", unit = "m", log = true },
    legend = "below", curves = curves }
end

local function energy_figure(cases)
  local curves = {}
  for _, name in ipairs(shown) do
    local case = cases:find { scheme = name, periods = 10 }
    local y = {}
    for i = 1, case and #case.time or 0 do
      y[i] = oscillation(case, case.p, i)
    end
    if case then
      curves[#curves + 1] = { label = name, x = case.time, y = y }
    end
  end
  return stiction.figure.lines { name = "energy", title = "Energy of the oscillation, 20 steps per period",
    x = { label = "time", unit = "s" }, y = { label = "energy over its start", unit = "1" }, legend = "below", curves = curves }
end

return stiction.study {
  title = "Time schemes on a free bar",
  question = "Has every scheme the order that theory claims, and does it treat the energy as its recursion says?",
  given = {
    young = { 900*Pa, "makes c = 30 m/s" }, density = { 1*kg/m^3, "" }, length = { 10*m, "first period 4/3 s" },
    gravity = { 10*m/s^2, "" }, cells = { 4, "few, so that all modes are resolved in time" },
  },
  sweep = sweep_of(schemes.names(), short),
  quick = { sweep = sweep_of(few, { 320, 640, 1280 }) },
  case_id = function(p) return ("%s_%g_%d"):format(p.scheme, p.periods, p.steps) end,
  scene = scene,
  results = {
    { name = "tip", unit = "m", meaning = "displacement of the free end at the end",
      function(run) local u = run:series("tip", "u_y") return u[#u] end },
    { name = "energy_kept", unit = "1", meaning = "energy of the oscillation about the sag at the end over the start",
      function(run, p) return oscillation(run, p, #run.time) end },
  },
  check = function(cases, check)
    for _, name in ipairs(names_in(cases)) do
      check_scheme(cases, check, name)
    end
    check.table(table_of(cases))
  end,
  figures = function(cases) return { order_figure(cases), energy_figure(cases) } end,
}
