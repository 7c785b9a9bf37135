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
-- A rigid ball does the same, with the contact points on the slab: their slip is the way round it. Both by mortar, too.
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

local function centre(p) return { -leg(p) / 2, -leg(p) / 2, p.radius } end

local function ball_mesh(p)
  return stiction.mesh.half_ball { centre = centre(p), radius = p.radius, part = "full", fine = { p.fine, p.fine },
    fine_size = p.ratio * p.cell, coarse_size = 4 * p.cell }
end

local function slab_mesh(p)
  local function count(length) return math.floor(length / p.cell + 0.5) end
  return stiction.mesh.box { origin = { -p.side / 2, -p.side / 2, -p.height }, size = { p.side, p.side, p.height },
    cells = { count(p.side), count(p.side), count(p.height / 1.5) }, grading = { 1, 1, 0.4 } }
end

local function scene(p)
  local zero, down = 0*mm, -p.depth
  local along, across = math.cos(p.angle) * leg(p), math.sin(p.angle) * leg(p)
  local steps = math.floor(p.leg / p.facets + 0.5)
  local way = { times = { 0*s, 1*s, 2*s, 3*s }, x = { zero, zero, along, along - across },
    y = { zero, zero, across, across + along }, z = { zero, down, down, down } }
  local soft, motions = p.ball == "soft", { stiction.motion.fix { set = "slab.bottom" } }
  if soft then
    motions[2] = stiction.motion.drive { set = "ball.flat", times = way.times, x = way.x, y = way.y, z = way.z }
  end
  return stiction.scene {
    kinematics = "three_dimensional",
    bodies = { ball = soft and body(p, ball_mesh(p), p.ball_young) or nil, slab = body(p, slab_mesh(p), p.slab_young) },
    obstacles = not soft and { ball = stiction.obstacle { shape = stiction.rigid.sphere { centre = centre(p), radius = p.radius },
      times = way.times, x = way.x, y = way.y, z = way.z } } or nil,
    pairs = { iron = stiction.pair { secondary = soft and "ball.cap" or "slab.top", primary = soft and "slab.top" or "ball",
      discretisation = p.contact, friction = stiction.friction.coulomb { mu = p.mu } } },
    motions = motions,
    scheme = stiction.scheme.quasi_static {},
    schedule = stiction.schedule { stages = {
      stiction.stage { to = 1*s, steps = p.steps_down }, stiction.stage { to = 2*s, steps = steps },
      stiction.stage { to = 3*s, steps = steps } } },
    probes = { ball = soft and stiction.probe.force { set = "ball.flat" } or stiction.probe.rigid { obstacle = "ball" },
      energy = stiction.probe.energy { audit = true } },
  }
end

--- Of what draws a ball, over its probe's forces: those of contact are on a rigid one.
local function sign(p) return p.ball == "soft" and 1 or -1 end

--- At the end of the way: force along and across the second leg and downwards, N.
local function ends(run, p)
  local c, sine = math.cos(p.angle), math.sin(p.angle)
  local function last(component) return sign(p) * run:last("ball", "force_" .. component) end
  local x, y = last("x"), last("y")
  return { along = -sine * x + c * y, across = c * x + sine * y, normal = -last("z") }
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

--- The cases of one ball and one contact.
local function kind(p) return p.ball .. " ball, " .. p.contact:gsub("_", " ") end

