-- What explain advises, followed: each kind on scenes that it was not made from, run as written and as advised; and scenes
-- that tempt to the advice where it would be wrong.
local test, equal, _, shared = ...
local engine = require "stiction.engine"
local stiction = require "stiction"
local units = stiction.units
local m, mm, s, ms, kg, N, J, MPa, GPa = units.m, units.mm, units.s, units.ms, units.kg, units.N, units.J, units.MPa, units.GPa
local fix, drive = stiction.motion.fix, stiction.motion.drive

local function warning(scene, part)
  for _, its in ipairs(engine.explain(scene).warnings) do
    equal(its.text:gsub("%b()", ""):match("[()]"), nil) -- each bracket is closed
    if its.text:find(part, 1, true) then
      return its
    end
  end
end

local function advised(scene, part)
  return (warning(scene, part) or error("no advice that says: " .. part, 2)).change
end

local function silent(scene, part)
  local its = warning(scene, part)
  if its then
    error("advises: " .. its.text .. " -> " .. its.change, 2)
  end
end

local run = shared("runs").below "advice_runs"

local function finished(scene)
  local case = run(scene)
  if case.result.verdict ~= "finished" then
    error(("%s: %s"):format(case.result.verdict, tostring(case.result.reason)), 2)
  end
  return case
end

--- The share that an advice says.
local function share_of(change)
  return tonumber(change:match("about ([%d.e+-]+) %%")) / 100
end

local function within(got, wanted, share, what)
  if got ~= got or math.abs(got - wanted) > share * math.abs(wanted) then
    error(("%s: %g is off %g by %.3g %%, not by %.3g %%"):format(what or "value", got, wanted,
      100 * math.abs(got / wanted - 1), 100 * share), 2)
  end
end

--- A length of the advice, as it writes it.
local function length(text)
  local number, unit = text:match("^([-%d.e+]+) (%a+)$")
  return tonumber(number) * units(unit)
end

local function mean_force(case)
  return case:at(case.time[#case.time], "joint", "force_y")
end

local function body(mesh, young, poisson)
  return stiction.body { mesh = mesh, density = 1000*kg/m^3,
    material = stiction.material.neo_hookean { young = young, poisson = poisson or 0.3 } }
end

local function slab(x, y, width, height, nx, ny)
  return stiction.mesh.block { origin = { x, y }, size = { width, height }, cells = { nx, ny } }
end

--- A soft block, 40 mm wide, driven down on a stiff one from x to x + width, `thick`, held below; then along.
local function on_base(t)
  local thick = t.thick or 20*mm
  return stiction.scene {
    kinematics = t.kinematics,
    bodies = {
      soft = body(slab(t.left or 0*mm, 0*mm, 40*mm, 20*mm, 10, 5), 1*MPa),
      base = body(slab(t.x, -thick, t.width, thick, t.cells or 16, 3), t.young or 20*GPa),
    },
    pairs = { joint = stiction.pair { secondary = "soft.bottom", primary = "base.top", friction = t.friction,
      adhesion = t.adhesion } },
    motions = t.motions or { fix { set = "base.bottom" }, drive { set = "soft.top", times = { 0*s, 1*s, 2*s },
      x = { 0*mm, 0*mm, t.slide or 0*mm }, y = t.y or { 0*mm, -1*mm, -1*mm } } },
    scheme = stiction.scheme.quasi_static {},
    schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = 5 }, stiction.stage { to = 2*s, steps = t.steps or 5 } } },
    probes = { joint = stiction.probe.contact { pair = "joint" }, energy = stiction.probe.energy {} },
  }
end

