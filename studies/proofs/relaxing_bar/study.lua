-- A bar that relaxes, creeps and swings: a Prony series of the shear modulus, the bulk modulus constant or alike; sides free.
--
--     |###|-> pulled, its sides free    exact: E(s) = 9 K G(s) / (3 K + G(s)) has one pole, so that the bar is a standard
--                                       linear solid too: E(t) = E + (E0 - E) exp(-t / tau_E); with a bulk modulus that
--                                       relaxes alike, "equal", nu stays and E(t) = E (1 + share exp(-t / tau))
--
--     ./stiction run studies/proofs/relaxing_bar
local stiction = require "stiction"
local units, numeric = stiction.units, stiction.numeric
local m, s, kg, Pa = units.m, units.s, units.kg, units.Pa

local cycles = 3

--- Moduli at rest and at once and times of relaxation and creep of the bar, SI.
local function solid(p)
  if p.test == "equal" then
    return { rest = p.young.si, at_once = p.young.si * (1 + p.share), relaxing = p.time.si }
  end
  local shear, bulk = p.young.si / (2 * (1 + p.poisson)), p.young.si / (3 * (1 - 2 * p.poisson))
  local at_once = shear * (1 + p.share)
  local time = p.time.si * (3 * bulk + at_once) / (3 * bulk + shear)
  local E0 = 9 * bulk * at_once / (3 * bulk + at_once)
  return { rest = p.young.si, at_once = E0, relaxing = time, creeping = time * E0 / p.young.si }
end

--- Angular frequency of the cycles, 1/s, and how long all of them last, s.
local function omega(p)
  return p.pace / p.time.si
end
local function duration(p)
  return p.test == "cycles" and cycles * 2 * math.pi / omega(p) or p.duration.si
end

--- Storage and loss modulus, Pa.
local function moduli(p)
  local e = solid(p)
  local x = omega(p) * e.relaxing
  return e.rest + (e.at_once - e.rest) * x ^ 2 / (1 + x ^ 2), (e.at_once - e.rest) * x / (1 + x ^ 2)
end

--- Stress at the end: strained evenly until p.ramp, then held.
local function stress(p)
  local e = solid(p)
  local ramp, t = p.ramp.si, p.duration.si
  return p.strain * (e.rest + (e.at_once - e.rest) * e.relaxing / ramp * (1 - math.exp(-ramp / e.relaxing))
    * math.exp((ramp - t) / e.relaxing))
end

--- Strain at the end under a stress that grows evenly to E times p.strain.
local function strain(p)
  local e = solid(p)
  local t = p.duration.si
  local rate = p.young.si * p.strain / t
  return rate * (t / e.rest - (1 / e.rest - 1 / e.at_once) * e.creeping * (1 - math.exp(-t / e.creeping)))
end

--- Where the end is drawn: up and held, or through cycles of a sine, straight between the ends of steps.
local function path(p)
  local times, x = { 0*s, p.ramp, p.duration }, { 0*m, p.strain * p.length, p.strain * p.length }
  if p.test == "cycles" then
    times, x = {}, {}
    for k = 0, cycles * p.steps do
      local angle = 2 * math.pi * k / p.steps
      times[k + 1], x[k + 1] = angle / omega(p) * s, p.strain * math.sin(angle) * p.length
    end
  end
  return stiction.motion.drive { set = "bar.right", times = times, x = x }
end

