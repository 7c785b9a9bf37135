-- Every law of friction at one point, through the whole program: a pressed cell dragged along a plane.
--
--      v v v p v v v
--      ______             nu = 0, so that the pressure below is E times the way of the top down over 1 m
--     | cell |  -> v
--     |______|
--     -o----o-- rigid plane    area 1 m^2 per m: shear and pressure are the points' tractions
--
-- rising: p grows from 0.1 to 2 kPa at 1 mm/s. speeds: p = 1 kPa, half, one and three mm/s. pauses: p = 1 kPa, dragged, let be,
-- dragged on and back.
--
--     ./stiction run studies/proofs/friction_laws
local stiction = require "stiction"
local laws = stiction.reference.point_laws.friction
local friction = stiction.friction
local numeric = stiction.numeric
local units = stiction.units
local m, mm, s, kg, Pa, GPa = units.m, units.mm, units.s, units.kg, units.Pa, units.GPa

local young = 1e9 -- Pa

-- Paths: times in s, way along the plane in mm, pressure in Pa.
local paths = {
  rising = { { 0, 4 }, { 0, 4 }, { 100, 2000 } },
  speeds = { { 0, 1, 2, 3 }, { 0, 0.5, 1.5, 4.5 }, { 1000, 1000, 1000, 1000 } },
  pauses = { { 0, 1, 2, 3, 4 }, { 0, 1, 1, 2, 1 }, { 1000, 1000, 1000, 1000, 1000 } },
}

-- The law and its shear at the pressure p and the speed v, Pa; whether the step starts from rest matters to one law alone.
local tests = {
  coulomb = { path = "rising", source = "Coulomb 1785", law = function() return friction.coulomb { mu = 0.5 } end,
    shear = function(p) return 0.5 * p end },
  tresca = { path = "rising", source = "Orowan 1943", law = function() return friction.tresca { mu = 0.5, tau_max = 400*Pa } end,
    shear = function(p) return laws.tresca(0.5, 400, p) end },
  pressure = { path = "rising", source = "Thirion 1946, exponential",
    law = function() return friction.pressure { mu_0 = 0.8, mu_inf = 0.2, p_ref = 500*Pa } end,
    shear = function(p) return laws.pressure(0.8, 0.2, 500, "exponential", p) end },
  thirion = { path = "rising", source = "Thirion 1946",
    law = function() return friction.pressure { mu_0 = 0.8, mu_inf = 0.2, p_ref = 500*Pa, decay = "thirion" } end,
    shear = function(p) return laws.pressure(0.8, 0.2, 500, "thirion", p) end },
  velocity = { path = "speeds", source = "Tustin 1947",
    law = function() return friction.velocity { mu_s = 0.6, mu_k = 0.3, v_ref = 1*mm/s } end,
    shear = function(p, v) return p * laws.velocity(0.6, 0.3, 1e-3, v) end },
  static_kinetic = { path = "pauses", source = "Coulomb 1785",
    law = function() return friction.static_kinetic { mu_s = 0.6, mu_k = 0.4 } end,
    shear = function(p, v, from_rest) return p * (from_rest and 0.6 or 0.4) * (v < 0 and -1 or 1) end },
}
local order = { "coulomb", "tresca", "pressure", "thirion", "velocity", "static_kinetic" }

