-- Adhesion tests with small soft caps: what the size of the cap changes, and what it does not [shull1997].
--
--     ///////////////////    flat side held; height h on the axis, spherical of radius R
--      '-._   cap   _.-'
--     ______'--...--'______   pressed by the plate and pulled off: load P, contact radius a, approach d
--     |__ rigid plate ____|
--
-- Measured: the compliance of caps differs significantly from what a standard analysis by Johnson, Kendall and Roberts
-- assumes, by an amount that does not depend on the contact area; the relation of load and area is not affected. Computed
-- without any adjustment: all three, for caps of three heights.
--
-- Axisymmetric, small strains, quasi-static, frictionless; bonds RCC with b = 0, near the limit of JKR.
--
--     ./stiction run studies/experiments/soft_caps
local stiction = require "stiction"
local jkr = stiction.reference.jkr
local units, numeric = stiction.units, stiction.numeric
local mm, m, s, kg, J, N, MPa = units.mm, units.m, units.s, units.kg, units.J, units.N, units.MPa

local function modulus(p) return jkr.modulus(p.young.si, p.poisson) end
local function stiffness(p) return p.share * jkr.stiffness(modulus(p), p.radius.si, p.w.si) end
local function cell(p) return modulus(p) / stiffness(p) / p.cells end

-- JKR's stable contact radius under the load P, m.
local function under(p, P)
  local R, pull = p.radius.si, 3 * math.pi * p.w.si * p.radius.si
  return (3 * R / (4 * modulus(p)) * (P + pull + math.sqrt(2 * pull * P + pull ^ 2))) ^ (1 / 3)
end
local function depth(p) return p.deep * under(p, 0) ^ 2 / (3 * p.radius.si) end -- times JKR's without a load

local function cap(p) -- the right half, hanging; finest along the skin that ever touches
  local edge, R, h, zero, c = stiction.edge, p.radius, p.height, 0*mm, cell(p) * m
  local rim, far = math.sqrt(h.si * (2 * R.si - h.si)) * m, 1.25 * math.sqrt(R.si * depth(p))
  local sizes, n = {}, 60
  for i = 0, n do
    local x = far * i / n
    for _, v in ipairs { x * m, (R.si - math.sqrt(R.si ^ 2 - x ^ 2)) * m, c } do sizes[#sizes + 1] = v end
  end
  return stiction.mesh.gmsh { size = h / 6, start = { zero, zero }, edges = {
    edge { to = { rim, h }, centre = { zero, R }, name = "skin" }, edge { to = { zero, h }, name = "base" },
    edge { to = { zero, zero }, name = "axis" } }, sizes = sizes, growth = 0.15,
    refine = { stiction.refinement { near = "skin", size = 2 * c, within = 0*mm, beyond = far / 2 * m } } }
end

local function scene(p)
  local over = (2 + p.above)*s
  return stiction.scene {
    kinematics = "axisymmetric",
    bodies = { cap = stiction.body { mesh = cap(p), density = 1000*kg/m^3, interpolation = "mean_dilatation",
      material = stiction.material.linear_elastic { young = p.young, poisson = p.poisson } } },
    obstacles = { plate = stiction.obstacle { shape = stiction.rigid.plane {}, times = { 0*s, 1*s, over },
      y = { 0*m, depth(p) * m, -p.above * depth(p) * m } } },
    pairs = { touch = stiction.pair { secondary = "cap.skin", primary = "plate",
      adhesion = stiction.adhesion.rcc { w = p.w, C_n = stiffness(p)*N/m^3, C_t = 0*N/m^3, b = 0*N*s/m } } },
    motions = { stiction.motion.fix { set = "cap.base" }, stiction.motion.fix { set = "cap.axis", y = false } },
    scheme = stiction.scheme.quasi_static {},
    schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = 20 },
      stiction.stage { to = over, steps = math.floor(p.steps * (1 + p.above)) } } },
    output = stiction.output { frames = 1 },
    probes = { touch = stiction.probe.contact { pair = "touch" }, line = stiction.probe.contact_line { pair = "touch" } },
  }
end

