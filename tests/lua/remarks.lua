-- Remarks on a run's energy: none of what is rounding, and of what a stabilisation holds back beside what is turned over.
local test, equal, _, shared = ...
local stiction = require "stiction"
local u = stiction.units
local mm, s = u.mm, u.s

local run = shared("runs").below "remarks_runs"

local function remark(scene, words)
  for _, text in ipairs(run(scene).result.remarks or {}) do
    if text:find(words, 1, true) then
      return text
    end
  end
end

local function block(more)
  local scene = { bodies = { a = stiction.body { mesh = stiction.mesh.block { size = { 10*mm, 5*mm }, cells = { 12, 6 } },
      density = 1000*u.kg/u.m^3, material = stiction.material.neo_hookean { young = 1*u.MPa, poisson = 0.4 } } },
    scheme = stiction.scheme.quasi_static {},
    schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = 20 } } }, probes = {} }
  for key, value in pairs(more) do
    scene[key] = value
  end
  return stiction.scene(scene)
end

test("a body that nothing reaches, and one that only goes along, make no energy", function()
  equal(remark(block {
    obstacles = { o = stiction.obstacle { shape = stiction.rigid.plane { point = { 0*mm, 7*mm }, normal = { 0, -1 } },
      times = { 0*s, 1*s }, y = { 0*mm, -1*mm } } },
    pairs = { j = stiction.pair { secondary = "a.top", primary = "o" } },
    motions = { stiction.motion.fix { set = "a.bottom" } },
  }, "made energy"), nil)
  local along = stiction.motion.drive { set = "a.bottom", times = { 0*s, 1*s }, x = { 0*mm, 3*mm }, y = { 0*mm, 1*mm } }
  equal(remark(block { motions = { along } }, "made energy"), nil)
end)

test("a slender strip that its stabilisation holds back is told, whatever its surface's own energy", function()
  local function strip(stabilisation)
    return stiction.scene { bodies = { d = stiction.body { density = 1000*u.kg/u.m^3,
        mesh = stiction.mesh.block { size = { 20*mm, 1*mm }, cells = { 40, 2 }, kind = "quad8" },
        material = stiction.material.neo_hookean { young = 1*u.MPa, poisson = 0.3 } } },
      loads = { stiction.load.surface_stress { set = "d.top", gamma = 0.2*u.N/u.m } },
      motions = { stiction.motion.fix { set = "d.left", y = false }, stiction.motion.fix { set = "d.left", near = { 0*mm, 0.5*mm } } },
      scheme = stiction.scheme.quasi_static { stabilisation = stabilisation },
      schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = 10 } } }, probes = {} }
  end
  assert(remark(strip(0.03), "take less of it"), remark(strip(0.03), "stabilisation") or "nothing")
end)

test("a body that spins and touches nothing loses by the surfaces of its pair, as is told", function()
  local function brick(inertia)
    return stiction.scene { kinematics = "three_dimensional",
      bodies = { b = stiction.body { mesh = stiction.mesh.box { origin = { -150*mm, -100*mm, -50*mm }, size = { 300*mm, 200*mm, 100*mm },
          cells = { 6, 4, 2 } }, density = 1000*u.kg/u.m^3, spin = { 0/s, 0/s, 10/s },
        material = stiction.material.st_venant_kirchhoff { young = 1*u.MPa, poisson = 0.3 } } },
      obstacles = { o = stiction.obstacle { shape = stiction.rigid.plane { point = { 0*mm, 0*mm, -5000*mm } } } },
      pairs = { c = stiction.pair { secondary = "b.bottom", primary = "o" } },
      scheme = stiction.scheme.theta_xi { contact_inertia = inertia },
      schedule = stiction.schedule { stages = { stiction.stage { to = 1.25*s, steps = 125 } } }, probes = {} }
  end
  local text = remark(brick "implicit", "lost energy")
  assert(text and text:find("nothing touched", 1, true), text or "nothing")
  equal(remark(brick "none", "lost energy"), nil)
end)

test("of a body that turns in steps too long a scheme that damps is named, and that makes none", function()
  local function spinning(scheme)
    local mesh = stiction.mesh.block { size = { 10*mm, 4*mm }, cells = { 10, 4 } }
    return stiction.scene { bodies = { d = stiction.body { mesh = mesh, density = 1000*u.kg/u.m^3,
        velocity = { 0*u.m/s, 0.2*u.m/s }, spin = { 20/s }, velocity_gradient = { 3/s, 5/s, 5/s, -3/s },
        material = stiction.material.neo_hookean { young = 100*u.MPa, poisson = 0.3 } } },
      scheme = stiction.scheme.theta_xi(scheme),
      schedule = stiction.schedule { stages = { stiction.stage { to = 0.6*s, steps = 600 } } }, probes = {} }
  end
  local text = remark(spinning {}, "made energy")
  assert(text and text:find("theta = xi = 0.6", 1, true), text or "nothing")
  equal(remark(spinning { theta = 0.6, xi = 0.6 }, "made energy"), nil)
end)