local function scene(p)
  local creep = p.test == "creep"
  local motions = { stiction.motion.fix { set = "bar.left", y = false, z = false },
    stiction.motion.fix { set = "bar.bottom", x = false, y = false }, stiction.motion.fix { set = "bar.front", x = false, z = false } }
  motions[#motions + 1] = not creep and path(p) or nil
  return stiction.scene {
    kinematics = "three_dimensional",
    bodies = { bar = stiction.body {
      mesh = stiction.mesh.box { origin = { 0*m, 0*m, 0*m }, size = { p.length, p.width, p.width }, cells = { 3, 1, 1 } },
      material = stiction.material.linear_elastic { young = p.young, poisson = p.poisson }, density = 1*kg/m^3,
      relaxing = { { share = p.share, bulk_share = p.test == "equal" and p.share or nil, time = p.time } },
    } },
    motions = motions,
    loads = creep and { stiction.load.traction { set = "bar.right", times = { 0*s, p.duration },
      x = { 0*Pa, p.young * p.strain } } } or nil,
    scheme = stiction.scheme.quasi_static {},
    control = stiction.control { force_tolerance = 1e-12 },
    schedule = stiction.schedule { stages = { stiction.stage { to = duration(p) * s,
      steps = p.test == "cycles" and cycles * p.steps or p.steps } } },
    output = stiction.output { frames = 0 },
    probes = {
      pull = stiction.probe.force { set = "bar.right" },
      tip = stiction.probe.node { set = "bar.right", near = { p.length, 0*m, 0*m } },
      side = stiction.probe.node { set = "bar.right", near = { p.length, p.width, 0*m } },
      energy = stiction.probe.energy { audit = true },
    },
  }
end

local function last(list)
  return list[#list]
end

--- Storage and loss modulus from the last cycle's stress: least squares by sine, cosine and what is left of the start.
local function measured(run, p)
  local force, sine, cosine, fading, stress_of = run:series("pull", "force_x"), {}, {}, {}, {}
  local time, e = run.time, solid(p)
  for k = #force - p.steps + 1, #force do
    local t, i = time[k], #sine + 1
    sine[i], cosine[i] = math.sin(omega(p) * t), math.cos(omega(p) * t)
    fading[i], stress_of[i] = math.exp((time[#force - p.steps + 1] - t) / e.relaxing), force[k] / p.width.si ^ 2 / p.strain
  end
  local found = numeric.least_squares(omega(p) * e.relaxing > 0.3 and { sine, cosine, fading } or { sine, cosine }, stress_of)
  return found[1], found[2]
end

--- The value of a case that has an answer, over that answer.
local function over_exact(run, p)
  if p.test == "creep" then
    return last((run:series("tip", "u_x"))) / p.length.si / strain(p)
  elseif p.test == "relaxation" or p.test == "equal" then
    return last((run:series("pull", "force_x"))) / p.width.si ^ 2 / stress(p)
  end
  local storage, loss = measured(run, p)
  local exact_storage, exact_loss = moduli(p)
  return math.sqrt((storage ^ 2 + loss ^ 2) / (exact_storage ^ 2 + exact_loss ^ 2))
end

local sweep, quick = {}, {}
for _, test in ipairs { "relaxation", "creep" } do
  for _, steps in ipairs { 20, 40, 80, 1280 } do
    local case = { test = test, steps = steps, pace = 1 }
    sweep[#sweep + 1], quick[#quick + 1] = case, steps <= 40 and case or nil
  end
end
for _, steps in ipairs { 4, 40 } do
  local case = { test = "equal", steps = steps, pace = 1 }
  sweep[#sweep + 1], quick[#quick + 1] = case, case
end
local paces = { 0.01, 0.1, 1, 10, 100 }
for _, pace in ipairs(paces) do
  for _, steps in ipairs { 80, 160 } do
    local case = { test = "cycles", steps = steps, pace = pace }
    sweep[#sweep + 1], quick[#quick + 1] = case, case
  end
end

--- Storage and loss modulus at one frequency, over the size of the modulus there.
local function check_moduli(check, runs)
  local p = runs[1].p
  local exact, values = { moduli(p) }, { {}, {} }
  local size = math.sqrt(exact[1] ^ 2 + exact[2] ^ 2)
  for k, run in ipairs(runs) do
    for i, found in ipairs { measured(run, run.p) } do
      values[i][k] = { 1 / run.p.steps, found / size }
    end
  end
  for i, name in ipairs { "storage", "loss" } do
    check.proof { case = ("Relaxing bar, omega tau = %g"):format(p.pace), quantity = name .. " modulus over the size of the modulus",
      kind = "exact", source = "linear viscoelasticity", reference = exact[i] / size, scale = 1, values = values[i],
      resolution = "cycles step", tolerance = 1e-3, run = runs[#runs] }
  end
end

return stiction.study {
  title = "Relaxing bar",
  question = "Does a bar with free sides relax, creep and swing as its Prony series says?",
  given = {
    young = { 1*units.MPa, "at rest" }, poisson = { 0.3, "at rest" }, share = { 4, "G_1 / G" }, time = { 1*s, "tau_1" },
    strain = { 1e-3, "" }, ramp = { 0.5*s, "until it is held" }, duration = { 2*s, "" }, length = { 3*m, "" }, width = { 1*m, "" },
  },
  sweep = sweep,
  quick = { sweep = quick },
  case_id = function(p) return p.test == "cycles" and ("cycles_%g_%d"):format(p.pace, p.steps) or ("%s_%d"):format(p.test, p.steps) end,
  scene = scene,
  results = {
    { name = "over_exact", unit = "1",
      meaning = "stress of the held bar, strain of the loaded one at the end, size of the modulus, over the exact one", over_exact },
    { name = "dissipated", unit = "1", meaning = "by the network over the work put in",
      function(run)
        return last((run:series("energy", "relaxation_loss")))
          / (last((run:series("energy", "motion_work"))) + last((run:series("energy", "load_work"))))
      end },
  },
  check = function(cases, check)
    for _, test in ipairs { "relaxation", "creep" } do
      local runs, values = cases:where { test = test }, {}
      for k, case in ipairs(runs) do
        values[k] = { case.p.duration.si / case.p.steps, case.results.over_exact }
      end
      check.proof { case = "Relaxing bar, " .. test, quantity = test == "creep" and "strain at the end" or "stress at the end",
        kind = "exact", source = "linear viscoelasticity", reference = 1, scale = 1, values = values, resolution = "s step",
        tolerance = #runs > 2 and 1e-6 or 1e-4, order = 1.9, run = runs[#runs] }
      check.holds("a good part of the work is dissipated, " .. test, runs[#runs].results.dissipated > 0.1)
    end
    local runs, values = cases:where { test = "equal" }, {}
    for k, case in ipairs(runs) do
      values[k] = { case.p.duration.si / case.p.steps, case.results.over_exact }
      local tip, side = last((case:series("tip", "u_x"))) / case.p.length.si, last((case:series("side", "u_y"))) / case.p.width.si
      check.close(("Poisson's ratio stays, %d steps"):format(case.p.steps), -side / tip, case.p.poisson, 1e-9)
    end
    check.proof { case = "Relaxing bar, bulk modulus alike", quantity = "stress at the end", kind = "exact",
      source = "linear viscoelasticity", reference = 1, scale = 1, values = values, resolution = "s step", tolerance = 1e-9,
      run = runs[#runs] }
    for _, pace in ipairs(paces) do
      check_moduli(check, cases:where { test = "cycles", pace = pace })
    end
    for _, case in ipairs(cases) do
      check.ledger(case, 1e-9)
    end
  end,
  figures = function(cases)
    local x, storage, loss, exact = {}, {}, {}, { x = {}, storage = {}, loss = {} }
    for k, pace in ipairs(paces) do
      local case = last(cases:where { test = "cycles", pace = pace })
      x[k], storage[k], loss[k] = pace, measured(case, case.p)
    end
    for k = 0, 80 do
      exact.x[k + 1] = 10 ^ (k / 20 - 2)
      exact.storage[k + 1], exact.loss[k + 1] = moduli { young = cases[1].p.young, poisson = cases[1].p.poisson,
        share = cases[1].p.share, time = cases[1].p.time, pace = exact.x[k + 1] }
    end
    return { stiction.figure.lines { name = "moduli", title = "Storage and loss modulus of the bar",
      x = { label = "omega tau", unit = "1", log = true }, y = { label = "modulus", unit = "Pa", log = true },
      curves = { { label = "storage, exact", x = exact.x, y = exact.storage }, { label = "loss, exact", x = exact.x, y = exact.loss },
        { label = "storage", x = x, y = storage, style = "points" }, { label = "loss", x = x, y = loss, style = "points" } } } }
  end,
}
