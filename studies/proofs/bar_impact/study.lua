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

local schemes = {
  default = {},
  paper = { theta = 0.5, xi = 0.5, contact_weight = 1, contact_inertia = "full" },
  paper_055 = { theta = 0.55, xi = 0.55, contact_weight = 1, contact_inertia = "full" },
  backward_euler = { theta = 1, xi = 1, contact_weight = 1, contact_inertia = "full" },
  half_one = { theta = 0.5, xi = 1, contact_weight = 1, contact_inertia = "full" },
  averaged = { theta = 0.5, xi = 0.5, contact_weight = 0.5, contact_inertia = "full" },
  massless_backward = { theta = 1, xi = 1, contact_inertia = "none" },
  massless = { theta = 0.5, xi = 0.5, contact_inertia = "none" },
  damped = { theta = 0.55, xi = 0.55, contact_inertia = "implicit" },
}

local function scene(p)
  local c = 30*m/s -- sqrt(young / density)
  local cell = p.length / p.cells
  local duration = 1.5*s
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
    scheme = stiction.scheme.theta_xi(schemes[p.scheme]),
    schedule = stiction.schedule {
      stages = { stiction.stage { to = duration, steps = math.floor(duration / (p.courant * cell / c) + 0.5) } },
    },
    output = stiction.output { frames = 0 },
    probes = {
      foot = stiction.probe.contact_point { pair = "impact", near = { 0*m, p.gap } },
      energy = stiction.probe.energy {},
    },
  }
end

-- Mean square deviation of the pressure from the exact one while the bar surely touches.
local function ripple(run)
  local sum, count = 0, 0
  local pressure = run:series("foot", "pressure")
  for i, t in ipairs(run.time) do
    if t > 0.7 and t < 1.1 then
      sum, count = sum + (pressure[i] - 300) ^ 2, count + 1
    end
  end
  return math.sqrt(sum / count)
end

local function mechanical(run, i)
  return run:series("energy", "kinetic")[i] + run:series("energy", "strain")[i]
end

return stiction.study {
  title = "Impact of an elastic bar",
  question = "Does the scheme keep the energy, and does the contact pressure ring?",
  given = {
    young = { 900*Pa, "makes c = 30 m/s" }, density = { 1*kg/m^3, "" }, length = { 10*m, "" },
    speed = { 10*m/s, "" }, gap = { 5*m, "touches at 0.5 s" }, cells = { 100, "" },
  },
  chosen = { courant = { 1, "a step is the time a wave takes through a cell" } },
  sweep = {
    scheme = { "default", "paper", "paper_055", "backward_euler", "half_one", "averaged", "massless", "massless_backward",
      "damped" },
  },
  case_id = function(p) return p.scheme end,
  scene = scene,
  results = {
    { name = "energy_kept", unit = "1", meaning = "kinetic + strain energy at the end over the start",
      function(run) return mechanical(run, #run.time) / mechanical(run, 1) end },
    { name = "pressure_rms", unit = "Pa", meaning = "rms deviation of the pressure from the exact 300 Pa", ripple },
  },
  check = function(cases, check)
    for _, case in ipairs(cases) do
      local r = case.results
      if case.p.scheme == "default" then
        -- it may lose what the contact cell holds and a little more, never make energy
        check.within("default: energy kept", r.energy_kept, 0.985, 1)
        check.within("default: pressure ripple", r.pressure_rms, 0, 0.1)
      elseif case.p.scheme == "massless" then
        check.equal("massless: energy", r.energy_kept, 1, 0.0005)
        check.within("massless: pressure ripple", r.pressure_rms, 0, 0.01)
      elseif case.p.scheme == "paper" then
        check.within("paper: pressure rings, 300 +- 173", r.pressure_rms, 165, 181)
        check.equal("paper: energy", r.energy_kept, 0.9987, 0.001)
      elseif case.p.scheme == "paper_055" then
        check.equal("theta = 0.55: energy", r.energy_kept, 0.9426, 0.003)
      elseif case.p.scheme == "backward_euler" then
        check.equal("backward Euler: energy", r.energy_kept, 0.8192, 0.003)
      end
    end
  end,
}
