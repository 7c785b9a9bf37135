-- Sides that cannot meet or cannot give way are told before the run, and pairs of which nothing met after it.
local test, equal, _, shared = ...
local stiction = require "stiction"
local u = stiction.units
local mm, s = u.mm, u.s

local run, scenes = shared("runs").below "meeting_runs", shared "scenes"

local function block(y, columns, x)
  return stiction.body { mesh = stiction.mesh.block { origin = { (x or 0)*mm, y*mm }, size = { 10*mm, 5*mm }, cells = { columns, 4 } },
    density = 1000*u.kg/u.m^3, material = stiction.material.neo_hookean { young = 1*u.MPa, poisson = 0.4 } }
end

local down = { times = { 0*s, 1*s }, x = { 0*mm, 0*mm }, y = { 0*mm, -1*mm } }

local function scene(more)
  more.motions = more.motions or {}
  table.insert(more.motions, stiction.motion.fix { set = "a.bottom" })
  more.scheme = stiction.scheme.quasi_static {}
  more.schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = 4 } } }
  more.probes = {}
  return stiction.scene(more)
end

--- Two blocks, the upper one driven down, so many mm aside.
local function stacked(secondary, primary, aside)
  return scene { bodies = { a = block(0, 10), b = block(5.01, 8, aside) },
    pairs = { j = stiction.pair { secondary = secondary, primary = primary } },
    motions = { stiction.motion.drive { set = "b.top", times = down.times, x = down.x, y = down.y } } }
end

--- A block below an obstacle that moves down, or in no pair with it.
local function beneath(shape, motions, paired)
  return scene { bodies = { a = block(0, 10) },
    obstacles = { p = stiction.obstacle { shape = shape, times = down.times, y = down.y } },
    pairs = paired ~= false and { j = stiction.pair { secondary = "a.top", primary = "p" } } or {}, motions = motions }
end

local function plane(y, normal)
  return stiction.rigid.plane { point = { 0*mm, y*mm }, normal = { 0, normal } }
end

local function unmet(what)
  for _, text in ipairs(run(what).result.remarks) do
    if text:find("nothing of it touched or adhered", 1, true) then
      return text
    end
  end
end

test("sides that look the same way are told, those that face each other are not", function()
  for _, pair in ipairs { { "a.bottom", "b.bottom" }, { "a.top", "b.top" } } do
    assert(scenes.warning(stacked(pair[1], pair[2]), "look the same way"))
    assert(unmet(stacked(pair[1], pair[2])))
  end
  equal(scenes.warning(stacked("a.top", "b.bottom"), "look the same way"), nil)
  equal(unmet(stacked("a.top", "b.bottom")), nil)
  local aside = stacked("a.top", "b.bottom", 30)
  assert(unmet(aside):find("do the two look at each other?", 1, true), unmet(aside))
  assert(scenes.warning(beneath(plane(-0.1, 1)), "look the same way"))
  equal(scenes.warning(beneath(plane(5.1, -1)), "look the same way"), nil)
end)

test("points that nothing lets give way before a rigid counterpart are told", function()
  local held = { stiction.motion.fix { set = "a.top" } }
  assert(scenes.warning(beneath(plane(5.1, -1), held), "is rigid: the run will end there"))
  local guided = { stiction.motion.fix { set = "a.top", y = false } }
  equal(scenes.warning(beneath(plane(5.1, -1), guided), "is rigid: the run will end there"), nil)
end)

test("a ball smaller than a cell is told, and how near it came where it touched nothing", function()
  local small = stiction.rigid.circle { centre = { 5.5*mm, 5.21*mm }, radius = 0.2*mm }
  assert(scenes.warning(beneath(small), "radii down to 200 um"))
  local near = tonumber(unmet(beneath(small)):match("no point came nearer than ([%d.]+) um"))
  assert(near > 200 and near < 600, near) -- 0.5 mm beside its centre, less 0.2 mm
  equal(scenes.warning(beneath(stiction.rigid.circle { centre = { 5.5*mm, 7.1*mm }, radius = 2*mm }), "radii down to"), nil)
end)

test("a dry ball that touches over few cells is told, and with cells as small as advised its force is known", function()
  local function indented(cell, depth)
    return stiction.scene { kinematics = "axisymmetric",
      bodies = { base = stiction.body { density = 1000*u.kg/u.m^3,
        material = stiction.material.linear_elastic { young = 5*u.MPa, poisson = 0.3 },
        mesh = stiction.mesh.graded_block { size = { 6*mm, 5*mm }, fine = { 1.2*mm, 0.6*mm }, fine_size = cell*mm,
          coarse_size = 0.6*mm } } },
      obstacles = { ball = stiction.obstacle { shape = stiction.rigid.circle { centre = { 0*mm, 8*mm }, radius = 3*mm },
        times = { 0*s, 1*s }, y = { 0*mm, -depth*mm } } },
      pairs = { j = stiction.pair { secondary = "base.top", primary = "ball" } },
      motions = { stiction.motion.fix { set = "base.bottom" }, stiction.motion.fix { set = "base.left", y = false } },
      scheme = stiction.scheme.quasi_static {}, schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = 4 } } },
      probes = { j = stiction.probe.contact { pair = "j" } },
    }
  end
  local function force(cell, depth) return math.abs(run(indented(cell, depth)):last("j", "force_y")) end
  for _, depth in ipairs { 0.012, 0.02, 0.03 } do
    local touched = math.sqrt(3 * depth) -- sqrt(R d), mm
    local told = scenes.warning(indented(touched / 1.2, depth), "it touches over a radius")
    local number = tonumber(told.change:match("cells of ([%d.]+) um or less"))
    assert(math.abs(number / (touched / 4 * 1000) - 1) < 0.01, number)
    equal(scenes.warning(indented(number / 1000, depth), "it touches over a radius"), nil)
    local fine = force(touched / 20, depth)
    for _, share in ipairs { 1, 0.9 } do
      local off = force(share * number / 1000, depth) / fine - 1
      assert(math.abs(off) < 0.03, off)
    end
    assert(math.abs(force(1.4 * touched, depth) / fine - 1) > 0.06)
  end
