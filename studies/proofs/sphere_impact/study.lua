-- Impact of a rigid ball on a soft block, slow beside the block's waves: Hertz's depth and time in contact.
--
--            .-'''-.       mass m at the speed v
--           |   R   |
--     _______'-._.-'_______     deepest d = (15 m v^2/(16 E* sqrt R))^2/5,
--    |        a a          |    in contact for 2.943 d/v, leaves at v
--    |        block        |
--    |_____________________|    axisymmetric, small strains, frictionless, held at the bottom
--
-- Mesh and step are refined together, with the default scheme and with the plain one.
--
--     ./stiction run studies/proofs/sphere_impact
local stiction = require "stiction"
local hertz = stiction.reference.hertz_impact
local units = stiction.units
local m, mm, um, s, kg, MPa = units.m, units.mm, units.um, units.s, units.kg, units.MPa

local schemes = { default = {}, plain = { contact_inertia = "full" } }

local function modulus(p) return p.young.si / (1 - p.poisson ^ 2) end
local function mass(p) return 4 / 3 * math.pi * p.radius.si ^ 3 * p.ball_density.si end
-- The speed that reaches the depth.
local function speed(p)
  return math.sqrt(16 * modulus(p) * math.sqrt(p.radius.si) * p.depth.si ^ 2.5 / (15 * mass(p)))
end
local function radius_of_contact(p) return math.sqrt(p.radius.si * p.depth.si) end
local function cell(p) return radius_of_contact(p) / p.cells end
local function duration(p) return hertz.duration(modulus(p), p.radius.si, mass(p), speed(p)) end

local function scene(p)
  local zero, size, h = 0*m, p.size, cell(p) * m
  local ends = 1.2 * duration(p) * s
  return stiction.scene {
    kinematics = "axisymmetric",
    bodies = { block = stiction.body {
      mesh = stiction.mesh.graded_block {
        origin = { zero, -size }, size = { size, size }, fine = { 1.5 * radius_of_contact(p) * m, radius_of_contact(p) * m },
        fine_size = h, coarse_size = size / 12, growth = p.growth,
      },
      material = stiction.material.linear_elastic { young = p.young, poisson = p.poisson }, density = p.density,
    } },
    obstacles = { ball = stiction.obstacle {
      shape = stiction.rigid.sphere { centre = { zero, p.radius }, radius = p.radius },
      mass = mass(p) * kg, velocity = { 0*m/s, -speed(p) * m/s },
    } },
    motions = { stiction.motion.fix { set = "block.bottom" }, stiction.motion.fix { set = "block.left", y = false } },
    pairs = { contact = stiction.pair { secondary = "block.top", primary = "ball" } },
    scheme = stiction.scheme.theta_xi(schemes[p.scheme]),
    schedule = stiction.schedule { stages = { stiction.stage { to = ends, steps = math.floor(1.2 * p.steps + 0.5) } } },
    output = stiction.output { frames = 0 },
    probes = {
      contact = stiction.probe.contact { pair = "contact" }, ball = stiction.probe.rigid { obstacle = "ball" },
      energy = stiction.probe.energy { audit = true },
    },
  }
end

-- Last time under force.
local function together(run)
  local force, k = run:series("ball", "force_y"), #run.time
  while k > 1 and force[k] <= 0 do k = k - 1 end
  return run.time[k]
end

local function proofs(cases, check)
  local p = cases[1].p
  local function row(quantity, unit, result, reference, order)
    local values = {}
    for i, c in ipairs(cases) do values[i] = { cell(c.p), c.results[result] } end
    check.proof { case = "Hertz impact, " .. p.scheme .. " scheme", quantity = quantity, unit = unit, kind = "exact",
      source = "Hertz 1881; Johnson 1985, 11.4", reference = reference, values = values, resolution = "cell, m; step with it",
      tolerance = 0.03, order = order, run = cases[#cases],
      note = "a rigid ball of contact radius R/20, a block of 320 contact radii" }
  end
  row("largest depth", "um", "deepest", p.depth.si)
  row("time in contact", "ms", "together", duration(p))
  row("largest force", "N", "peak", hertz.force(modulus(p), p.radius.si, p.depth.si))
  row("speed of rebound", "mm/s", "rebound", speed(p), p.scheme == "default" and 0.85 or nil)
end

local function cases_of(levels)
  local list = {}
  for _, scheme in ipairs { "default", "plain" } do
    for i = 1, levels do list[#list + 1] = { scheme = scheme, cells = 2 << i, steps = 50 << i } end
  end
  return list
end

return stiction.study {
  title = "Impact of a rigid ball on a soft block", question = "Does an impact follow Hertz?",
  given = {
    radius = { 10*mm, "" }, young = { 10*MPa, "" }, poisson = { 0.3, "" }, ball_density = { 8000*kg/m^3, "33.5 g" },
  },
  chosen = {
    depth = { 25*um, "contact radius 0.5 mm, a twentieth of R; the speed follows from it" },
    density = { 100*kg/m^3, "of the block: a wave crosses it 14 times while they touch; 10 and 1000 change the depth by 1e-4" },
    size = { 160*mm, "of the block, 320 contact radii; with 40 mm the depth is 0.2 % less" },
    growth = { 1.25, "of the cells outside the fine zone" },
  },
  sweep = cases_of(3), quick = { sweep = cases_of(2) },
  case_id = function(p) return ("%s_%d_cells"):format(p.scheme, p.cells) end,
  scene = scene,
  results = {
    { name = "deepest", unit = "m", meaning = "largest depth of the ball", function(run) return -run:min("ball", "u_y") end },
    { name = "together", unit = "s", meaning = "time in contact", together },
    { name = "peak", unit = "N", meaning = "largest force", function(run) return run:max("ball", "force_y") end },
    { name = "rebound", unit = "m/s", meaning = "speed at the end",
      function(run)
        local u, t = run:series("ball", "u_y"), run.time
        return (u[#u] - u[#u - 1]) / (t[#u] - t[#u - 1])
      end },
    { name = "scheme_loss", unit = "1", meaning = "what the scheme takes over the energy at the start",
      function(run, p)
        local loss = run:series("energy", "scheme_loss")
        return loss[#loss] / (mass(p) * speed(p) ^ 2 / 2)
      end },
  },
  check = function(cases, check)
    for _, scheme in ipairs { "default", "plain" } do proofs(cases:where { scheme = scheme }, check) end
    for _, c in ipairs(cases) do
      check.ledger(c)
      check.within(c.id .. ": the scheme makes no energy, over that at the start", c.results.scheme_loss, -1e-3, 0.15)
    end
    local plain = cases:where { scheme = "plain" }
    check.within("the plain scheme keeps the energy to 0.5 %", plain[#plain].results.scheme_loss, -0.005, 0.005)
  end,
  figures = function(cases)
    local p, curves = cases[1].p, {}
    local exact = hertz.history(modulus(p), p.radius.si, mass(p), speed(p), 400)
    for _, scheme in ipairs { "default", "plain" } do
      local runs = cases:where { scheme = scheme }
      for i, c in ipairs { runs[1], runs[#runs] } do
        curves[#curves + 1] = { label = ("%s scheme, %d cells in a"):format(scheme, c.p.cells), case = c, y = "ball/force_y",
          colour = #curves + 1, style = i == 1 and "dot" or nil }
      end
    end
    curves[#curves + 1] = { label = "Hertz", x = exact.t, y = exact.force, style = "dash", colour = 6 }
    return { stiction.figure.lines { name = "force", title = "force on the ball", x = { label = "time", unit = "ms" },
      y = { label = "force", unit = "N" }, curves = curves, legend = "below" } }
  end,
}
