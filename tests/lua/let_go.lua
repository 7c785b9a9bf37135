-- A ball drawn off, or just touching: the cells and points that explain asks for over its contact.
local test, equal, _, shared = ...
local stiction = require "stiction"
local units = stiction.units
local mm, s, kg, m, J, MPa, N = units.mm, units.s, units.kg, units.m, units.J, units.MPa, units.N

local run, scenes = shared("runs").quasi_static "let_go_runs", shared "scenes"

--- A ball of 6 mm pressed onto a layer of 3 mm and drawn off; of another way down and another law where these are given.
local function ball(cell, depth, law)
  local function cells(size) return math.ceil(size.si / cell.si - 1e-9) end
  return stiction.scene { kinematics = "axisymmetric",
    bodies = { layer = stiction.body { mesh = law and stiction.mesh.graded_block { size = { 5*mm, 3*mm }, fine = { 1*mm, 0.5*mm },
        fine_size = cell, coarse_size = 0.5*mm }
      or stiction.mesh.block { size = { 5*mm, 3*mm }, cells = { cells(5*mm), cells(3*mm) } },
      interpolation = "mean_dilatation", density = 1000*kg/m^3,
      material = stiction.material.neo_hookean { young = 0.4*MPa, poisson = 0.47 } } },
    obstacles = { ball = stiction.obstacle { shape = stiction.rigid.circle { centre = { 0*mm, 9*mm }, radius = 6*mm },
      times = { 0*s, 1*s, 3*s }, y = { 0*mm, -(depth or 0.15*mm), 0.35*mm } } },
    pairs = { touch = stiction.pair { secondary = "layer.top", primary = "ball",
      adhesion = stiction.adhesion.rcc(law or { w = 0.4*J/m^2, C_n = 4e8*N/m^3, C_t = 0*N/m^3, b = 0.02*N*s/m }) } },
    motions = { stiction.motion.fix { set = "layer.bottom" }, stiction.motion.fix { set = "layer.left", y = false } },
    scheme = stiction.scheme.quasi_static {},
    schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = 50 }, stiction.stage { to = 3*s, steps = 40 } } },
    probes = { touch = stiction.probe.contact { pair = "touch" } },
  }
end

local function warning(cell) return scenes.warning(ball(cell), "when it lets go") end

test("cells as small as advised over what is left of a ball's contact leave a per cent or two of its pull-off", function()
  local number, unit = warning(0.33*mm).change:match("cells of ([%d.]+) (%a+) or less at layer.top")
  equal(warning(0.15*mm), nil)
  local advised = tonumber(number) * units(unit)
  local function pull(cell) return 1e3 * run(ball(cell)):max("touch", "force_y") end
  local fine = pull(advised)
  assert(math.abs(fine / 16.2 - 1) < 0.02, fine) -- mN, of cells of 0.06 mm
  assert(pull(0.33*mm) > 1.1 * fine)
end)

test("bonds made by touching are counted in whole cells: five per cent at most with cells as small as advised", function()
  local depth, law = 0.02*mm, { w = 0.05*J/m^2, C_n = 3e7*N/m^3, C_t = 0*N/m^3, b = 0.002*N*s/m } -- 0.35 mm touch
  local function pull(cell) return 1e3 * run(ball(cell, depth, law)):max("touch", "force_y") end
  local told = scenes.warning(ball(0.08*mm, depth, law), "when it lets go")
  local number = tonumber(told.change:match("cells of ([%d.]+) um or less at layer.top, which leave up to five per cent"))
  equal(scenes.warning(ball(0.03*mm, depth, law), "when it lets go"), nil)
  local fine = pull(number / 2 * units.um)
  for _, share in ipairs { 1, 0.9, 0.8 } do
    local off = pull(share * number * units.um) / fine - 1
    assert(math.abs(off) < 0.05, off)
  end
  assert(pull(0.08*mm) > 1.2 * fine)
end)

