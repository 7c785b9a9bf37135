-- Points that are one: nodes between pairs of one counterpart that border on each other, and nodes that move as one.
local test, equal, _, shared = ...
local stiction = require "stiction"
local u = stiction.units
local mm, s = u.mm, u.s

local run = shared("runs").quasi_static "borders_runs"

--- Two arms bonded beyond 20 mm, opened at their free ends; the crack's faces are a pair as well where that is asked for.
local function arms(crack, friction)
  local e = stiction.edge
  local material = stiction.material.linear_elastic { young = 70*u.GPa, poisson = 0 }
  local lower = stiction.mesh.gmsh { size = 1*mm, kind = "quad8", start = { 0*mm, 0*mm }, edges = {
    e { to = { 60*mm, 0*mm }, name = "bottom" }, e { to = { 60*mm, 1.5*mm }, name = "right" }, e { to = { 20*mm, 1.5*mm }, name = "bond" },
    e { to = { 0*mm, 1.5*mm }, name = "crack" }, e { to = { 0*mm, 0*mm }, name = "left" } } }
  local upper = stiction.mesh.block { origin = { 0*mm, 1.5*mm }, size = { 60*mm, 1.5*mm }, cells = { 60, 2 }, kind = "quad8" }
  local pairs = { bond = stiction.pair { secondary = "lower.bond", primary = "upper.bottom", adhesion = stiction.adhesion.bilinear {
    K = 1e14*u.N/u.m^3, sigma_n = 30*u.MPa, sigma_t = 40*u.MPa, G_I = 250*u.J/u.m^2, G_II = 700*u.J/u.m^2 } } }
  pairs.a_crack = crack and stiction.pair { secondary = "lower.crack", primary = "upper.bottom", friction = friction } or nil
  return stiction.scene {
    bodies = { lower = stiction.body { mesh = lower, material = material, density = 2700*u.kg/u.m^3 },
      upper = stiction.body { mesh = upper, material = material, density = 2700*u.kg/u.m^3 } },
    pairs = pairs,
    motions = { stiction.motion.fix { set = "lower.right" },
      stiction.motion.fix { set = "lower.bottom", near = { 0*mm, 0*mm }, x = false },
      stiction.motion.drive { set = "upper.top", near = { 0*mm, 3*mm }, times = { 0*s, 1*s }, y = { 0*mm, 1.5*mm } } },
    schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = 8 } } },
    probes = { f = stiction.probe.force { set = "upper.top", near = { 0*mm, 3*mm } } } }
end

test("a crack whose faces are a pair opens as without it, and its problems are answered as plainly", function()
  local function peak(...)
    local case = run(arms(...))
    return case:max("f", "force_y"), case.result.contact
  end
  local plain, by = peak(false)
  for _, friction in ipairs { false, stiction.friction.coulomb { mu = 0.3 } } do
    local held, how = peak(true, friction or nil)
    assert(math.abs(held / plain - 1) < 1e-8, held / plain)
    equal(how:find("minimisation", 1, true), by:find("minimisation", 1, true))
  end
end)

