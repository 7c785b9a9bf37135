-- A ball is pressed into a softer slab and drawn over it, once round a corner, in steps of one to five facets.
--
--        ________           seen from above:
--       |  ball  |                 | 2nd leg
--        \_    _/                  |
--     _____'--'___________      ___|  1st leg, neither along the mesh
--    |        slab        |
--    |____________________|  ten times softer, held below
--
-- The ball carries the contact points; in each step their counterparts pass `facets` facets of the slab, in the dent that
-- the ball makes. Bodies are linear, so that Newton's method has nothing to do but contact: normals that turn, feet that go
-- from facet to facet, friction that turns round the corner. With the whole derivative it needs few iterations whatever the
-- step, and the forces at the end of the way depend on the steps by friction alone, which is of first order in them.
--
--     ./stiction run studies/proofs/ironing_in_space
local stiction = require "stiction"
local units = stiction.units
local mm, MPa, s, kg, m = units.mm, units.MPa, units.s, units.kg, units.m
local numeric = stiction.numeric

local function body(p, mesh, young)
  return stiction.body { mesh = mesh, density = p.density,
    material = stiction.material.linear_elastic { young = young, poisson = p.poisson } }
end

local function leg(p) return p.leg * p.cell end

local function meshes(p)
  local h, half = p.cell, p.side / 2
  local function count(length) return math.floor(length / h + 0.5) end
  return stiction.mesh.half_ball { centre = { -leg(p) / 2, -leg(p) / 2, p.radius }, radius = p.radius, part = "full",
      fine = { p.fine, p.fine }, fine_size = p.ratio * h, coarse_size = 4 * h },
    stiction.mesh.box { origin = { -half, -half, -p.height }, size = { p.side, p.side, p.height },
      cells = { count(p.side), count(p.side), count(p.height / 1.5) }, grading = { 1, 1, 0.4 } }
end

local function scene(p)
  local zero, down = 0*mm, -p.depth
  local ball, slab = meshes(p)
  local along, across = math.cos(p.angle) * leg(p), math.sin(p.angle) * leg(p)
  local steps = math.floor(p.leg / p.facets + 0.5)
  return stiction.scene {
    kinematics = "three_dimensional",
    bodies = { ball = body(p, ball, p.ball_young), slab = body(p, slab, p.slab_young) },
    pairs = { iron = stiction.pair { secondary = "ball.cap", primary = "slab.top", friction = stiction.friction.coulomb { mu = p.mu } } },
    motions = {
      stiction.motion.fix { set = "slab.bottom" },
      stiction.motion.drive { set = "ball.flat", times = { 0*s, 1*s, 2*s, 3*s },
        x = { zero, zero, along, along - across }, y = { zero, zero, across, across + along }, z = { zero, down, down, down } },
    },
    scheme = stiction.scheme.quasi_static {},
    schedule = stiction.schedule { stages = {
      stiction.stage { to = 1*s, steps = p.steps_down }, stiction.stage { to = 2*s, steps = steps },
      stiction.stage { to = 3*s, steps = steps } } },
    probes = { ball = stiction.probe.force { set = "ball.flat" }, energy = stiction.probe.energy { audit = true } },
  }
end

