-- Bonds that form anew at another place, works of runs without inertia, and what runs say of surfaces, pairs and strains that a
-- model does not hold.
local test, equal, _, shared = ...
local engine = require "stiction.engine"
local stiction = require "stiction"
local units = stiction.units
local mm, s, kg, m, N, J, Pa, kPa, MPa, GPa = units.mm, units.s, units.kg, units.m, units.N, units.J, units.Pa, units.kPa, units.MPa,
  units.GPa
local drive, fix = stiction.motion.drive, stiction.motion.fix

local run = shared("runs").quasi_static "anew_runs"

local function near(got, wanted, part)
  if got ~= got or math.abs(got - wanted) > part * math.abs(wanted) then
    error(("%g is off %g by more than %g of it"):format(got, wanted, part), 2)
  end
end

local function says(case, words)
  return table.concat(case.result.remarks, "\n"):find(words, 1, true) ~= nil
end

local function warns(scene, words)
  scene.scheme, scene.output = stiction.scheme.quasi_static {}, stiction.output { frames = 0 }
  return shared("scenes").warned(scene, words)
end

local function block(t)
  return stiction.body { mesh = stiction.mesh.block { origin = t.origin, size = t.size or { 1*m, 1*m }, cells = t.cells or { 1, 1 } },
    density = 1000*kg/m^3, material = stiction.material.linear_elastic { young = t.young or 1*GPa, poisson = t.poisson or 0 },
    plane_stress = t.plane_stress, interpolation = t.interpolation }
end

local rcc = { w = 0.8*J/m^2, C_n = 1.3e6*N/m^3, C_t = 0.6e6*N/m^3 }
local laws = {
  slow = stiction.adhesion.rcc { w = rcc.w, C_n = rcc.C_n, C_t = rcc.C_t, b = 0.4*N*s/m },
  quick = stiction.adhesion.rcc { w = rcc.w, C_n = rcc.C_n, C_t = rcc.C_t, b = 0*N*s/m },
  potential = stiction.adhesion.exponential { phi_n = 0.8*J/m^2, sigma_max = 1000*Pa, delta_t = 0.7*mm, memory = "reversible" } }

--- Rests, is lifted by 50 mm, carried along by `aside`, lowered, rests, is lifted.
local function twice(law, aside, half_space)
  local times, y = { 0*s, 1*s, 2*s, 3*s, 4*s, 6*s, 7*s }, { 0*mm, 0*mm, 50*mm, 50*mm, 0*mm, 0*mm, 5*mm }
  local x, stages = { 0*mm, 0*mm, 0*mm, aside, aside, aside, aside }, {}
  for k, steps in ipairs { 20, 200, 10, 50, 20, 200 } do
    stages[k] = stiction.stage { to = times[k + 1], steps = steps }
  end
  local scene = { schedule = stiction.schedule { stages = stages }, probes = { sole = stiction.probe.contact_point { pair = "sole",
    near = { 0*m, 0*m } }, energy = stiction.probe.energy { audit = not half_space } } }
  if half_space then
    scene.kinematics = "plane_strain"
    scene.bodies = { block = stiction.body.half_space { young = 1*MPa, poisson = 0.3, size = { 1*m }, points = { 4 } } }
    scene.obstacles = { floor = stiction.obstacle.height_map { surface = stiction.surface.map { heights = { 0, 0, 0, 0 } },
      times = times, y = y, x = x } }
    scene.pairs = { sole = stiction.pair { secondary = "block.surface", primary = "floor", adhesion = law } }
  else
    scene.bodies, scene.obstacles = { block = block {} }, { floor = stiction.obstacle { shape = stiction.rigid.plane {} } }
    scene.pairs = { sole = stiction.pair { secondary = "block.bottom", primary = "floor", adhesion = law } }
    scene.motions = { drive { set = "block.all", times = times, x = x, y = y } }
  end
  local case = run(scene)
  local pull, largest = case:series("sole", "adhesion_n"), 0
  for k, t in ipairs(case.time) do
    largest = math.max(largest, t > 6 and math.abs(pull[k]) or 0)
  end
  return largest, case