local function scene(p)
  local path = paths[tests[p.law].path]
  local times = numeric.map(path[1], function(t) return t * s end)
  return stiction.scene {
    bodies = { cell = stiction.body {
      mesh = stiction.mesh.block { size = { 1*m, 1*m }, cells = { 1, 1 } }, density = 1000*kg/m^3,
      material = stiction.material.linear_elastic { young = 1*GPa, poisson = 0 },
    } },
    obstacles = { plane = stiction.obstacle { shape = stiction.rigid.plane {} } },
    pairs = { point = stiction.pair { secondary = "cell.bottom", primary = "plane", friction = tests[p.law].law() } },
    motions = {
      stiction.motion.drive { set = "cell.all", times = times, x = numeric.map(path[2], function(x) return x * mm end) },
      stiction.motion.drive { set = "cell.top", times = times, y = numeric.map(path[3], function(f) return -f / young * m end) },
    },
    scheme = stiction.scheme.quasi_static {}, control = stiction.control { force_tolerance = p.tolerance },
    schedule = stiction.schedule { stages = { stiction.stage { to = times[#times], steps = p.steps * path[1][#path[1]] } } },
    output = stiction.output { frames = 0 },
    probes = { point = stiction.probe.contact_point { pair = "point", near = { 0*m, 0*m } }, energy = stiction.probe.energy {} },
  }
end

-- Pressure, speed over the step and way at the k-th recorded time.
local function place(run, k)
  local path = paths[tests[run.p.law].path]
  local t, before = run.time[k], run.time[math.max(1, k - 1)]
  local x, x_before = numeric.interpolate(path[1], path[2], t), numeric.interpolate(path[1], path[2], before)
  return numeric.interpolate(path[1], path[3], t), k > 1 and (x - x_before) * 1e-3 / (t - before) or 0, x
end

-- Shear against the motion, Pa.
local function shear(run)
  return numeric.map(run:series("point", "friction"), function(r) return -r end)
end

-- The closed law at the k-th recorded time, nil where the point rests.
local function exact(run, k)
  local p, v = place(run, k)
  if v == 0 then return nil end
  local _, v_before = place(run, k - 1)
  return tests[run.p.law].shear(p, v, k == 2 or v_before == 0)
end

local function deviation(run)
  local most, list = 0, shear(run)
  for k = 2, #list do
    local wanted = exact(run, k)
    if wanted then most = math.max(most, math.abs(list[k] - wanted) / 1e3) end
  end
  return most
end

-- int shear dx of the closed law, by the middle of 12000 intervals.
local function closed_loss(name)
  local t, sum, n = tests[name], 0, 12000
  local path = paths[t.path]
  local last_time = path[1][#path[1]]
  local function at(k) return last_time * k / n end
  for k = 1, n do
    local middle = 0.5 * (at(k - 1) + at(k))
    local way = 1e-3 * (numeric.interpolate(path[1], path[2], at(k)) - numeric.interpolate(path[1], path[2], at(k - 1)))
    sum = sum + (way == 0 and 0 or 1) * t.shear(numeric.interpolate(path[1], path[3], middle), way / (at(k) - at(k - 1))) * way
  end
  return sum
end

local function check_law(runs, check)
  local finest = runs[#runs]
  local name = finest.p.law
  local t = tests[name]
  local function row(quantity, unit, result, reference, tolerance, least_order)
    local values = {}
    for i, c in ipairs(runs) do values[i] = { 1 / c.p.steps, c.results[result] } end
    check.proof { case = "Friction, " .. name:gsub("_", " "), quantity = quantity, unit = unit, kind = "exact", source = t.source,
      reference = reference, values = values, resolution = "s step", tolerance = tolerance, order = least_order, run = finest }
  end
  local path = paths[t.path]
  local n = #path[1]
  local v = 1e-3 * (path[2][n] - path[2][n - 1]) / (path[1][n] - path[1][n - 1])
  row("shear at the end", "kPa", "at_end", t.shear(path[3][n], v), 1e-10)
  row("loss of friction", "J/m^2", "loss", closed_loss(name), 5e-3, t.path ~= "speeds" and 0.9 or nil)
  for _, c in ipairs(runs) do check.within(c.id .. ": the whole curve, over 1 kPa", c.results.deviation, 0, 1e-10) end
end

-- The closed law over `at`, in pieces where it moves.
local function exact_pieces(run, at, label, colour)
  local pieces, open = {}, nil
  for k = 2, #run.time do
    local wanted = exact(run, k)
    if wanted and not open then
      open = { label = #pieces == 0 and label or nil, x = {}, y = {}, colour = colour }
      pieces[#pieces + 1] = open
    end
    if wanted then
      open.x[#open.x + 1], open.y[#open.y + 1] = at[k], wanted
    else
      open = nil
    end
  end
  return pieces
end

-- Shear over what the law follows: pressure, or time.
local function picture(cases, t)
  local curves = {}
  for i, name in ipairs(t.laws) do
    local run, at = cases:find { law = name, steps = 100 }, {}
    for k = 1, #run.time do at[k] = t.along(run, k) end
    for _, piece in ipairs(exact_pieces(run, at, name:gsub("_", " "), i)) do curves[#curves + 1] = piece end
    curves[#curves + 1] = { label = i == 1 and "run" or nil, x = at, y = shear(run), style = "dot", colour = 6 }
  end
  return stiction.figure.lines { name = t.name, title = t.title, x = t.x, y = { label = "shear", unit = "kPa" }, curves = curves,
    legend = "below" }
end

return stiction.study {
  title = "Laws of friction at one point", question = "Does the whole program follow their closed curves?",
  chosen = { tolerance = { 1e-12, "the default 1e-7 stops too early to see 1e-10" } },
  sweep = { { "law", order }, { "steps", { 50, 100 } } },
  scene = scene,
  results = {
    { name = "at_end", unit = "Pa", meaning = "shear at the end", function(run) return -run:last("point", "friction") end },
    { name = "loss", unit = "J/m", meaning = "loss of friction", function(run) return run:last("energy", "friction_loss") end },
    { name = "deviation", unit = "1", meaning = "largest distance from the closed curve over 1 kPa", deviation },
  },
  check = function(cases, check)
    for _, name in ipairs(order) do check_law(cases:where { law = name }, check) end
  end,
  figures = function(cases)
    return {
      picture(cases, { name = "pressure", title = "shear under rising pressure", laws = { "coulomb", "tresca", "pressure", "thirion" },
        x = { label = "pressure", unit = "kPa" }, along = function(run, k) return (place(run, k)) end }),
      picture(cases, { name = "motion", title = "three speeds; drag, pause, drag on and back", laws = { "velocity", "static_kinetic" },
        x = { label = "time", unit = "s" }, along = function(run, k) return run.time[k] end }),
    }
  end,
}