--- At the end of the way: force along and across the second leg and downwards, N.
local function ends(run, p)
  local fx, fy, fz = run:series("ball", "force_x"), run:series("ball", "force_y"), run:series("ball", "force_z")
  local c, sine = math.cos(p.angle), math.sin(p.angle)
  local x, y = fx[#fx], fy[#fy]
  return { along = -sine * x + c * y, across = c * x + sine * y, normal = -fz[#fz] }
end

--- Newton iterations of the steps that slide.
local function iterations(run)
  local all, sliding = run:series("step", "iterations"), {}
  for i, t in ipairs(run.time) do
    if t > 1 + 1e-9 then
      sliding[#sliding + 1] = all[i]
    end
  end
  return sliding
end

local function result(name, unit, meaning, of)
  return { name = name, unit = unit, meaning = meaning, of }
end

--- Difference of the forces from those by the shortest steps, over the normal one.
local function row(check, cases, quantity, difference, bounds)
  local finest, others = cases[#cases], {}
  for i = 1, #cases - 1 do
    others[i] = { cases[i].p.facets, difference(cases[i].results, finest.results) / finest.results.normal }
  end
  check.proof { case = "Ironing in space by long steps", quantity = quantity .. ", difference over the normal one",
    kind = "ours", source = ("steps of %g facets"):format(finest.p.facets), reference = 0, scale = 1, values = others,
    tolerance = bounds.allowed, order = bounds.order, resolution = "facets a step", run = cases[#cases - 1] }
end

local function force_figure(cases, component, sign, label)
  local curves = {}
  for i, case in ipairs(cases) do
    local force, x, y = case:series("ball", "force_" .. component), {}, {}
    for k, t in ipairs(case.time) do
      if t > 1 - 1e-9 then
        x[#x + 1], y[#y + 1] = (t - 1) * leg(case.p).si, sign * force[k]
      end
    end
    curves[i] = { label = ("%g facets a step"):format(case.p.facets), x = x, y = y, colour = i }
  end
  return stiction.figure.lines { name = "force_" .. component, title = label, curves = curves, legend = "below",
    x = { label = "travel", unit = "mm" }, y = { label = label, unit = "N" } }
end

return stiction.study {
  title = "Ironing in space by long steps",
  question = "Do Newton's iterations and the forces of a sliding ball bear steps of several facets?",
  given = { density = { 1000*kg/m^3, "not used in statics" } },
  chosen = {
    radius = { 1*mm, "of the ball" }, side = { 2.8*mm, "of the slab" }, height = { 0.6*mm, "of the slab" },
    ball_young = { 10*MPa, "ten times the slab's, both deform" }, slab_young = { 1*MPa, "the soft one" },
    poisson = { 0.3, "no locking" }, depth = { 0.2*mm, "a dent some five facets wide" }, mu = { 0.3, "dry" },
    cell = { 0.2*mm, "facet of the slab" }, ratio = { 0.9, "size of the ball's cells over the slab's; no simple fraction" },
    fine = { 0.4*mm, "part of the ball with fine cells" }, leg = { 5, "facets" }, angle = { 0.35, "of the first leg to the mesh" },
    steps_down = { 4, "to full depth" }, allowed = { 0.02, "of the shortest steps but one; ours" },
    allowed_normal = { 0.002, "the same" },
    order = { 0.8, "at least, of the tangential force in the step" }, most = { 8, "iterations of a step; ours" },
  },
  sweep = { { facets = 5 }, { facets = 2.5 }, { facets = 5 / 3 }, { facets = 1 }, { facets = 0.5 }, { facets = 0.25 } },
  quick = { sweep = { { facets = 5 }, { facets = 2.5 }, { facets = 1 } }, set = { allowed = 0.04 } },
  case_id = function(p) return ("%.3g"):format(p.facets) end,
  scene = scene,
  results = {
    result("normal", "N", "normal force at the end", function(run, p) return ends(run, p).normal end),
    result("along", "N", "force along the second leg", function(run, p) return ends(run, p).along end),
    result("across", "N", "force across the second leg", function(run, p) return ends(run, p).across end),
    result("most_iterations", "1", "of a step that slides", function(run) return numeric.max(iterations(run)) end),
    result("mean_iterations", "1", "of the steps that slide", function(run) return numeric.mean(iterations(run)) end),
  },
  check = function(cases, check)
    local p = cases[1].p
    row(check, cases, "tangential force", function(a, b)
      return math.sqrt((a.along - b.along) ^ 2 + (a.across - b.across) ^ 2)
    end, { allowed = p.allowed, order = p.order })
    row(check, cases, "normal force", function(a, b) return math.abs(a.normal - b.normal) end, { allowed = p.allowed_normal })
    for _, case in ipairs(cases) do
      check.within(("%s facets a step: Newton iterations"):format(case.id), case.results.most_iterations, 1, case.p.most)
      check.ledger(case)
    end
  end,
  figures = function(cases)
    return { force_figure(cases, "z", -1, "normal force"), force_figure(cases, "y", 1, "tangential force in y") }
  end,
}