--- The scene with its stiff body as the obstacle that the advice describes.
local function as_obstacle(scene, name, change, path)
  local shape
  local plane, round = change:match("rigid%.plane through {([^}]*)}"), change:match("rigid%.%a+{centre = {([^}]*)}")
  local place = {}
  for word in (plane or round):gmatch("[^,]+") do
    place[#place + 1] = length(word:match("^%s*(.-)%s*$"))
  end
  if plane then
    shape = stiction.rigid.plane { point = place }
  else
    local kind = change:match("rigid%.(%a+){")
    shape = stiction.rigid[kind] { centre = place, radius = length(change:match("radius = ([^}]*)}")) }
  end
  scene.bodies[name] = nil
  scene.obstacles = scene.obstacles or {}
  local obstacle = { shape = shape }
  for key, value in pairs(path or {}) do
    obstacle[key] = value
  end
  scene.obstacles[name] = stiction.obstacle(obstacle)
  for _, pair in pairs(scene.pairs) do
    pair.primary = pair.primary:find("^" .. name .. "%.") and name or pair.primary
  end
  local motions = {}
  for _, motion in ipairs(scene.motions) do
    motions[#motions + 1] = not motion.set:find("^" .. name .. "%.") and motion or nil
  end
  scene.motions = motions
  return scene
end

local stiffer = "times stiffer than body soft"

test("a stiff base under all of a soft block may be a plane", function()
  for _, t in ipairs { { x = -30*mm, width = 100*mm },
    { x = -30*mm, width = 100*mm, slide = 3*mm, friction = stiction.friction.coulomb { mu = 0.4 } } } do
    local change = advised(on_base(t), stiffer)
    local before, after = finished(on_base(t)), finished(as_obstacle(on_base(t), "base", change))
    within(mean_force(after), mean_force(before), share_of(change), "force")
    within(after:min("joint", "force_x") - 1, before:min("joint", "force_x") - 1, share_of(change) + 1e-3, "drag")
    assert(share_of(change) < 0.02)
  end
end)

test("so may one that a soft block is pulled off, whatever holds them together", function()
  local function scene()
    return on_base { kinematics = "axisymmetric", x = 0*mm, width = 80*mm, steps = 60, y = { 0*mm, -0.2*mm, 1*mm },
      adhesion = stiction.adhesion.rcc { w = 1*J/m^2, C_n = 1e8*N/m^3, C_t = 1e8*N/m^3, b = 0.2*N*s/m } }
  end
  local change = advised(scene(), stiffer)
  local before, after = finished(scene()), finished(as_obstacle(scene(), "base", change))
  within(after:min("joint", "force_y"), before:min("joint", "force_y"), share_of(change), "pull-off")
  within(after:max("joint", "force_y"), before:max("joint", "force_y"), share_of(change), "force")
end)

--- A stiff sphere of radius R pressed into a soft adhesive block and drawn back.
local function ball(radius, depth)
  return stiction.scene {
    kinematics = "axisymmetric",
    bodies = {
      soft = body(slab(0*mm, -10*mm, 10*mm, 10*mm, 25, 20), 2*MPa, 0.4),
      ball = body(stiction.mesh.quarter_disc { centre = { 0*mm, radius }, radius = radius, fine = { 0.4 * radius, 0.2 * radius },
        fine_size = 0.04 * radius, coarse_size = 0.15 * radius }, 70*GPa),
    },
    motions = { fix { set = "soft.bottom" }, fix { set = "soft.left", y = false }, fix { set = "ball.axis", y = false },
      drive { set = "ball.flat", times = { 0*s, 1*s, 2*s }, y = { 0*mm, -depth, 0.5*mm } } },
    pairs = { joint = stiction.pair { secondary = "soft.top", primary = "ball.arc",
      adhesion = stiction.adhesion.rcc { w = 5*J/m^2, C_n = 5e8*N/m^3, C_t = 0*N/m^3, b = 1*N*s/m } } },
    scheme = stiction.scheme.quasi_static {},
    schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = 15 }, stiction.stage { to = 2*s, steps = 60 } } },
    probes = { joint = stiction.probe.contact { pair = "joint" } },
  }
end

test("a stiff ball may be a sphere", function()
  local change = advised(ball(8*mm, 0.6*mm), stiffer)
  local before = finished(ball(8*mm, 0.6*mm))
  local after = finished(as_obstacle(ball(8*mm, 0.6*mm), "ball", change,
    { times = { 0*s, 1*s, 2*s }, y = { 0*mm, -0.6*mm, 0.5*mm } }))
  within(after:min("joint", "force_y"), before:min("joint", "force_y"), share_of(change), "force at depth")
  within(after:max("joint", "force_y"), before:max("joint", "force_y"), share_of(change) + 0.005, "pull-off")
end)

