-- Cells that lock: while a network that holds the volume has not relaxed, and where slender bodies bend.
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

--- A strip of 30 mm by 1 mm (in space 2 mm wide) held on the left; `drive`: of its right end, or of its whole top.
local function strip(columns, kind, drive)
  local space = kind:find("hex", 1, true)
  local mesh = space and stiction.mesh.box { size = { 30*mm, 2*mm, 1*mm }, cells = { columns, 1, 1 }, kind = kind }
    or stiction.mesh.block { size = { 30*mm, 1*mm }, cells = { columns, 1 }, kind = kind }
  return stiction.scene { kinematics = space and "three_dimensional" or nil,
    bodies = { strip = stiction.body { mesh = mesh, material = stiction.material.linear_elastic { young = 1*u.MPa, poisson = 0 },
      density = 1000*u.kg/u.m^3 } },
    motions = { stiction.motion.fix { set = drive.layer and "strip.bottom" or "strip.left" },
      stiction.motion.drive { set = drive.layer and "strip.top" or "strip.right", times = { 0*s, 1*s }, [drive.way] = { 0*mm, 0.1*mm } } },
    scheme = stiction.scheme.quasi_static {}, schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = 1 } } },
    probes = { f = stiction.probe.force { set = "strip.right" } } }
end

test("strips that bend are told how stiff long cells are, and with cells as short as advised or quadratic ones they are not", function()
  for kind, way in pairs { quad4 = "y", hex8 = "z" } do
    local told = scenes.warning(strip(12, kind, { way = way }), "as it bends")
    local percent = tonumber(told.text:match("too stiff by (%d+) %%"))
    local number, unit, finer = tonumber(told.change:match("cells of ([%d.]+)")), told.change:match("cells of [%d.]+ (%a+)"),
      told.change:match("^(%w+) cells")
    local exact = 1e6 * 1e-3 ^ 3 / 12 * (kind == "hex8" and 2e-3 or 1) * 3 / 0.03 ^ 3 * 1e-4 -- 3 E I u / L^3
    local function off(columns, other) return run(strip(columns, other or kind, { way = way })):last("f", "force_" .. way) / exact - 1 end
    assert(math.abs(off(12) / (percent / 100) - 1) < 0.05, off(12))
    local columns = math.ceil(30*mm / (number * u(unit)))
    assert(math.abs(off(columns)) < 0.05, off(columns))
    assert(math.abs(off(12, finer)) < 0.02, off(12, finer))
    equal(scenes.warning(strip(columns, kind, { way = way }), "as it bends"), nil)
    equal(scenes.warning(strip(12, finer, { way = way }), "as it bends"), nil)
  end
  equal(scenes.warning(strip(12, "quad4", { way = "x" }), "as it bends"), nil)
  equal(scenes.warning(strip(12, "quad4", { way = "y", layer = true }), "as it bends"), nil)
end)

test("a surface stress that bends a slender strip is told where its law knows small strains only, and by how much it bends less", function()
  local function curled(law, L, poisson)
    return stiction.scene {
      bodies = { strip = stiction.body { mesh = stiction.mesh.block { size = { L*mm, 0.2*mm }, cells = { 20, 2 }, kind = "quad8" },
        material = stiction.material[law] { young = 50*u.kPa, poisson = poisson }, density = 1000*u.kg/u.m^3 } },
      motions = { stiction.motion.fix { set = "strip.left", y = false },
        stiction.motion.fix { set = "strip.left", near = { 0*mm, 0*mm }, x = false } },
      loads = { stiction.load.surface_stress { set = "strip.top", gamma = 0.008*u.N/u.m } },
      schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = 4 } } },
      probes = { tip = stiction.probe.node { set = "strip.right", near = { L*mm, 0*mm } } } }
  end
  for _, L in ipairs { 1.5, 2 } do
    local told = scenes.warning(curled("linear_elastic", L, 0.2), "it bends by")
    local share = tonumber(told.text:match("bends by ([%d.]+) %% less")) / 100
    assert(told.change:find("neo_hookean", 1, true))
    local function tip(law) return run(curled(law, L, 0.2)):last("tip", "u_y") end
    local less = 1 - tip("linear_elastic") / tip("neo_hookean")
    assert(math.abs(less / share - 1) < 0.15, less)
    equal(scenes.warning(curled("neo_hookean", L, 0.2), "it bends by"), nil)
  end
end)

test("moments of a turned and pressed set are doubted where its law knows small strains only", function()
  local function twisted(law, probed)
    return stiction.scene { kinematics = "three_dimensional",
      bodies = { b = stiction.body { mesh = stiction.mesh.box { size = { 1*mm, 1*mm, 1*mm }, cells = { 3, 3, 3 } },
        material = stiction.material[law] { young = 1*u.MPa, poisson = 0.4 }, density = 1000*u.kg/u.m^3 } },
      obstacles = { floor = stiction.obstacle { shape = stiction.rigid.plane {} } },
      pairs = { sole = stiction.pair { secondary = "b.bottom", primary = "floor", friction = stiction.friction.coulomb { mu = 0.1 } } },
      motions = { stiction.motion.turn { set = "b.top", times = { 0*s, 1*s, 2*s }, angle = { 0, 0, 0.01 },
        centre = { 0.5*mm, 0.5*mm, 1*mm }, axis = { 0, 0, 1 }, z = { 0*mm, -0.05*mm, -0.05*mm } } },
      schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = 1 }, stiction.stage { to = 2*s, steps = 4 } } },
      probes = { top = stiction.probe.force { set = probed or "b.top", about = { 0.5*mm, 0.5*mm, 0*mm } },
        floor = stiction.probe.rigid { obstacle = "floor" } } }
  end
  local words = "do not turn with b.top"
  assert(scenes.warning(twisted "linear_elastic", words).change:find("neo_hookean", 1, true))
  equal(scenes.warning(twisted "neo_hookean", words), nil)
  equal(scenes.warning(twisted("linear_elastic", "b.bottom"), words), nil)
  local function moments(law)
    local case = run(twisted(law))
    return math.abs(case:last("top", "moment_z")), math.abs(case:last("floor", "moment_z"))
  end
  local doubted, met = moments "linear_elastic"
  local other, same = moments "neo_hookean"
  assert(math.abs(other / same - 1) < 1e-3, other / same)
  assert(math.abs(met / same - 1) < 0.1, met / same)
  assert(math.abs(doubted / met - 1) > 0.05, doubted / met)
end)
