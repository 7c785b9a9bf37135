-- Slender arms that bonds hold: the cells that explain asks for, and the steps in which the bonds' edge leaps.
local test, equal, _, shared = ...
local stiction = require "stiction"
local units = stiction.units
local mm, s, kg, m, J, MPa, GPa, N = units.mm, units.s, units.kg, units.m, units.J, units.MPa, units.GPa, units.N

local run, scenes = shared("runs").quasi_static "arm_runs", shared "scenes"

--- An arm, 0.5 mm thick, on a rigid plane, bonded from 15 mm to `bond`, its free end lifted.
local function arm(t)
  return stiction.scene {
    bodies = { arm = stiction.body {
      mesh = stiction.mesh.gmsh { size = t.cell, kind = "quad8", start = { 0*mm, 0*mm },
        edges = { stiction.edge { to = { 15*mm, 0*mm }, name = "crack" }, stiction.edge { to = { t.bond, 0*mm }, name = "bond" },
          stiction.edge { to = { t.bond, 0.5*mm }, name = "far" }, stiction.edge { to = { 0*mm, 0.5*mm }, name = "top" },
          stiction.edge { to = { 0*mm, 0*mm }, name = "near" } } },
      material = stiction.material.linear_elastic { young = 3*GPa, poisson = 0 }, density = 1000*kg/m^3 } },
    obstacles = { middle = stiction.obstacle { shape = stiction.rigid.plane {} } },
    pairs = { bond = stiction.pair { secondary = "arm.bond", primary = "middle",
      adhesion = stiction.adhesion.bilinear { K = 1e13*N/m^3, sigma_n = t.sigma, sigma_t = t.sigma, G_I = 20*J/m^2, G_II = 20*J/m^2 } } },
    motions = { stiction.motion.drive { set = "arm.near", near = { 0*mm, 0.5*mm }, times = { 0*s, 1*s }, y = { 0*mm, t.lift } } },
    schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = t.steps } } },
    scheme = stiction.scheme.quasi_static {},
    probes = { force = stiction.probe.force { set = "arm.near", near = { 0*mm, 0.5*mm } }, energy = stiction.probe.energy {} },
  }
end

--- The steps in which bonds snapped, as the run's remarks say.
local function snaps(case)
  for _, remark in ipairs(case.result.remarks) do
    local steps = remark:match("snaps? there, or nearly.*%((%d+) of %d+ steps%)")
    if steps then
      return tonumber(steps)
    end
  end
  return 0
end

test("where bonds are few over the cohesive length the remark counts the steps in which their edge leaps", function()
  local case = run(arm { cell = 0.6*mm, bond = 25*mm, sigma = 4*MPa, lift = 4*mm, steps = 80 })
  local force, loss, leaps = case:series("force", "force_y"), case:series("energy", "scheme_loss"), 0
  for i = 2, #force do
    if loss[i] - loss[i - 1] > 2e-5 then -- of 3.5e-3 J/m that the motion brings in a step; others lose 3e-7
      assert(force[i] < force[i - 1] - 0.5)
      leaps = leaps + 1
    end
  end
  assert(leaps >= 6)
  local told = snaps(case)
  assert(told >= leaps and told <= leaps + 2, told) -- the edge's start is steep, too
end)

test("bonds whose edge goes on from point to point have no such remark", function()
  local case = run(arm { cell = 0.3*mm, bond = 20*mm, sigma = 0.5*MPa, lift = 4*mm, steps = 40 })
  assert(case:series("energy", "bond")[40] > 0)
  equal(snaps(case), 0)
end)

test("cells as small as explain asks for on a slender arm end the peak's dependence on them", function()
  local function scene(cell) return arm { cell = cell, bond = 20*mm, sigma = 4*MPa, lift = 3.6*mm, steps = 36 } end
  local function warning(cell) return scenes.warning(scene(cell), "will depend on the mesh") end
  local its = warning(1.2*mm)
  assert(its.text:find("cohesive length 827 um", 1, true), its.text) -- thick bodies' 3.75 mm holds three such cells
  equal(warning(0.26*mm), nil)
  local function peak(cell) return run(scene(cell)):max("force", "force_y") end
  local limit = peak(0.26*mm)
  assert(math.abs(limit / 70.93 - 1) < 0.025, limit) -- of cells of 0.14 mm
  assert(peak(1.2*mm) > 1.15 * limit)
end)

test("an arm lifted at its end is not asked for steps in which all of its bonds would open alike", function()
  equal(scenes.warned(arm { cell = 0.6*mm, bond = 25*mm, sigma = 4*MPa, lift = 4*mm, steps = 80 }, "the motions open it"), false)
end)

test("a beam that bends on two rollers is not taken for one that is pressed flat", function()
  local function roller(x) return stiction.obstacle { shape = stiction.rigid.circle { centre = { x*mm, -5*mm }, radius = 5*mm } } end
  local function beam(depth)
    return stiction.scene {
      bodies = { beam = stiction.body { mesh = stiction.mesh.block { origin = { -60*mm, 0*mm }, size = { 120*mm, 3*mm },
        cells = { 60, 3 } },
        material = stiction.material.linear_elastic { young = 1*GPa, poisson = 0.3 }, density = 1000*kg/m^3 } },
      obstacles = { left = roller(-50), right = roller(50) },
      pairs = { left = stiction.pair { secondary = "beam.bottom", primary = "left" },
        right = stiction.pair { secondary = "beam.bottom", primary = "right" } },
      motions = { stiction.motion.drive { set = "beam.top", near = { 0*mm, 3*mm }, times = { 0*s, 1*s }, x = { 0*mm, 0*mm },
        y = { 0*mm, -depth } } },
      scheme = stiction.scheme.quasi_static { stabilisation = 1e-6 },
      schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = 20 } } }, probes = {},
    }
  end
  equal(scenes.warned(beam(2*mm), "will be strained"), false) -- by 6 h depth / L^2 = 0.4 %
  equal(scenes.warned(beam(60*mm), "will be strained"), true) -- 11 %
end)

test("a half of a disc is pressed along the normal of the plane, not along the mean of its rim's", function()
  local function to(x, y, name, round)
    return stiction.edge { to = { x*mm, y*mm }, name = name, centre = round and { 0*mm, 0*mm } or nil }
  end
  local function plane(y, way)
    return stiction.obstacle { shape = stiction.rigid.plane { point = { 0*mm, y*mm }, normal = { 0, way } }, times = { 0*s, 1*s },
      y = { 0*mm, (way < 0 and -4 or 0)*mm } }
  end
  local scene = stiction.scene {
    bodies = { disc = stiction.body { mesh = stiction.mesh.gmsh { size = 1*mm, start = { 0*mm, -10*mm },
        edges = { to(10, 0, "rim", true), to(0, 10, "rim", true), to(0, -10, "middle") } },
      material = stiction.material.linear_elastic { young = 1*MPa, poisson = 0.3 }, density = 1000*kg/m^3 } },
    obstacles = { low = plane(-10, 1), top = plane(10, -1) },
    pairs = { low = stiction.pair { secondary = "disc.rim", primary = "low" },
      top = stiction.pair { secondary = "disc.rim", primary = "top" } },
    motions = { stiction.motion.fix { set = "disc.middle", y = false } },
    scheme = stiction.scheme.quasi_static { stabilisation = 1e-6 },
    schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = 10 } } }, probes = {},
  }
  local warning = scenes.warning(scene, "will be strained by about")
  local strain = tonumber(warning.text:match("by about ([%d.]+) %%"))
  assert(strain > 15 and strain < 30, warning.text) -- 4 mm of 20
end)
