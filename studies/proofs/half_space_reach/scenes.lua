-- A block under a rigid sphere, punch, or sphere that adheres, in units of the contact radius a; and the half space's answer.
local stiction = require "stiction"
local units = stiction.units
local m, s, kg, Pa = units.m, units.s, units.kg, units.Pa
local jkr, maugis, point = stiction.reference.jkr, stiction.reference.maugis, stiction.reference.point_contact

local scenes = {}

local young = 1e6 -- Pa
local flat_part = 0.8 -- of a punch's contact that is flat; its edge is a parabola

function scenes.modulus(p) return jkr.modulus(young, p.poisson) end

--- Depth at which the half space has the contact radius 1 m; of a sphere that adheres Maugis' unit.
function scenes.depth(p) return p.slope end

--- Height of the punch's edge is (r - flat part)^2 / (2 this), m: the contact ends at 1 m.
local function rounding(p)
  return (math.sqrt(1 - flat_part ^ 2) - flat_part * math.acos(flat_part)) / scenes.depth(p)
end

--- 2 E* (a d - int_0^a g ds), g(s) = s int_0^s f'(r) / sqrt(s^2 - r^2) dr of the height f (Sneddon 1965); Simpson.
local function punch_force(p)
  local n, sum, h = 200, 0, (1 - flat_part) / 200
  for i = 0, n do
    local at = flat_part + i * h
    local g = at / rounding(p) * (math.sqrt(math.max(0, at ^ 2 - flat_part ^ 2)) - flat_part * math.acos(math.min(1, flat_part / at)))
    sum = sum + ((i == 0 or i == n) and 1 or i % 2 == 1 and 4 or 2) * g
  end
  return 2 * scenes.modulus(p) * (scenes.depth(p) - sum * h / 3)
end

--- Work of adhesion of a pull, J/m^2: Maugis' unit of length is 1 m.
function scenes.work(p) return 4 / 3 * scenes.modulus(p) * p.slope ^ 2 / math.pi end

--- What forces are over: that of the half space at the same approach, or pi w R.
function scenes.force(p)
  if p.kind == "punch" then
    return punch_force(p)
  end
  local R = 1 / p.slope
  return p.kind == "pull" and math.pi * scenes.work(p) * R or point.force(scenes.depth(p), R, scenes.modulus(p))
end

local function shape(p)
  if p.kind ~= "punch" then
    return stiction.rigid.sphere { centre = { 0*m, 1 / p.slope * m }, radius = 1 / p.slope * m }
  end
  local points, n, curve = {}, 80, 2 * rounding(p)
  for i = 0, n do -- as close along the flat part, where a spline bulges
    local r = 2 * flat_part * i / n
    points[#points + 1], points[#points + 2] = r * m, math.max(0, r - flat_part) ^ 2 / curve * m
  end
  return stiction.rigid.polyline { points = points }
end

local function adhesion(p)
  local sigma0 = maugis.traction(scenes.modulus(p), 1 / p.slope, scenes.work(p), p.lambda)
  return stiction.adhesion.dugdale { sigma0 = sigma0*Pa, h0 = scenes.work(p) / sigma0 * m, ramp = p.ramp }
end

--- Finer by two from level to level, and so is the growth of cells away from the contact.
local function mesh(p)
  local h, L, cell = 1 / p.thick, 1 / p.wide, 1 / (p.cells * 2 ^ p.level)
  local near = p.kind == "pull" and 2 or p.kind == "punch" and 1.1 or 1.25
  return stiction.mesh.graded_block { origin = { 0*m, -h * m }, size = { L * m, h * m },
    fine = { math.min(near, L) * m, math.min(0.5, h) * m }, fine_size = cell * m,
    coarse_size = math.max(math.min(h, L) / 12 / 2 ^ p.level, cell) * m, growth = p.growth ^ (1 / 2 ^ p.level) }
end

function scenes.scene(p)
  assert(p.set and p.number) -- its name
  local d, pull = scenes.depth(p), p.kind == "pull"
  local times, y, stages = { 0*s, 1*s }, { 0*m, -d * m }, { stiction.stage { to = 1*s, steps = p.steps } }
  if pull then
    times, y = { 0*s, 1*s, 2*s }, { 0*m, -p.depth * d * m, p.above * d * m }
    stages[2] = stiction.stage { to = 2*s, steps = p.up }
  end
  local law = stiction.material[p.law] { young = young*Pa, poisson = p.poisson }
  return stiction.scene {
    kinematics = "axisymmetric",
    bodies = { block = stiction.body { mesh = mesh(p), material = law, density = 1000*kg/m^3, interpolation = "mean_dilatation" } },
    obstacles = { tool = stiction.obstacle { shape = shape(p), times = times, y = y } },
    motions = { stiction.motion.fix { set = "block.bottom", x = p.base == "stuck", y = true },
      stiction.motion.fix { set = "block.left", y = false } },
    pairs = { touch = stiction.pair { secondary = "block.top", primary = "tool", adhesion = pull and adhesion(p) or nil } },
    scheme = stiction.scheme.quasi_static {}, schedule = stiction.schedule { stages = stages },
    output = stiction.output { frames = 0 }, probes = { touch = stiction.probe.contact { pair = "touch" } },
  }
end

--- What explain says: bound of the half space's error.
function scenes.bound(p)
  for _, section in ipairs(stiction.explain(scenes.scene(p)).sections) do
    for _, line in ipairs(section.lines) do
      if line.name == "half space" then
        return line.value
      end
    end
  end
  error("explain says nothing of a half space")
end

return scenes
