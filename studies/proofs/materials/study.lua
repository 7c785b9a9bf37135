-- One cell of every material, stretched with free sides and sheared: forces against its energy differentiated by hand.
--
--      ____ z = l     sides free, area 1 m^2            ____ -> g
--     |    |    force P(l) with the lateral            /   /     every node driven:
--     |____|    stretch q from dW/dq = 0              /___/      tractions of x = X + g Z
--
-- A homogeneous state has no mesh error, so there is one resolution.
--
--     ./stiction run studies/proofs/materials
local stiction = require "stiction"
local reference = stiction.reference.hyperelastic
local units = stiction.units
local m, s, kg, kPa = units.m, units.s, units.kg, units.kPa

local bulk = 5000*kPa
local E, nu = 280*kPa, 0.4
-- How the scene names each law, the reference, and the formula's source; about 100 kPa of shear modulus.
local laws = {
  linear_elastic = { { young = E, poisson = nu }, nil, "Hooke" },
  st_venant_kirchhoff = { { young = E, poisson = nu }, reference.st_venant_kirchhoff(E.si, nu), "Hooke's law of E and S" },
  neo_hookean = { { young = E, poisson = nu }, reference.neo_hookean(E.si, nu), "W in principal stretches" },
  mooney_rivlin = { { C10 = 35*kPa, C01 = 15*kPa, bulk_modulus = bulk },
    reference.mooney_rivlin(35e3, 15e3, bulk.si), "W in principal stretches" },
  yeoh = { { C10 = 50*kPa, C20 = -5*kPa, C30 = 1*kPa, bulk_modulus = bulk },
    reference.yeoh(50e3, -5e3, 1e3, bulk.si), "Yeoh 1993" },
  ogden = { { mu = { 120*kPa, -40*kPa }, alpha = { 1.3, -1.1 }, bulk_modulus = bulk },
    reference.ogden({ 120e3, -40e3 }, { 1.3, -1.1 }, bulk.si), "Ogden 1972" },
  arruda_boyce = { { shear_modulus = 100*kPa, lambda_m = 2, bulk_modulus = bulk },
    reference.arruda_boyce(100e3, 2, bulk.si), "Arruda and Boyce 1993" },
  blatz_ko = { { shear_modulus = 100*kPa }, reference.blatz_ko(100e3), "Blatz and Ko 1962" },
}
local order = { "linear_elastic", "st_venant_kirchhoff", "neo_hookean", "mooney_rivlin", "yeoh", "ogden", "arruda_boyce",
  "blatz_ko" }

-- Force per area and lateral stretch.
local function stretched(name, l)
  if laws[name][2] then return reference.uniaxial(laws[name][2], l) end
  return E.si * (l - 1), 1 - nu * (l - 1)
end

-- Forces per reference area on the top along x and z, on the right along x and on the back along y, from the Cauchy
-- stress by P = J s F^-T.
local function sheared(name, g)
  if not laws[name][2] then
    return { shear = (reference.moduli(E.si, nu)) * g, top = 0, right = 0, back = 0 }
  end
  local stress = reference.simple_shear(laws[name][2], g)
  return { shear = stress.s12, top = stress.s22, right = stress.s11 - g * stress.s12, back = stress.s33 }
end

-- The sides of St Venant and Kirchhoff meet at sqrt(1 + 1/nu) = 1.87.
local function last_stretch(name) return name == "st_venant_kirchhoff" and 1.5 or 2 end

local function motions(p)
  local fix, drive = stiction.motion.fix, stiction.motion.drive
  local times, path = { 0*s, 1*s }, { 0*m, p.amount * m }
  if p.loading == "shear" then
    return {
      fix { set = "cube.bottom" }, fix { set = "cube.top", x = false },
      drive { set = "cube.top", times = times, x = path },
    }
  end
  return {
    fix { set = "cube.left", y = false, z = false }, fix { set = "cube.front", x = false, z = false },
    fix { set = "cube.bottom", x = false, y = false },
    drive { set = "cube.top", times = times, z = { path[1], path[2] - 1*m } },
  }
end

local function scene(p)
  local force = stiction.probe.force
  return stiction.scene {
    kinematics = "three_dimensional",
    bodies = { cube = stiction.body {
      mesh = stiction.mesh.box { size = { 1*m, 1*m, 1*m }, cells = { 1, 1, 1 } },
      material = stiction.material[p.law](laws[p.law][1]), density = 1000*kg/m^3,
    } },
    motions = motions(p), scheme = stiction.scheme.quasi_static {},
    control = stiction.control { force_tolerance = p.tolerance },
    schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = p.steps } } },
    output = stiction.output { frames = 0 },
    probes = {
      top = force { set = "cube.top" }, right = force { set = "cube.right" }, back = force { set = "cube.back" },
      corner = stiction.probe.node { set = "cube.all", near = { 1*m, 1*m, 1*m } },
    },
  }
