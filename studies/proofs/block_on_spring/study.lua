-- A block on a spring: how it swings, how a dashpot damps it, how it sticks and slips on a plane.
--
--      k, c    ______
--   o-/\/\/\--|______|      swing, damped: in the air, thrown off at v0
--   -> v      ----------    stick_slip: pressed by N onto a plane, the spring's other end drawn at v
--
--     ./stiction run studies/proofs/block_on_spring
local stiction = require "stiction"
local units, numeric = stiction.units, stiction.numeric
local m, mm, s, ms, kg, N, Pa, MPa = units.m, units.mm, units.s, units.ms, units.kg, units.N, units.Pa, units.MPa

local function mass(p) return (p.density * p.width * p.height).si end -- per metre of depth
local function omega(p) return math.sqrt(p.stiffness.si / mass(p)) end
local function period(p) return 2 * math.pi / omega(p) end
local function fade(p) return p.kind == "damped" and p.damping_ratio * omega(p) or 0 end
local function damped_period(p) return 2 * math.pi / math.sqrt(omega(p) ^ 2 - fade(p) ^ 2) end
local function weight(p) return (p.pressure * p.width).si end
local function duration(p) return (p.kind == "stick_slip" and 16 or 5) * period(p) end

local function spring(p)
  local t = { from = p.kind == "stick_slip" and "block.bottom" or "block.all", direction = { 1, 0 }, stiffness = p.stiffness,
    damping = 2 * fade(p) * mass(p) * N*s/m }
  if p.kind == "stick_slip" then
    t.times, t.x = { 0*s, duration(p)*s }, { 0*m, p.speed * duration(p)*s }
  end
  return stiction.spring(t)
end

local function scene(p)
  local slips, viscosity = p.kind == "stick_slip", p.calm * p.young
  return stiction.scene {
    bodies = { block = stiction.body {
      mesh = stiction.mesh.block { size = { p.width, p.height }, cells = { 1, 1 } }, density = p.density,
      material = stiction.material.linear_elastic { young = p.young, poisson = 0 },
      damping = slips and stiction.damping.kelvin_voigt { shear_viscosity = viscosity, bulk_viscosity = viscosity } or nil,
      velocity = { slips and 0*m/s or p.throw, 0*m/s },
    } },
    obstacles = slips and { plane = stiction.obstacle { shape = stiction.rigid.plane {} } } or nil,
    pairs = slips and { sole = stiction.pair { secondary = "block.bottom", primary = "plane",
      friction = stiction.friction.static_kinetic { mu_s = p.mu_s, mu_k = p.mu_k } } } or nil,
    loads = slips and { stiction.load.traction { set = "block.top", times = { 0*s, p.ramp, duration(p)*s },
      y = { 0*Pa, -p.pressure, -p.pressure } } } or nil,
    springs = { tie = spring(p) },
    scheme = slips and stiction.scheme.theta_xi { theta = 0.55, xi = 0.55, contact_inertia = "full" } or nil,
    schedule = stiction.schedule { stages = {
      stiction.stage { to = duration(p)*s, steps = math.floor(duration(p) / period(p) * p.steps + 0.5) },
    } },
    output = stiction.output { frames = 0 },
    probes = {
      tie = stiction.probe.spring { spring = "tie" },
      block = stiction.probe.node { set = "block.all", near = { 0*m, 0*m } },
      energy = stiction.probe.energy { audit = true },
    },
  }
end

-- Time of the n-th time that the block comes through its middle from below, between records on a straight line.
local function crossing(run, n)
  local u, t = run:series("block", "u_x"), run.time
  for k = 2, #u do
    if u[k - 1] < 0 and u[k] >= 0 then
      n = n - 1
      if n == 0 then return t[k - 1] - u[k - 1] * (t[k] - t[k - 1]) / (u[k] - u[k - 1]) end
    end
  end
end

