-- A wavy tube in space, pressed along its axis until it folds onto itself, and rubbed: contact of a surface with itself.
--
--       _________      half of the tube, y >= 0, between walls at the crests of its wave: they come together along the axis
--      (         )     until the loops outside touch all round and press each other; then the upper end goes sideways by a
--       )       (      little, and they rub
--      (_________)
--
-- While it is only pressed, its section about the axis is the same in one dimension less, and touches itself too: the tube must
-- bear what that bears, but for its being a polygon. Thrown without walls, the half tube folds onto itself and keeps its momentum.
--
--     ./stiction run studies/proofs/folded_tube
local stiction = require "stiction"
local units = stiction.units
local m, mm, s, kg, MPa = units.m, units.mm, units.s, units.kg, units.MPa

local function length(p) return 4 * p.loop.si * math.sin(p.opening) end

local function space(p) return p.model ~= "section" end

local function wall(p, at, press)
  local function along(value) return space(p) and { 0, 0, value } or { 0, value } end
  local moves = at > 0
  return stiction.obstacle { shape = stiction.rigid.plane { normal = along(moves and -1 or 1),
      point = space(p) and { 0*m, 0*m, at*m } or { 0*m, at*m } },
    times = moves and { 0*s, 1*s, 2*s } or nil, [space(p) and "z" or "y"] = moves and { 0*m, -press*m, -press*m } or nil }
end

--- The crests at the ends keep their radius; in the second half of the run the upper one goes sideways, in space.
local function motions(p, press)
  local times, down, none = { 0*s, 1*s, 2*s }, { 0*m, -press*m, -press*m }, { 0*m, 0*m, 0*m }
  local held = stiction.motion.fix { set = "tube.low" }
  if p.model == "section" then
    return { held, stiction.motion.drive { set = "tube.high", times = times, x = none, y = down } }
  end
  return { held, stiction.motion.drive { set = "tube.high", times = times, x = { 0*m, 0*m, p.rub }, y = none, z = down },
    stiction.motion.fix { set = "tube.cut", x = false, z = false } }
end

local function tube(p)
  local thrown, rate = p.model == "thrown", 2 * p.speed.si / length(p)
  return stiction.body { density = p.density,
    mesh = stiction.mesh.msh_file { path = space(p) and ("tube_%d.msh"):format(p.around) or "section.msh", scale = 1*mm },
    material = stiction.material.neo_hookean { young = p.young, poisson = p.poisson },
    velocity = thrown and { p.speed, 0*m/s, 0*m/s } or nil, spin = thrown and { 0*p.spin, p.spin, 0*p.spin } or nil,
    velocity_gradient = thrown and { 0 / s, 0 / s, 0 / s, 0 / s, 0 / s, 0 / s, 0 / s, 0 / s, -rate / s } or nil }
end

local function pressed(p)
  local press = p.press * length(p)
  return {
    kinematics = space(p) and "three_dimensional" or "axisymmetric",
    obstacles = { low = wall(p, 0, press), high = wall(p, length(p), press) },
    pairs = { below = stiction.pair { secondary = "tube.inner", primary = "low" },
      above = stiction.pair { secondary = "tube.inner", primary = "high" } },
    motions = motions(p, press),
    scheme = stiction.scheme.quasi_static {},
    schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = p.steps },
      space(p) and stiction.stage { to = 2*s, steps = p.steps } or nil } },
    probes = { held = stiction.probe.force { set = "tube.low" }, wall = stiction.probe.contact { pair = "below" } },
  }
end

local function thrown(p)
  return { kinematics = "three_dimensional", pairs = {}, scheme = stiction.scheme.theta_xi { contact_inertia = "cells" },
    control = stiction.control { force_tolerance = 1e-10 },
    schedule = stiction.schedule { stages = { stiction.stage { to = p.flight, steps = p.steps } } },
    probes = { momentum = stiction.probe.momentum {} } }
end

local function scene(p)
  local t = p.model == "thrown" and thrown(p) or pressed(p)
  t.bodies = { tube = tube(p) }
  t.pairs.folds = stiction.pair { secondary = "tube.outer", primary = "tube.outer",
    friction = stiction.friction.coulomb { mu = p.mu } }
  t.output = stiction.output { frames = 4 }
  t.probes.folds, t.probes.energy = stiction.probe.contact { pair = "folds" }, stiction.probe.energy { audit = true }
  return stiction.scene(t)
end