end

test("what was torn off bonds as well at another place as at its own", function()
  for name, law in pairs(laws) do
    local here = twice(law, 0*mm)
    local there, told = twice(law, 20*mm)
    equal(here > 900, true)
    near(there, here, 1e-3)
    if name ~= "potential" then
      near((twice(law, 20*mm, true)), here, 1e-2)
    end
    for _, left in ipairs(told:series("energy", "unaccounted")) do
      equal(math.abs(left) < 1e-6 * 0.8, true)
    end
  end
end)

test("what slides while it is bonded, or is lifted less than that, stays with its place", function()
  local scene = { bodies = { block = block {} }, obstacles = { floor = stiction.obstacle { shape = stiction.rigid.plane {} } },
    pairs = { sole = stiction.pair { secondary = "block.bottom", primary = "floor", adhesion = laws.quick } },
    motions = { drive { set = "block.all", times = { 0*s, 1*s, 2*s, 3*s }, x = { 0*mm, 20*mm, 20*mm, 20*mm },
      y = { 0*mm, 0*mm, 3*mm, 0*mm } } },
    schedule = stiction.schedule { stages = { stiction.stage { to = 3*s, steps = 300 } } },
    probes = { sole = stiction.probe.contact_point { pair = "sole", near = { 0*m, 0*m } } } }
  near(run(scene):last("sole", "beta"), 0.8 / (0.6e6 * 0.0198 ^ 2), 1e-6) -- bonded at the end of the first step
end)

test("what slid away in contact and comes off by little does not bond anew", function()
  local times = { 0*s, 1*s, 2*s, 3*s, 4*s }
  local scene = { bodies = { block = block {} }, obstacles = { floor = stiction.obstacle { shape = stiction.rigid.plane {} } },
    pairs = { sole = stiction.pair { secondary = "block.bottom", primary = "floor", adhesion = laws.slow } },
    motions = { drive { set = "block.all", times = times, x = { 0*mm, 60*mm, 60*mm, 60*mm, 60*mm },
      y = { 0*mm, 0*mm, 0.1*mm, 0*mm, 0*mm } } },
    schedule = stiction.schedule { stages = { stiction.stage { to = 4*s, steps = 400 } } },
    probes = { sole = stiction.probe.contact_point { pair = "sole", near = { 0*m, 0*m } } } }
  equal(run(scene):last("sole", "beta") < 1 / 400, true)
end)

test("a bond without viscosity that forms takes what it gains; the scheme loses none of it", function()
  local _, case = twice(laws.quick, 20*mm)
  local lost = case:last("energy", "bonding_loss")
  near(lost, 2 * 0.8, 0.01) -- whole at once, twice
  equal(math.abs(case:last("energy", "scheme_loss")) < 0.02 * lost, true)
end)

local function pad(steps)
  return { bodies = { pad = stiction.body { mesh = stiction.mesh.block { origin = { -5*mm, 0*mm }, size = { 10*mm, 4*mm },
      cells = { 10, 4 } }, material = stiction.material.neo_hookean { young = 1*MPa, poisson = 0.35 }, density = 1000*kg/m^3 } },
    obstacles = { floor = stiction.obstacle { shape = stiction.rigid.plane {} } },
    pairs = { sole = stiction.pair { secondary = "pad.bottom", primary = "floor", friction = stiction.friction.coulomb { mu = 0.4 } } },
    motions = { drive { set = "pad.top", times = { 0*s, 1*s, 2*s }, x = { 0*mm, 0*mm, 2*mm }, y = { 0*mm, -0.3*mm, -0.5*mm } } },
    schedule = stiction.schedule { stages = { stiction.stage { to = 2*s, steps = steps } } },
    probes = { energy = stiction.probe.energy { audit = true } } }
end

test("works and what friction takes of runs without inertia are of second order in the step", function()
  local coarse, middle, fine = run(pad(20)), run(pad(40)), run(pad(320))
  for _, column in ipairs { "motion_work", "friction_loss" } do
    local wanted = fine:last("energy", column)
    near(coarse:last("energy", column), wanted, 0.01)
    near(middle:last("energy", column), wanted, 0.003)
  end
  equal(math.abs(middle:last("energy", "unaccounted")) < 1e-6 * middle:last("energy", "motion_work"), true)
end)

