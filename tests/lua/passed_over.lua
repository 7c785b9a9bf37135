-- What steps pass over: a pulse of a path within one of them, and the first peak of a peel that begins at bonds.
local test, equal, _, shared = ...
local stiction = require "stiction"
local u = stiction.units
local mm, s = u.mm, u.s

local run, scenes = shared("runs").quasi_static "passed_over_runs", shared "scenes"

local function soft(mesh, young)
  return stiction.body { mesh = mesh, density = 1000*u.kg/u.m^3,
    material = stiction.material.neo_hookean { young = young*u.MPa, poisson = 0.4 } }
end

--- A cylinder that comes down and goes up again within 60 ms.
local function pulse(steps)
  return stiction.scene {
    bodies = { b = soft(stiction.mesh.block { origin = { -4*mm, -4*mm }, size = { 8*mm, 4*mm }, cells = { 16, 8 } }, 2) },
    obstacles = { c = stiction.obstacle { shape = stiction.rigid.circle { centre = { 0*mm, 8*mm }, radius = 8*mm },
      times = { 0*s, 0.51*s, 0.54*s, 0.57*s, 1*s }, y = { 0*mm, 0*mm, -0.1*mm, 0*mm, 0*mm } } },
    pairs = { j = stiction.pair { secondary = "b.top", primary = "c" } },
    motions = { stiction.motion.fix { set = "b.bottom" } },
    schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = steps } } },
    probes = { j = stiction.probe.contact { pair = "j" } } }
end

test("a path that turns within a step is told, and steps as short as advised see most of it", function()
  local function force(steps) return -run(pulse(steps)):min("j", "force_y") end
  local told = scenes.warning(pulse(10), "its path turns")
  local advised = math.ceil(1000 / tonumber(told.change:match("a stage that ends at 540 ms, or steps of ([%d.]+) ms")))
  assert(force(10) < 1e-9) -- N/m
  equal(scenes.warning(pulse(100), "its path turns"), nil)
  assert(force(advised) > 0.6 * force(100), force(advised) / force(100))
end)

--- A bonded strip that is lifted at one end, bonds and all.
local function strip(steps)
  return stiction.scene {
    bodies = { tape = soft(stiction.mesh.block { size = { 10*mm, 0.5*mm }, cells = { 30, 2 }, kind = "quad8" }, 3) },
    obstacles = { f = stiction.obstacle { shape = stiction.rigid.plane {} } },
    pairs = { j = stiction.pair { secondary = "tape.bottom", primary = "f", adhesion = stiction.adhesion.bilinear {
      K = 1e10*u.N/u.m^3, sigma_n = 40*u.kPa, sigma_t = 40*u.kPa, G_I = 0.5*u.J/u.m^2, G_II = 0.5*u.J/u.m^2 } } },
    motions = { stiction.motion.drive { set = "tape.right", times = { 0*s, 1*s }, y = { 0*mm, 1*mm } } },
    schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = steps } } },
    probes = { g = stiction.probe.force { set = "tape.right" } } }
end

test("the first peak of a peel that begins at bonds is told where steps pass over it", function()
  local function peak(steps) return run(strip(steps)):max("g", "force_y") end
  local told = scenes.warning(strip(10), "the first peak")
  local advised = tonumber(told.change:match("^(%d+) steps instead of 10"))
  equal(scenes.warning(strip(advised), "the first peak"), nil)
  local fine = peak(4 * advised)
  assert(math.abs(peak(advised) / fine - 1) < 0.05, peak(advised) / fine)
  assert(peak(10) < 0.9 * fine, peak(10) / fine)
end)