-- Peaks of u_x, each of the parabola through three records.
local function peaks(run)
  local u, found = run:series("block", "u_x"), {}
  for k = 2, #u - 1 do
    local a, b, c = u[k - 1], u[k], u[k + 1]
    if b > a and b >= c then found[#found + 1] = b + (a - c) ^ 2 / (8 * (2 * b - a - c)) end
  end
  return found
end

-- Pull of the spring where the first slip begins and where it ends.
local function slip(run)
  local pull, k = run:series("tie", "force_x"), 2
  while pull[k] >= pull[k - 1] do k = k + 1 end
  local first = pull[k - 1]
  while pull[k + 1] <= pull[k] do k = k + 1 end
  return first, pull[k]
end

local function proof(cases, check, t)
  local of = cases:where { kind = t.kind }
  local values = numeric.map(of, function(c) return { period(c.p) / c.p.steps, c.results[t.result] } end)
  check.proof { case = "Block on a spring", quantity = t.quantity, unit = t.unit, kind = "exact", source = t.source,
    reference = t.reference(of[1].p), values = values, resolution = "s step", tolerance = t.tolerance, order = t.order,
    run = of[#of] }
end

local sweep = {}
for _, kind in ipairs { "swing", "damped", "stick_slip" } do
  for _, steps in ipairs { 25, 50, 100 } do sweep[#sweep + 1] = { kind = kind, steps = steps } end
end

return stiction.study {
  title = "Block on a spring", question = "Does a spring swing, damp and let slip as it should?",
  given = {
    width = { 10*mm, "" }, height = { 1*mm, "flat, so that it does not tip" }, density = { 1000*kg/m^3, "" },
    stiffness = { 100*N/m, "100 rad/s" }, damping_ratio = { 0.05, "of the critical damping, where it is damped" },
    throw = { 0.1*m/s, "" }, pressure = { 100*Pa, "1 N/m in all" }, mu_s = { 0.5, "" }, mu_k = { 0.3, "" },
    speed = { 10*mm/s, "slow beside (mu_s - mu_k) N / k omega" },
  },
  chosen = { young = { 1*MPa, "rigid beside the spring" }, ramp = { 0.2*s, "N is there before it slips" },
    calm = { 1*ms, "viscosity of the pressed block over Young's modulus: it does not shake" } },
  sweep = sweep,
  quick = { sweep = { sweep[2], sweep[3], sweep[5], sweep[6], sweep[8], sweep[9] } },
  case_id = function(p) return ("%s_%d"):format(p.kind, p.steps) end,
  scene = scene,
  results = {
    { name = "period", unit = "s", meaning = "mean of the first three", function(run)
      return run.p.kind ~= "stick_slip" and (crossing(run, 4) - crossing(run, 1)) / 3 or 0 end },
    { name = "decrement", unit = "1", meaning = "logarithm of a peak over the next, mean of three", function(run)
      local found = run.p.kind ~= "stick_slip" and peaks(run)
      return found and math.log(found[1] / found[4]) / 3 or 0 end },
    { name = "start", unit = "N/m", meaning = "pull where the first slip begins", function(run)
      return run.p.kind == "stick_slip" and slip(run) or 0 end },
    { name = "fall", unit = "N/m", meaning = "of the pull, by the first slip", function(run)
      if run.p.kind ~= "stick_slip" then return 0 end
      local first, last = slip(run)
      return first - last end },
  },
  check = function(cases, check)
    local rigid = "rigid block"
    proof(cases, check, { kind = "swing", result = "period", quantity = "period", unit = "s", source = rigid,
      reference = period, tolerance = 1e-3, order = 1.9 })
    proof(cases, check, { kind = "damped", result = "period", quantity = "period, damped", unit = "s", source = rigid,
      reference = damped_period, tolerance = 1e-3, order = 1.9 })
    proof(cases, check, { kind = "damped", result = "decrement", quantity = "logarithmic decrement", unit = "1",
      source = rigid, reference = function(p) return fade(p) * damped_period(p) end, tolerance = 2e-3, order = 1.8 })
    proof(cases, check, { kind = "stick_slip", result = "start", quantity = "pull at which it slips, mu_s N", unit = "N/m",
      source = rigid, reference = function(p) return p.mu_s * weight(p) end, tolerance = 5e-3 })
    proof(cases, check, { kind = "stick_slip", result = "fall", quantity = "fall of the pull, 2 (mu_s - mu_k) N",
      unit = "N/m", source = rigid, reference = function(p) return 2 * (p.mu_s - p.mu_k) * weight(p) end,
      tolerance = 5e-3 })
    for _, c in ipairs(cases) do
      check.ledger(c)
    end
  end,
  figures = function(cases)
    local function curve(case) return { label = case.id, case = case, y = "tie/force_x" } end
    return {
      stiction.figure.lines { name = "swings", title = "pull of the spring", x = { label = "time", unit = "s" },
        y = { label = "pull per depth", unit = "N/m" }, legend = "below",
        curves = numeric.map({ cases:find { kind = "swing", steps = 100 }, cases:find { kind = "damped", steps = 100 },
          cases:find { kind = "stick_slip", steps = 100 } }, curve) },
    }
  end,
}
