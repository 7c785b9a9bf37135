-- A pressure that follows the free end of a strip: all that the matrix lacks of it acts there.
local test, _, _, shared = ...
local stiction = require "stiction"
local u = stiction.units
local mm, s, Pa = u.mm, u.s, u.Pa

local run = shared("runs").quasi_static "following_runs"

--- How far the end of a strip held at x = 0 goes aside under q as it is pulled by T = p h along itself: E I y'''' - T y'' = q with
--- y''(L) = y'''(L) = 0.
local function aside(p, q)
  local L, h, young, poisson = 0.01, 0.001, 1e6, 0.3
  local T, k = p * h, math.sqrt(p * h / (young / (1 - poisson ^ 2) * h ^ 3 / 12))
  local e = math.exp(k * L)
  return q / T * (L * (e - 1 / e) / 2 / k - ((e + 1 / e) / 2 - 1) / k ^ 2 - L ^ 2 / 2)
end

test("a pull that follows a slender end is borne by bending", function()
  for _, pull in ipairs { 2000, 5000 } do
    local case = run(stiction.scene {
      bodies = { b = stiction.body { mesh = stiction.mesh.block { size = { 10*mm, 1*mm }, cells = { 20, 2 }, kind = "quad8" },
        material = stiction.material.neo_hookean { young = 1*u.MPa, poisson = 0.3 }, density = 1000*u.kg/u.m^3 } },
      motions = { stiction.motion.fix { set = "b.left" } },
      loads = { stiction.load.pressure { set = "b.right", times = { 0*s, 1*s }, pressure = { 0*Pa, -pull*Pa } },
        stiction.load.traction { set = "b.top", times = { 0*s, 1*s }, y = { 0*Pa, 50*Pa } } },
      scheme = stiction.scheme.quasi_static {}, schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = 20 } } },
      probes = { n = stiction.probe.node { set = "b.right", near = { 10*mm, 1*mm } } } })
    local over = case:last("n", "u_y") / aside(pull, 50)
    assert(math.abs(over - 1) < 0.02, over)
  end
end)