end

local black = 6 -- among the colours of figures

local function proofs(c, check)
  local p, r = c.p, c.results
  local word = p.law:gsub("_", " ")
  local function row(quantity, unit, value, wanted, scale)
    check.proof {
      case = ("%s, %s %g"):format(word, p.loading, p.amount), quantity = quantity, unit = unit, kind = "exact",
      source = laws[p.law][3], values = { { 1, value } }, reference = wanted, scale = scale, tolerance = 1e-10, run = c,
    }
  end
  if p.loading == "stretch" then
    local P, q = stretched(p.law, p.amount)
    row("force per area", "kPa", r.top_z, P)
    row("lateral stretch", "1", r.lateral, q)
    return
  end
  local exact = sheared(p.law, p.amount)
  row("shear", "kPa", r.top_x, exact.shear)
  row("force along z on the top", "kPa", r.top_z, exact.top, exact.shear)
  row("force along x on the right", "kPa", r.right_x, exact.right, exact.shear)
  row("force along y on the back", "kPa", r.back_y, exact.back, exact.shear)
end

-- The exact curve of a law, up to where its runs go.
local function exact_curve(name, colour, t)
  local x, y = {}, {}
  for k = 0, 60 do
    x[k + 1] = math.min(t.from + k * (t.to - t.from) / 60, last_stretch(name))
    y[k + 1] = t.exact(name, x[k + 1])
  end
  return { label = name:gsub("_", " "), x = x, y = y, colour = colour }
end

-- One figure of all laws under one loading: the runs as black dots over the exact curves.
local function picture(cases, t)
  local curves = {}
  for i, name in ipairs(order) do curves[i] = exact_curve(name, i < black and i or i + 1, t) end
  for i, c in ipairs(cases:where { loading = t.loading }) do
    local amount = stiction.numeric.map(c.time, function(time) return t.start + (c.p.amount - t.start) * time end)
    curves[#curves + 1] = { label = i == 1 and "one cell" or nil, x = amount, y = c:series("top", t.series), colour = black,
      style = "dot" }
  end
  return stiction.figure.lines { name = t.name, title = t.title, x = { label = t.label, unit = "1" },
    y = { label = "force per area", unit = "kPa" }, legend = "below", curves = curves }
end

local list = {}
for _, name in ipairs(order) do
  for _, load in ipairs { { "stretch", 0.7 }, { "stretch", last_stretch(name) }, { "shear", 0.5 } } do
    list[#list + 1] = { law = name, loading = load[1], amount = load[2] }
  end
end

return stiction.study {
  title = "Every material in stretch and shear", question = "Does one cell give what the law's energy says?",
  chosen = {
    steps = { 10, "Newton's method converges in each" },
    tolerance = { 1e-12, "the default 1e-7 stops too early to see 1e-10" },
  },
  sweep = list,
  case_id = function(p) return ("%s_%s_%g"):format(p.law, p.loading, p.amount) end,
  scene = scene,
  results = {
    { name = "lateral", unit = "1", meaning = "stretch along x at the corner",
      function(run) return 1 + run:last("corner", "u_x") end },
    { name = "top_x", unit = "N", meaning = "force on the top along x", function(run) return run:last("top", "force_x") end },
    { name = "top_z", unit = "N", meaning = "force on the top along z", function(run) return run:last("top", "force_z") end },
    { name = "right_x", unit = "N", meaning = "force on the right along x",
      function(run) return run:last("right", "force_x") end },
    { name = "back_y", unit = "N", meaning = "force on the back along y",
      function(run) return run:last("back", "force_y") end },
  },
  check = function(cases, check)
    for _, c in ipairs(cases) do proofs(c, check) end
  end,
  figures = function(cases)
    return {
      picture(cases, { name = "stretch", title = "stretched with free sides", loading = "stretch",
        from = 0.7, to = 2, start = 1, series = "force_z", label = "stretch",
        exact = function(name, l) return (stretched(name, l)) end }),
      picture(cases, { name = "shear", title = "simple shear: force across the shear", loading = "shear", from = 0, to = 0.5,
        start = 0, series = "force_z", label = "shear", exact = function(name, g) return sheared(name, g).top end }),
    }
  end,
}