-- {P =, a =, d =} of each step of the pull in which the edge recedes, N and m; a: as far as bonds are whole, which they are
-- up to the largest traction.
local function pull(run, p)
  local list, force, X, beta = {}, run:series("touch", "force_y"), {}, {}
  for k = 1, math.floor(run:series("line", "count")[1]) do
    X[k], beta[k] = run:series("line", "X", k)[1], run:series("line", "beta", k)
  end
  local largest
  for i, t in ipairs(run.time) do
    local a = 0
    for k, x in ipairs(X) do
      if beta[k][i] > 0.999 and x > a then a = x end
    end
    if t > 1 then
      largest = largest or a
      if a < 0.97 * largest and a > 0 then list[#list + 1] = { P = force[i], a = a, d = (2 - t) * depth(p) } end
    end
  end
  return list
end

-- The part of it under loads that press, where JKR's edge is stable, with JKR's radius and approach under the same load.
local function pressed(run, p)
  local list = {}
  for _, step in ipairs(pull(run, p)) do
    if step.P > 0 then
      step.a_jkr = under(p, step.P)
      step.d_jkr = jkr.sphere.depth(modulus(p), p.radius.si, p.w.si, step.a_jkr)
      list[#list + 1] = step
    end
  end
  return list
end

-- Compliance beside JKR's, m/N: what the approach is more under the same load, over the load, at loads from a fifth of the
-- largest on (below it is a small difference over a small load). Its mean and spread, {mean =, spread =, radius =}.
local function compliance(run, p)
  local list, ratios, radii = pressed(run, p), {}, {}
  for _, step in ipairs(list) do
    if step.P > 0.2 * list[1].P then
      ratios[#ratios + 1], radii[#radii + 1] = (step.d - step.d_jkr) / step.P, step.a_jkr
    end
  end
  local mean = numeric.mean(ratios)
  return { mean = mean, spread = (numeric.max(ratios) - numeric.min(ratios)) / math.abs(mean), radius = numeric.mean(radii) }
end

return stiction.study {
  title = "Adhesion tests with small soft caps",
  question = "Does the size of a cap change its compliance, but not the relation of load and contact area?",
  chosen = {
    radius = { 1*mm, "of the sphere" }, young = { 0.7*MPa, "a soft silicone rubber" }, poisson = { 0.48, "nearly incompressible" },
    w = { 0.04*J/m^2, "of the order of silicones without viscosity" },
    share = { 0.15, "of the stiffness of bonds from which on RCC is JKR; cohesive length E*/C 9.4 um" },
    cells = { 13, "in that length" },
    deep = { 6, "approach at the end of pressing over that of JKR without a load" },
    above = { 0.5, "of that approach, pulled beyond where it touched" }, steps = { 150, "for the way back of the approach" },
  },
  sweep = { height = { 0.3*mm, 0.5*mm, 0.99*mm } },
  quick = { sweep = { height = { 0.3*mm, 0.99*mm } } },
  scene = scene,
  results = {
    { name = "misfit", unit = "1", meaning = "largest difference of the contact radius from JKR's under the same load",
      function(run, p)
        return numeric.max(numeric.map(pressed(run, p), function(step) return math.abs(step.a / step.a_jkr - 1) end))
      end },
    { name = "stiffer", unit = "1", meaning = "compliance less JKR's, over JKR's",
      function(run, p)
        local c = compliance(run, p)
        return c.mean * 2 * c.radius * modulus(p)
      end },
    { name = "spread", unit = "1", meaning = "of that difference over the contact radii, over its mean",
      function(run, p) return compliance(run, p).spread end },
    { name = "widest", unit = "1", meaning = "largest contact radius of these over the height",
      function(run, p) return pressed(run, p)[1].a / p.height.si end },
    { name = "radii", unit = "1", meaning = "largest of these radii over the smallest",
      function(run, p) return pressed(run, p)[1].a_jkr / under(p, 0.2 * pressed(run, p)[1].P) end },
    { name = "pull_off", unit = "1", meaning = "largest pull over JKR's 3/2 pi w R",
      function(run, p) return -numeric.min(run:series("touch", "force_y")) / jkr.sphere.pull_off(p.radius.si, p.w.si) end },
  },
  check = function(cases, check)
    for _, c in ipairs(cases) do
      check.within(c.id .. ": load and area are JKR's", c.results.misfit, 0, 0.06)
      check.within(c.id .. ": and so is the largest pull", c.results.pull_off, 0.9, 1.15)
    end
    local flat, ball = cases[1].results, cases[#cases].results
    check.within("the flattest cap: its compliance is not JKR's", math.abs(flat.stiffer), 0.2, 1)
    check.within("the flattest cap: the discrepancy does not depend on the contact area", flat.spread, 0, 0.2)
    check.within("a hemisphere is nearer to JKR than the flattest cap", ball.stiffer / flat.stiffer, 0, 0.4)
    check.within("the height does not change the largest pull", flat.pull_off / ball.pull_off, 0.95, 1.05)
  end,
  figures = function(cases)
    local radius, approach = {}, {}
    local p, largest, P, a, d = cases[1].p, pressed(cases[1], cases[1].p)[1].P, {}, {}, {}
    for i = 0, 40 do
      P[i + 1] = largest * i / 40
      a[i + 1] = under(p, P[i + 1])
      d[i + 1] = jkr.sphere.depth(modulus(p), p.radius.si, p.w.si, a[i + 1])
    end
    radius[1] = { label = "JKR", x = P, y = a, colour = 0 }
    approach[1] = { label = "JKR", x = P, y = d, colour = 0 }
    for i, c in ipairs(cases) do
      local load, wide, deep = {}, {}, {}
      for k, step in ipairs(pressed(c, c.p)) do load[k], wide[k], deep[k] = step.P, step.a, step.d end
      local label = ("h / R = %g"):format(c.p.height / c.p.radius)
      radius[i + 1] = { label = label, x = load, y = wide, style = "points", colour = i }
      approach[i + 1] = { label = label, x = load, y = deep, style = "points", colour = i }
    end
    local x = { label = "load P", unit = "mN" }
    return { stiction.figure.panel { name = "caps", width = "double", columns = 2, figures = {
      stiction.figure.lines { name = "radius", x = x, y = { label = "contact radius a", unit = "um" }, curves = radius },
      stiction.figure.lines { name = "approach", x = x, y = { label = "approach d", unit = "um" }, curves = approach },
    } } }
  end,
}