--- Difference of the forces from those by the shortest steps, over the normal one.
local function row(check, cases, quantity, difference, bounds)
  local finest, others = cases[#cases], {}
  for i = 1, #cases - 1 do
    others[i] = { cases[i].p.facets, difference(cases[i].results, finest.results) / finest.results.normal }
  end
  check.proof { case = "Ironing in space by long steps, " .. kind(finest.p),
    quantity = quantity .. ", difference over the normal one",
    kind = "ours", source = ("steps of %g facets"):format(finest.p.facets), reference = 0, scale = 1, values = others,
    tolerance = bounds.allowed, order = bounds.order, resolution = "facets a step", run = cases[#cases - 1] }
end

--- Of nodes alone: on so coarse a mesh the forces of mortar pairs are others, by 5 to 8 %.
local function force_figure(cases, component, direction, label)
  local curves, colours, count = {}, {}, 0
  for i, case in ipairs(cases) do
    if case.p.contact ~= "node_to_segment" then break end
    if not colours[case.p.facets] then
      count = count + 1
      colours[case.p.facets] = count
    end
    local force, x, y = case:series("ball", "force_" .. component), {}, {}
    for k, t in ipairs(case.time) do
      if t > 1 - 1e-9 then
        x[#x + 1], y[#y + 1] = (t - 1) * leg(case.p).si, direction * sign(case.p) * force[k]
      end
    end
    curves[i] = { label = ("%s ball, %.3g facets a step"):format(case.p.ball, case.p.facets), x = x, y = y,
      colour = colours[case.p.facets], style = case.p.ball == "rigid" and "dash" or nil }
  end
  return stiction.figure.lines { name = "force_" .. component, title = label, curves = curves, legend = "below",
    x = { label = "travel", unit = "mm" }, y = { label = label, unit = "N" } }
end

--- A rigid ball that steps farther goes through nodes of the slab at once, and the step is cut.
local function sweep(kinds)
  local rows = {}
  for _, of in ipairs(kinds) do
    for _, facets in ipairs(of.facets) do rows[#rows + 1] = { ball = of[1], contact = of[2], facets = facets } end
  end
  return rows
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
    allowed_normal = { 0.002, "the same, of the rigid ball's tangential force, too" },
    allowed_cut = { 0.004, "the same, of mortar pairs, whose samples are those of where a step begins" },
    order = { 0.8, "at least, of the tangential force in the step" }, most = { 8, "iterations of a step; ours" },
    most_rigid = { 4, "the same of a rigid ball; ours" },
  },
  sweep = sweep { { "soft", "node_to_segment", facets = { 5, 2.5, 5 / 3, 1, 0.5, 0.25 } },
    { "rigid", "node_to_segment", facets = { 2.5, 5 / 3, 1, 0.5, 0.25 } },
    { "soft", "mortar", facets = { 5, 2.5, 1, 0.5 } }, { "rigid", "mortar", facets = { 2.5, 5 / 3, 1, 0.5, 0.25 } } },
  quick = { sweep = sweep { { "soft", "node_to_segment", facets = { 5, 2.5, 1 } },
    { "rigid", "node_to_segment", facets = { 2.5, 5 / 3, 1, 0.5 } }, { "rigid", "mortar", facets = { 2.5, 5 / 3, 1, 0.5 } } },
    set = { allowed = 0.04 } },
  case_id = function(p)
    return (p.contact == "mortar" and "mortar_" or "") .. (p.ball == "soft" and "%.3g" or "rigid_%.3g"):format(p.facets)
  end,
  scene = scene,
  results = {
    result("normal", "N", "normal force at the end", function(run, p) return ends(run, p).normal end),
    result("along", "N", "force along the second leg", function(run, p) return ends(run, p).along end),
    result("across", "N", "force across the second leg", function(run, p) return ends(run, p).across end),
    result("most_iterations", "1", "of a step that slides", function(run) return numeric.max(iterations(run)) end),
    result("mean_iterations", "1", "of the steps that slide", function(run) return numeric.mean(iterations(run)) end),
  },
  check = function(cases, check)
    local p, of, kinds = cases[1].p, {}, {}
    for _, case in ipairs(cases) do
      local name = kind(case.p)
      if not of[name] then
        of[name], kinds[#kinds + 1] = {}, name
      end
      table.insert(of[name], case)
    end
    for _, name in ipairs(kinds) do
      local one = of[name][1].p
      local tangential = one.ball == "soft" and { allowed = p.allowed, order = p.order } or { allowed = p.allowed_normal }
      row(check, of[name], "tangential force", function(a, b)
        return math.sqrt((a.along - b.along) ^ 2 + (a.across - b.across) ^ 2)
      end, tangential)
      row(check, of[name], "normal force", function(a, b) return math.abs(a.normal - b.normal) end,
        { allowed = one.contact == "mortar" and p.allowed_cut or p.allowed_normal })
    end
    for _, case in ipairs(cases) do
      check.within(("%s: Newton iterations"):format(case.id), case.results.most_iterations, 1,
        case.p.ball == "soft" and case.p.most or case.p.most_rigid)
      check.ledger(case)
    end
  end,
  figures = function(cases)
    return { force_figure(cases, "z", -1, "normal force"), force_figure(cases, "y", 1, "tangential force in y") }
  end,
}
