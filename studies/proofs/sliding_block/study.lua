-- A block thrown along a rigid plane: when, where and in which direction friction stops it.
--
--      z        ______
--      |  y    /_____/|  -> v0, oblique to the edges      stops at v0/(mu g) after v0^2/(2 mu g),
--      | /    |_____|/   v g                              straight ahead, all its energy gone
--      |/___x ----------- plane, Coulomb's mu
--
-- The block is elastic but stiff, and damped, so that it moves as a rigid one: without damping its own
-- vibrations go on, and lift it a little off the plane.
--
--     ./stiction run studies/proofs/sliding_block
local stiction = require "stiction"
local units = stiction.units
local m, mm, s, kg, MPa, ms = units.m, units.mm, units.s, units.kg, units.MPa, units.ms

local function speed(p) return math.sqrt(p.vx.si ^ 2 + p.vy.si ^ 2) end
local function stop_time(p) return speed(p) / (p.mu * p.gravity.si) end
local function stop_distance(p) return speed(p) ^ 2 / (2 * p.mu * p.gravity.si) end
local function start_energy(p) return p.density.si * p.side.si ^ 2 * p.height.si * speed(p) ^ 2 / 2 end
local function middle(p) return { p.side / 2, p.side / 2, 0*m } end
local function step(p) return stop_time(p) / p.steps end

local function block(p)
  local viscosity = p.damping * p.young
  return stiction.body {
    mesh = stiction.mesh.box { size = { p.side, p.side, p.height }, cells = { p.cells, p.cells, p.layers } },
    material = stiction.material.linear_elastic { young = p.young, poisson = p.poisson },
    damping = stiction.damping.kelvin_voigt { shear_viscosity = viscosity, bulk_viscosity = viscosity },
    density = p.density, velocity = { p.vx, p.vy, 0*m/s },
  }
end

