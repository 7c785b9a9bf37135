-- Every other law of adhesion at one point, through the whole program: opened along a ray, some closed half-way and reopened.
--
--      ______
--     | cell |  every node moved by d (1, r)/sqrt(1 + r^2), (normal, along); r = inf: along the plane
--     |______|
--     -o----o-- rigid plane    area 1 m^2 per m, so that forces per m are tractions and J/m are J/m^2
--
-- Damage that stays unloads to the origin: r(d) = r_envelope(D) d/D, D the largest d so far.
--
--     ./stiction run studies/proofs/cohesive_laws
local stiction = require "stiction"
local laws = stiction.reference.point_laws
local adhesion = stiction.adhesion
local numeric = stiction.numeric
local units = stiction.units
local m, mm, s, kg, J, N, Pa, GPa = units.m, units.mm, units.s, units.kg, units.J, units.N, units.Pa, units.GPa

local strength = 1e3 -- Pa, the scale of all curves

local zone = { K = 1e7, sigma_n = 1e3, sigma_t = 2e3, G_I = 1, G_II = 3 }
local function bilinear(mix, exponent)
  return adhesion.bilinear { K = zone.K*N/m^3, sigma_n = zone.sigma_n*Pa, sigma_t = zone.sigma_t*Pa, G_I = zone.G_I*J/m^2,
    G_II = zone.G_II*J/m^2, mix = mix, exponent = exponent }
end

-- Normal and tangential part of a traction along the ray.
local function split(size, r)
  if r == math.huge then return 0, size end
  local c = 1 / math.sqrt(1 + r ^ 2)
  return size * c, size * c * r
end

local function bilinear_test(r, mix)
  local law = { exponent = mix == "benzeggagh_kenane" and 1.5 or nil }
  for key, value in pairs(zone) do law[key] = value end
  local _, finish, G = laws.bilinear.openings(law, r)
  return { r = r, to = 1.1 * finish, lasts = true, work = G, loss = G, source = "Camanho and Davila 2002",
    part = function() return bilinear(mix, law.exponent) end,
    envelope = function(d) return split(laws.bilinear.traction(law, r, d), r) end }
end

local delta_n, delta_t = 1 / (math.exp(1) * strength), 0.5e-3
local function xu(q, r, memory)
  return function()
    return adhesion.exponential { phi_n = 1*J/m^2, sigma_max = strength*Pa, delta_t = delta_t*m, q = q, r = r, memory = memory }
  end
end
local function xu_test(ray, to, q, r, memory)
  local law = { phi_n = 1, delta_n = delta_n, delta_t = delta_t, q = q, r = r }
  local function at(d) return split(d, ray) end
  local t = { r = ray, to = to, lasts = memory == "irreversible", part = xu(q, r, memory), loss = 0,
    source = "Xu and Needleman 1994", envelope = function(d) return laws.exponential.traction(law, at(d)) end }
  t.work = laws.exponential.energy(law, at(to))
  if t.lasts then -- less what unloading to the origin gives back
    local normal, along = t.envelope(to)
    t.loss = t.work - 0.5 * math.sqrt(normal ^ 2 + along ^ 2) * to
  end
  return t
end

local function dugdale_test(memory)
  local h0, ramp = 1e-3, 0.05
  local lasts = memory == "irreversible"
  return { r = 0, to = 1.5e-3, lasts = lasts, work = strength * h0, loss = lasts and strength * h0 or 0, source = "Dugdale 1960",
    part = function() return adhesion.dugdale { sigma0 = strength*Pa, h0 = h0*m, ramp = ramp, memory = memory } end,
    envelope = function(d) return laws.dugdale.traction(strength, h0, ramp, d), 0 end }
end