test("their ledger closes under weight from the first step on, and with stabilisation", function()
  local scene = pad(20)
  scene.gravity, scene.scheme = { 0*m/s^2, -2000*m/s^2 }, stiction.scheme.quasi_static { stabilisation = 0.01 }
  local case = shared("runs").below "anew_runs/heavy" (scene)
  equal(case.result.verdict, "finished")
  local work = case:last("energy", "motion_work")
  equal(case:last("energy", "stabilisation_loss") > 1e-4 * work, true)
  for _, left in ipairs(case:series("energy", "unaccounted")) do
    equal(math.abs(left) < 1e-6 * work, true)
  end
end)

test("a block that is only lifted off makes no energy, whatever its rounding is", function()
  local case = run { bodies = { block = block { size = { 10*mm, 10*mm }, cells = { 2, 2 }, young = 1*MPa, poisson = 0.3 } },
    obstacles = { floor = stiction.obstacle { shape = stiction.rigid.plane {} } },
    pairs = { sole = stiction.pair { secondary = "block.bottom", primary = "floor" } },
    motions = { drive { set = "block.top", times = { 0*s, 1*s }, x = { 0*mm, 0*mm }, y = { 0*mm, 1*mm } } },
    schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = 10 } } }, probes = { e = stiction.probe.energy {} } }
  equal(says(case, "made energy"), false)
end)

test("where every node is driven no step is cut for energies that are rounding", function()
  local case = run { bodies = { block = block {} }, obstacles = { floor = stiction.obstacle { shape = stiction.rigid.plane {} } },
    pairs = { sole = stiction.pair { secondary = "block.bottom", primary = "floor", adhesion = stiction.adhesion.dugdale {
      sigma0 = 500*Pa, h0 = 1.1*mm, ramp = 0.15, memory = "irreversible" } } },
    motions = { drive { set = "block.all", times = { 0*s, 1*s }, x = { 0*mm, 3*mm }, y = { 0*mm, 0*mm } } },
    schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = 40 } } }, probes = { e = stiction.probe.energy {} } }
  equal(#case.time, 41)
  equal(says(case, "made energy"), false)
end)

local space = "three_dimensional"
local function pressed(points, boundary)
  return run { kinematics = space, bodies = { plate = stiction.body.half_space { young = 1*MPa, poisson = 0.3, size = { 2*mm, 2*mm },
      points = { points, points }, boundary = boundary, depth = boundary == "periodic" and 2*mm or nil } },
    obstacles = { ball = stiction.obstacle.height_map { surface = stiction.surface.sphere { radius = 10*mm },
      times = { 0*s, 1*s, 2*s }, z = { 0*mm, -0.02*mm, -0.2*mm } } },
    pairs = { touch = stiction.pair { secondary = "plate.surface", primary = "ball" } },
    schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = 1 }, stiction.stage { to = 2*s, steps = 4 } } },
    probes = { touch = stiction.probe.contact { pair = "touch" } } }
end

test("contact that reaches the border of a free surface's points is remarked on, with the time", function()
  equal(says(pressed(16, "free"), "reaches the border of the points"), true)
  equal(says(pressed(16, "free"), "from t = 1.5 s on"), true)
  equal(says(pressed(16, "periodic"), "reaches the border"), false)
end)

test("surfaces that are steep where they touch are warned of and remarked on", function()
  local function touching(radius, depth, model)
    return { kinematics = space, model = model, bodies = { plate = stiction.body.half_space { young = 1*MPa, poisson = 0.3,
        size = { 4*mm, 4*mm }, points = { 32, 32 }, boundary = "free" } },
      obstacles = { ball = stiction.obstacle.height_map { surface = stiction.surface.sphere { radius = radius },
        times = { 0*s, 1*s }, z = { 0*mm, -depth } } },
      pairs = { touch = stiction.pair { secondary = "plate.surface", primary = "ball" } },
      schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = 2 } } }, probes = {} }
  end
  for _, case in ipairs { { 2.2*mm, 0.5*mm, true }, { 22*mm, 0.05*mm, false } } do -- the same radius of contact; a/R = 0.48
    local radius, depth, steep = table.unpack(case)
    equal(says(run(touching(radius, depth)), "have a slope of"), steep)
    equal(warns(touching(radius, depth), "the contact grows to a/R = 0.48"), steep)
    equal(warns(touching(radius, depth, "formula"), "the contact grows to a/R = 0.48"), steep)
  end
