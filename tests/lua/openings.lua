-- Bonds that open where no motion tells it beforehand: steps that would pass a barrier, what explain says of them, and bonds
-- across a gap at the start.
local test, equal, _, shared = ...
local engine = require "stiction.engine"
local stiction = require "stiction"
local units = stiction.units
local mm, um, s, kg, m, N, J, MPa, GPa = units.mm, units.um, units.s, units.kg, units.m, units.N, units.J, units.MPa, units.GPa
local fix, drive = stiction.motion.fix, stiction.motion.drive

local run = shared("runs").quasi_static "opening_runs"

local function near(got, wanted, part)
  if got ~= got or math.abs(got - wanted) > part then
    error(("%g is off %g by more than %g"):format(got, wanted, part), 2)
  end
end

local whole = { bilinear = stiction.adhesion.bilinear { K = 1e12*N/m^3, sigma_n = 3*MPa, sigma_t = 3*MPa, G_I = 50*J/m^2,
  G_II = 50*J/m^2 }, exponential = stiction.adhesion.exponential { phi_n = 50*J/m^2, sigma_max = 3*MPa, delta_t = 10*um } }

--- A beam, 60 mm by 2 mm, of which the right two thirds lie bonded on a plate that ends at x = 20 mm.
local function beam(t)
  return { bodies = { beam = stiction.body { mesh = stiction.mesh.block { size = { 60*mm, 2*mm }, cells = { 60, 2 },
      kind = "quad8" }, material = stiction.material.linear_elastic { young = 2000*MPa, poisson = 0.3 }, density = 1000*kg/m^3 } },
    obstacles = { plate = stiction.obstacle { shape = stiction.rigid.polyline { smoothing = "polyline",
      points = { 80*mm, 0*mm, 20*mm, 0*mm, 20*mm, -1*mm } } } },
    pairs = { joint = stiction.pair { secondary = "beam.bottom", primary = "plate", adhesion = t.adhesion } },
    motions = t.motions or { fix { set = "beam.right", x = true } }, springs = t.springs,
    schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = t.steps } } },
    probes = { joint = stiction.probe.contact { pair = "joint" }, line = stiction.probe.contact_line { pair = "joint" },
      energy = stiction.probe.energy {}, lift = t.springs and stiction.probe.spring { spring = "lift" } } }
end

local function lifted(law, steps)
  return beam { adhesion = whole[law], steps = steps, springs = { lift = stiction.spring { from = "beam.left", axes = { 0, 1 },
    stiffness = 1e8*N/m, times = { 0*s, 1*s }, y = { 0*mm, 1.2*mm } } } }
end

test("no step goes to a state of more energy than there was, where all bonds are gone that had hardly been pulled", function()
  for law in pairs(whole) do
    local few, many = run(lifted(law, 5)), run(lifted(law, 40))
    near(few:max("lift", "force_y"), many:max("lift", "force_y"), 1)
    near(few:last("joint", "beta_mean"), many:last("joint", "beta_mean"), 1e-3)
    equal(many:max("lift", "force_y") > 400, true)
  end
end)

test("where steps may not be shorter such a state is taken, and the run says so", function()
  for _, shortest in ipairs { { halvings = 0 }, { accuracy = stiction.accuracy { smallest = 0.2*s, largest = 0.2*s } } } do
    local scene = lifted("bilinear", 5)
    scene.schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = 5 } }, halvings = shortest.halvings,
      accuracy = shortest.accuracy }
    local case = run(scene)
    equal(case:max("lift", "force_y") < 1, true)
    equal(table.concat(case.result.remarks, "\n"):find("the time steps made energy", 1, true) ~= nil, true)
  end
end)

local function number_of(scene, name)
  for _, section in ipairs(engine.explain(scene).sections) do
    for _, entry in ipairs(section.lines) do
      if entry.name == name then
        return entry
      end
    end
  end
  error("no number " .. name, 2)
end

test("explain says where speeds leave out what springs do, and looks at what turns where it opens fastest", function()
  local still = beam { adhesion = whole.bilinear, steps = 10 }
  for _, name in ipairs { "opening speed", "opening per step / u0" } do
    equal(number_of(lifted("bilinear", 10), name).meaning:find("springs", 1, true) ~= nil, true)
    equal(number_of(still, name).meaning:find("springs", 1, true), nil)
  end
  local turned = beam { adhesion = whole.bilinear, steps = 10, motions = { stiction.motion.turn { set = "beam.right",
    centre = { 60*mm, 0*mm }, times = { 0*s, 1*s }, angle = { 0, -0.01 } } } }
  near(number_of(turned, "opening speed").value, 0.4e-3, 0.01e-3) -- of the end that is farthest from the centre
end)

test("RCC with beta0 leaves across a gap what that gap would leave of it at rest", function()
  for _, b in ipairs { 0, 50 } do
    local case = run(beam { steps = 5, motions = { fix { set = "beam.right" }, fix { set = "beam.left" } },
      adhesion = stiction.adhesion.rcc { w = 50*J/m^2, C_n = 1.8e11*N/m^3, C_t = 0*N/m^3, b = b*N*s/m, beta0 = 1,
        bonding = "never" } })
    near(case:series("energy", "bond")[1], -2, 0.05) -- J/m: 40 mm, and half a cell
    near(case:min("joint", "adhesion_n"), 0, 1)
  end
end)