local tests = {
  bilinear_normal = bilinear_test(0, "benzeggagh_kenane"), bilinear_shear = bilinear_test(math.huge, "benzeggagh_kenane"),
  bilinear_mixed = bilinear_test(1, "benzeggagh_kenane"), bilinear_linear = bilinear_test(2, "linear"),
  exponential_normal = xu_test(0, 3e-3, 1, 0, "irreversible"), exponential_shear = xu_test(math.huge, 1.5e-3, 1, 0, "irreversible"),
  exponential_mixed = xu_test(0.7, 2e-3, 0.6, 0.2, "reversible"),
  dugdale = dugdale_test("reversible"), dugdale_damage = dugdale_test("irreversible"),
  potential = { r = 0, to = 3e-3, loss = 0, source = "Rose, Ferrante and Smith 1981", work = 1 - 11 * math.exp(-10),
    part = function() return adhesion.potential { w = 1*J/m^2, delta = 0.3*mm } end,
    envelope = function(d) return laws.potential.traction(1, 0.3e-3, d), 0 end },
  attraction = { r = 0, to = 3e-3, loss = 0, strongest_at_none = true, source = "Muser 2017", work = 1 - math.exp(-10),
    part = function() return adhesion.attraction { w = 1*J/m^2, range = 0.3*mm } end,
    envelope = function(d) return laws.attraction.traction(1, 0.3e-3, d), 0 end },
}
local order = { "bilinear_normal", "bilinear_shear", "bilinear_mixed", "bilinear_linear", "exponential_normal", "exponential_shear",
  "exponential_mixed", "dugdale", "dugdale_damage", "potential", "attraction" }

-- The opening d over the time: to the end, or to a third of it, back to a sixth, and to the end.
local function path(p)
  local to = tests[p.test].to
  if p.back then return { 0, 2, 3, 8 }, { 0, to / 3, to / 6, to } end
  return { 0, 6 }, { 0, to }
end

