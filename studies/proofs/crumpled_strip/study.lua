-- A wavy strip crumpled until its loops press on each other, and rub: contact of a surface with itself, with friction.
--
--     |-.   .-.   .-|      walls and ends come together along x until the loops of the strip touch and press each other
--     |  ) (   ) (  |      flat, two pairs of them above and one below; then the right end goes up, and they rub
--     | (   ) (   ) |
--     |  '-'   '-'  |
--
-- While it is only pressed, every plane through a crest or a trough is one of symmetry: half a wave between two rigid planes
-- ("cell") needs no contact with itself and must bear the same. Turned by 180 degrees, each loop that had the contact points
-- has the facets. Thrown together without any support, the strip keeps its momentum and its moment.
--
--     ./stiction run studies/proofs/crumpled_strip
local stiction = require "stiction"
local units = stiction.units
local m, mm, s, kg, MPa = units.m, units.mm, units.s, units.kg, units.MPa

local function half_wave(p) return 2 * p.R.si * math.sin(p.opening) end

--- How the outline is laid: in itself, or turned by 180 degrees about the origin.
local function sign(p) return p.model == "turned" and -1 or 1 end

--- Arcs of one side of the strip, `off` above its middle line, from crest to crest: {from, to, centre} from left to right.
local function side(p, off, count)
  local arcs, R, a, L = {}, p.R.si, p.opening, half_wave(p)
  for k = 0, count do -- 0: the crest at the left
    local up = k % 2 == 0 and 1 or -1
    local r, centre = R + up * off, { k * L, -up * R * math.cos(a) }
    local function at(angle) return { centre[1] + r * math.sin(angle), centre[2] + up * r * math.cos(angle) } end
    for piece = k == 0 and 0 or -2, k == count and -1 or 1 do
      arcs[#arcs + 1] = { from = at(piece * a / 2), to = at((piece + 1) * a / 2), centre = centre }
    end
  end
  return arcs
end

local function outline(p, count)
  local edges, turn = {}, sign(p)
  local function point(at) return { turn * at[1]*m, turn * at[2]*m } end
  local function edge(arc, to, name)
    edges[#edges + 1] = stiction.edge { to = point(to), centre = arc and point(arc.centre), name = name }
  end
  local lower, upper = side(p, -p.thick.si / 2, count), side(p, p.thick.si / 2, count)
  for _, arc in ipairs(lower) do
    edge(arc, arc.to, "lower")
  end
  edge(nil, upper[#upper].to, "right")
  for i = #upper, 1, -1 do
    edge(upper[i], upper[i].from, "upper")
  end
  edge(nil, lower[1].from, "left")
  return point(lower[1].from), edges
end

local function strip(p, count)
  local start, edges = outline(p, count)
  local thrown = p.model == "thrown"
  local rate = p.speed.si / (half_wave(p) * count / 2)
  return stiction.body { mesh = stiction.mesh.gmsh { size = p.h, kind = "quad8", start = start, edges = edges },
    material = stiction.material.neo_hookean { young = p.young, poisson = p.poisson }, density = p.density,
    velocity = thrown and { p.speed, 0*m/s } or nil, spin = thrown and { p.spin } or nil,
    velocity_gradient = thrown and { -rate / s, 0 / s, 0 / s, 0 / s } or nil }
end

--- Crests and troughs at the ends stay upright, and meet smooth walls there; walls and ends press in the first second. In the
--- next the right end goes up, if it is held at all.
local function held(p, press, rub)
  local turn = sign(p)
  local times, x = { 0*s, 1*s, 2*s }, { 0*m, -turn * press*m, -turn * press*m }
  return { stiction.motion.fix { set = "strip.left" },
    stiction.motion.drive { set = "strip.right", times = times, x = x, y = rub and { 0*m, 0*m, turn * rub*m } or nil } },
    function(at, moves)
      return stiction.obstacle { shape = stiction.rigid.plane { normal = { at > 0 and -turn or turn, 0 }, point = { turn * at*m, 0*m } },
        times = moves and times or nil, x = moves and x or nil }
    end
end

local function pair(secondary, primary, mu)
  return stiction.pair { secondary = secondary, primary = primary, friction = mu and stiction.friction.coulomb { mu = mu } or nil }
end

local function itself(p)
  return { upper = pair("strip.upper", "strip.upper", p.mu), lower = pair("strip.lower", "strip.lower", p.mu) }
end

local function pressed(p)
  local cell = p.model == "cell"
  local length = half_wave(p) * (cell and 1 or p.waves)
  local motions, wall = held(p, p.press * length, not cell and p.rub.si or nil)
  local pairs = cell and { upper = pair("strip.upper", "right") } or itself(p)
  pairs.at_left = pair("strip.lower", "left")
  pairs.at_right = not cell and pair("strip.lower", "right") or nil
  return {
    obstacles = { left = wall(0, false), right = wall(length, true) }, pairs = pairs, motions = motions,
    scheme = stiction.scheme.quasi_static {},
    schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = p.steps },
      not cell and stiction.stage { to = 2*s, steps = p.steps } or nil } },
    probes = { held = stiction.probe.force { set = "strip.left" },
      wall = stiction.probe.contact { pair = "at_left" } },
  }
end

local function thrown(p)
  return { pairs = itself(p), scheme = stiction.scheme.theta_xi { contact_inertia = "cells" },
    control = stiction.control { force_tolerance = 1e-10 },
    schedule = stiction.schedule { stages = { stiction.stage { to = p.flight, steps = p.steps } } },
    probes = { momentum = stiction.probe.momentum {} } }
end

local function scene(p)
  local count = p.model == "cell" and 1 or p.waves
  local t = p.model == "thrown" and thrown(p) or pressed(p)
  t.bodies = { strip = strip(p, count) }
  t.output = stiction.output { frames = 10 }
  t.probes.upper = stiction.probe.contact { pair = "upper" }
  t.probes.lower = t.pairs.lower and stiction.probe.contact { pair = "lower" } or nil
  t.probes.energy = stiction.probe.energy { audit = true }
  return stiction.scene(t)
end

local function sweep_of(t)
  local cases = {}
  for _, model in ipairs { "itself", "turned", "cell" } do
    for _, h in ipairs(t.sizes) do cases[#cases + 1] = { model = model, waves = 2, h = h, steps = t.steps } end
  end
  for _, steps in ipairs(t.thrown) do cases[#cases + 1] = { model = "thrown", waves = 2, h = t.sizes[1], steps = steps } end
  for _, model in ipairs(t.long) do cases[#cases + 1] = { model = model, waves = 4, h = t.sizes[1], steps = t.steps } end
  return cases
end

--- Value at the end of the pressing, or 0 where the case has no such thing.
local function at_press(run, group, name)
  local there, value = pcall(function() return run:at(1*s, group, name) end)
  return there and math.abs(value) or 0
end

--- Largest change of a history over a scale.
local function drift(run, names, scale)
  local most = 0
  for _, name in ipairs(names) do
    local values = run:series("momentum", name)
    for _, value in ipairs(values) do most = math.max(most, math.abs(value - values[1])) end
  end
  return most / math.abs(run:series("momentum", scale)[1])
end

local function thrown_only(of)
  return function(run, p) return p.model == "thrown" and of(run) or 0 end
end

local function result(name, unit, meaning, of)
  return { name = name, unit = unit, meaning = meaning, of }
end

--- What loops bear on each other, over what half a wave on the finest mesh bears on a plane.
local function couples(cases, check, model, waves)
  local cells, runs = cases:where { model = "cell" }, cases:where { model = model, waves = waves }
  local reference, p = cells[#cells].results, runs[#runs] and runs[#runs].p
  local function row(quantity, wanted, allowed, of)
    local values = {}
    for i, case in ipairs(runs) do values[i] = { case.p.h, of(case.results) } end
    check.proof { case = ("Crumpled strip of %d half waves%s"):format(waves, model == "turned" and ", turned" or ""), kind = "ours",
      quantity = quantity, source = "half a wave between rigid planes", reference = wanted, values = values, resolution = "m cell",
      tolerance = allowed * p.h.si / 0.4e-3 * wanted, run = runs[#runs] }
  end
  if #runs == 0 then return end
  row("force between the loops above, over that of one pair", waves / 2, 0.01, function(r) return r.upper / reference.upper end)
  if waves > 2 then
    row("force between the loops below, over that of one pair", waves / 2 - 1, 0.01, function(r) return r.lower / reference.wall end)
  end
  row("force of the crest at the end, over that of half a wave", 1, 0.01, function(r) return r.force / reference.force end)
end

local function held_together(case, check)
  local r, p = case.results, case.p
  check.within(case.id .. ": deepest point over the thickness", r.deepest / p.thick.si, 0, 1e-6)
  check.ledger(case)
  if p.model == "cell" then return end
  check.non_decreasing(case.id .. ": friction only takes", (case:series("energy", "friction_loss")), 1e-9 * r.rubbed)
  check.within(case.id .. ": and takes something, over the work", r.rubbed / case:max("energy", "strain"), 1e-3, 1)
end

--- Linear momentum at every step; angular momentum but for the lumping of contact nodes, less with smaller steps.
local function thrown_together(runs, check)
  local spins = {}
  for i, case in ipairs(runs) do
    check.within(case.id .. ": change of momentum over its start", case.results.drift, 0, 1e-10)
    spins[i] = { case.p.flight.si / case.p.steps, case.results.spin_drift }
  end
  check.proof { case = "Strip thrown together", quantity = "change of angular momentum over its start", kind = "exact",
    source = "no outer forces", reference = 0, scale = 1, values = spins, resolution = "s step", tolerance = 0.01, run = runs[#runs] }
end

local function picture(case, at, name, title)
  return stiction.figure.field { name = name, case = case, time = at, array = "von_mises", label = "von Mises stress", unit = "MPa",
    deformed = true, title = title, show_time = false }
end

return stiction.study {
  title = "Crumpled strip",
  question = "Does a strip crumpled onto itself bear what symmetry says, keep its momentum, and lose what friction takes?",
  given = {
    R = { 3*mm, "of the middle line" }, opening = { math.rad(120), "from a crest to the end of its arc" }, thick = { 0.8*mm, "" },
    young = { 1*MPa, "neo-Hookean" }, poisson = { 0.3, "" }, density = { 1000*kg/m^3, "" }, mu = { 0.3, "dry" },
    press = { 0.62, "of the length" }, rub = { 3*mm, "of the right end" },
    speed = { 2*m/s, "thrown: sideways, and of its ends towards each other" }, spin = { 50*units.rad/s, "thrown: turning" },
  },
  chosen = { flight = { 8*units.ms, "they meet after 3 ms and part after 6 ms" } },
  sweep = sweep_of { sizes = { 0.4*mm, 0.27*mm, 0.2*mm }, steps = 20, thrown = { 200, 400 }, long = { "itself", "turned" } },
  quick = { sweep = sweep_of { sizes = { 0.4*mm }, steps = 12, thrown = { 200 }, long = {} } },
  case_id = function(p) return ("%s_%d_%.3g_%d"):format(p.model, p.waves, p.h.si * 1e3, p.steps) end,
  scene = scene,
  results = {
    result("force", "N/m", "of the crest at the left after pressing", function(run) return at_press(run, "held", "force_x") end),
    result("upper", "N/m", "of contact on the upper side, all loops", function(run) return at_press(run, "upper", "force_x") end),
    result("lower", "N/m", "of contact on the lower side with itself", function(run) return at_press(run, "lower", "force_x") end),
    result("wall", "N/m", "on the left wall", function(run) return at_press(run, "wall", "force_x") end),
    result("rubbed", "J/m", "lost by friction", function(run) return run:last("energy", "friction_loss") end),
    result("deepest", "m", "a point in the body it touches", function(run, p)
      return math.max(0, -run:min("upper", "gap_min"), p.model == "cell" and 0 or -run:min("lower", "gap_min"))
    end),
    result("drift", "1", "thrown: change of momentum over its start",
      thrown_only(function(run) return drift(run, { "p_x", "p_y" }, "p_x") end)),
    result("spin_drift", "1", "thrown: change of angular momentum over its start",
      thrown_only(function(run) return drift(run, { "l" }, "l") end)),
  },
  check = function(cases, check)
    for _, case in ipairs(cases) do
      held_together(case, check)
    end
    thrown_together(cases:where { model = "thrown" }, check)
    for _, waves in ipairs { 2, 4 } do
      couples(cases, check, "itself", waves)
      couples(cases, check, "turned", waves)
    end
    for _, case in ipairs(cases:where { model = "turned" }) do
      local own = cases:find { model = "itself", waves = case.p.waves, h = case.p.h }
      check.close(case.id .. ": it loses as much by rubbing as it does unturned", case.results.rubbed, own.results.rubbed, 0.05)
    end
  end,
  figures = function(cases)
    local runs = cases:where { model = "itself" }
    local case = runs[#runs]
    return { stiction.figure.panel { name = "strip", columns = 2, common_range = true, dpi = 150, figures = {
      picture(case, 1*s, "pressed", "pressed"), picture(case, 2*s, "rubbed", "and rubbed") } } }
  end,
}
