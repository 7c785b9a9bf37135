-- A bar that bounces on the floor for ever: Doyen, Ern and Piperno's benchmark of time schemes for impact.
--
--     |  bar, length L, dropped undeformed from h0    exact: on the floor during [t_f, t_f + 2 t_w], up and down in
--     |                                               2 t_f while it vibrates, on the floor again, back to h0 at rest;
--     v  gravity                                      t_f = sqrt(2 h0 / g) = 1 s, t_w = L / c = 1/3 s
--   ----- floor
--
--     ./stiction run studies/proofs/bouncing_bar
local stiction = require "stiction"
local units = stiction.units
local m, s, kg, Pa = units.m, units.s, units.kg, units.Pa
local bar, schemes = stiction.reference.bar, stiction.schemes

local function exact(p)
  return bar.bounce { young = p.young.si, density = p.density.si, length = p.length.si, gravity = p.gravity.si,
    height = p.height.si }
end

local function scene(p)
  local cell, answer = p.length / p.cells, exact(p)
  local duration = p.periods * answer.period
  local step = p.courant * answer.wave / p.cells
  return stiction.scene {
    gravity = { 0*m/s^2, -p.gravity },
    bodies = { bar = stiction.body {
      mesh = stiction.mesh.block { origin = { 0*m, p.height }, size = { cell, p.length }, cells = { 1, p.cells } },
      material = stiction.material.linear_elastic { young = p.young, poisson = 0 }, density = p.density,
    } },
    obstacles = { floor = stiction.obstacle { shape = stiction.rigid.plane {} } },
    pairs = { foot = stiction.pair { secondary = "bar.bottom", primary = "floor" } },
    motions = { stiction.motion.fix { set = "bar.all", y = false } },
    scheme = schemes.make(p.scheme),
    schedule = stiction.schedule { stages = { stiction.stage { to = duration*s, steps = math.floor(duration / step + 0.5) } } },
    output = stiction.output { frames = 0 },
    probes = {
      foot = stiction.probe.contact_point { pair = "foot", near = { 0*m, p.height } },
      lower = stiction.probe.node { set = "bar.bottom", near = { 0*m, p.height } },
      energy = stiction.probe.energy { audit = true },
    },
  }
end

local function heights(run, p)
  return stiction.numeric.map(run:series("lower", "u_y"), function(u) return p.height.si + u end)
end

--- Norm of the path's error over that of the path.
local function path_error(run, p)
  local answer, sum, whole = exact(p), 0, 0
  local y = heights(run, p)
  for i = 2, #y do
    local wanted, dt = answer.height(run.time[i]), run.time[i] - run.time[i - 1]
    sum, whole = sum + dt * (y[i] - wanted) ^ 2, whole + dt * wanted ^ 2
  end
  return math.sqrt(sum / whole)
end

--- Mechanical energy over that at the start, with the floor as the level of the potential.
local function energies(run, p)
  local width = p.length.si / p.cells
  local start = p.density.si * p.length.si * width * p.gravity.si * p.height.si
  local strain, potential = run:series("energy", "strain"), run:series("energy", "potential")
  local list = {}
  for i, kinetic in ipairs((run:series("energy", "kinetic"))) do
    list[i] = 1 + (kinetic + strain[i] + potential[i]) / start
  end
  return list
end