test("a ball lets go without a snap where none is told, and with one where it is", function()
  local um = units.um
  local function scene(delta, steps)
    return stiction.scene { kinematics = "axisymmetric",
      bodies = { layer = stiction.body { density = 1000*kg/m^3, material = stiction.material.neo_hookean { young = 2*MPa, poisson = 0.4 },
        mesh = stiction.mesh.graded_block { size = { 2*mm, 2*mm }, fine = { 0.2*mm, 0.05*mm }, fine_size = 8*um,
          coarse_size = 0.2*mm } } },
      obstacles = { ball = stiction.obstacle { shape = stiction.rigid.circle { centre = { 0*mm, 4*mm }, radius = 2*mm },
        times = { 0*s, 1*s, 3*s }, y = { 0*um, -3*um, 9*um } } },
      pairs = { touch = stiction.pair { secondary = "layer.top", primary = "ball",
        adhesion = stiction.adhesion.potential { w = 0.1*J/m^2, delta = delta } } },
      motions = { stiction.motion.fix { set = "layer.bottom" }, stiction.motion.fix { set = "layer.left", y = false } },
      scheme = stiction.scheme.quasi_static {},
      schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = 20 }, stiction.stage { to = 3*s, steps = steps } } },
      probes = { touch = stiction.probe.contact { pair = "touch" } },
    }
  end
  local function fall(delta, steps) -- the largest of the force in a step as it is drawn off
    local result, largest = run(scene(delta, steps)), 0
    local force = result:series("touch", "force_y")
    for i = 2, #force do
      largest = result.time[i] > 1 and math.max(largest, math.abs(force[i] - force[i - 1])) or largest
    end
    return largest
  end
  equal(scenes.warning(scene(1.1*um, 50), "snaps"), nil)
  assert(scenes.warning(scene(0.45*um, 50), "snaps"))
  assert(fall(1.1*um, 200) < 0.4 * fall(1.1*um, 50))
  assert(fall(0.45*um, 200) > 0.7 * fall(0.45*um, 50))
end)

test("points as near as advised know the force of a ball's small contact", function()
  local um, depth, R = units.um, 0.0156, 10 -- um, mm: a = sqrt(R d) = 12.5 um
  local function scene(points)
    return stiction.scene { kinematics = "three_dimensional",
      bodies = { base = stiction.body.half_space { young = 1*MPa, poisson = 0.3, size = { 1*mm, 1*mm }, points = { points, points },
        boundary = "free" } },
      obstacles = { ball = stiction.obstacle.height_map { surface = stiction.surface.sphere { radius = R*mm }, times = { 0*s, 1*s },
        z = { 0*um, -depth*um } } },
      pairs = { touch = stiction.pair { secondary = "base.surface", primary = "ball" } },
      scheme = stiction.scheme.quasi_static {}, schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = 1 } } },
      probes = { touch = stiction.probe.contact { pair = "touch" } },
    }
  end
  local function told(points)
    local its = scenes.warning(scene(points), "times the spacing of points")
    return its and its.change:match("points at most ([%d.]+) um apart")
  end
  local function off(points)
    local force = 4 / 3 * 1e6 / 0.91 * math.sqrt(R * 1e-3) * (depth * 1e-6) ^ 1.5
    return math.abs(-run(scene(points)):min("touch", "force_z") / force - 1)
  end
  local near = tonumber(told(64)) -- 0.8 spacings
  assert(scenes.warning(scene(48), "it may lie between them"))
  equal(scenes.warning(scene(64), "it may lie between them"), nil)
  local enough = 2 * math.ceil(500 / near)
  equal(told(enough), nil)
  assert(off(64) > 0.1 and off(enough) < 0.02, off(enough))
end)

test("bonds of one traction snap point by point on points as coarse as this, and no longer with the ramp that is advised", function()
  local function told(ramp)
    return scenes.warning(stiction.scene { kinematics = "three_dimensional",
      bodies = { base = stiction.body.half_space { young = 1*MPa, poisson = 0.3, size = { 1*mm, 1*mm }, points = { 32, 32 },
        boundary = "free" } },
      obstacles = { ball = stiction.obstacle.height_map { surface = stiction.surface.sphere { radius = 10*mm }, times = { 0*s, 1*s },
        z = { 0*mm, -0.01*mm } } },
      pairs = { touch = stiction.pair { secondary = "base.surface", primary = "ball",
        adhesion = stiction.adhesion.dugdale { sigma0 = 0.2*MPa, h0 = 20*units.um, ramp = ramp } } },
      scheme = stiction.scheme.quasi_static {}, schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = 1 } } },
      probes = { touch = stiction.probe.contact { pair = "touch" } },
    }, "falls off faster than one point")
  end
  local times = told(0.05).change:match("or ([%d.]+) times its ramp")
  equal(told(0.05 * times), nil)
  assert(told(0.05 * times / 3) ~= nil)
end)

