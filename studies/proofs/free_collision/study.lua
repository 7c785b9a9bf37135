-- Two free bodies that collide: what becomes of momentum, angular momentum and energy.
--
--      ______   v                      bars, head on: the shorter one stops and has given away all its momentum, so that they
--     |      | -->  ______             part at 1/r of the speed at which they met, r the ratio of their lengths; with r = 1
--     |      |     |      |            nothing of the energy is left to vibrate
--     |______|     |      |            squares and cubes, off centre: they fly apart and spin; momentum and its moment stay
--                  |______|
--
--     ./stiction run studies/proofs/free_collision
local stiction = require "stiction"
local units = stiction.units
local m, mm, s, ms, kg, MPa, Pa = units.m, units.mm, units.s, units.ms, units.kg, units.MPa, units.Pa
local schemes = stiction.schemes

local title = "Two free bodies collide: what each scheme keeps"

local function bar(p, length, x, speed)
  local cell = p.length / p.cells
  return stiction.body {
    mesh = stiction.mesh.block { origin = { x, 0*m }, size = { length, cell }, cells = { math.floor(length.si / cell.si + 0.5), 1 } },
    material = stiction.material.linear_elastic { young = p.bar_young, poisson = 0 }, density = p.bar_density,
    velocity = { speed, 0*m/s },
  }
end

local function transit(p) return p.length.si / math.sqrt(p.bar_young.si / p.bar_density.si) end

local function bars(p)
  local touch = p.gap.si / p.bar_speed.si
  local duration = touch + (2 * p.ratio + 1) * transit(p)
  return {
    bodies = { striker = bar(p, p.length, 0*m, p.bar_speed), struck = bar(p, p.ratio * p.length, p.length + p.gap, 0*m/s) },
    motions = { stiction.motion.fix { set = "striker.all", x = false }, stiction.motion.fix { set = "struck.all", x = false } },
    stage = stiction.stage { to = duration * s, steps = math.floor(duration / transit(p) * p.cells + 0.5) },
  }
end

--- A square or a cube whose first corner is at x and `up` sideways.
local function lump(p, x, up, speed)
  local size, cells, origin, velocity = {}, {}, { x }, { speed }
  for c = 1, p.kind == "cubes" and 3 or 2 do
    size[c], cells[c], origin[c], velocity[c] = p.side, p.cells, origin[c] or up / (c - 1), velocity[c] or 0*m/s
  end
  local mesh = p.kind == "cubes" and stiction.mesh.box or stiction.mesh.block
  return stiction.body { mesh = mesh { origin = origin, size = size, cells = cells },
    material = stiction.material.neo_hookean { young = p.young, poisson = p.poisson }, density = p.density, velocity = velocity }
end

local function lumps(p)
  return {
    kinematics = p.kind == "cubes" and "three_dimensional" or "plane_strain",
    bodies = { striker = lump(p, 0*m, 0*m, p.speed), struck = lump(p, p.side + p.slit, p.offset, 0*m/s) },
    friction = stiction.friction.coulomb { mu = p.mu },
    stage = stiction.stage { to = p.duration, steps = p.steps },
  }
end

local function scene(p)
  local made = p.kind == "bars" and bars(p) or lumps(p)
  return stiction.scene {
    kinematics = made.kinematics, bodies = made.bodies, motions = made.motions,
    pairs = { hit = stiction.pair { secondary = "striker.right", primary = "struck.left", friction = made.friction } },
    scheme = schemes.make(p.scheme), control = stiction.control { force_tolerance = 1e-12 },
    schedule = stiction.schedule { stages = { made.stage } },
    output = stiction.output { frames = 0 },
    probes = { momentum = stiction.probe.momentum {}, energy = stiction.probe.energy { audit = true } },
  }
end

local axes = { bars = { "x", "y" }, squares = { "x", "y" }, cubes = { "x", "y", "z" } }
local moments = { bars = { "l" }, squares = { "l" }, cubes = { "l_x", "l_y", "l_z" } }

local function columns(p, prefix)
  local list = {}
  for i, axis in ipairs(axes[p.kind]) do list[i] = prefix .. "_" .. axis end
  return list
end

--- Length of a vector of columns at each time, each less its first value where `change` says so.
local function lengths(run, names, change)
  local sums = {}
  for _, name in ipairs(names) do
    local values = run:series("momentum", name)
    for i, value in ipairs(values) do
      sums[i] = (sums[i] or 0) + (value - (change and values[1] or 0)) ^ 2
    end
  end
  return stiction.numeric.map(sums, math.sqrt)
