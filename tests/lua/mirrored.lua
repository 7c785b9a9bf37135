-- Scenes that are symmetric or mirrored, step by step: what rounding decides must not show.
local test, _, _, shared = ...
local stiction = require "stiction"
local units = stiction.units
local mm, s, kg, m, J, MPa, N = units.mm, units.s, units.kg, units.m, units.J, units.MPa, units.N

local run = shared("runs").quasi_static "mirrored_runs"

--- A block, 10 mm by 5 mm, on a plane with friction and bonds; its top goes through x and y at these times.
local function block(t)
  local floor = stiction.obstacle { shape = stiction.rigid.plane {} }
  return stiction.scene {
    bodies = { block = stiction.body { mesh = stiction.mesh.block { origin = { -5*mm, 0*mm }, size = { 10*mm, 5*mm }, cells = { 6, 3 } },
      material = stiction.material.linear_elastic { young = 1*MPa, poisson = 0.3 }, density = 1000*kg/m^3 } },
    obstacles = { floor = floor },
    pairs = { touch = stiction.pair { secondary = "block.bottom", primary = "floor", friction = stiction.friction.coulomb { mu = 0.3 },
      adhesion = stiction.adhesion.rcc { w = 1*J/m^2, C_n = t.C * (1*N/m^3), C_t = t.C * (1*N/m^3), b = t.b * (1*N*s/m) } } },
    motions = { stiction.motion.drive { set = "block.top", times = t.times, x = t.x, y = t.y } },
    scheme = stiction.scheme.quasi_static {},
    schedule = stiction.schedule { stages = { stiction.stage { to = t.times[#t.times], steps = t.steps } } },
    probes = { line = stiction.probe.contact_line { pair = "touch" }, energy = stiction.probe.energy {} },
  }
end

test("bonds that form in thousands of steps form on both sides alike", function()
  local case = run(block { C = 1e9, b = 0.5, times = { 0*s, 0.1*s }, x = { 0*mm, 0*mm }, y = { 0*mm, -0.05*mm }, steps = 1000 })
  local most, off = 0, 0
  for k = 1, 3 do
    local left, right = case:series("line", "pressure", k), case:series("line", "pressure", 8 - k)
    for i in ipairs(left) do
      most, off = math.max(most, left[i]), math.max(off, math.abs(left[i] - right[i]))
    end
  end
  assert(most > 1000 and off < 1e-9 * most, off / most)
end)

test("friction takes from points that open in a step nothing that rounding decides", function()
  local taken = {}
  for _, side in ipairs { 1, -1 } do
    local case = run(block { C = 5e8, b = 0.5, times = { 0*s, 1*s, 2*s, 3*s }, x = { 0*mm, 0*mm, side * mm, side * mm },
      y = { 0*mm, -0.2*mm, -0.2*mm, 0.4*mm }, steps = 90 })
    taken[#taken + 1] = case:series("energy", "friction_loss")
  end
  local first, second = taken[1], taken[2]
  for i = 2, #first do
    assert(first[i] >= first[i - 1] - 1e-12 * first[#first], i)
    assert(math.abs(first[i] - second[i]) < 1e-7 * first[#first], ("%d: %g, %g"):format(i, first[i], second[i]))
  end
end)

--- A hairpin whose shorter leg is pressed on the longer one and drawn along it; upwards, or mirrored in y. The inside of it
--- touches itself, all around its tip where `round`.
local function hairpin(up, round)
  local function to(x, y, name) return stiction.edge { to = { x*mm, up * y*mm }, name = name } end
  local function arc(x, y, name) return stiction.edge { to = { x*mm, up * y*mm }, centre = { 0*mm, 0*mm }, name = name } end
  local tip = round and "inside" or nil
  local mesh = stiction.mesh.gmsh { size = 0.5*mm, start = { 10*mm, up * -3*mm }, edges = { to(10, -2.5), to(10, -1.5),
    to(0, -1.5, "inside"), arc(-1.5, 0, "inside"), arc(0, 1.5, "inside"), to(6, 1.5, "inside"), to(6, 2.5, tip), to(6, 3, "end"),
    to(0, 3), arc(-3, 0), arc(0, -3), to(10, -3, "base") } }
  local times = { 0*s, 1*s, 2*s }
  return stiction.scene {
    bodies = { pin = stiction.body { mesh = mesh, material = stiction.material.neo_hookean { young = 1*MPa, poisson = 0.4 },
      density = 1000*kg/m^3 } },
    pairs = { own = stiction.pair { secondary = "pin.inside", primary = "pin.inside", friction = stiction.friction.coulomb { mu = 0.4 } } },
    motions = { stiction.motion.fix { set = "pin.base" }, stiction.motion.drive { set = "pin.end", times = times,
      x = { 0*mm, 0*mm, 1*mm }, y = { 0*mm, up * -3.2*mm, up * -3.2*mm } } },
    scheme = stiction.scheme.quasi_static {},
    schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = 30 }, stiction.stage { to = 2*s, steps = 30 } } },
    probes = { pull = stiction.probe.force { set = "pin.end" }, energy = stiction.probe.energy {} },
  }
end

test("the end of a leg that touches the other one is borne whichever way up the two are", function()
  local forces, losses = {}, {}
  for _, round in ipairs { false, true } do
    for _, up in ipairs { 1, -1 } do
      local case = run(hairpin(up, round))
      forces[#forces + 1], losses[#losses + 1] = case:last("pull", "force_x"), case:last("energy", "friction_loss")
    end
  end
  assert(losses[1] > 1e-3, losses[1])
  for k = 2, 4 do
    assert(math.abs(forces[k] / forces[1] - 1) < 1e-6, ("%d: %g, %g"):format(k, forces[k], forces[1]))
    assert(math.abs(losses[k] / losses[1] - 1) < 1e-6, ("%d: %g, %g"):format(k, losses[k], losses[1]))
  end
end)

--- A block turned one way or the other, lifted, then pressed on a base of other cells by mortar in space and drawn aside.
local function slab(way)
  local function body(corner, size, cells)
    return stiction.body { mesh = stiction.mesh.box { origin = corner, size = size, cells = cells }, density = 1000*kg/m^3,
      material = stiction.material.neo_hookean { young = 1*MPa, poisson = 0.3 } }
  end
  local still, angle, aside = 0*mm, way * 0.4, way * 0.2*mm
  return stiction.scene { kinematics = "three_dimensional",
    bodies = { block = body({ -2*mm, -1.5*mm, 0*mm }, { 4*mm, 3*mm, 1*mm }, { 3, 2, 1 }),
      base = body({ -3.2*mm, -2.5*mm, -1*mm }, { 6.4*mm, 5*mm, 1*mm }, { 4, 3, 1 }) },
    pairs = { touch = stiction.pair { secondary = "block.bottom", primary = "base.top", discretisation = "mortar",
      friction = stiction.friction.coulomb { mu = 0.3 } } },
    motions = { stiction.motion.fix { set = "base.bottom" },
      stiction.motion.turn { set = "block.top", times = { 0*s, 1*s, 2*s, 3*s }, centre = { still, still, still },
        angle = { 0, angle, angle, angle }, x = { still, still, still, 0.1*mm }, y = { still, aside, aside, aside },
        z = { still, 0.02*mm, -0.1*mm, -0.1*mm } } },
    schedule = stiction.schedule { stages = { stiction.stage { to = 3*s, steps = 12 } } },
    probes = { touch = stiction.probe.contact { pair = "touch" },
      corner = stiction.probe.node { set = "base.top", near = { -3.2*mm, way * 2.5*mm, 0*mm } } } }
end

test("mortar in space presses and rubs mirrored surfaces alike", function()
  local one, other = run(slab(1)), run(slab(-1))
  for column, way in pairs { force_x = 1, force_y = -1, force_z = 1, pressure_max = 1, slip = 1 } do
    local a, b = one:last("touch", column), other:last("touch", column)
    assert(math.abs(a) > 1e-9 and math.abs(way * b / a - 1) < 1e-7, ("%s: %.9g, %.9g"):format(column, a, b))
  end
  local a, b = one:last("corner", "u_z"), other:last("corner", "u_z")
  assert(math.abs(b / a - 1) < 1e-6, b / a)
end)