local function scene(p)
  local t = tests[p.test]
  local times, d = path(p)
  local function along(which)
    return numeric.map(d, function(value) return select(which, split(value, t.r)) * m end)
  end
  return stiction.scene {
    bodies = { cell = stiction.body {
      mesh = stiction.mesh.block { size = { 1*m, 1*m }, cells = { 1, 1 } }, density = 1000*kg/m^3,
      material = stiction.material.linear_elastic { young = 1*GPa, poisson = 0 },
    } },
    obstacles = { plane = stiction.obstacle { shape = stiction.rigid.plane {} } },
    pairs = { point = stiction.pair { secondary = "cell.bottom", primary = "plane", adhesion = t.part() } },
    motions = { stiction.motion.drive {
      set = "cell.all", times = numeric.map(times, function(x) return x * s end), x = along(2), y = along(1),
    } },
    scheme = stiction.scheme.quasi_static {},
    schedule = stiction.schedule { stages = { stiction.stage { to = times[#times] * s, steps = p.steps * times[#times] // 6 } } },
    output = stiction.output { frames = 0 },
    probes = { point = stiction.probe.contact_point { pair = "point", near = { 0*m, 0*m } }, energy = stiction.probe.energy {} },
  }
end

local function opening(run) -- d and the largest so far, at every recorded time
  local times, values = path(run.p)
  local list, largest, far = {}, {}, 0
  for k, time in ipairs(run.time) do
    list[k] = numeric.interpolate(times, values, time)
    far = math.max(far, list[k])
    largest[k] = far
  end
  return list, largest
end

-- Normal and tangential traction at the opening d of a point that was open as far as `largest`.
local function exact(t, d, largest)
  if not t.lasts or largest == 0 then return t.envelope(d) end
  local normal, along = t.envelope(largest)
  return normal * d / largest, along * d / largest
end

local function deviation(run)
  local t, d, largest = tests[run.p.test], opening(run)
  local normal, along, most = run:series("point", "adhesion_n"), run:series("point", "adhesion_t"), 0
  for k in ipairs(d) do
    local wanted_n, wanted_t = exact(t, d[k], largest[k])
    if k > 1 or not t.strongest_at_none then -- before the first step no traction is asked for
      most = math.max(most, math.abs(-normal[k] - wanted_n), math.abs(math.abs(along[k]) - math.abs(wanted_t)))
    end
  end
  return most / strength
end

local function size(run)
  local list, along = {}, run:series("point", "adhesion_t")
  for k, normal in ipairs((run:series("point", "adhesion_n"))) do list[k] = math.sqrt(normal ^ 2 + along[k] ^ 2) end
  return list
end

local function proofs(runs, check)
  local finest = runs[#runs]
  local p = finest.p
  local t = tests[p.test]
  local name = p.test:gsub("_", " ") .. (p.back and ", closed half-way" or "")
  local function row(quantity, unit, result, reference, tolerance, least_order)
    local values = {}
    for i, c in ipairs(runs) do values[i] = { 1 / c.p.steps, c.results[result] } end
    check.proof { case = name, quantity = quantity, unit = unit, kind = "exact", source = t.source, reference = reference,
      scale = reference == 0 and 1 or nil, values = values, resolution = "step over the path", tolerance = tolerance,
      order = least_order, run = finest }
  end
  local normal, along = exact(t, t.to / 3, t.to / 3)
  if not p.back then
    row("traction at a third of the way", "kPa", "at_third", math.sqrt(normal ^ 2 + along ^ 2), 1e-10)
    row("loss of bonding", "J/m^2", "loss", t.loss, p.test:find "exponential" and 1e-6 or 1e-10)
  end
  -- the ledger takes the force at the step's end: of first order on the way back, and from the largest traction on; from none to
  -- none this rule is as good as trapezia
  if t.strongest_at_none then
    row("work", "J/m^2", "work", t.work, 0.05, 0.95)
  elseif p.back then
    row("work", "J/m^2", "work", t.work, 0.01, p.test ~= "dugdale" and 0.85 or nil)
  else
    row("work", "J/m^2", "work", t.work, 5e-3)
  end
  for _, c in ipairs(runs) do
    check.within(c.id .. ": the whole curve, over 1 kPa", c.results.deviation, 0, 1e-10)
    check.equal(c.id .. ": loss of bonding", c.results.loss, t.loss, 1e-6)
  end
end

local function cases_of(ways)
  local list = {}
  for _, test in ipairs(order) do
    for _, back in ipairs(ways) do
      for _, steps in ipairs(back and { 120, 240 } or { 60, 120 }) do list[#list + 1] = { test = test, back = back, steps = steps } end
    end
  end
  return list
end

local function picture(cases, name, title, wanted)
  local curves = {}
  for i, test in ipairs(wanted) do
    local run = cases:find { test = test, back = true, steps = 240 } or cases:find { test = test, back = false, steps = 120 }
    local t, x, y = tests[test], {}, {}
    for k = 0, 300 do
      x[k + 1] = t.to * k / 300
      local normal, along = t.envelope(x[k + 1])
      y[k + 1] = math.sqrt(normal ^ 2 + along ^ 2)
    end
    curves[#curves + 1] = { label = test:gsub("_", " "), x = x, y = y, colour = i }
    local openings, sizes = opening(run), size(run)
    if t.strongest_at_none then -- which acts from the first step on
      table.remove(openings, 1)
      table.remove(sizes, 1)
    end
    curves[#curves + 1] = { label = i == 1 and "run" or nil, x = openings, y = sizes, style = "dot", colour = 6 }
  end
  return stiction.figure.lines { name = name, title = title, x = { label = "opening", unit = "mm" },
    y = { label = "traction", unit = "kPa" }, curves = curves, legend = "below" }
end

return stiction.study {
  title = "The other laws of adhesion at one point", question = "Does the whole program follow their closed curves?",
  sweep = cases_of { false, true }, quick = { sweep = cases_of { false } }, scene = scene,
  case_id = function(p) return ("%s%s_%d"):format(p.test, p.back and "_back" or "", p.steps) end,
  results = {
    { name = "at_third", unit = "Pa", meaning = "traction when a third of the opening is reached first",
      function(run) return numeric.interpolate(run.time, size(run), 2) end },
    { name = "work", unit = "J/m", meaning = "work of the motion", function(run) return run:last("energy", "motion_work") end },
    { name = "loss", unit = "J/m", meaning = "loss of bonding", function(run) return run:last("energy", "bonding_loss") end },
    { name = "deviation", unit = "1", meaning = "largest distance from the closed curve over 1 kPa", deviation },
  },
  check = function(cases, check)
    for _, test in ipairs(order) do
      proofs(cases:where { test = test, back = false }, check)
      if not cases.quick then proofs(cases:where { test = test, back = true }, check) end
    end
  end,
  figures = function(cases)
    return {
      picture(cases, "bilinear", "bilinear, closed half-way", { "bilinear_normal", "bilinear_shear", "bilinear_mixed", "bilinear_linear" }),
      picture(cases, "exponential", "exponential, closed half-way", { "exponential_normal", "exponential_shear", "exponential_mixed" }),
      picture(cases, "others", "Dugdale and two of short range, closed half-way", { "dugdale", "dugdale_damage", "potential",
        "attraction" }),
    }
  end,
}