test("a body of which the contact meets an edge may not be endless", function()
  silent(on_base { x = 0*mm, width = 40*mm }, stiffer) -- as wide as the soft one: it bulges over the edge
  silent(on_base { x = 10*mm, width = 20*mm }, stiffer) -- a punch
  silent(on_base { x = -30*mm, width = 100*mm, slide = 40*mm }, stiffer) -- slides off
  silent(on_base { kinematics = "axisymmetric", x = 0*mm, width = 10*mm, y = { 0*mm, 0*mm, 1*mm },
    adhesion = stiction.adhesion.rcc { w = 1*J/m^2, C_n = 1e9*N/m^3, C_t = 0*N/m^3, b = 0*N*s/m, beta0 = 1, bonding = "never" } },
    stiffer) -- Kendall's punch
  silent(ball(1*mm, 0.8*mm), stiffer) -- sinks in to its flat side
  local punch = on_base { x = 10*mm, width = 20*mm }
  local wrong = as_obstacle(on_base { x = 10*mm, width = 20*mm }, "base", "rigid.plane through {0 m, 0 m}")
  assert(mean_force(finished(wrong)) > 1.2 * mean_force(finished(punch))) -- what the advice would have done
end)

test("a punch whose own points touch is not advised on: its cells would not decide any more", function()
  local scene = on_base { x = -30*mm, width = 100*mm }
  scene.pairs.joint.secondary, scene.pairs.joint.primary = "base.top", "soft.bottom"
  silent(scene, "times stiffer")
end)

test("a stiff body that bends, is squeezed by its motions or turns may not be rigid", function()
  silent(on_base { x = -200*mm, width = 440*mm, thick = 2*mm, cells = 44, motions = { fix { set = "base.left" },
    fix { set = "base.right" }, drive { set = "soft.top", times = { 0*s, 1*s, 2*s }, x = { 0*mm, 0*mm, 0*mm },
      y = { 0*mm, -1*mm, -1*mm } } } }, stiffer) -- a strip between two walls
  silent(on_base { x = -30*mm, width = 100*mm, motions = { fix { set = "base.left" }, drive { set = "base.right",
    times = { 0*s, 2*s }, x = { 0*mm, 0*mm }, y = { 0*mm, 1*mm } }, drive { set = "soft.top", times = { 0*s, 1*s, 2*s },
      x = { 0*mm, 0*mm, 0*mm }, y = { 0*mm, -1*mm, -1*mm } } } }, stiffer)
end)

test("a stiff body between two soft ones stays", function()
  local scene = on_base { x = -30*mm, width = 100*mm }
  scene.bodies.other = body(slab(0*mm, -40*mm, 40*mm, 20*mm, 10, 5), 1*MPa)
  scene.pairs.below = stiction.pair { secondary = "other.top", primary = "base.bottom" }
  scene.motions[1] = fix { set = "base.left" }
  table.insert(scene.motions, fix { set = "other.bottom" })
  silent(scene, "times stiffer")
end)

local slow = "nothing is fast"

--- on_base in dynamics, its times stretched.
local function moving(t, stretch)
  local scene = on_base(t)
  scene.scheme = stiction.scheme.theta_xi {}
  for _, motion in ipairs(scene.motions) do
    motion.times = motion.times and { 0*s, stretch * s, 2 * stretch * s }
  end
  for i, stage in ipairs(scene.schedule.stages) do
    stage.to = i * stretch * s
  end
  return scene
end

test("what is slow may be quasi-static", function()
  for _, t in ipairs { { x = -30*mm, width = 100*mm, young = 1*MPa, slide = 1*mm, friction = stiction.friction.coulomb { mu = 0.3 } },
    { x = -30*mm, width = 100*mm, young = 4*MPa, steps = 60, y = { 0*mm, -0.5*mm, 0.5*mm },
      adhesion = stiction.adhesion.rcc { w = 1*J/m^2, C_n = 2e7*N/m^3, C_t = 2e7*N/m^3, b = 0.5*N*s/m } } } do
    local scene = moving(t, 2)
    local change = advised(scene, slow)
    assert(change:find("scheme.quasi_static{}", 1, true))
    local before = finished(scene)
    scene = moving(t, 2)
    scene.scheme = stiction.scheme.quasi_static {}
    local after = finished(scene)
    within(after:max("joint", "force_y"), before:max("joint", "force_y"), share_of(change), "force")
    within(after:min("joint", "force_y") - 1, before:min("joint", "force_y") - 1, share_of(change) + 1e-3, "pull")
  end
end)

