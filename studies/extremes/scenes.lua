-- Small scenes that the extremes are tried on: each a table of ordinary SI values, and a function making the scene.
local stiction = require "stiction"
local dent = require "dent"
local units = stiction.units

local scenes = {}

--- Units of a cell: SI times its factors of length, mass and time, so that the same numbers mean a rescaled problem.
local function unit_set(q)
  local m, kg, s = units.m * q.L, units.kg * q.M, units.s * q.T
  return { m = m, kg = kg, s = s, Pa = kg / m / s^2, N = kg * m / s^2, J_m2 = kg / s^2,
    stiffness = kg / m^2 / s^2, drag = kg / s }
end

local function list(values, unit)
  local scaled = {}
  for i, value in ipairs(values) do
    scaled[i] = value * unit
  end
  return scaled
end

local function adhesion_of(q, u)
  if not q.C then
    return nil
  end
  return stiction.adhesion.rcc { C_n = q.C * u.stiffness, C_t = q.C * u.stiffness, w = q.w * u.J_m2,
    b = q.b * u.drag, beta0 = q.beta0 }
end

local function pair_of(q, u, secondary, primary)
  return stiction.pair { secondary = secondary, primary = primary, adhesion = adhesion_of(q, u),
    friction = q.mu and stiction.friction.coulomb { mu = q.mu } or nil, discretisation = q.discretisation,
    reach = q.reach and q.reach * u.m or nil }
end

local function material_of(q, u, factor)
  return stiction.material[q.material] { young = q.E * (factor or 1) * u.Pa, poisson = q.nu }
end

local function body_of(q, u, mesh, t)
  return stiction.body { mesh = mesh, material = material_of(q, u, t and t.factor), density = q.rho * u.kg / u.m^3,
    interpolation = q.interpolation, plane_stress = q.sheet, velocity = t and t.velocity, relief = t and t.relief,
    relaxing = q.relax and { { share = q.share, bulk_share = q.bulk_share, time = q.relax * u.s } } or nil,
    damping = q.eta and stiction.damping.kelvin_voigt { shear_viscosity = q.eta * u.Pa * u.s,
      bulk_viscosity = q.eta * u.Pa * u.s } or nil }
end

--- Of two waves over its sole, `relief` high.
local function relief_of(q, u)
  return q.relief and stiction.relief { set = "bottom", size = { q.size * u.m }, points = { 512 },
    surface = stiction.surface.wave { amplitude = q.relief * u.m, wavelengths = { q.size / 2 * u.m } } } or nil
end

local function block(u, origin, size, cells)
  return stiction.mesh.block { origin = list(origin, u.m), size = list(size, u.m), cells = cells }
end

local function node(u, set, at)
  return stiction.probe.node { set = set, near = list(at, u.m) }
end