end

local function largest(run, names, change) return (stiction.numeric.max(lengths(run, names, change))) end

--- Change of a vector at the end over its start.
local function changed(run, names)
  local change, first = lengths(run, names, true), lengths(run, names)[1]
  return change[#change] / first
end

local function start(run) return run:series("momentum", "p_x")[1] end

--- Difference of the speeds at the end over that at the start.
local function restitution(run, p)
  if p.kind ~= "bars" then return 0 end
  return (run:last("momentum", "struck_p_x") / p.ratio - run:last("momentum", "striker_p_x")) / start(run)
end

--- Most that the steps have made of the energy, and what they have lost in the end, over that at the start.
local function made(run)
  return math.max(0, -run:min("energy", "scheme_loss")) / run:series("energy", "kinetic")[1]
end

local function bar_checks(cases, check)
  for _, scheme in ipairs { "default", "cells" } do
    for _, ratio in ipairs { 1, 2 } do
      local runs, values = cases:where { kind = "bars", ratio = ratio, scheme = scheme }, {}
      for i, case in ipairs(runs) do values[i] = { case.p.length / case.p.cells, case.results.restitution } end
      check.proof { case = ("Two bars, lengths 1 : %d, %s scheme"):format(ratio, scheme),
        quantity = "speed of parting over that of meeting", kind = "exact", reference = 1 / ratio, values = values,
        source = "Saint-Venant 1867; Johnson 1985, 11.1: the shorter one stops",
        resolution = "m cell", tolerance = 0.03, run = runs[#runs] }
    end
  end
end

local function lump_checks(cases, check, kind)
  for _, scheme in ipairs { "default", "cells" } do
    local runs = cases:where { kind = kind, scheme = scheme }
    local function row(quantity, result, tolerance)
      local values = {}
      for i, case in ipairs(runs) do values[i] = { case.p.duration / case.p.steps, case.results[result] } end
      check.proof { case = ("Two %s off centre, %s scheme"):format(kind, scheme), quantity = quantity, kind = "exact",
        source = "no outer forces", reference = 0, scale = 1, values = values, resolution = "s step", tolerance = tolerance,
        run = runs[#runs] }
    end
    row("change of momentum over its start", "drift_end", scheme == "cells" and 1e-10 or 0.01)
    row("change of angular momentum over its start", "spin_drift_end", 0.01)
  end
end

--- What holds at every step, whatever the mesh and the step.
local function exact_checks(cases, check)
  for _, case in ipairs(cases) do
    local r = case.results
    check.within(case.id .. ": both sides of the contact together, over the impulse", r.reaction, 0, 1e-12)
    if case.p.scheme ~= "default" then -- whose contact nodes are at most half of the last step's gain ahead of the others
      check.within(case.id .. ": change of momentum less all impulses, over that at the start", r.unaccounted, 0, 1e-10)
      check.within(case.id .. ": change of momentum over that at the start", r.drift, 0, 1e-10)
    end
    if case.p.scheme == "cells" then
      check.within(case.id .. ": energy made over that at the start", r.made, 0, 1e-9)
    end
    check.ledger(case)
  end
end

local function table_of(cases)
  local rows = {}
  for i, case in ipairs(cases:where { kind = "squares", steps = 200 }) do
    local r = case.results
    rows[i] = { case.p.scheme, r.drift, r.spin_drift, r.made, r.lost }
  end
  return { title = title, rows = rows, columns = { "scheme", "change of momentum", "change of angular momentum", "energy made",
    "energy lost in the end" } }
end

local shown = { "default", "cells", "massless", "paper", "moreau_jean", "backward_euler", "central_difference" }

local function curves_of(cases, y_of)
  local curves = {}
  for _, name in ipairs(shown) do
    local case = cases:find { kind = "squares", scheme = name, steps = 200 }
    if case then curves[#curves + 1] = { label = name, x = case.time, y = y_of(case) } end
  end
  return curves
end

local function figures(cases)
  local function relative(group, names)
    return function(case)
      local y = {}
      for _, name in ipairs(names) do
        for i, value in ipairs((case:series(group, name))) do y[i] = (y[i] or 0) + value end
      end
      local first = y[1]
      return stiction.numeric.map(y, function(v) return v / first end)
    end
  end
  local x = { label = "time", unit = "ms" }
  return {
    stiction.figure.lines { name = "spin", title = "Angular momentum of two squares that collide off centre, 200 steps", x = x,
      y = { label = "over its start", unit = "1" }, legend = "below", curves = curves_of(cases, relative("momentum", { "l" })) },
    stiction.figure.lines { name = "energy", title = "Energy of two squares that collide off centre, 200 steps", x = x,
      y = { label = "over its start", unit = "1" }, legend = "below",
      curves = curves_of(cases, relative("energy", { "kinetic", "strain" })) },
  }
end

local function sweep_of(t)
  local cases = {}
  for _, scheme in ipairs { "default", "cells" } do
    for _, ratio in ipairs { 1, 2 } do
      for _, cells in ipairs(t.bars) do cases[#cases + 1] = { kind = "bars", scheme = scheme, ratio = ratio, cells = cells } end
    end
    for _, steps in ipairs(t.steps) do
      cases[#cases + 1] = { kind = "squares", scheme = scheme, cells = t.squares, steps = steps }
      cases[#cases + 1] = { kind = "cubes", scheme = scheme, cells = t.cubes, steps = steps }
    end
  end
  for _, name in ipairs(shown) do
    if name ~= "default" and name ~= "cells" then
      cases[#cases + 1] = { kind = "squares", scheme = name, cells = t.squares, steps = 200 }
    end
  end
  for _, case in ipairs(cases) do case.ratio, case.steps = case.ratio or 1, case.steps or 0 end
  return cases
end

return stiction.study {
  title = "Two free bodies collide",
  question = "What do impulses, momentum, angular momentum and energy of a collision add up to?",
  given = {
    bar_young = { 900*Pa, "c = 30 m/s" }, bar_density = { 1*kg/m^3, "" }, bar_speed = { 1*m/s, "" }, length = { 5*m, "of the striker" },
    gap = { 0.25*m, "" },
    side = { 10*mm, "of squares and cubes" }, young = { 1*MPa, "" }, poisson = { 0.3, "" }, density = { 1000*kg/m^3, "" },
    speed = { 4*m/s, "an eighth of the waves'" }, mu = { 0.2, "" },
  },
  chosen = {
    slit = { 0.2*mm, "between the lumps" }, offset = { 4*mm, "sideways, half of it along z: makes them spin" },
    duration = { 4*ms, "they part after 1.2 ms" },
  },
  sweep = sweep_of { bars = { 25, 50, 100 }, steps = { 100, 200, 400 }, squares = 8, cubes = 4 },
  quick = { sweep = sweep_of { bars = { 25, 50 }, steps = { 100, 200 }, squares = 4, cubes = 2 } },
  case_id = function(p)
    if p.kind == "bars" then return ("bars_%s_%d_%d"):format(p.scheme, p.ratio, p.cells) end
    return ("%s_%s_%d"):format(p.kind, p.scheme, p.steps)
  end,
  scene = scene,
  results = {
    { name = "restitution", unit = "1", meaning = "of bars: speed of parting over that of meeting", restitution },
    { name = "drift", unit = "1", meaning = "largest change of all momentum over that at the start",
      function(run, p) return largest(run, columns(p, "p"), true) / start(run) end },
    { name = "unaccounted", unit = "1", meaning = "change of momentum less all impulses, over that at the start",
      function(run, p) return largest(run, columns(p, "unaccounted_p")) / start(run) end },
    { name = "reaction", unit = "1", meaning = "impulses of both sides together over that of one",
      function(run, p) return largest(run, columns(p, "hit_sum")) / largest(run, columns(p, "hit_impulse")) end },
    { name = "spin_drift", unit = "1", meaning = "largest change of angular momentum over its start",
      function(run, p) return largest(run, moments[p.kind], true) / math.max(largest(run, moments[p.kind]), 1e-300) end },
    { name = "drift_end", unit = "1", meaning = "change of all momentum at the end over that at the start",
      function(run, p) return changed(run, columns(p, "p")) end },
    { name = "spin_drift_end", unit = "1", meaning = "change of angular momentum at the end over its start",
      function(run, p) return changed(run, moments[p.kind]) end },
    { name = "made", unit = "1", meaning = "most that the steps have made of the energy, over that at the start", made },
    { name = "lost", unit = "1", meaning = "what the steps have lost of it in the end",
      function(run) return run:last("energy", "scheme_loss") / run:series("energy", "kinetic")[1] end },
  },
  check = function(cases, check)
    exact_checks(cases, check)
    bar_checks(cases, check)
    for _, kind in ipairs { "squares", "cubes" } do lump_checks(cases, check, kind) end
    check.table(table_of(cases))
  end,
  figures = figures,
}