test("bonds that grow as long as they are closed are told where the step in which they open is long beside that", function()
  local function dwell(steps, hold)
    return stiction.scene {
      bodies = { b = stiction.body { mesh = stiction.mesh.block { size = { 2*mm, 1*mm }, cells = { 8, 4 } }, density = 1000*kg/m^3,
        material = stiction.material.neo_hookean { young = 5*MPa, poisson = 0.3 } } },
      obstacles = { f = stiction.obstacle { shape = stiction.rigid.plane {} } },
      pairs = { j = stiction.pair { secondary = "b.bottom", primary = "f",
        adhesion = stiction.adhesion.rcc { w = 0.5*J/m^2, C_n = 1e9*N/m^3, C_t = 1e9*N/m^3, b = 1*N*s/m } } },
      motions = { stiction.motion.drive { set = "b.top", times = { 0*s, 0.1*s, 0.1*s + hold, 1.1*s + hold }, x = { 0*mm, 0*mm, 0*mm, 0*mm },
        y = { 0*mm, -0.01*mm, -0.01*mm, 0.09*mm } } },
      schedule = stiction.schedule { stages = { stiction.stage { to = 0.1*s, steps = 10 }, stiction.stage { to = 0.1*s + hold, steps = 2 },
        stiction.stage { to = 1.1*s + hold, steps = steps } } },
      probes = { j = stiction.probe.contact { pair = "j" } } }
  end
  local function told(...) return scenes.warning(dwell(...), "its bonds grow as long as") end
  local function pull(...) return -run(dwell(...)):min("j", "force_y") end
  local advised = tonumber(told(20, 0.1*s).change:match("^(%d+) steps instead of 20"))
  equal(told(advised, 0.1*s), nil)
  equal(told(20, 20*s), nil) -- full by then
  local fine = pull(4 * advised, 0.1*s)
  assert(math.abs(pull(advised, 0.1*s) / fine - 1) < 0.03, pull(advised, 0.1*s) / fine)
  assert(pull(20, 0.1*s) < 0.9 * fine, pull(20, 0.1*s) / fine)
end)

test("a ball that leaves a half space in long steps is told, and in as many as advised its pull is known", function()
  local function lifted(steps, t)
    local balls = { ball = stiction.obstacle.height_map { surface = stiction.surface.sphere { radius = 6*mm },
      times = { 0*s, 1*s, 2*s }, z = { 0*mm, -t.depth*mm, t.lift*mm } } }
    return stiction.scene { kinematics = "three_dimensional",
      bodies = { base = stiction.body.half_space { young = 3*MPa, poisson = 0.45, size = { t.size*mm, t.size*mm }, points = { 48, 48 },
        boundary = "free" } }, obstacles = balls,
      pairs = { touch = stiction.pair { secondary = "base.surface", primary = "ball",
        adhesion = stiction.adhesion.potential { w = t.w * (1*J/m^2), delta = t.delta * (1*mm) } } },
      scheme = stiction.scheme.quasi_static {},
      schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = 3 }, stiction.stage { to = 2*s, steps = steps } } },
      probes = { ball = stiction.probe.rigid { obstacle = "ball" } }, output = stiction.output { frames = 0 } }
  end
  local scenes_ = { { w = 0.1, delta = 0.004, depth = 0.02, lift = 0.05, size = 2.2 },
    { w = 0.03, delta = 0.01, depth = 0.013, lift = 0.04, size = 1.6 } }
  local worst = 1
  for _, t in ipairs(scenes_) do
    local told = scenes.warning(lifted(7, t), "over which its pull is largest")
    local advised = tonumber(told.change:match("^(%d+) steps instead of 7"))
    equal(scenes.warning(lifted(advised, t), "over which its pull is largest"), nil)
    local function pull(steps) return -run(lifted(steps, t)):min("ball", "force_z") end
    local fine = pull(3 * advised + 17)
    assert(math.abs(pull(advised) / fine - 1) < 0.1, pull(advised) / fine)
    worst = math.min(worst, pull(7) / fine)
  end
  assert(worst < 0.9, worst)
end)

test("a contact that outgrows the points of a half space is foretold", function()
  local function pressed(size)
    return stiction.scene { kinematics = "three_dimensional",
      bodies = { base = stiction.body.half_space { young = 3*MPa, poisson = 0.45, size = { size*mm, size*mm }, points = { 32, 32 },
        boundary = "free" } },
      obstacles = { ball = stiction.obstacle.height_map { surface = stiction.surface.sphere { radius = 6*mm },
        times = { 0*s, 1*s }, z = { 0*mm, -0.1*mm } } },
      pairs = { touch = stiction.pair { secondary = "base.surface", primary = "ball" } },
      scheme = stiction.scheme.quasi_static {}, schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = 3 } } },
      probes = { ball = stiction.probe.rigid { obstacle = "ball" } } }
  end
  local told = scenes.warning(pressed(1.4), "past the last points")
  assert(told and told.text:find("radius of 775 um", 1, true), told and told.text)
  equal(scenes.warning(pressed(1.6), "past the last points"), nil)
end)