test("accuracy without inertia says what it does not see, with bonds or events as well", function()
  local scene = beam { adhesion = whole.bilinear, steps = 5, motions = { fix { set = "beam.right" }, fix { set = "beam.left" } } }
  scene.schedule.accuracy = stiction.accuracy {}
  local function told(case)
    return table.concat(case.result.remarks, "\n"):find("not how bodies flow", 1, true) ~= nil
  end
  equal(told(run(scene)), false)
  scene.bodies.beam.relaxing = { { share = 0.5, time = 0.01*s } }
  equal(told(run(scene)), true)
end)

engine.remove("opening_runs")

test("the end-notched flexure of a specimen that bonds alone hold goes on past the start of its crack", function()
  local edge, h, l, notch = stiction.edge, 2*mm, 40*mm, 32*mm
  local function half(edges)
    return stiction.body { mesh = stiction.mesh.gmsh { size = 1*mm, kind = "quad8", start = { 0*mm, 0*mm }, edges = edges },
      material = stiction.material.linear_elastic { young = 100*GPa, poisson = 0 }, density = 1000*kg/m^3 }
  end
  local up = half { edge { to = { notch, 0*mm }, name = "crack" }, edge { to = { 2*l, 0*mm }, name = "bond" },
    edge { to = { 2*l, h }, name = "far" }, edge { to = { l, h }, name = "out" }, edge { to = { 0*mm, h }, name = "out" },
    edge { to = { 0*mm, 0*mm }, name = "near" } }
  local low = half { edge { to = { 0*mm, -h }, name = "near" }, edge { to = { 2*l, -h }, name = "out" },
    edge { to = { 2*l, 0*mm }, name = "far" }, edge { to = { notch, 0*mm }, name = "bond" }, edge { to = { 0*mm, 0*mm }, name = "crack" } }
  local case = run { bodies = { up = up, low = low },
    pairs = { bond = stiction.pair { secondary = "up.bond", primary = "low.bond", adhesion = stiction.adhesion.bilinear {
      K = 1e14*N/m^3, sigma_n = 6*MPa, sigma_t = 6*MPa, G_I = 6*J/m^2, G_II = 6*J/m^2 } } },
    motions = { fix { set = "up.out", near = { 0*mm, h }, y = true }, fix { set = "low.out", near = { 0*mm, -h }, y = true },
      fix { set = "low.out", near = { 2*l, -h }, x = true, y = true },
      drive { set = "up.out", near = { l, h }, times = { 0*s, 1*s }, y = { 0*mm, -0.112*mm } } },
    schedule = stiction.schedule { stages = { stiction.stage { to = 0.5*s, steps = 2 }, stiction.stage { to = 1*s, steps = 10 } } },
    probes = { press = stiction.probe.force { set = "up.out", near = { l, h } }, e = stiction.probe.energy {} } }
  -- G_II = 9 P^2 a^2 / (16 E h^3) with the length a that the compliance (3 a^3 + 2 l^3) / (8 E h^3) tells
  local force, stiffness = -case:last("press", "force_y"), 8 * 100e9 * 0.002^3
  local grown = ((stiffness * 0.112e-3 / force - 2 * 0.04^3) / 3)^(1 / 3)
  equal(grown > 0.034, true)
  near(9 * force^2 * grown^2 / (2 * stiffness), 6, 0.2)
end)

test("bonds that are torn off in steps too long to see them pull are remarked on", function()
  local run_with_inertia = shared("runs").below "torn_runs"
  local function told(steps)
    local case = run_with_inertia(stiction.scene {
      bodies = { foot = stiction.body { mesh = stiction.mesh.block { size = { 10*mm, 10*mm }, cells = { 10, 10 } },
        material = stiction.material.linear_elastic { young = 100*MPa, poisson = 0.3 }, density = 1000*kg/m^3 } },
      obstacles = { floor = stiction.obstacle { shape = stiction.rigid.plane {} } },
      pairs = { bond = stiction.pair { secondary = "foot.bottom", primary = "floor", adhesion = stiction.adhesion.bilinear {
        K = 1e12*N/m^3, sigma_n = 1*MPa, sigma_t = 1*MPa, G_I = 50*J/m^2, G_II = 50*J/m^2 } } },
      motions = { drive { set = "foot.top", times = { 0*s, 2e-3*s }, y = { 0*mm, 2*mm } } },
      scheme = stiction.scheme.theta_xi {},
      schedule = stiction.schedule { stages = { stiction.stage { to = 2e-3*s, steps = steps } } },
      probes = { bond = stiction.probe.contact { pair = "bond" } },
    })
    equal(case.result.verdict, "finished")
    for _, remark in ipairs(case.result.remarks) do
      if remark:find("bonds were torn off in steps too long to see them pull", 1, true) then
        return true
      end
    end
    return false
  end
  equal(told(10), true)
  equal(told(100), false)
end)

test("bonds that follow their opening take no iteration for whether they touch", function()
  for _, law in pairs(whole) do
    local case = run(stiction.scene {
      bodies = { block = stiction.body { mesh = stiction.mesh.block { size = { 1*mm, 1*mm }, cells = { 1, 1 } },
        material = stiction.material.linear_elastic { young = 70*GPa, poisson = 0 }, density = 1000*kg/m^3 } },
      obstacles = { floor = stiction.obstacle { shape = stiction.rigid.plane {} } },
      pairs = { glue = stiction.pair { secondary = "block.bottom", primary = "floor", adhesion = law } },
      motions = { drive { set = "block.top", times = { 0*s, 1*s }, x = { 0*um, 5*um }, y = { 0*um, 0*um } } },
      schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = 20 } } }, probes = {} })
    equal(case.result.iterations, 20)
  end
end)
