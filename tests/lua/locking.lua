-- Cells that lock while a network that holds the volume has not relaxed.
local test, equal, _, shared = ...
local stiction = require "stiction"
local u = stiction.units
local mm, s = u.mm, u.s

local run, scenes = shared("runs").quasi_static "locking_runs", shared "scenes"

local function ball(cells, relaxing, interpolation)
  return stiction.scene { kinematics = "axisymmetric",
    bodies = { b = stiction.body { mesh = stiction.mesh.block { size = { 4*mm, 4*mm }, cells = { cells, cells } },
      material = stiction.material.neo_hookean { young = 0.5*u.MPa, poisson = 0.3 }, density = 1000*u.kg/u.m^3,
      interpolation = interpolation, relaxing = { relaxing } } },
    obstacles = { f = stiction.obstacle { shape = stiction.rigid.circle { centre = { 0*mm, 12*mm }, radius = 8*mm },
      times = { 0*s, 0.1*s }, y = { 0*mm, -0.2*mm } } },
    pairs = { j = stiction.pair { secondary = "b.top", primary = "f" } },
    motions = { stiction.motion.fix { set = "b.bottom" }, stiction.motion.fix { set = "b.left", y = false } },
    schedule = stiction.schedule { stages = { stiction.stage { to = 0.1*s, steps = 5 } } },
    probes = { j = stiction.probe.contact { pair = "j" } } }
end

test("volume that a network holds makes plain cells lock, as is told, and those that are named do not", function()
  local firm = { bulk_share = 60, time = 100*s }
  assert(scenes.warning(ball(16, firm), "cells lock").change:find("mean_dilatation", 1, true))
  equal(scenes.warning(ball(16, firm, "mean_dilatation"), "cells lock"), nil)
  equal(scenes.warning(ball(16, { share = 60, time = 100*s }), "cells lock"), nil)
  local function force(...) return -run(ball(...)):min("j", "force_y") end
  local fine = force(48, firm, "mean_dilatation")
  assert(force(16, firm) > 1.08 * fine, force(16, firm) / fine)
  assert(math.abs(force(16, firm, "mean_dilatation") / fine - 1) < 0.03)
end)
