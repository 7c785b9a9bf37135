-- The four contacts, each on a finite body by elements ("mesh") and on a half space by its points ("points").
local stiction = require "stiction"
local units = stiction.units
local m, s, kg, Pa, N = units.m, units.s, units.kg, units.Pa, units.N
local jkr, maugis = stiction.reference.jkr, stiction.reference.maugis

local scenes = {}

--- Modulus of the body under a rigid counterpart.
function scenes.modulus(p) return jkr.modulus(p.young.si, p.poisson) end

local function w(p) return p.bond * scenes.modulus(p) * p.radius.si end

--- Length, force and depth that make a scene's numbers pure: Hertz's a, or Maugis' units.
function scenes.scales(p)
  if p.contact == "pull_off" then
    return maugis.units(scenes.modulus(p), p.radius.si, w(p))
  end
  local a, E = p.slope * p.radius.si, scenes.modulus(p)
  local force = p.contact == "shear" and math.pi * E * a * p.slope / 4 or 4 / 3 * E * a ^ 2 * p.slope
  return a, force, a * p.slope
end

local function adhesion(p)
  local sigma0 = maugis.traction(scenes.modulus(p), p.radius.si, w(p), p.lambda)
  return stiction.adhesion.dugdale { sigma0 = sigma0*Pa, h0 = w(p) / sigma0 * m, ramp = p.ramp }
end

--- What both sides share: the law, the stages, the probes.
local function common(p, names)
  local pair = { secondary = names.secondary, primary = names.primary }
  local last = (p.contact == "sphere" or p.contact == "unlike") and 1 or 2
  local stages = { stiction.stage { to = 1*s, steps = ({ sphere = p.press, unlike = p.grip })[p.contact] or p.down } }
  if p.contact == "pull_off" then
    pair.adhesion = adhesion(p)
  elseif p.contact ~= "sphere" then
    pair.friction = stiction.friction.coulomb { mu = p.mu }
  end
  if last == 2 then
    stages[2] = stiction.stage { to = 2*s, steps = p.contact == "shear" and p.along or p.up }
  end
  return { pairs = { touch = stiction.pair(pair) }, scheme = stiction.scheme.quasi_static {},
    schedule = stiction.schedule { stages = stages }, output = stiction.output { frames = 1 },
    probes = { touch = stiction.probe.contact { pair = "touch" }, energy = stiction.probe.energy {} } }
end

--- Way of the counterpart into the surface and along it at 0, 1 and 2 s.
local function paths(p)
  local _, _, d = scenes.scales(p)
  if p.contact == "sphere" or p.contact == "unlike" then
    return { 0*s, 1*s }, { 0*m, -d * m }
  elseif p.contact == "pull_off" then
    return { 0*s, 1*s, 2*s }, { 0*m, -p.depth * d * m, p.above * d * m }
  end
  return { 0*s, 1*s, 2*s }, { 0*m, -p.sink * d * m, -p.sink * d * m }, { 0*m, 0*m, p.way * p.mu * d * m }
end

--- The block that stands for the half space: all of it in plane strain, half of a section through its axis.
local function block_mesh(p)
  local a = scenes.scales(p)
  local size, h, near = p.size * a * m, a / p.cells * m, (p.contact == "pull_off" and 2 or 1.25) * a * m
  if p.contact ~= "shear" then
    return stiction.mesh.graded_block { origin = { 0*m, -size }, size = { size, size }, fine = { near, 0.5 * a * m },
      fine_size = h, coarse_size = size / 12, growth = p.growth }
  end
  local edge = stiction.edge
  return stiction.mesh.gmsh { size = p.coarse * a * m, kind = "quad4", start = { -size, 0*m }, edges = {
    edge { to = { -near, 0*m } }, edge { to = { near, 0*m }, name = "top" }, edge { to = { size, 0*m } },
    edge { to = { size, -size } }, edge { to = { -size, -size }, name = "bottom" }, edge { to = { -size, 0*m } } },
    refine = { stiction.refinement { near = "top", size = h, within = 0.5 * a * m, beyond = 10 * a * m } } }
end

local function by_mesh(p)
  local axial = p.contact ~= "shear"
  local t = common(p, { secondary = "block.top", primary = "body" })
  local times, y, x = paths(p)
  t.kinematics = axial and "axisymmetric" or nil
  t.bodies = { block = stiction.body { mesh = block_mesh(p), density = 1000*kg/m^3, interpolation = "mean_dilatation",
    material = stiction.material.linear_elastic { young = p.young, poisson = p.poisson } } }
  local shape = axial and stiction.rigid.sphere or stiction.rigid.circle
  t.obstacles = { body = stiction.obstacle { shape = shape { centre = { 0*m, p.radius }, radius = p.radius },
    times = times, x = x, y = y } }
  t.motions = { stiction.motion.fix { set = "block.bottom" } }
  if axial then
    t.motions[2] = stiction.motion.fix { set = "block.left", y = false }
  end
  return stiction.scene(t)
end

local function by_points(p)
  local a, force = scenes.scales(p)
  local plane = p.contact == "shear"
  local extent = p.extent * a * m
  local t = common(p, { secondary = "base.surface", primary = "body" })
  local times, z, x = paths(p)
  t.kinematics = not plane and "three_dimensional" or nil
  t.bodies = { base = stiction.body.half_space { young = p.young, poisson = p.poisson, boundary = "free",
    size = plane and { extent } or { extent, extent }, points = plane and { p.points } or { p.points, p.points } } }
  local surface = plane and stiction.surface.cylinder or stiction.surface.sphere
  t.obstacles = { body = stiction.obstacle.height_map { surface = surface { radius = p.radius }, times = times, x = x,
    z = not plane and z or nil, force = plane and { 0*N, force * N, force * N } or nil } }
  return stiction.scene(t)
end

function scenes.scene(p) return p.side == "mesh" and by_mesh(p) or by_points(p) end

return scenes