--- A bar of 10 mm that lands on a plane at 0.5 m/s.
local function landing(steps, inertia, more)
  local bar = { mesh = stiction.mesh.block { size = { 1*mm, 10*mm }, cells = { 1, 16 } }, density = 1000*u.kg/u.m^3,
    material = stiction.material.linear_elastic { young = 1*u.MPa, poisson = 0 }, velocity = { 0*u.m/s, -0.5*u.m/s } }
  for key, value in pairs(more or {}) do
    bar[key] = value
  end
  return stiction.scene { bodies = { b = stiction.body(bar) },
    obstacles = { floor = stiction.obstacle { shape = stiction.rigid.plane {} } },
    pairs = { t = stiction.pair { secondary = "b.bottom", primary = "floor" } },
    scheme = stiction.scheme.theta_xi { contact_inertia = inertia },
    schedule = stiction.schedule { stages = { stiction.stage { to = 5*u.ms, steps = steps } } },
    probes = { e = stiction.probe.energy { audit = true } } }
end

test("viscosity takes no more than there is, however contact nodes are balanced, and no steps are said to make energy for it", function()
  local viscous = { damping = stiction.damping.kelvin_voigt { shear_viscosity = 100*u.Pa*s, bulk_viscosity = 100*u.Pa*s } }
  local start = 0.5 * 1000 * 1e-3 * 10e-3 * 0.5 ^ 2 -- J/m
  local full = run(landing(400, "full", viscous)):last("e", "damping_loss")
  for _, inertia in ipairs { "implicit", "cells" } do
    local case = run(landing(100, inertia, viscous))
    local taken = case:last("e", "damping_loss")
    assert(taken < start and math.abs(taken / full - 1) < 0.2, taken / start)
    assert(math.abs(case:last("e", "unaccounted")) < 1e-9 * start)
    for _, text in ipairs(case.result.remarks or {}) do
      assert(not text:find("made energy", 1, true), text)
    end
  end
end)

test("what long steps lose of a blow is a share of what there was before it", function()
  local function dropped(steps)
    return stiction.scene { kinematics = "axisymmetric",
      bodies = { b = stiction.body { mesh = stiction.mesh.block { size = { 5*mm, 4*mm }, cells = { 10, 8 } }, density = 1000*u.kg/u.m^3,
        material = stiction.material.neo_hookean { young = 1*u.MPa, poisson = 0.4 } } },
      obstacles = { ball = stiction.obstacle { shape = stiction.rigid.sphere { centre = { 0*mm, 6.05*mm }, radius = 2*mm },
        mass = 1e-4*u.kg, velocity = { 0*u.m/s, -1*u.m/s } } },
      pairs = { c = stiction.pair { secondary = "b.top", primary = "ball" } },
      motions = { stiction.motion.fix { set = "b.bottom" }, stiction.motion.fix { set = "b.left", y = false } },
      schedule = stiction.schedule { stages = { stiction.stage { to = 10*u.ms, steps = steps } } }, probes = {} }
  end
  for _, steps in ipairs { 3, 8 } do
    local text = remark(dropped(steps), "lost energy")
    local share = tonumber(text:match("lost energy, ([%d.]+) %%"))
    assert(share > 50 and share <= 100, text)
  end
end)

test("what a free body on a spring loses is told with what helps it, which does", function()
  local function swung(inertia)
    return block { motions = { stiction.motion.fix { set = "a.all" } },
      obstacles = { o = stiction.obstacle { shape = stiction.rigid.circle { centre = { 50*mm, 0*mm }, radius = 1*mm },
        mass = 0.01*u.kg, velocity = { 0*u.m/s, 0.05*u.m/s } } },
      pairs = { j = stiction.pair { secondary = "a.right", primary = "o" } },
      springs = { k = stiction.spring { from = "o", anchor = { 40*mm, 0*mm }, stiffness = 2*u.N/u.m, along = "line", rest = 8*mm } },
      schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = 400 } } },
      scheme = stiction.scheme.theta_xi { contact_inertia = inertia } }
  end
  for _, inertia in ipairs { "implicit", "none" } do
    local text = remark(swung(inertia), "backward Euler")
    assert(text and text:find('contact_inertia = "full" hardly any', 1, true), text or "no remark")
  end
  equal(remark(swung "full", "lost"), nil)
  local warned = shared("scenes").warned
  equal(warned(swung "full", "backward Euler"), false)
  for _, inertia in ipairs { "implicit", "none" } do
    equal(warned(swung(inertia), "which takes 39"), true)
  end
end)