test("what swings, flies or snaps is not slow", function()
  local base = { x = -30*mm, width = 100*mm, young = 1*MPa }
  silent(moving(base, 0.01), slow)
  local flying = moving(base, 2)
  flying.bodies.soft.velocity = { 0*m/s, -1e-4*m/s }
  silent(flying, slow)
  local bonded = { x = -30*mm, width = 100*mm, young = 1*MPa, y = { 0*mm, -0.1*mm, 2*mm },
    adhesion = stiction.adhesion.rcc { w = 1*J/m^2, C_n = 2e7*N/m^3, C_t = 0*N/m^3, b = 0*N*s/m, beta0 = 1 } }
  silent(moving(bonded, 2), slow)
  -- a reed, held at its end: a wave crosses it in 30 ms, it swings in 5 s
  local reed = stiction.scene {
    bodies = { reed = body(slab(0*mm, 0*mm, 500*mm, 4*mm, 50, 2), 1*MPa, 0) },
    obstacles = { floor = stiction.obstacle { shape = stiction.rigid.plane { point = { 0*mm, -1*mm } },
      times = { 0*s, 10*s }, y = { 0*mm, 5*mm } } },
    pairs = { joint = stiction.pair { secondary = "reed.bottom", primary = "floor" } },
    motions = { fix { set = "reed.left" } }, scheme = stiction.scheme.theta_xi {},
    schedule = stiction.schedule { stages = { stiction.stage { to = 10*s, steps = 100 } } },
  }
  silent(reed, slow)
end)

test("the period of what is held is that of its slowest swing", function()
  local scene = moving({ x = -30*mm, width = 100*mm, young = 1*MPa, slide = 1*mm }, 2)
  local text = warning(scene, slow).text
  local number, unit = text:match("swing in ([%d.]+) (%a+)")
  -- the soft block on its driven top: a shear beam of height 20 mm, c = sqrt(G / rho) = 19.6 m/s, T = 4 h / c, bent a little
  local period = tonumber(number) * (unit == "ms" and 1e-3 or 1)
  within(period, 4 * 0.02 / math.sqrt(1e6 / 2.6 / 1000), 0.25, "period")
  equal(ms.si, 1e-3)
end)