test("two soles that border on each other press like one, on one floor or on two of one height", function()
  local e = stiction.edge
  local function pressed(parts, second)
    local mesh = stiction.mesh.gmsh { size = 1*mm, start = { 0*mm, 0*mm }, edges = {
      e { to = { 4*mm, 0*mm }, name = parts and "a" or "sole" }, e { to = { 10*mm, 0*mm }, name = parts and "b" or "sole" },
      e { to = { 10*mm, 5*mm }, name = "right" }, e { to = { 0*mm, 5*mm }, name = "top" }, e { to = { 0*mm, 0*mm }, name = "left" } } }
    local pairs, probes = {}, {}
    for _, name in ipairs(parts or { "sole" }) do
      pairs[name] = stiction.pair { secondary = "pad." .. name, primary = name == "b" and second or "floor",
        friction = stiction.friction.pressure { mu_0 = 0.8, mu_inf = 0.1, p_ref = 20*u.kPa } }
      probes[name] = stiction.probe.contact { pair = name }
    end
    if second then
      probes.on_floor, probes.on_other = stiction.probe.rigid { obstacle = "floor" }, stiction.probe.rigid { obstacle = "other" }
    end
    local case = run(stiction.scene {
      bodies = { pad = stiction.body { mesh = mesh, density = 1000*u.kg/u.m^3,
        material = stiction.material.neo_hookean { young = 1*u.MPa, poisson = 0.4 } } },
      obstacles = { floor = stiction.obstacle { shape = stiction.rigid.plane {} },
        other = second and stiction.obstacle { shape = stiction.rigid.plane { point = { 7*mm, 0*mm } } } }, pairs = pairs, probes = probes,
      motions = { stiction.motion.drive { set = "pad.top", times = { 0*s, 1*s }, x = { 0*mm, 0.3*mm }, y = { 0*mm, -0.2*mm } } },
      schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = 5 } } } })
    local sums = { 0, 0, 0, 0 }
    for name in next, pairs do
      for k, column in ipairs { "force_x", "force_y", "closed_area" } do
        sums[k] = sums[k] + case:last(name, column)
      end
      sums[4] = math.max(sums[4], case:last(name, "pressure_max"))
    end
    if second then
      local on_floors = case:last("on_floor", "force_y") + case:last("on_other", "force_y")
      assert(math.abs(on_floors / sums[2] + 1) < 1e-9, on_floors / sums[2])
      local part = case:last("on_other", "force_y") / case:last("b", "force_y")
      assert(math.abs(part + 1) < 1e-9, part)
    end
    return sums
  end
  local whole = pressed()
  for _, halves in ipairs { pressed { "a", "b" }, pressed({ "a", "b" }, "other") } do
    for k = 1, 4 do
      assert(math.abs(halves[k] / whole[k] - 1) < 1e-7, ("%d: %.10g for %.10g"):format(k, halves[k], whole[k]))
    end
  end
end)

--- A corner past the border of its counterpart by what a point keeps it where it is pressed, and within it where it is not.
test("borders that lie flush pass each other, whatever the steps", function()
  local function block(y)
    return stiction.body { density = 1000*u.kg/u.m^3, material = stiction.material.neo_hookean { young = 1*u.MPa, poisson = 0.3 },
      mesh = stiction.mesh.block { origin = { 0*mm, y*mm }, size = { 4*mm, 1*mm }, cells = { 6, 2 } } }
  end
  local function force(steps, more)
    return run(stiction.scene { bodies = { low = block(0), up = block(1) },
      pairs = { joint = stiction.pair { secondary = "up.bottom", primary = "low.top", smoothing = more } },
      motions = { stiction.motion.fix { set = "low.bottom" }, stiction.motion.drive { set = "up.top", times = { 0*s, 1*s, 2*s },
        x = { 0*mm, 0*mm, 0.2*mm }, y = { 0*mm, -0.06*mm, -0.06*mm } } },
      schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = 5 }, stiction.stage { to = 2*s, steps = steps } } },
      probes = { joint = stiction.probe.contact { pair = "joint" } } }):last("joint", "force_y")
  end
  local once = force(1)
  for _, steps in ipairs { 8, 20, 60 } do
    assert(math.abs(force(steps) / once - 1) < 1e-6, steps)
  end
  assert(force(60, "polyline") / once > 0.9)
end)

local follows = stiction.friction.pressure { mu_0 = 0.8, mu_inf = 0.1, p_ref = 50*u.kPa }

--- Blocks of so many cells side by side, 1 mm high, pressed on a floor or what `more` gives, and dragged.
local function dragged(blocks, more)
  local bodies, pairs, motions, probes, from = {}, {}, {}, {}, 0
  for i, cells in ipairs(blocks) do
    local name = "b" .. i
    bodies[name] = stiction.body { material = stiction.material.neo_hookean { young = 1*u.MPa, poisson = 0.4 }, density = 1000*u.kg/u.m^3,
      mesh = stiction.mesh.block { origin = { from * 0.5*mm, 0*mm }, size = { cells * 0.5*mm, 1*mm }, cells = { cells, 2 } } }
    from = from + cells
    pairs[name] = stiction.pair { secondary = name .. ".bottom", primary = "floor", friction = follows }
    probes[name] = stiction.probe.contact { pair = name }
    motions[i] = stiction.motion.drive { set = name .. ".top", times = { 0*s, 1*s }, x = { 0*mm, 0.2*mm }, y = { 0*mm, -0.05*mm } }
  end
  local scene = { bodies = bodies, pairs = pairs, motions = motions, probes = probes,
    obstacles = { floor = stiction.obstacle { shape = stiction.rigid.circle { centre = { 0.8*mm, -5*mm }, radius = 5*mm } } },
    schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = 8 } } } }
  for key, value in _G.pairs(more or {}) do
    scene[key] = value
  end
  return scene