--- Stages that end at the given times; one single step over all of them where the cell asks for it.
local function schedule_of(q, u, times)
  local stages = {}
  for _, time in ipairs(q.whole and { times[#times] } or times) do
    stages[#stages + 1] = stiction.stage { to = time * q.pace * u.s, steps = q.whole and 1 or q.steps }
  end
  return stiction.schedule { stages = stages, halvings = q.halvings }
end

local function path(q, u, t)
  local times = {}
  for i, time in ipairs(t.times) do
    times[i] = time * q.pace
  end
  if t.turn then -- while it is held down, about the middle of the block's top
    return stiction.motion.turn { set = t.set, times = list(times, u.s), x = list(t.x, u.m), y = list(t.y, u.m),
      angle = list({ 0, 0, t.turn, t.turn }, units.rad), centre = list({ 0, q.height }, u.m) }
  end
  return stiction.motion.drive { set = t.set, times = list(times, u.s), x = t.x and list(t.x, u.m),
    y = t.y and list(t.y, u.m), z = t.z and list(t.z, u.m) }
end

local ordinary = { L = 1, M = 1, T = 1, E = 1e6, nu = 0.3, rho = 1000, material = "linear_elastic", pace = 1, beta0 = 0, share = 1,
  interpolation = "plain", discretisation = "node_to_segment", halvings = 10 }

local function floor()
  return { floor = stiction.obstacle { shape = stiction.rigid.plane {} } }
end

local output = stiction.output { frames = 0 }

--- One driven cell on a plane: bonds for 1 s, is drawn off by `pull`. The law alone.
scenes.law = {
  values = { size = 0.01, C = 1e9, w = 1, b = 2, pull = 2e-4, steps = 40, until_pull = 1.01 },
  make = function(q, u)
    return {
      bodies = { block = body_of(q, u, block(u, { 0, 0 }, { q.size, q.size }, { 1, 1 })) },
      obstacles = floor(), pairs = { touch = pair_of(q, u, "block.bottom", "floor") },
      motions = { path(q, u, { set = "block.all", times = { 0, q.until_pull, 2 }, x = { 0, 0, 0 },
        y = { 0, 0, q.pull } }) },
      scheme = stiction.scheme.quasi_static {}, schedule = schedule_of(q, u, { 1, 2 }),
      probes = { point = stiction.probe.contact_point { pair = "touch", near = list({ 0, 0 }, u.m) },
        contact = stiction.probe.contact { pair = "touch" }, drive = stiction.probe.force { set = "block.all" },
        driven = node(u, "block.all", { 0, 0 }), energy = stiction.probe.energy { audit = true } },
    }
  end,
}

--- An adhesive block pressed onto a plane, held, drawn off.
scenes.punch = {
  values = { size = 0.01, height = 0.005, cells = { 6, 3 }, mu = 0.3, C = 1e9, w = 1, b = 0.5, press = 1e-4,
    pull = 1e-3, steps = 20, sink = 0 },
  make = function(q, u)
    return {
      bodies = { block = body_of(q, u, block(u, { -q.size / 2, -q.sink }, { q.size, q.height }, q.cells),
        { relief = relief_of(q, u) }) },
      obstacles = floor(), pairs = { touch = pair_of(q, u, "block.bottom", "floor") },
      motions = { path(q, u, { set = "block.top", times = { 0, 1, 2, 3 }, x = { 0, 0, 0, 0 },
        y = { 0, -q.press, -q.press, q.pull }, turn = q.turn }) },
      scheme = stiction.scheme.quasi_static {}, schedule = schedule_of(q, u, { 1, 2, 3 }),
      probes = { contact = stiction.probe.contact { pair = "touch" },
        line = stiction.probe.contact_line { pair = "touch" },
        drive = stiction.probe.force { set = "block.top", about = list({ 0, q.height }, u.m) },
        driven = node(u, "block.top", { 0, q.height }), energy = stiction.probe.energy { audit = true },
        sole = node(u, "block.bottom", { 0, 0 }) },
    }
  end,
}

--- Two blocks pressed together and slid: node to segment, and (slide_mortar) averaged.
scenes.slide = {
  values = { size = 0.01, upper = 0.006, height = 0.003, cells = { 4, 2 }, below = { 8, 3 }, at = 0.0013, mu = 0.3,
    press = 6e-5, slip = 6e-4, steps = 12, contrast = 1, sink = 0 },
  make = function(q, u)
    return {
      bodies = {
        lower = body_of(q, u, block(u, { 0, -q.height }, { q.size, q.height }, q.below)),
        upper = body_of(q, u, block(u, { q.at, -q.sink }, { q.upper, q.height }, q.cells), { factor = q.contrast }),
      },
      pairs = { touch = pair_of(q, u, "upper.bottom", "lower.top") },
      motions = { stiction.motion.fix { set = "lower.bottom" }, path(q, u, { set = "upper.top", times = { 0, 1, 2 },
        x = { 0, 0, q.slip }, y = { 0, -q.press, -q.press } }) },
      scheme = stiction.scheme.quasi_static {}, schedule = schedule_of(q, u, { 1, 2 }),
      probes = { contact = stiction.probe.contact { pair = "touch" },
        line = stiction.probe.contact_line { pair = "touch" },
        drive = stiction.probe.force { set = "upper.top" }, driven = node(u, "upper.top", { q.at, q.height }),
        sole = node(u, "upper.bottom", { q.at + q.upper / 2, 0 }),
        bed = node(u, "lower.top", { q.at + q.upper / 2, 0 }),
        energy = stiction.probe.energy { audit = true } },
    }
  end,
}

--- A bar that hits a wall endwise: pressure rho c v0 while a wave runs to its end and back.
scenes.bar = {
  values = { E = 900, rho = 1, nu = 0, size = 10, cells = 40, speed = 3, gap = 0.5, courant = 1 },
  make = function(q, u)
    local c, cell = math.sqrt(q.E / math.max(q.rho, 1e-9)), q.size / q.cells
    local last = q.last or q.gap / q.speed + 3 * q.size / c
    q.whole, q.steps = q.whole, q.count or math.ceil(last / (q.courant * cell / c))
    return {
      bodies = { bar = body_of(q, u, block(u, { 0, q.gap }, { cell, q.size }, { 1, q.cells }),
        { velocity = list({ 0, -q.speed }, u.m / u.s) }) },
      obstacles = floor(), pairs = { touch = pair_of(q, u, "bar.bottom", "floor") },
      motions = { stiction.motion.fix { set = "bar.all", y = false } },
      scheme = stiction.scheme.theta_xi {}, schedule = schedule_of(q, u, { last }),
      probes = { point = stiction.probe.contact_point { pair = "touch", near = list({ 0, q.gap }, u.m) },
        contact = stiction.probe.contact { pair = "touch" }, energy = stiction.probe.energy { audit = true },
        line = stiction.probe.contact_line { pair = "touch" }, sole = node(u, "bar.bottom", { 0, q.gap }) },
    }
  end,
}

--- Two boxes in a rigid channel, the upper driven down: uniaxial strain in space. Or tied (stack_tied), `apart` by so much.
scenes.stack = {
  values = { size = 0.01, heights = { 0.01, 0.005 }, cells = { 2, 2, 2 }, below = { 2, 2, 2 }, press = 2e-4, steps = 4,
    contrast = 1, shift = 0, apart = 0, solid = true },
  make = function(q, u)
    local lower, upper = q.heights[1], q.heights[2]
    local function box(z, height, cells, x)
      return stiction.mesh.box { origin = list({ x, 0, z }, u.m), size = list({ q.size, q.size, height }, u.m),
        cells = cells }
    end
    local motions = { stiction.motion.fix { set = "lower.bottom", x = false, y = false },
      path(q, u, { set = "upper.top", times = { 0, 1 }, z = { 0, -q.press } }) }
    for _, name in ipairs { "lower", "upper" } do
      motions[#motions + 1] = stiction.motion.fix { set = name .. ".all", z = false }
    end
    return {
      kinematics = "three_dimensional",
      bodies = { lower = body_of(q, u, box(-lower, lower, q.below, 0)),
        upper = body_of(q, u, box(q.apart, upper, q.cells, q.shift), { factor = q.contrast }) },
      pairs = not q.tied and { touch = pair_of(q, u, "upper.bottom", "lower.top") } or nil, motions = motions,
      constraints = q.tied and { stiction.constraint.tied { set = "upper.bottom", to = "lower.top" } } or nil,
      scheme = stiction.scheme.quasi_static {}, schedule = schedule_of(q, u, { 1 }),
      probes = { contact = q.tied and stiction.probe.force { set = "lower.bottom" } or stiction.probe.contact { pair = "touch" },
        line = not q.tied and stiction.probe.contact_line { pair = "touch" } or nil,
        drive = stiction.probe.force { set = "upper.top" }, driven = node(u, "upper.top", { q.shift, 0, upper }),
        energy = stiction.probe.energy { audit = true } },
    }
  end,
}

--- A single cell without support falls onto a plane.
scenes.drop = {
  values = { size = 0.01, E = 1e5, gap = 1e-4, g = 9.81, speed = 0, last = 0.04, steps = 200, eta = 3 },
  make = function(q, u)
    local corners = {}
    for i, at in ipairs { { 0, 0 }, { 1, 0 }, { 0, 1 }, { 1, 1 } } do
      corners["corner_" .. i] = node(u, "block.all", { at[1] * q.size, q.gap + at[2] * q.size })
    end
    corners.contact, corners.energy = stiction.probe.contact { pair = "touch" }, stiction.probe.energy { audit = true }
    corners.line = stiction.probe.contact_line { pair = "touch" }
    return {
      gravity = list({ 0, -q.g }, u.m / u.s^2),
      bodies = { block = body_of(q, u, block(u, { 0, q.gap }, { q.size, q.size }, { 1, 1 }),
        { velocity = list({ 0, -q.speed }, u.m / u.s) }) },
      obstacles = floor(), pairs = { touch = pair_of(q, u, "block.bottom", "floor") },
      scheme = q.static and stiction.scheme.quasi_static {} or stiction.scheme.theta_xi {},
      schedule = schedule_of(q, u, { q.last }), probes = corners,
    }
  end,
}

--- A pressed block that a spring draws along a plane, whose other end is moved: nothing else holds it sideways.
scenes.tie = {
  values = { size = 0.01, height = 0.005, cells = { 4, 2 }, mu = 0.3, press = 5e-5, k = 1e4, draw = 1e-3, steps = 10 },
  make = function(q, u)
    return {
      bodies = { block = body_of(q, u, block(u, { 0, 0 }, { q.size, q.height }, q.cells)) },
      obstacles = floor(), pairs = { touch = pair_of(q, u, "block.bottom", "floor") },
      motions = { path(q, u, { set = "block.top", times = { 0, 1, 2 }, y = { 0, -q.press, -q.press } }) },
      springs = { tie = stiction.spring { from = "block.top", stiffness = q.k * u.Pa * units.m, spread = q.spread,
        anchor = not q.spread and list({ 1, q.height }, u.m) or nil, along = q.line and "line" or nil,
        direction = not q.line and { 1, 0 } or nil, rest = q.rest and q.rest * u.m or nil,
        times = list({ 0, q.pace, 2 * q.pace }, u.s), x = list({ 0, 0, q.draw }, u.m) } },
      scheme = stiction.scheme.quasi_static {}, schedule = schedule_of(q, u, { 1, 2 }),
      probes = { contact = stiction.probe.contact { pair = "touch" },
        line = stiction.probe.contact_line { pair = "touch" }, tie = stiction.probe.spring { spring = "tie" },
        drive = stiction.probe.force { set = "block.top" }, driven = node(u, "block.top", { 0, q.height }),
        sole = node(u, "block.bottom", { q.size / 2, 0 }), energy = stiction.probe.energy { audit = true } },
    }
  end,
}

--- A ring of a long tube about the axis, radii size and size + wall, filled through its inner side and rounded by its stress.
scenes.tube = {
  values = { size = 0.01, wall = 0.01, revolved = true, cells = { 4, 1 }, press = 0, fill = 0.05, by = "amount", steps = 10,
    material = "neo_hookean" },
  make = function(q, u)
    local gas = q.by ~= "pressure"
    local blown = { set = "ring.left", times = list({ 0, 1 * q.pace }, u.s) }
    if q.by == "volume" then
      blown.volume = { 1, q.fill }
    else
      blown.pressure = list({ 0, q.fill * q.E }, u.Pa)
      blown.outside = q.outside and q.outside * q.E * u.Pa or nil
    end
    return {
      kinematics = "axisymmetric", bodies = { ring = body_of(q, u, block(u, { q.size, 0 }, { q.wall, q.size / 5 }, q.cells)) },
      motions = { stiction.motion.fix { set = "ring.all", y = true } },
      loads = { stiction.load[gas and "gas" or "pressure"](blown),
        q.gamma and stiction.load.surface_stress { set = "ring.right", gamma = q.gamma * q.E * q.size * u.J_m2 } or nil },
      scheme = stiction.scheme.quasi_static {}, schedule = schedule_of(q, u, { 1 }),
      probes = { gas = gas and stiction.probe.gas { set = "ring.left" } or nil, wall = node(u, "ring.left", { q.size, 0 }),
        energy = stiction.probe.energy { audit = true } },
    }
  end,
}

--- A suction cup pressed onto a plane and drawn off: air goes out under its rim, what is left holds it until the rim is off.
scenes.cup = {
  values = { size = 0.01, wall = 0.002, height = 0.003, revolved = true, mu = 0.5, outside = 0.1, leaks_at = 1e-5, press = 1e-3,
    pull = 6e-3, steps = 40, material = "neo_hookean", nu = 0.45 },
  make = function(q, u)
    local R, h, t = q.size, q.height, q.wall
    local function at(x, y, name)
      return stiction.edge { to = list({ x, y }, u.m), name = name }
    end
    local mesh = stiction.mesh.gmsh { size = t * u.m, start = list({ R, 0 }, u.m), edges = { at(R + t, 0, "rim"),
      at(R + t, h, "out"), at(t, h + t, "out"), at(0, h + t, "top"), at(0, h, "axis"), at(R, h - t, "under"), at(R, 0, "under") } }
    return {
      kinematics = "axisymmetric", bodies = { cup = body_of(q, u, mesh) }, obstacles = floor(),
      pairs = { touch = pair_of(q, u, "cup.rim", "floor") },
      motions = { path(q, u, { set = "cup.top", times = { 0, 1, 2 }, x = { 0, 0, 0 }, y = { 0, -q.press, q.pull } }) },
      loads = { stiction.load.gas { set = "cup.under", outside = q.outside * q.E * u.Pa, times = list({ 0, 2 * q.pace }, u.s),
        pressure = list({ 0, 0 }, u.Pa), seal = { 0, 1 }, leaks_at = q.leaks_at * u.m } },
      scheme = stiction.scheme.quasi_static {}, schedule = schedule_of(q, u, { 1, 2 }),
      probes = { gas = stiction.probe.gas { set = "cup.under" }, lip = node(u, "cup.under", { R, 0 }),
        contact = stiction.probe.contact { pair = "touch" }, line = stiction.probe.contact_line { pair = "touch" },
        drive = stiction.probe.force { set = "cup.top" }, driven = node(u, "cup.top", { 0, h + t }),
        energy = stiction.probe.energy { audit = true } },
    }
  end,
}

--- A rigid ball with three moments of inertia that flies onto a bed, spinning.
scenes.top = {
  values = { size = 0.01, gap = 1e-3, speed = 0.1, spin = { 3, 5, 20 }, mass = 1e-3, moments = { 1, 1.5, 2 }, slender = 1, mu = 0.3,
    eta = 3, E = 1e5, last = 0.2, steps = 100, solid = true },
  make = function(q, u)
    local own, J = 0.1 * q.mass * q.size ^ 2, {}
    for i, moment in ipairs(q.moments) do
      J[i] = moment * own * (i == 3 and q.slender or 1)
    end
    local ball = stiction.obstacle { shape = stiction.rigid.sphere { centre = list({ 0, 0, q.gap + q.size }, u.m), radius = q.size * u.m },
      mass = q.mass * u.kg, inertia_tensor = list(J, u.kg * u.m^2), velocity = list({ 0, 0, -q.speed }, u.m / u.s),
      spin = list(q.spin, units.rad / u.s) }
    local bed = stiction.mesh.box { origin = list({ -q.size, -q.size, -q.size }, u.m), size = list({ 2 * q.size, 2 * q.size, q.size }, u.m),
      cells = { 2, 2, 1 } }
    return {
      kinematics = "three_dimensional", bodies = { bed = body_of(q, u, bed) }, obstacles = { ball = ball },
      pairs = { touch = pair_of(q, u, "bed.top", "ball") }, motions = { stiction.motion.fix { set = "bed.bottom" } },
      scheme = stiction.scheme.theta_xi {}, schedule = schedule_of(q, u, { q.last }),
      probes = { contact = stiction.probe.contact { pair = "touch" }, line = stiction.probe.contact_line { pair = "touch" },
        momentum = stiction.probe.momentum {}, ball = stiction.probe.rigid { obstacle = "ball" },
        energy = stiction.probe.energy { audit = true } },
    }
  end,
}

--- Whether block i is asked about block k, each a whole boundary.
local asks = {
  neighbours = function(i, k) return k == i + 1 end,
  one_way = function(i, k) return k > i end,
  both_ways = function(i, k) return k ~= i end,
  everything = function() return true end,
}

local function crowd_pairs(q, u)
  local pairs, probes = {}, { energy = stiction.probe.energy { audit = true } }
  local function meet(name, secondary, primary)
    pairs[name] = pair_of(q, u, secondary, primary)
    probes[name] = stiction.probe.contact { pair = name }
    probes["line_" .. name] = stiction.probe.contact_line { pair = name }
  end
  for i = 1, 3 do
    meet(("floor_%d"):format(i), ("b%d.skin"):format(i), "floor")
    for k = 1, 3 do
      if asks[q.pairing](i, k) then
        meet(("b%d_b%d"):format(i, k), ("b%d.skin"):format(i), ("b%d.skin"):format(k))
      end
    end
  end
  return pairs, probes
end

--- A square whose whole boundary is one set.
local function square(u, x, y, size)
  local function corner(a, b)
    return list({ x + a * size, y + b * size }, u.m)
  end
  local edges = {}
  for i, at in ipairs { { 1, 0 }, { 1, 1 }, { 0, 1 }, { 0, 0 } } do
    edges[i] = stiction.edge { to = corner(at[1], at[2]), name = "skin" }
  end
  return stiction.mesh.gmsh { size = size * u.m, start = corner(0, 0), edges = edges }
end

--- Three loose blocks fall onto each other; in the extreme everything may touch everything.
scenes.crowd = {
  values = { size = 0.01, E = 1e5, gap = 1e-4, g = 9.81, last = 0.03, steps = 100, eta = 3, mu = 0.3, speed = 0,
    pairing = "neighbours" },
  make = function(q, u)
    local bodies = {}
    local pairs, probes = crowd_pairs(q, u)
    for i = 1, 3 do
      local y = q.gap + (i - 1) * (q.size + q.gap)
      bodies["b" .. i] = body_of(q, u, square(u, 0.31 * q.size * (i % 2), y, q.size),
        { velocity = list({ 0, -q.speed }, u.m / u.s) })
    end
    return { gravity = list({ 0, -q.g }, u.m / u.s^2), bodies = bodies, obstacles = floor(), pairs = pairs,
      scheme = q.static and stiction.scheme.quasi_static {} or stiction.scheme.theta_xi {},
      schedule = schedule_of(q, u, { q.last }), probes = probes }
  end,
}

--- Outline of a strip of thickness q.thick that goes down and up `q.folds + 1` times, q.clear between its legs; `name`
--- of its outer sides: left and right, of all else: skin.
local function serpentine(q, u)
  local right, left, pitch, n = { { 0, q.size } }, { { q.thick, q.size } }, q.thick + q.clear, q.folds
  for k = 0, n do
    local down, west = k % 2 == 0, k * pitch
    local own, other = down and west or west + q.thick, down and west + q.thick or west
    local low, high = down and 0 or q.size - q.thick, down and q.thick or q.size
    if k > 0 then
      right[#right + 1], left[#left + 1] = { own, right[#right][2] }, { other, left[#left][2] }
    end
    local tip = k == n and (down and 0.15 or 0.85) * q.size -- not flush with the leg beside it
    right[#right + 1], left[#left + 1] = { own, tip or low }, { other, tip or high }
  end
  local last_is_right = n % 2 == 1
  local edges = {}
  for i = 2, #right do
    local name = i == 2 and "left" or i == #right and last_is_right and "right" or "skin"
    edges[#edges + 1] = stiction.edge { to = list(right[i], u.m), name = name }
  end
  edges[#edges + 1] = stiction.edge { to = list(left[#left], u.m), name = "end" }
  for i = #left - 1, 1, -1 do
    local name = i == #left - 1 and not last_is_right and "right" or "skin"
    edges[#edges + 1] = stiction.edge { to = list(left[i], u.m), name = name }
  end
  edges[#edges + 1] = stiction.edge { to = list(right[1], u.m), name = "end" }
  return stiction.mesh.gmsh { size = q.cell * u.m, kind = "quad4", start = list(right[1], u.m), edges = edges }
end

--- A folded strip squeezed until its legs touch each other, and let go.
scenes.fold = {
  values = { size = 0.01, thick = 0.001, clear = 0.001, folds = 1, cell = 0.0005, press = 1.2e-3, mu = 0.3, steps = 24,
    material = "neo_hookean" },
  make = function(q, u)
    local width = q.folds * (q.thick + q.clear) + q.thick
    return {
      bodies = { strip = body_of(q, u, serpentine(q, u)) }, pairs = { touch = pair_of(q, u, "strip.skin", "strip.skin") },
      motions = { stiction.motion.fix { set = "strip.left" }, path(q, u, { set = "strip.right", times = { 0, 1, 2 },
        x = { 0, -q.press, 0 }, y = { 0, 0, 0 } }) },
      scheme = stiction.scheme.quasi_static {}, schedule = schedule_of(q, u, { 1, 2 }),
      probes = { contact = stiction.probe.contact { pair = "touch" },
        line = stiction.probe.contact_line { pair = "touch" }, drive = stiction.probe.force { set = "strip.right" },
        held = stiction.probe.force { set = "strip.left" }, driven = node(u, "strip.right", { width, 0.5 * q.size }),
        energy = stiction.probe.energy { audit = true } },
    }
  end,
}

scenes.dent = dent.scene { unit_list = list, adhesion_of = adhesion_of, schedule_of = schedule_of }

local variants = { slide_mortar = "slide", stack_mortar = "stack", stack_tied = "stack", dent_space = "dent" }

--- Values of a scene with the changes of a cell: ordinary ones where it has none.
function scenes.values_of(name, changes)
  local q = {}
  for _, layer in ipairs { ordinary, scenes[variants[name] or name].values, name == "dent_space" and dent.in_space or {}, changes } do
    for key, value in pairs(layer) do
      q[key] = value
    end
  end
  if variants[name] and variants[name] ~= "dent" then
    q.tied = name == "stack_tied"
    q.discretisation = not q.tied and "mortar" or nil
  end
  for _, key in ipairs(q.without or {}) do
    q[key] = nil
  end
  if q.tiny then
    q.steps, q.count = q.tiny, q.tiny
  end
  return q
end

--- The scene of this name with these values.
function scenes.make(name, q)
  local t = scenes[variants[name] or name].make(q, unit_set(q))
  t.output = output
  return stiction.scene(t)
end

return scenes