end)

test("linear bodies that are strained or turned by more than their law knows are remarked on", function()
  local function moved(x, y)
    return run { bodies = { block = block { cells = { 4, 4 } } }, motions = { fix { set = "block.bottom" },
        drive { set = "block.top", times = { 0*s, 1*s }, x = { 0*m, x }, y = { 0*m, y } } },
      schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = 2 } } }, probes = { e = stiction.probe.energy {} } }
  end
  equal(says(moved(0*m, -0.3*m), "small strains and rotations only"), true)
  equal(says(moved(0.4*m, 0*m), "small strains and rotations only"), true)
  equal(says(moved(0*m, -0.03*m), "small strains and rotations only"), false)
end)

local function two_soles(primary, how)
  local scene = { bodies = { pad = block { size = { 1*m, 0.5*m }, cells = { 4, 2 }, poisson = 0.3 } },
    obstacles = { floor = stiction.obstacle { shape = stiction.rigid.plane {} },
      other = stiction.obstacle { shape = stiction.rigid.plane { point = { 0*m, -0.1*m } } } },
    pairs = { a = stiction.pair { secondary = "pad.bottom", primary = "floor", discretisation = how },
      b = stiction.pair { secondary = "pad.all_edges", primary = primary } },
    motions = { drive { set = "pad.top", times = { 0*s, 1*s }, x = { 0*m, 0*m }, y = { 0*m, -0.01*m } } },
    schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = 1 } } }, probes = {} }
  scene.pairs.b.secondary = "pad.left"
  return scene
end

test("points of several pairs, or of mortar and periodic sides, that share a node are warned of", function()
  equal(warns(two_soles("floor"), "in common on the same counterpart"), false) -- the corner is a point of one
  equal(warns(two_soles("floor", "mortar"), "in common on the same counterpart"), true)
  equal(warns(two_soles("other", "mortar"), "in common on the same counterpart"), false)
  for _, how in ipairs { "mortar", "node_to_segment" } do
    local scene = two_soles("floor")
    scene.pairs = { a = stiction.pair { secondary = "pad.bottom", primary = "floor", discretisation = how } }
    scene.obstacles.other = nil
    scene.constraints = { stiction.constraint.periodic { set = "pad.left", to = "pad.right" } }
    equal(warns(scene, "nodes that move as one"), how == "mortar")
  end
  for _, stiffer in ipairs { 1, 100 } do
    local scene = two_soles("floor")
    scene.bodies.base = block { origin = { -2*m, -1*m }, size = { 5*m, 1*m }, cells = { 5, 2 }, young = stiffer * (1*GPa) }
    scene.pairs = { a = stiction.pair { secondary = "pad.bottom", primary = "base.top" } }
    scene.obstacles = nil
    scene.motions[2] = stiction.motion.fix { set = "base.bottom" }
    scene.constraints = { stiction.constraint.periodic { set = "pad.left", to = "pad.right" } }
    equal(warns(scene, "over different facets of a body that hardly gives way"), stiffer == 100)
  end
end)

