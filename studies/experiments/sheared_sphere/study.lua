-- A rubber sphere on glass loses contact area when it is sheared, long before it slides [sahli2018], and finite
-- strains alone make it do so, without adhesion [lengiewicz2020].
--
--      ///////////////////    flat side held
--      \       R         /
--       \   neo-Hookean /     shear strength of the interface tau_max, no adhesion
--        '-._       _.-'
--     _______'-----'_______   P upwards, held; pushed sideways by Q until it slides
--     |__ rigid plate ____|->
--
-- A half, y >= 0, in three dimensions. The plate has a mass, so that P can be its load, and moves so slowly that the mass
-- does not matter (backward Euler takes its swinging away).
--
-- Measured: A = A0 - alpha Q^2, up to 30 % less, alpha about as A0^-3/2; the contact gets shorter along the shear, and lifting
-- is most of it. Nothing is fitted. The same in small strains loses next to nothing.
--
--     ./stiction run studies/experiments/sheared_sphere
local stiction = require "stiction"
local contact = require "contact"
local units, numeric = stiction.units, stiction.numeric
local mm, m, s, kg, N, MPa = units.mm, units.m, units.s, units.kg, units.N, units.MPa

local landed, settled = 0.4, 4.4 -- s; then a step a second

local function modulus(p) return p.young.si / (1 - p.poisson ^ 2) end
local function wide(p) return (3 * p.load.si * p.radius.si / (4 * modulus(p))) ^ (1 / 3) end -- Hertz's contact radius
local function cell(p) return wide(p) / p.cells end
local function friction(p) -- the strength is reached where the pressure is a share of Hertz's largest
  return p.strength.si / (p.bound * 3 * p.load.si / (2 * math.pi * wide(p) ^ 2))
end
local function shift(p, time) return math.max(0, time - settled) / p.steps * p.shear * wide(p) end

local function plate(p)
  local zero, over, depth = 0*mm, settled + p.steps, wide(p) ^ 2 / p.radius.si
  return stiction.obstacle { shape = stiction.rigid.plane {}, force = { 0*N, 0*N, p.load / 2 },
    mass = p.load.si / 2 * 0.1 ^ 2 / depth * kg, -- would fall by Hertz's depth in the first step
    times = { 0*s, settled*s, over*s }, x = { zero, zero, shift(p, over) * m }, y = { zero, zero, zero } }
end

local function scene(p)
  local R, a, zero = p.radius, wide(p) * m, 0*mm
  return stiction.scene {
    kinematics = "three_dimensional",
    bodies = { ball = stiction.body { density = 1000*kg/m^3, interpolation = "mean_dilatation",
      mesh = stiction.mesh.half_ball { centre = { zero, zero, R }, radius = R, part = "half",
        fine = { 1.5 * a, 0.8 * a }, fine_size = cell(p) * m, coarse_size = R / 5, growth = 1.3 },
      material = stiction.material[p.law] { young = p.young, poisson = p.poisson } } },
    obstacles = { plate = plate(p) },
    pairs = { touch = stiction.pair { secondary = "ball.cap", primary = "plate", reach = 0.5*mm, direction = { 1, 0, 0 },
      friction = stiction.friction.tresca { mu = friction(p), tau_max = p.strength } } },
    motions = { stiction.motion.fix { set = "ball.flat" }, stiction.motion.fix { set = "ball.symmetry_y", x = false, z = false } },
    scheme = stiction.scheme.theta_xi { theta = 1, xi = 1 },
    schedule = stiction.schedule { stages = { stiction.stage { to = landed*s, steps = 4 },
      stiction.stage { to = settled*s, steps = 2 }, stiction.stage { to = (settled + p.steps)*s, steps = p.steps } } },
    output = stiction.output { frames = 2 },
    probes = { touch = stiction.probe.contact { pair = "touch" }, line = stiction.probe.contact_line { pair = "touch" } },
  }
end

local function hertz(p)
  local a = wide(p)
  return { a = a, peak = 3 * p.load.si / (2 * math.pi * a ^ 2), radius = p.radius.si }