--- Impulse of the floor over the time, over the weight that it has to carry.
local function impulse(run, p)
  local pressure = run:series("foot", "pressure")
  local sum = 0
  for i = 2, #pressure do
    sum = sum + pressure[i] * (run.time[i] - run.time[i - 1])
  end
  return sum / (p.density.si * p.length.si * p.gravity.si * run.time[#run.time])
end

local names = { "massless", "default", "moreau_jean", "generalised_alpha_massless", "paper_055", "paper" }

local function sweep_of(schemes_run, meshes)
  local cases = {}
  for _, cells in ipairs(meshes) do
    cases[#cases + 1] = { scheme = "massless", cells = cells }
  end
  for _, name in ipairs(schemes_run) do
    if name ~= "massless" then
      cases[#cases + 1] = { scheme = name, cells = meshes[#meshes] }
    end
  end
  return cases
end

--- The exact history as one more curve.
local function exact_curve(p, name)
  local answer, x, y = exact(p), {}, {}
  for i = 0, 2000 do
    x[i + 1] = p.periods * answer.period * i / 2000
    y[i + 1] = answer[name](x[i + 1])
  end
  return { label = "exact", style = "dash", x = x, y = y }
end

--- One picture of the schemes that t.schemes names, or all, on the finest mesh.
local function picture(cases, t, y_of)
  local curves, finest = {}, cases[1].p.cells
  for _, case in ipairs(cases) do
    finest = math.max(finest, case.p.cells)
  end
  for _, case in ipairs(cases:where { cells = finest }) do
    local wanted = t.schemes == nil or t.schemes:find(case.p.scheme .. " ", 1, true)
    curves[#curves + 1] = wanted and { label = case.p.scheme, x = case.time, y = y_of(case) } or nil
  end
  curves[#curves + 1] = t.exact and exact_curve(cases[1].p, t.exact)
  return stiction.figure.lines { name = t.name, title = ("%s, %d cells"):format(t.title, finest), x = { label = "time", unit = "s" },
    y = t.y, legend = "below", curves = curves }
end

return stiction.study {
  title = "Bouncing bar (Doyen, Ern, Piperno)",
  question = "Do energy, path and pressure of a bar stay right over two bounces and back, twice?",
  given = {
    young = { 900*Pa, "c = 30 m/s" }, density = { 1*kg/m^3, "" }, length = { 10*m, "" }, gravity = { 10*m/s^2, "" },
    height = { 5*m, "" }, periods = { 2, "of 16/3 s, two bounces in each" },
  },
  chosen = { courant = { 1, "a step is the time a wave takes through a cell" } },
  sweep = sweep_of(names, { 50, 100, 200 }),
  quick = { sweep = sweep_of({ "massless", "default" }, { 50, 100, 200 }) },
  case_id = function(p) return ("%s_%d"):format(p.scheme, p.cells) end,
  scene = scene,
  results = {
    { name = "energy_kept", unit = "1", meaning = "least mechanical energy over that at the start",
      function(run, p) return (stiction.numeric.min(energies(run, p))) end },
    { name = "path_error", unit = "1", meaning = "L2 error of the lower end's height over its L2 norm", path_error },
    { name = "impulse", unit = "1", meaning = "impulse of the floor over weight times time", impulse },
  },
  check = function(cases, check)
    local runs = cases:where { scheme = "massless" }
    local source = "Doyen, Ern and Piperno 2011; d'Alembert"
    local function row(quantity, result, reference, tolerance, order)
      local values = {}
      for k, case in ipairs(runs) do
        values[k] = { case.p.length / case.p.cells, case.results[result] }
      end
      check.proof { case = "Bouncing bar, massless", quantity = quantity, kind = "exact", source = source, reference = reference,
        scale = 1, values = values, resolution = "m cell", tolerance = tolerance, order = order, run = runs[#runs] }
    end
    row("least energy over two periods", "energy_kept", 1, 0.005)
    row("path of the lower end, L2 error", "path_error", 0, 0.03)
    row("impulse of the floor over the weight's", "impulse", 1, 0.01)
    for _, case in ipairs(cases) do
      check.ledger(case)
    end
  end,
  figures = function(cases)
    local massless = cases:where { scheme = "massless" }
    return {
      picture(cases, { name = "path", title = "Height of the lower end", exact = "height",
        schemes = "massless default paper_055 ", y = { label = "height", unit = "m" } },
        function(case) return heights(case, case.p) end),
      picture(massless, { name = "pressure", title = "Pressure under the bar", exact = "pressure",
        y = { label = "pressure", unit = "Pa", range = { -50*Pa, 700*Pa } } },
        function(case) return (case:series("foot", "pressure")) end),
      picture(cases, { name = "energy", title = "Mechanical energy", y = { label = "energy over its start", unit = "1",
        range = { 0.8, 1.05 } } }, function(case) return energies(case, case.p) end),
    }
  end,
}