local function scene(p)
  return stiction.scene {
    kinematics = "three_dimensional", gravity = { 0*m/s^2, 0*m/s^2, -p.gravity },
    bodies = { block = block(p) },
    obstacles = { plane = stiction.obstacle { shape = stiction.rigid.plane {} } },
    pairs = { sole = stiction.pair {
      secondary = "block.bottom", primary = "plane", direction = { 1, 0, 0 },
      friction = stiction.friction.coulomb { mu = p.mu },
    } },
    schedule = stiction.schedule { stages = {
      stiction.stage { to = 1.25 * stop_time(p) * s, steps = 5 * p.steps // 4 },
    } },
    output = stiction.output { frames = 0 },
    probes = {
      sole = stiction.probe.contact { pair = "sole" },
      centre = stiction.probe.node { set = "block.bottom", near = middle(p) },
      energy = stiction.probe.energy { audit = true },
    },
  }
end

-- First recorded time from which no point slides any more.
local function stopped(run)
  local slipping, at = run:series("sole", "slip"), #run.time
  while at > 1 and slipping[at - 1] == 0 do at = at - 1 end
  return run.time[at]
end

-- Work of the whole force on the sole along the way of its middle by trapezia, from these two histories alone.
local function work_on_the_way(run)
  local sum = 0
  for _, axis in ipairs { "x", "y" } do
    local force, way = run:series("sole", "force_" .. axis), run:series("centre", "u_" .. axis)
    sum = sum - stiction.numeric.integral(way, force)
  end
  return sum
end

local function proofs(cases, check)
  local finest = cases[#cases]
  local p = finest.p
  local function row(quantity, unit, reference, tolerance, order, result)
    local values = {}
    for i, c in ipairs(cases) do values[i] = { step(c.p), c.results[result] } end
    check.proof { case = "Sliding block", quantity = quantity, unit = unit, kind = "exact", source = "rigid block",
      reference = reference, values = values, resolution = "s step", tolerance = tolerance, order = order, run = finest }
  end
  row("time to rest", "s", stop_time(p), 0.005, 0.9, "stop")
  row("distance", "m", stop_distance(p), 0.005, 0.9, "distance")
  row("direction, u_y/u_x", "1", p.vy.si / p.vx.si, 1e-5, nil, "direction")
  row("energy that friction takes", "J", start_energy(p), 0.005, 0.9, "friction_loss")
end

return stiction.study {
  title = "Block sliding to rest", question = "Does friction stop a thrown block when and where it should?",
  given = {
    vx = { 0.6*m/s, "" }, vy = { 0.8*m/s, "1 m/s in all" }, mu = { 0.4, "" }, gravity = { 10*m/s^2, "" },
    side = { 200*mm, "" }, height = { 40*mm, "" }, density = { 1000*kg/m^3, "" },
  },
  chosen = {
    young = { 10*MPa, "a wave crosses the height in 0.4 ms: rigid beside the 250 ms of the motion" },
    poisson = { 0.3, "of no account" },
    damping = { 1*ms, "viscosity over Young's modulus: vibrations are gone within some ms" },
  },
  sweep = {
    { steps = 100, cells = 4, layers = 2 }, { steps = 200, cells = 4, layers = 2 }, { steps = 400, cells = 4, layers = 2 },
    { steps = 400, cells = 8, layers = 3 },
  },
  quick = { sweep = { { steps = 200, cells = 4, layers = 2 }, { steps = 400, cells = 4, layers = 2 } } },
  case_id = function(p) return ("%d_steps_%d_cells"):format(p.steps, p.cells) end,
  scene = scene,
  results = {
    { name = "stop", unit = "s", meaning = "time from which no point slides", stopped },
    { name = "distance", unit = "m", meaning = "way of the middle of the sole",
      function(run) return math.sqrt(run:last("centre", "u_x") ^ 2 + run:last("centre", "u_y") ^ 2) end },
    { name = "direction", unit = "1", meaning = "u_y / u_x at the end",
      function(run) return run:last("centre", "u_y") / run:last("centre", "u_x") end },
    { name = "friction_loss", unit = "J", meaning = "what friction takes, by the ledger",
      function(run) return run:last("energy", "friction_loss") end },
    { name = "friction_work", unit = "J", meaning = "the same from the force on the sole and its way", work_on_the_way },
    { name = "damping_loss", unit = "J", meaning = "what the block's viscosity takes",
      function(run) return run:last("energy", "damping_loss") end },
    { name = "scheme_loss", unit = "J", meaning = "what the scheme takes",
      function(run) return run:last("energy", "scheme_loss") end },
  },
  check = function(cases, check)
    local coarse_mesh = cases:where { cells = 4 }
    proofs(coarse_mesh, check)
    for _, c in ipairs(cases) do
      check.ledger(c)
      check.close(c.id .. ": kinetic energy at the start", c:series("energy", "kinetic")[1], start_energy(c.p), 1e-12)
      check.close(c.id .. ": friction's loss is the work of the force on the sole", c.results.friction_loss,
        c.results.friction_work, 1e-5)
      check.within(c.id .. ": the scheme makes no energy and loses less than 1 %",
        c.results.scheme_loss / start_energy(c.p), 0, 0.01)
    end
    local fine_mesh = cases:find { steps = 400, cells = 8 }
    if fine_mesh then
      local same = coarse_mesh[#coarse_mesh].results
      check.close("the mesh does not matter: distance", fine_mesh.results.distance, same.distance, 5e-4)
      check.close("the mesh does not matter: time to rest", fine_mesh.results.stop, same.stop, 1e-9)
    end
  end,
  figures = function(cases)
    local p = cases[1].p
    local speeds, energies, stop = {}, {}, stop_time(p)
    local t, v, e = {}, {}, {}
    for i = 0, 50 do
      t[i + 1] = stop * 1.25 * i / 50
      v[i + 1] = speed(p) * math.max(0, 1 - t[i + 1] / stop)
      e[i + 1] = start_energy(p) * (v[i + 1] / speed(p)) ^ 2
    end
    for i, c in ipairs(cases:where { cells = 4 }) do
      local vx, vy, way = c:series("centre", "v_x"), c:series("centre", "v_y"), {}
      for k in ipairs(vx) do way[k] = math.sqrt(vx[k] ^ 2 + vy[k] ^ 2) end
      speeds[i] = { label = c.p.steps .. " steps to rest", x = c.time, y = way, colour = i }
    end
    speeds[#speeds + 1] = { label = "v0 - mu g t", x = t, y = v, style = "dash", colour = 4 }
    local fine = cases[#cases]
    for i, name in ipairs { "kinetic", "friction_loss", "damping_loss", "scheme_loss" } do
      energies[i] = { label = name:gsub("_", " "), case = fine, y = "energy/" .. name, colour = i }
    end
    energies[#energies + 1] = { label = "kinetic, rigid block", x = t, y = e, style = "dash", colour = 5 }
    return {
      stiction.figure.lines { name = "speed", title = "speed of the middle of the sole", x = { label = "time", unit = "ms" },
        y = { label = "speed", unit = "m/s" }, curves = speeds },
      stiction.figure.lines { name = "energy", title = "where the energy goes, " .. fine.p.steps .. " steps",
        x = { label = "time", unit = "ms" }, y = { label = "energy", unit = "J" }, curves = energies },
    }
  end,
}