end

test("two bodies that are tied press and rub like one, whichever follows", function()
  local function answer(blocks, more)
    local case, force, most = run(stiction.scene(dragged(blocks, more))), 0, 0
    for i in ipairs(blocks) do
      force, most = force + case:last("b" .. i, "force_x"), math.max(most, case:last("b" .. i, "pressure_max"))
    end
    return force, most
  end
  local force, most = answer { 8 }
  for _, sides in ipairs { { "b1.right", "b2.left" }, { "b2.left", "b1.right" } } do
    local of_two, at_most = answer({ 4, 4 }, { constraints = { stiction.constraint.tied { set = sides[1], to = sides[2] } } })
    assert(math.abs(of_two / force - 1) < 1e-7, of_two / force)
    assert(math.abs(at_most / most - 1) < 1e-7, at_most / most)
  end
end)

test("the ends of a periodic side are one point also where motions hold them along it", function()
  local floor = { floor = stiction.obstacle { shape = stiction.rigid.plane {} } }
  local scene = dragged({ 8 }, { obstacles = floor, constraints = { stiction.constraint.periodic { set = "b1.left", to = "b1.right" } } })
  scene.motions = { stiction.motion.drive { set = "b1.top", times = { 0*s, 1*s }, x = { 0*mm, 0*mm }, y = { 0*mm, -0.05*mm } },
    stiction.motion.fix { set = "b1.left", x = true }, stiction.motion.fix { set = "b1.right", x = true } }
  local case = run(stiction.scene(scene))
  local mean = case:last("b1", "force_y") / 4e-3
  assert(math.abs(case:last("b1", "pressure_max") / mean - 1) < 1e-7, case:last("b1", "pressure_max") / mean)
end)

--- The way that one floor went is kept by its bonds, though both are at rest again, of one height, with intact bonds.
test("points with bonds stretched by unlike ways do not become one", function()
  local e = stiction.edge
  local mesh = stiction.mesh.gmsh { size = 1*mm, start = { 0*mm, 0*mm }, edges = {
    e { to = { 4*mm, 0*mm }, name = "a" }, e { to = { 10*mm, 0*mm }, name = "b" }, e { to = { 10*mm, 5*mm }, name = "right" },
    e { to = { 0*mm, 5*mm }, name = "top" }, e { to = { 0*mm, 0*mm }, name = "left" } } }
  local glue = stiction.adhesion.rcc { w = 1000*u.J/u.m^2, C_n = 1e8*u.N/u.m^3, C_t = 1e8*u.N/u.m^3, b = 0*u.N*s/u.m, beta0 = 1,
    bonding = "never" }
  local floor = stiction.rigid.plane {}
  local case = run(stiction.scene {
    bodies = { pad = stiction.body { mesh = mesh, density = 1000*u.kg/u.m^3,
      material = stiction.material.neo_hookean { young = 1*u.MPa, poisson = 0.4 } } },
    obstacles = { floor = stiction.obstacle { shape = floor },
      other = stiction.obstacle { shape = floor, times = { 0*s, 0.5*s, 1*s }, x = { 0*mm, 0.3*mm, 0.3*mm } } },
    pairs = { a = stiction.pair { secondary = "pad.a", primary = "floor", adhesion = glue },
      b = stiction.pair { secondary = "pad.b", primary = "other", adhesion = glue } },
    motions = { stiction.motion.drive { set = "pad.top", times = { 0*s, 1*s }, x = { 0*mm, 0*mm }, y = { 0*mm, 0*mm } } },
    schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = 8 } } },
    probes = { a = stiction.probe.contact { pair = "a" }, b = stiction.probe.contact { pair = "b" } } })
  for _, pair in ipairs { "a", "b" } do
    local moved, rested = case:at(0.5*s, pair, "force_x"), case:last(pair, "force_x")
    assert(math.abs(rested / moved - 1) < 1e-6, pair .. ": " .. rested / moved)
  end
end)
