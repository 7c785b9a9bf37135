-- A rigid bead on a gel with surface stress: the scene, and where the bead rests. Parameters: R, w, gamma, young, poisson of the
-- case, and what `chosen` holds.
local stiction = require "stiction"
local jkr = stiction.reference.jkr
local um, m, s, kg, N = stiction.units.um, stiction.units.m, stiction.units.s, stiction.units.kg, stiction.units.N

local bead = {}

bead.chosen = {
  size = { 12, "of the block, in the larger of bead and contact" }, wide = { 1.2, "finest cells, of that" },
  stiff = { 4, "C h^2 / w, or" }, zone = { 5, "cells to E*/C, the stiffer" },
  deep = { 4, "pressed first, in depths of JKR, or until" }, far = { 1.3, "contact radii of wetting, the lesser" },
  slack = { 1e-3*s, "b / w: bonds that snap do it within a step" }, steps = { 80, "on the way back" },
}

function bead.liquid(p) return p.w.si * p.R.si / p.gamma.si end -- depth, m

--- JKR without a load: radius and depth, m.
function bead.solid(p)
  local a = (9 * math.pi * p.w.si * p.R.si ^ 2 / (2 * jkr.modulus(p.young.si, p.poisson))) ^ (1 / 3)
  return a, a ^ 2 / (3 * p.R.si)
end

--- How deep it is pressed so that it touches farther than it will: into an elastic body, or a membrane held at its rim; m.
local function pressed(p)
  local _, d = bead.solid(p)
  local R, a = p.R.si, p.far * math.sqrt(2 * p.R.si * bead.liquid(p))
  return math.min(p.deep * d, a ^ 2 / R * (0.5 + math.log(p.size * R / a)))
end

function bead.scene(p)
  local radius, depth = bead.solid(p)
  local R, E, zero = p.R.si, jkr.modulus(p.young.si, p.poisson), 0*um
  local a = math.min(math.sqrt(2 * R * math.min(depth, bead.liquid(p))) * 1.25, radius) * p.wide -- it touches less far
  local h, size = p.cell * a, p.size * math.max(R, a)
  local C = math.max(p.stiff * p.w.si / (h * h), E / (p.zone * h))*N/m^3 -- so far apart and so near the edge bonds act
  return stiction.scene {
    kinematics = "axisymmetric",
    bodies = { gel = stiction.body { density = 1000*kg/m^3, interpolation = "mean_dilatation",
      mesh = stiction.mesh.graded_block { origin = { zero, -size*m }, size = { size*m, size*m }, growth = 1.2,
        fine = { 1.4 * a*m, 6 * h*m }, fine_size = h*m, coarse_size = size / 12 * m },
      material = stiction.material.neo_hookean { young = p.young, poisson = p.poisson } } },
    obstacles = { bead = stiction.obstacle { shape = stiction.rigid.sphere { centre = { zero, p.R }, radius = p.R },
      times = { 0*s, 1*s, 2*s }, y = { zero, -pressed(p)*m, zero } } },
    pairs = { touch = stiction.pair { secondary = "gel.top", primary = "bead",
      adhesion = stiction.adhesion.rcc { w = p.w, C_n = C, C_t = C, b = p.slack * p.w } } },
    loads = { stiction.load.surface_stress { set = "gel.top", gamma = p.gamma } },
    motions = { stiction.motion.fix { set = "gel.bottom" }, stiction.motion.fix { set = "gel.left", y = false },
      stiction.motion.fix { set = "gel.right", y = false } },
    scheme = stiction.scheme.quasi_static {}, output = stiction.output { frames = 2 },
    schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = 40 }, stiction.stage { to = 2*s, steps = p.steps } } },
    probes = { touch = stiction.probe.contact { pair = "touch" }, bead = stiction.probe.rigid { obstacle = "bead" },
      energy = stiction.probe.energy { audit = true } },
  }
end

--- Depth at which the bead bears nothing on its way back, m; 0: nowhere.
function bead.rest(run)
  local force, y = run:series("touch", "force_y"), run:series("bead", "u_y")
  for i = 2, #force do
    if run.time[i] > 1 and force[i] >= 0 and force[i - 1] < 0 then
      local part = force[i] / (force[i] - force[i - 1])
      return -(y[i] + part * (y[i - 1] - y[i]))
    end
  end
  return 0
end

return bead