end

-- {time =, Q = N, P = N, at =, points =, patch =} (contact.points, contact.patch) of each step from the settled contact on;
-- made once a case.
local kept = setmetatable({}, { __mode = "k" })
local function way(run, p)
  if not kept[run] then
    local list, forces, loads = {}, run:series("touch", "force_x"), run:series("touch", "force_z")
    local histories = contact.read(run)
    for i, time in ipairs(run.time) do
      if time > settled - 1e-6 then
        local points = contact.points(histories, shift(p, time), i, hertz(p), cell(p))
        list[#list + 1] = { time = time, Q = 2 * forces[i], P = 2 * loads[i], at = i, points = points,
          patch = contact.patch(points, 1.7 * cell(p)) }
      end
    end
    kept[run] = list
  end
  return kept[run]
end

-- The first step in which nothing sticks any more: gross sliding.
local function sliding(run, p)
  local stick = run:series("touch", "stick")
  for _, step in ipairs(way(run, p)) do
    if stick[step.at] == 0 then return step end
  end
  error("the plate never slides: make `shear` larger")
end

-- alpha of A = A0 - alpha Q^2 until it slides, by least squares, m^2/N^2; and the largest misfit over A0.
local function law(run, p)
  local steps, last = way(run, p), sliding(run, p).time
  local A0, above, below, misfit = steps[1].patch.area, 0, 0, 0
  for _, step in ipairs(steps) do
    if step.time <= last then above, below = above + (A0 - step.patch.area) * step.Q ^ 2, below + step.Q ^ 4 end
  end
  local alpha = above / below
  for _, step in ipairs(steps) do
    if step.time <= last then misfit = math.max(misfit, math.abs(step.patch.area - A0 + alpha * step.Q ^ 2) / A0) end
  end
  return alpha, misfit
end

-- 1 - what is left of a quantity of the patch when it slides.
local function loss(name)
  return function(run, p) return 1 - sliding(run, p).patch[name] / way(run, p)[1].patch[name] end
end

