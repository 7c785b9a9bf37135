-- A body or a counterpart that comes off under what pulls at it: no equilibrium bears the pull any more, and the run says so.
local test, equal, _, shared = ...
local stiction = require "stiction"
local u = stiction.units
local mm, s = u.mm, u.s

local run, scenes = shared("runs").below "come_off_runs", shared "scenes"

local function ends_with(scene, words)
  local result = run(scene).result
  assert(result.verdict ~= "finished" and result.reason:find(words, 1, true), result.verdict .. ": " .. result.reason)
end

local function block(part)
  local pull = part * math.sqrt(1e9) -- sqrt(w C_n), Pa
  return stiction.scene {
    bodies = { block = stiction.body { mesh = stiction.mesh.block { size = { 10*mm, 10*mm }, cells = { 4, 4 } },
      material = stiction.material.linear_elastic { young = 100*u.MPa, poisson = 0 }, density = 1000*u.kg/u.m^3 } },
    obstacles = { floor = stiction.obstacle { shape = stiction.rigid.plane {} } },
    pairs = { sole = stiction.pair { secondary = "block.bottom", primary = "floor", adhesion = stiction.adhesion.rcc {
      w = 1*u.J/u.m^2, C_n = 1e9*u.N/u.m^3, C_t = 0*u.N/u.m^3, b = 1*u.N*s/u.m, beta0 = 1, bonding = "never" } } },
    motions = { stiction.motion.fix { set = "block.left", y = false } },
    loads = { stiction.load.traction { set = "block.top", times = { 0*s, 0.1*s, 4*s }, y = { 0*u.Pa, pull * u.Pa, pull * u.Pa } } },
    scheme = stiction.scheme.quasi_static {},
    schedule = stiction.schedule { stages = { stiction.stage { to = 0.1*s, steps = 10 }, stiction.stage { to = 4*s, steps = 40 } } },
    probes = {},
  }
end

test("a block under one and a half times what its bonds bear", function()
  ends_with(block(1.5), "a body has come off under its loads")
  local words = "body block: its loads pull with 474 N/m, and all of its bonds bear 316 N/m at their peak together"
  equal(scenes.warned(block(1.5), words), true)
  equal(scenes.warned(block(0.9), "its loads pull with"), false)
end)

test("a ball on a half space under a constant pull that its bonds bear for a while", function()
  local function force(mN) return mN * u.mN end
  ends_with(stiction.scene { kinematics = "three_dimensional",
    bodies = { base = stiction.body.half_space { young = 1*u.MPa, poisson = 0.5, size = { 2*mm, 2*mm }, points = { 24, 24 },
      boundary = "free" } },
    obstacles = { ball = stiction.obstacle.height_map { surface = stiction.surface.sphere { radius = 5*mm },
      times = { 0*s, 5*s, 6*s, 30*s }, force = { force(10), force(10), force(-4), force(-4) } } },
    pairs = { touch = stiction.pair { secondary = "base.surface", primary = "ball", adhesion = stiction.adhesion.rcc {
      w = 0.2*u.J/u.m^2, C_n = 2e9*u.N/u.m^3, C_t = 0*u.N/u.m^3, b = 0.2*u.N*s/u.m } } },
    scheme = stiction.scheme.quasi_static {},
    schedule = stiction.schedule { stages = { stiction.stage { to = 6*s, steps = 50 }, stiction.stage { to = 30*s, steps = 100 } } },
    probes = {},
  }, "nothing is left that bears a pull of 0.004 N")
end)