end)

test("an obstacle that no pair is of is told", function()
  assert(scenes.warning(beneath(plane(5.1, -1), nil, false), "is in no pair"))
  equal(scenes.warning(beneath(plane(5.1, -1)), "is in no pair"), nil)
end)

test("steps that see a blow a few times only are told, and with steps as short as advised what is kept is known", function()
  local function thrown(shape, steps)
    local ball = shape == "ball"
    local mesh = ball and stiction.mesh.quarter_disc { centre = { 0*mm, 4*mm }, radius = 4*mm, fine = { 1*mm, 0.6*mm }, fine_size = 0.2*mm,
        coarse_size = 0.6*mm } or stiction.mesh.block { size = { 2*mm, 8*mm }, cells = { 2, 16 } }
    return stiction.scene { kinematics = ball and "axisymmetric" or nil,
      bodies = { b = stiction.body { mesh = mesh, density = 1000*u.kg/u.m^3, velocity = { 0*u.m/s, -0.3*u.m/s },
        material = stiction.material.neo_hookean { young = 1*u.MPa, poisson = ball and 0.3 or 0 } } },
      obstacles = { floor = stiction.obstacle { shape = stiction.rigid.plane { point = { 0*mm, -0.05*mm } } } },
      pairs = { j = stiction.pair { secondary = ball and "b.arc" or "b.bottom", primary = "floor" } },
      motions = ball and { stiction.motion.fix { set = "b.axis", x = true } } or {},
      schedule = stiction.schedule { stages = { stiction.stage { to = 4*u.ms, steps = steps } } },
      probes = { m = stiction.probe.momentum {} } }
  end
  for _, shape in ipairs { "ball", "bar" } do
    local told = scenes.warning(thrown(shape, 10), "what it keeps of its speed")
    local number, unit = told.change:match("steps of ([%d.]+) (%a+) or less")
    local advised = math.ceil(4*u.ms / (tonumber(number) * u(unit)))
    equal(scenes.warning(thrown(shape, advised), "what it keeps of its speed"), nil)
    local function kept(steps)
      local p = run(thrown(shape, steps)):series("m", "p_y")
      return -p[#p] / p[1]
    end
    local fine = kept(4 * advised)
    assert(math.abs(kept(advised) - fine) < 0.02, kept(advised) - fine)
    assert(math.abs(kept(10) - fine) > 0.05, kept(10) - fine)
  end
end)

test("points that motions hold where they are are not told to be pressed by those of other sets", function()
  local above = stiction.scene { bodies = { a = block(0, 10) }, obstacles = { p = stiction.obstacle { shape = plane(0, 1) } },
    pairs = { j = stiction.pair { secondary = "a.bottom", primary = "p" } },
    motions = { stiction.motion.fix { set = "a.bottom" },
      stiction.motion.drive { set = "a.top", times = down.times, x = down.x, y = down.y } },
    scheme = stiction.scheme.quasi_static {}, schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = 4 } } },
    probes = {} }
  equal(scenes.warning(above, "is rigid: the run will end there"), nil)
end)

test("sides that begin within each other are told, by how much, those that touch are not", function()
  local held = { stiction.motion.fix { set = "a.top", y = false } }
  local told = scenes.warning(beneath(plane(4.95, -1), held), "begins 50 um within")
  assert(told and told.text:find("a.top begins 50 um within p", 1, true), told and told.text)
  equal(scenes.warning(beneath(plane(5, -1), held), "within"), nil)
end)

test("a blow on a nearly incompressible block that is free at its sides is foretold as long as it is", function()
  for _, poisson in ipairs { 0.1, 0.45, 0.499 } do
    local function thrown(steps)
      return stiction.scene { bodies = { b = stiction.body { mesh = stiction.mesh.block { size = { 3*mm, 3*mm }, cells = { 8, 8 } },
          material = stiction.material.neo_hookean { young = 2*u.MPa, poisson = poisson }, density = 1200*u.kg/u.m^3,
          interpolation = "mean_dilatation", velocity = { 0*u.m/s, -0.5*u.m/s } } },
        obstacles = { floor = stiction.obstacle { shape = stiction.rigid.plane { point = { 0*mm, -0.02*mm } } } },
        pairs = { j = stiction.pair { secondary = "b.bottom", primary = "floor" } },
        schedule = stiction.schedule { stages = { stiction.stage { to = 0.4*u.ms, steps = steps } } },
        probes = { j = stiction.probe.contact { pair = "j" } } }
    end
    local told = scenes.warning(thrown(4), "what it keeps of its speed")
    local foretold = tonumber(told.text:match("touches for about ([%d.]+) us")) * 1e-6
    local case = run(thrown(400))
    local force, all, passed, first, last = case:series("j", "force_y"), 0, 0, nil, nil
    for i = 1, #force do
      all = all + force[i]
    end
    for i, t in ipairs(case.time) do
      passed = passed + force[i]
      first = first or (passed > 0.02 * all and t or nil)
      last = passed < 0.98 * all and t or last
    end
    assert(math.abs(foretold / (last - first) - 1) < 0.3, ("%g: %g for %g s"):format(poisson, foretold, last - first))
  end
end)