-- The area lost when the force is 0.7 of that of sliding, over all that is lost until it slides.
local function early(run, p)
  local last, A, Q = sliding(run, p), {}, {}
  for i, step in ipairs(way(run, p)) do
    if step.time <= last.time then Q[i], A[i] = step.Q, step.patch.area end
  end
  return (A[1] - numeric.interpolate(Q, A, 0.7 * Q[#Q])) / (A[1] - last.patch.area)
end

local function check_rubber(c, check)
  local r = c.results
  check.within(c.id .. ": the area lost when it slides, up to 30 %", r.lost, 0.05, 0.33)
  check.within(c.id .. ": A = A0 - alpha Q^2 until it slides, misfit over A0", r.misfit, 0, 0.03)
  check.within(c.id .. ": much is lost well before it slides", r.early, 0.25, 1)
  check.holds(c.id .. ": the contact shrinks along the shear, more than across", r.shorter > 0.03 and r.shorter > 2 * r.narrower)
  check.within(c.id .. ": lifting is most of it", r.lifted / r.lost, 0.5, 1.1)
end

return stiction.study {
  title = "A sheared rubber sphere loses contact area",
  question = "Do finite strains without adhesion make the contact of a sheared rubber sphere shrink as it was measured to?",
  chosen = {
    radius = { 9.4*mm, "millimetres, as in \"millimeter-sized smooth sphere/plane contacts\"" },
    young = { 1.6*MPa, "of a silicone rubber; only strength / young matters" },
    poisson = { 0.48, "nearly incompressible" },
    strength = { 0.41*MPa, "of the interface, a quarter of young: rubber on glass slides at some tenths of a megapascal" },
    bound = { 0.5, "the strength is reached where the pressure is more than this share of Hertz's largest" },
    shear = { 1.3, "of the plate's way over Hertz's contact radius: it slides" }, steps = { 16, "of equal length" },
    cells = { 6, "in Hertz's contact radius; an even number" },
  },
  sweep = { { law = "neo_hookean", load = 2*N }, { law = "neo_hookean", load = 1*N }, { law = "linear_elastic", load = 2*N } },
  quick = { set = { cells = 4, steps = 12 }, sweep = { { law = "neo_hookean", load = 2*N }, { law = "linear_elastic", load = 2*N } } },
  scene = scene,
  results = {
    { name = "area", unit = "mm^2", meaning = "contact area under P alone, A0", function(run, p) return way(run, p)[1].patch.area end },
    { name = "force", unit = "N", meaning = "Q when it slides", function(run, p) return sliding(run, p).Q end },
    { name = "lost", unit = "1", meaning = "of the area when it slides", loss "area" },
    { name = "lifted", unit = "1", meaning = "of the reference area, by points that lift", loss "reference" },
    { name = "shorter", unit = "1", meaning = "the contact along the shear when it slides", loss "length" },
    { name = "narrower", unit = "1", meaning = "the contact across", loss "width" },
    { name = "early", unit = "1", meaning = "lost at 0.7 of the force, over all that is lost until it slides", early },
    { name = "alpha", unit = "mm^2/N^2", meaning = "of A = A0 - alpha Q^2", function(run, p) return (law(run, p)) end },
    { name = "misfit", unit = "1", meaning = "of that law, over A0", function(run, p) return (select(2, law(run, p))) end },
  },
  check = function(cases, check)
    local rubber = cases:where { law = "neo_hookean" }
    for _, c in ipairs(rubber) do check_rubber(c, check) end
    for _, c in ipairs(cases) do
      check.close(c.id .. ": the load stays what it is", sliding(c, c.p).P, c.p.load, 1e-3)
    end
    if #rubber > 1 then
      local low, high = rubber[2].results, rubber[1].results
      check.within("alpha falls about as A0^-3/2", math.log(low.alpha / high.alpha) / math.log(low.area / high.area), -1.9, -1.1)
    end
    local small = cases:where({ law = "linear_elastic" })[1]
    check.within("in small strains little is lost, over what rubber loses", small.results.lost / rubber[1].results.lost, -0.25, 0.25)
  end,
  figures = function(cases)
    local names = { neo_hookean = "finite strain", linear_elastic = "small strain" }
    local curves, outline = {}, {}
    for i, c in ipairs(cases) do
      local x, y, last, steps = {}, {}, sliding(c, c.p), way(c, c.p)
      for k, step in ipairs(steps) do
        if step.time <= last.time then x[k], y[k] = step.Q / last.Q, step.patch.area / steps[1].patch.area end
      end
      curves[i] = { label = ("%s, %g N"):format(names[c.p.law], c.p.load.si), x = x, y = y, style = "points", colour = i }
    end
    local c = cases[1]
    local x, y, Q, A0 = {}, {}, sliding(c, c.p).Q, c.results.area
    for i = 0, 20 do x[i + 1], y[i + 1] = i / 20, 1 - c.results.alpha * (i / 20 * Q) ^ 2 / A0 end
    table.insert(curves, 1, { label = "A0 - α Q², 2 N", x = x, y = y, colour = 0 })
    for i, step in ipairs { way(c, c.p)[1], sliding(c, c.p) } do
      x, y = {}, {}
      for _, p in ipairs(step.points) do
        if p.share > 0.5 then
          for _, side in ipairs { 1, -1 } do x[#x + 1], y[#y + 1] = p.x, side * p.y end
        end
      end
      outline[i] = { label = i == 1 and "pressed" or "sliding", x = x, y = y, style = "points", colour = i == 1 and 0 or 1 }
    end
    return { stiction.figure.panel { name = "area", width = "double", height = 85, columns = 2, figures = {
      stiction.figure.lines { name = "law", x = { label = "Q over that of sliding" }, legend = "bottom left", curves = curves,
        y = { label = "contact area A / A0", range = { 0.6, 1.05 } } },
      stiction.figure.lines { name = "outline", x = { label = "x, the plate moves to the right", unit = "mm" },
        y = { label = "y", unit = "mm" }, curves = outline },
    } } }
  end,
}