test("bonds hold past the border of their counterpart as far as one of its facets, and are let go with a remark", function()
  local function sheared(beyond, cells)
    local strip = { 20*mm, 5*mm }
    return run { bodies = { up = block { size = strip, cells = { 4, 1 }, young = 20*MPa },
        low = block { origin = { 0*mm, -5*mm }, size = { (20 + beyond) * mm, 5*mm }, cells = { cells, 1 }, young = 20*MPa } },
      pairs = { glue = stiction.pair { secondary = "up.bottom", primary = "low.top", adhesion = stiction.adhesion.bilinear {
        K = 1e6*N/m^3, sigma_n = 900*Pa, sigma_t = 900*Pa, G_I = 1.9*J/m^2, G_II = 1.9*J/m^2 } } },
      motions = { fix { set = "low.all" }, drive { set = "up.all", times = { 0*s, 1*s }, x = { 0*mm, 5*mm }, y = { 0*mm, 0*mm } } },
      schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = 50 } } }, probes = { e = stiction.probe.energy {} } }
  end
  local flush, finer, longer = sheared(0, 4), sheared(0, 8), sheared(10, 8) -- bonds end at a slip of 4.2 mm
  equal(says(finer, "loses its counterpart, past the border"), true)
  equal(says(flush, "loses its counterpart"), false)
  equal(says(longer, "loses its counterpart"), false)
  near(flush:last("e", "motion_work"), 1.9 * 0.02, 1e-3)
  near(longer:last("e", "motion_work"), 1.9 * 0.02, 1e-3)
end)

test("a lap joint in space with flush ends takes the whole energy of its bonds", function()
  local function body(z)
    return stiction.body { mesh = stiction.mesh.box { origin = { 0*mm, 0*mm, z }, size = { 20*mm, 10*mm, 5*mm }, cells = { 3, 2, 1 } },
      density = 1000*kg/m^3, material = stiction.material.linear_elastic { young = 20*MPa, poisson = 0 } }
  end
  local joint = run { kinematics = "three_dimensional", bodies = { up = body(0*mm), low = body(-5*mm) },
    pairs = { glue = stiction.pair { secondary = "up.bottom", primary = "low.top", adhesion = stiction.adhesion.bilinear {
      K = 1e6*N/m^3, sigma_n = 900*Pa, sigma_t = 900*Pa, G_I = 1.9*J/m^2, G_II = 1.9*J/m^2 } } },
    motions = { fix { set = "low.all" },
      drive { set = "up.all", times = { 0*s, 1*s }, x = { 0*mm, 4*mm }, y = { 0*mm, -3*mm }, z = { 0*mm, 0*mm } } },
    schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = 50 } } }, probes = { e = stiction.probe.energy {} } }
  equal(says(joint, "loses its counterpart"), false)
  near(joint:last("e", "motion_work"), 1.9 * 0.02 * 0.01, 1e-3)
end)

test("two pairs of the same surfaces are refused, and bonds in both directions", function()
  local function refused(first, second)
    local scene = { bodies = { low = block { size = { 1*m, 0.5*m } }, high = block { origin = { 0*m, 0.5*m }, size = { 1*m, 0.5*m } } },
      pairs = { a = stiction.pair(first), b = stiction.pair(second) }, motions = { fix { set = "low.bottom" }, fix { set = "high.top" } },
      schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = 1 } } }, probes = {},
      scheme = stiction.scheme.quasi_static {} }
    local fine, why = pcall(engine.explain, scene)
    return not fine and tostring(why):find("leave one of them out", 1, true) ~= nil
  end
  local up, down = { secondary = "low.top", primary = "high.bottom" }, { secondary = "high.bottom", primary = "low.top" }
  equal(refused(up, up), true)
  equal(refused(up, down), false)
  local function glued(pair)
    return { secondary = pair.secondary, primary = pair.primary, adhesion = laws.quick }
  end
  equal(refused(glued(up), glued(down)), true)
end)

test("a sheet in plane stress is not advised to change its cells, which do not lock", function()
  local function scene(sheet)
    return { bodies = { sheet = block { poisson = 0.499, plane_stress = sheet, cells = { 2, 2 }, young = 100*kPa } },
      motions = { fix { set = "sheet.bottom" }, drive { set = "sheet.top", times = { 0*s, 1*s }, x = { 0*m, 0*m }, y = { 0*m, 0.01*m } } },
      schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = 1 } } }, probes = {} }
  end
  equal(warns(scene(true), "lock"), false)
  equal(warns(scene(false), "lock"), true)
end)

engine.remove("anew_runs")