local function sweep_of(t)
  local cases = { { model = "section", around = 0, steps = 16 } }
  for _, around in ipairs(t.around) do cases[#cases + 1] = { model = "tube", around = around, steps = 16 } end
  for _, steps in ipairs(t.thrown) do cases[#cases + 1] = { model = "thrown", around = t.around[1], steps = steps } end
  return cases
end

--- Force along the axis of a whole tube at the end of the pressing, or 0.
local function axial(run, p, group)
  if p.model == "thrown" then return 0 end
  return math.abs(run:at(1*s, group, space(p) and "force_z" or "force_y")) * (space(p) and 2 or 1)
end

--- Largest change of a vector over the size that it has at the start; 0 of what is held.
local function drift(run, p, prefix)
  if p.model ~= "thrown" then return 0 end
  local size, changes = 0, {}
  for _, axis in ipairs { "x", "y", "z" } do
    local values = run:series("momentum", prefix .. axis)
    size = size + values[1] ^ 2
    for i, value in ipairs(values) do changes[i] = (changes[i] or 0) + (value - values[1]) ^ 2 end
  end
  return math.sqrt(stiction.numeric.max(changes) / size)
end

local function result(name, unit, meaning, of)
  return { name = name, unit = unit, meaning = meaning, of }
end

local function like_section(cases, check)
  local tubes, section = cases:where { model = "tube" }, cases:find { model = "section" }.results
  local function row(quantity, name, polygon) -- polygon: error times the square of the number of facets
    local values = {}
    for i, case in ipairs(tubes) do values[i] = { 1 / case.p.around, case.results[name] / section[name] } end
    check.proof { case = "Folded tube, pressed", quantity = quantity .. " over that of its section", kind = "ours",
      source = "the section about the axis", reference = 1, values = values, resolution = "facets, inverse", order = 1.5,
      tolerance = polygon / tubes[#tubes].p.around ^ 2, run = tubes[#tubes] }
  end
  row("force of the folds on each other", "folds", 5)
  row("force of the crest at the end", "held", 12)
end

local function thrown_together(runs, check)
  local spins = {}
  for i, case in ipairs(runs) do
    check.within(case.id .. ": change of momentum over its start", case.results.drift, 0, 1e-10)
    spins[i] = { case.p.flight.si / case.p.steps, case.results.spin_drift }
  end
  check.proof { case = "Half tube thrown together", quantity = "change of angular momentum over its start", kind = "exact",
    source = "no outer forces", reference = 0, scale = 1, values = spins, resolution = "s step", tolerance = 0.01, run = runs[#runs] }
end

return stiction.study {
  title = "Folded tube",
  question = "Does a tube in space that folds onto itself bear what its section bears, keep its momentum, and lose what friction takes?",
  given = {
    loop = { 2*mm, "of the middle line; radius 10 mm, wall 0.5 mm: make.lua" }, opening = { math.rad(105), "of a loop to either side" },
    young = { 1*MPa, "neo-Hookean" }, poisson = { 0.3, "" }, density = { 1000*kg/m^3, "" }, mu = { 0.3, "dry" },
    press = { 0.58, "of the length" }, rub = { 0.4*mm, "of the upper end, sideways" },
    speed = { 2*m/s, "thrown: sideways, and of its ends towards each other" }, spin = { 50*units.rad/s, "thrown: turning" },
  },
  chosen = { flight = { 4*units.ms, "they meet and part" } },
  sweep = sweep_of { around = { 8, 12, 18 }, thrown = { 100, 200 } },
  quick = { sweep = sweep_of { around = { 8, 12 }, thrown = { 60 } } },
  case_id = function(p) return ("%s_%d_%d"):format(p.model, p.around, p.steps) end,
  scene = scene,
  results = {
    result("held", "N", "of the crest at the end after pressing, whole tube", function(run, p) return axial(run, p, "held") end),
    result("folds", "N", "of the folds on each other, whole tube", function(run, p) return axial(run, p, "folds") end),
    result("wall", "N", "on the lower wall, whole tube", function(run, p) return axial(run, p, "wall") end),
    result("rubbed", "J", "lost by friction", function(run) return run:last("energy", "friction_loss") end),
    result("deepest", "m", "a point in the fold that it touches", function(run) return math.max(0, -run:min("folds", "gap_min")) end),
    result("drift", "1", "thrown: change of momentum over its start", function(run, p) return drift(run, p, "p_") end),
    result("spin_drift", "1", "thrown: change of angular momentum over its start", function(run, p) return drift(run, p, "l_") end),
  },
  check = function(cases, check)
    for _, case in ipairs(cases) do
      local r = case.results
      check.within(case.id .. ": deepest point, m", r.deepest, 0, 1e-9)
      check.ledger(case)
      if case.p.model ~= "section" then
        check.non_decreasing(case.id .. ": friction only takes", (case:series("energy", "friction_loss")), 1e-9 * r.rubbed)
        check.within(case.id .. ": and takes something, over the strain energy", r.rubbed / case:max("energy", "strain"), 1e-6, 1)
      end
    end
    like_section(cases, check)
    thrown_together(cases:where { model = "thrown" }, check)
  end,
  figures = function(cases)
    local tubes = cases:where { model = "tube" }
    local function picture(at, name, title)
      return stiction.figure.field { name = name, case = tubes[#tubes], time = at, array = "von_mises", label = "von Mises stress",
        unit = "kPa", deformed = true, title = title, show_time = false, view = { azimuth = -60, elevation = 25 } }
    end
    return { stiction.figure.panel { name = "tube", columns = 2, common_range = true, dpi = 150, figures = {
      picture(0.5*s, "half", "half-way"), picture(2*s, "rubbed", "pressed and rubbed") } } }
  end,
}