--- A block of `young` and side 10 mm, held by `bonds` or pressed, on a plane; its top follows x and y at times.
local function on_plane(t)
  return stiction.scene {
    kinematics = t.kinematics,
    bodies = { soft = stiction.body { mesh = t.mesh or slab(0*mm, t.gap or 0*mm, 10*mm, 10*mm, t.cells or 5, t.cells or 5),
      density = 1000*kg/m^3, velocity = t.velocity, interpolation = t.interpolation,
      material = stiction.material[t.law or "neo_hookean"] { young = t.young or 100*MPa, poisson = t.poisson or 0 } } },
    obstacles = { floor = stiction.obstacle { shape = t.shape or stiction.rigid.plane {}, times = t.shape and t.times,
      y = t.shape and t.y } },
    pairs = { joint = stiction.pair { secondary = t.shape and "soft.top" or "soft.bottom", primary = "floor",
      adhesion = t.adhesion } },
    motions = t.motions or { drive { set = "soft.top", times = t.times, x = t.x, y = t.y } },
    scheme = t.scheme or stiction.scheme.quasi_static {},
    schedule = stiction.schedule { stages = { stiction.stage { to = t.times[#t.times], steps = t.steps } } },
    probes = { joint = stiction.probe.contact { pair = "joint" }, energy = stiction.probe.energy {},
      line = stiction.probe.contact_line { pair = "joint" }, top = stiction.probe.force { set = "soft.top" } },
  }
end

local function whole(t)
  local all = {}
  for key, value in pairs(t) do all[key] = value end
  return all
end

--- The scene with as many steps as the advice says.
local function with_steps(t, part)
  local change, again = advised(on_plane(t), part), whole(t)
  again.steps = math.tointeger(tonumber(change:match("^(%d+) steps instead of")))
  return again
end

local function bonds(t)
  return stiction.adhesion.rcc { w = (t.w or 1)*J/m^2, C_n = t.C * (1*N/m^3), C_t = (t.C_t or 0) * (1*N/m^3), b = (t.b or 0) * (1*N*s/m),
    beta0 = t.beta0 or 1, bonding = t.bonding or "never" }
end

test("with the steps advised the peak of a bond that opens or slides is seen", function()
  local peak = math.sqrt(1e9) * 0.01 -- sqrt(w C) over 10 mm
  local function pulled(C_t, x, y)
    return { adhesion = bonds { C = 1e9, C_t = C_t }, times = { 0*s, 1*s }, x = { 0*mm, x }, y = { 0*mm, y }, steps = 2 }
  end
  for part, t in pairs { ["the motions open it"] = pulled(0, 0*mm, 0.1*mm),
    ["the motions slide by"] = pulled(1e9, 0.1*mm, -1e-4*mm) } do
    local column = part:find("open") and "force_y" or "force_x"
    local before, after = finished(on_plane(t)), finished(on_plane(with_steps(t, part)))
    within(-after:min("joint", column), peak, 0.08, part)
    assert(-before:min("joint", column) < 0.8 * peak, part)
  end
end)

test("with the steps advised a bond grows as it should", function()
  local t = { adhesion = bonds { C = 1e9, b = 0.4, beta0 = 0, bonding = "contact" }, times = { 0*s, 0.3*s, 1*s },
    x = { 0*mm, 0*mm, 0*mm }, y = { -0.01*mm, -0.01*mm, -0.01*mm }, steps = 4 }
  local change = advised(on_plane(t), "its growth is not resolved")
  t.steps = math.ceil(1 / length(change:match("steps of (.-) or less")).si)
  local case = finished(on_plane(t))
  within(case:at(0.3, "line", "beta", 3), 0.3 / 0.4, 0.1, "beta")
end)

test("with the steps advised no step onto the floor is cut", function()
  local t = { gap = 5*mm, times = { 0*s, 1*s }, x = { 0*mm, 0*mm }, y = { 0*mm, -6*mm }, steps = 2, young = 1*MPa, cells = 40 }
  equal(finished(on_plane(with_steps(t, "the motions close it by"))).result.cuts or 0, 0)
  t.cells = 20 -- six of them a step
  silent(on_plane(t), "the motions close it by")
  equal(finished(on_plane(t)).result.cuts or 0, 0)
end)

test("a bond that snaps gets past its peak with a little viscosity or inertia", function()
  local t = { adhesion = bonds { C = 1e8 }, young = 0.2*MPa, times = { 0*s, 1*s }, x = { 0*mm, 0*mm }, y = { 0*mm, 8*mm }, steps = 400 }
  local change = advised(on_plane(t), "the pull-off snaps")
  assert(change:find("b > 0", 1, true) and change:find("scheme.theta_xi{}", 1, true))
  local peak = math.sqrt(1e8) * 0.01
  local viscous, moving_too = whole(t), whole(t)
  viscous.adhesion = bonds { C = 1e8, b = 1e-3 }
  moving_too.scheme = stiction.scheme.theta_xi {}
  for _, its in ipairs { viscous, moving_too } do
    local case = finished(on_plane(its))
    within(-case:min("joint", "force_y"), peak, 0.05, "pull-off")
    within(1 + math.abs(case:at(1, "joint", "force_y")), 1, 0.01, "force after it")
  end
end)

test("cells as small as advised over the cohesive length end the pull-off's dependence on them", function()
  local function scene(size)
    return on_plane { kinematics = "axisymmetric", young = 1*MPa, poisson = 0.3, mesh = stiction.mesh.graded_block {
        origin = { 0*mm, -10*mm }, size = { 10*mm, 10*mm }, fine = { 2.8*mm, 1.4*mm }, fine_size = size, coarse_size = 2*mm },
      shape = stiction.rigid.sphere { centre = { 0*mm, 8*mm }, radius = 8*mm }, times = { 0*s, 1*s, 2*s },
      y = { 0*mm, -0.4*mm, 0.3*mm }, steps = 400, adhesion = bonds { C = 1.5e9, b = 0.01, beta0 = 0, bonding = "contact" },
      motions = { fix { set = "soft.bottom" }, fix { set = "soft.left", y = false } } }
  end
  local change = advised(scene(0.4*mm), "will depend on the mesh")
  local size = length(change:match("cells of (.-) or less"))
  local function pull_off(h) return finished(scene(h)):max("joint", "force_y") end
  local coarse, fine, finer = pull_off(0.4*mm), pull_off(size), pull_off(size / 2)
  within(fine, finer, 0.05, "pull-off")
  assert(coarse > 1.5 * finer)
end)

test("the law advised for large strains is right where linear elasticity is not", function()
  local t = { kinematics = "axisymmetric", law = "linear_elastic", young = 1*MPa, poisson = 0.3, times = { 0*s, 1*s },
    y = { 0*mm, -2*mm }, steps = 5 }
  local change = advised(on_plane(t), "linear_elastic knows small strains")
  local young, poisson = change:match("young = ([^,]+), poisson = ([%d.]+)")
  local again = whole(t)
  again.law, again.young, again.poisson = "neo_hookean", length(young), tonumber(poisson)
  local reference = stiction.reference.hyperelastic
  local stress = math.abs((reference.uniaxial(reference.neo_hookean(1e6, 0.3), 0.8)))
  local wanted = stress * math.pi * 1e-4
  within(math.abs(finished(on_plane(again)):at(1, "joint", "force_y")), wanted, 1e-3, "force")
  assert(math.abs(math.abs(finished(on_plane(t)):at(1, "joint", "force_y")) / wanted - 1) > 0.03)
end)

test("the interpolation advised does not lock", function()
  local function scene(interpolation, cells)
    return on_plane { kinematics = "axisymmetric", gap = -10*mm, cells = cells, young = 5*MPa, poisson = 0.48,
      interpolation = interpolation, shape = stiction.rigid.sphere { centre = { 0*mm, 10*mm }, radius = 10*mm },
      times = { 0*s, 1*s }, y = { 0*mm, -1.5*mm }, steps = 10,
      motions = { fix { set = "soft.bottom" }, fix { set = "soft.left", y = false } } }
  end
  assert(advised(scene("plain", 10), "lock"):find('interpolation = "mean_dilatation"', 1, true))
  local function force(interpolation, cells) return math.abs(finished(scene(interpolation, cells)):at(1, "joint", "force_y")) end
  within(force("mean_dilatation", 10), 70.95, 0.01, "force") -- the limit of fine cells
  assert(force("plain", 10) > 1.03 * 70.95)
end)

test("with the plane of symmetry held a quarter is a quarter", function()
  local function space(motions)
    return stiction.scene {
      kinematics = "three_dimensional",
      bodies = { soft = body(stiction.mesh.quarter_cylinder { radius = 10*mm, height = 10*mm, fine = { 5*mm, 5*mm },
        fine_size = 2.5*mm, coarse_size = 2.5*mm }, 1*MPa, 0.4) },
      motions = motions, scheme = stiction.scheme.quasi_static {},
      schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = 2 } } },
      probes = { top = stiction.probe.force { set = "soft.top" } },
    }
  end
  local motions = { fix { set = "soft.bottom" }, drive { set = "soft.top", times = { 0*s, 1*s }, z = { 0*mm, -1*mm } },
    fix { set = "soft.symmetry_x", y = false, z = false } }
  local change = advised(space(motions), "is a plane of symmetry")
  local set = change:match('set = "([^"]+)"')
  assert(change:find(", x = false, z = false", 1, true), change)
  motions[4] = fix { set = set, x = false, z = false }
  local section = on_plane { kinematics = "axisymmetric", cells = 8, young = 1*MPa, poisson = 0.4,
    times = { 0*s, 1*s }, steps = 2,
    motions = { fix { set = "soft.bottom" }, drive { set = "soft.top", times = { 0*s, 1*s }, y = { 0*mm, -1*mm } } } }
  section.pairs, section.probes.joint, section.probes.line, section.obstacles = nil, nil, nil, nil
  within(4 * finished(space(motions)):at(1, "top", "force_z"), finished(section):at(1, "top", "force_y"), 0.03, "force")
end)

test("an explicit run takes the steps advised", function()
  local t = { young = 1*MPa, gap = 1*mm, times = { 0*s, 20*ms }, x = { 0*mm, 0*mm }, y = { 0*mm, -2*mm }, steps = 20,
    scheme = stiction.scheme.central_difference {} }
  local change = advised(on_plane(t), "the run will refuse to start")
  assert(run(on_plane(t)).result.verdict ~= "finished")
  t.steps = math.ceil(20e-3 / length(change:match("steps of (.-) or less")).si)
  finished(on_plane(t))
end)

test("the inertia of contact nodes as advised ends the ringing", function()
  local function bar(contact_inertia)
    return on_plane { mesh = slab(0*mm, 0.5*mm, 1*mm, 10*mm, 1, 20), young = 1*MPa, velocity = { 0*m/s, -1*m/s },
      motions = { fix { set = "soft.all", y = false } }, times = { 0*ms, 1.2*ms }, steps = 76,
      scheme = stiction.scheme.theta_xi { theta = 0.5, contact_inertia = contact_inertia } }
  end
  assert(advised(bar("full"), "swings at every step"):find('contact_inertia = "implicit"', 1, true))
  local wanted = 1000 * math.sqrt(1000) * 1e-3 -- rho c v over 1 mm, from 0.5 ms to 1.13 ms
  local function swing(case)
    local force, largest = case:series("joint", "force_y"), 0
    for i, t in ipairs(case.time) do
      largest = t > 0.6e-3 and t < 1e-3 and math.max(largest, math.abs(force[i] / wanted - 1)) or largest
    end
    return largest
  end
  assert(swing(finished(bar("full"))) > 0.15)
  within(1 + swing(finished(bar("implicit"))), 1, 0.02, "force")
end)

test("what is fast has the waves that it is advised to have", function()
  local t = { young = 1*MPa, cells = 20, times = { 0*s, 0.2*ms }, x = { 0*mm, 0*mm }, y = { 0*mm, -1*mm }, steps = 100 }
  equal(advised(on_plane(t), "the motions are fast"), "scheme.theta_xi{}")
  local again = whole(t)
  again.scheme = stiction.scheme.theta_xi {}
  -- before the wave is back from the floor, rho c v acts on the driven top: rho = 1000, c = 31.6 m/s, v = 5 m/s
  local wanted = 1000 * math.sqrt(1e6 / 1000) * 5 * 0.01
  local function mean(case)
    local force, sum = case:series("top", "force_y"), 0
    for i = #force // 2, #force do sum = sum + math.abs(force[i]) / (#force - #force // 2 + 1) end
    return sum
  end
  within(mean(finished(on_plane(again))), wanted, 0.1, "force")
  assert(math.abs(mean(finished(on_plane(t))) / wanted - 1) > 0.3)
end)

engine.remove("advice_runs")

test("derivatives over several snaps, as help advises, hardly depend on the mesh; those between two do", function()
  local function pull_off(w, size)
    return finished(on_plane { kinematics = "axisymmetric", young = 1*MPa, poisson = 0.3, mesh = stiction.mesh.graded_block {
        origin = { 0*mm, -6*mm }, size = { 6*mm, 6*mm }, fine = { 1.1*mm, 0.24*mm }, fine_size = size, coarse_size = 1*mm },
      shape = stiction.rigid.sphere { centre = { 0*mm, 8*mm }, radius = 8*mm }, times = { 0*s, 1*s, 2*s },
      y = { 0*mm, -0.1*mm, 0.15*mm }, steps = 200, adhesion = bonds { C = 7e9, w = w, beta0 = 0, bonding = "contact" },
      motions = { fix { set = "soft.bottom" }, fix { set = "soft.left", y = false } } }):max("joint", "force_y")
  end
  local function power(low, high, size)
    return math.log(pull_off(high, size) / pull_off(low, size)) / math.log(high / low)
  end
  local coarse, fine = power(0.75, 1.3, 0.04*mm), power(0.75, 1.3, 0.02*mm)
  within(coarse, fine, 0.05, "d ln F / d ln w")
  within(fine, 1, 0.1, "d ln F / d ln w, of JKR at the limit")
  for _, size in ipairs { 0.04*mm, 0.02*mm } do
    assert(power(1 - 1e-5, 1, size) < 0.7 * fine)
  end
end)
