-- A rigid bead that sticks to a gel without a load: from Johnson, Kendall and Roberts to wetting, as surface stress takes over.
--
--         .-'''-.      drawn off slowly until it bears nothing: it rests at the depth d
--        | bead  |
--   _____.'-._.-'._____   gel: neo-Hookean, nearly incompressible; surface stress gamma all over its top, bonds of energy w
--         gel
--
-- Stiff gel, gamma/(E R) << 1: JKR without a load, d = a^2 / (3 R), a^3 = 9 pi w R^2 / (2 E*).
-- Soft gel,  gamma/(E R) >> 1: the surface stays flat and the bead floats in it as in a liquid. With the energy
-- gamma (area outside + cap) - w cap = gamma (pi d^2 + const) - w 2 pi R d it rests at d = w R / gamma (Young and Dupre).
--
--     ./stiction run studies/proofs/soft_wetting
local stiction = require "stiction"
local jkr = stiction.reference.jkr
local units, numeric = stiction.units, stiction.numeric
local um, m, s, kg, N, mN = units.um, units.m, units.s, units.kg, units.N, 1e-3 * units.N

local function young(p) return p.gamma.si / (p.R.si * p.softness) end -- Pa
local function modulus(p) return jkr.modulus(young(p), p.poisson) end
local function liquid(p) return p.w.si * p.R.si / p.gamma.si end -- m
local function solid(p) -- JKR without a load: radius and depth, m
  local a = (9 * math.pi * p.w.si * p.R.si ^ 2 / (2 * modulus(p))) ^ (1 / 3)
  return a, a ^ 2 / (3 * p.R.si)
end
local function least(p) -- of the two
  local _, d = solid(p)
  return math.min(d, liquid(p))
end

local function pressed(p) -- so that it touches farther than it will: into an elastic body, or a membrane held at its rim
  local _, d = solid(p)
  local R, a = p.R.si, p.far * math.sqrt(2 * p.R.si * liquid(p))
  return math.min(p.deep * d, a ^ 2 / R * (0.5 + math.log(p.size * R / a)))
end

local function scene(p)
  local d, R, zero = least(p), p.R.si, 0*um
  local a = math.min(math.sqrt(2 * R * d) * 1.25, (solid(p))) * p.wide -- fine as far as it ever touches
  local h = p.cell * a
  local size = p.size * math.max(R, a)
  local C = math.max(p.stiff * p.w.si / (h * h), modulus(p) / (p.zone * h)) -- so far apart and so near the edge bonds act
  return stiction.scene {
    kinematics = "axisymmetric",
    bodies = { gel = stiction.body { density = 1000*kg/m^3, interpolation = "mean_dilatation",
      mesh = stiction.mesh.graded_block { origin = { zero, -size*m }, size = { size*m, size*m }, growth = 1.2,
        fine = { 1.4 * a*m, 6 * h*m }, fine_size = h*m, coarse_size = size / 12 * m },
      material = stiction.material.neo_hookean { young = young(p)*N/m^2, poisson = p.poisson } } },
    obstacles = { bead = stiction.obstacle { shape = stiction.rigid.sphere { centre = { zero, p.R }, radius = p.R },
      times = { 0*s, 1*s, 2*s }, y = { zero, -pressed(p)*m, zero } } },
    pairs = { touch = stiction.pair { secondary = "gel.top", primary = "bead",
      adhesion = stiction.adhesion.rcc { w = p.w, C_n = C*N/m^3, C_t = C*N/m^3, b = p.slack * p.w } } },
    loads = { stiction.load.surface_stress { set = "gel.top", gamma = p.gamma } },
    motions = { stiction.motion.fix { set = "gel.bottom" }, stiction.motion.fix { set = "gel.left", y = false },
      stiction.motion.fix { set = "gel.right", y = false } },
    scheme = stiction.scheme.quasi_static {}, output = stiction.output { frames = 2 },
    schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = 40 }, stiction.stage { to = 2*s, steps = p.steps } } },
    probes = { touch = stiction.probe.contact { pair = "touch" }, bead = stiction.probe.rigid { obstacle = "bead" },
      energy = stiction.probe.energy { audit = true } },
  }
end

--- Depth at which the bead bears nothing on its way back, m.
local function rest(run)
  local force, y = run:series("touch", "force_y"), run:series("bead", "u_y")
  for i = 2, #force do
    if run.time[i] > 1 and force[i] >= 0 and force[i - 1] < 0 then
      local part = force[i] / (force[i] - force[i - 1])
      return -(y[i] + part * (y[i - 1] - y[i]))
    end
  end
  return 0
end

return stiction.study {
  title = "From JKR to wetting",
  question = "How deep does a bead sink into a gel whose surface stress takes over?",
  given = { R = { 15*um, "bead" }, gamma = { 30*mN/m, "surface stress" }, w = { 1.5*mN/m, "a twentieth of it" }, poisson = { 0.495, "" } },
  chosen = { size = { 12, "of the block, in the larger of bead and contact" }, wide = { 1.2, "finest cells, of that" },
    stiff = { 4, "C h^2 / w, or" }, zone = { 5, "cells to E*/C, the stiffer" }, deep = { 4, "pressed first, in depths of JKR, or until" }, far = { 1.3, "contact radii of wetting, the lesser" },
    slack = { 1e-3*s, "b / w: bonds that snap do it within a step" }, steps = { 80, "on the way back" } },
  sweep = { { softness = 1e-3, cell = 0.03 }, { softness = 1e-2, cell = 0.03 }, { softness = 0.1, cell = 0.03 },
    { softness = 1, cell = 0.03 }, { softness = 1, cell = 0.015 }, { softness = 10, cell = 0.03 }, { softness = 30, cell = 0.03 } },
  quick = { sweep = { { softness = 1e-3, cell = 0.03 }, { softness = 1, cell = 0.03 }, { softness = 10, cell = 0.03 } } },
  case_id = function(p) return ("softness_%g_%g"):format(p.softness, p.cell) end,
  scene = scene,
  results = {
    { name = "depth", unit = "m", meaning = "at rest", rest },
    { name = "of_liquid", unit = "1", meaning = "depth over w R / gamma", function(run, p) return rest(run) / liquid(p) end },
    { name = "of_solid", unit = "1", meaning = "depth over JKR's", function(run, p)
      local _, d = solid(p)
      return rest(run) / d
    end },
  },
  check = function(cases, check)
    local all = cases:where { cell = 0.03 }
    local first, last = all[1], all[#all]
    check.within("stiff: as deep as JKR", first.results.of_solid, 0.94, 1)
    check.within("soft: as deep as in a liquid", last.results.of_liquid, 0.97, 1.04)
    check.non_decreasing("the softer the nearer to a liquid", all:values "of_liquid", 0.01)
    for _, c in ipairs(all) do check.ledger(c) end
  end,
  figures = function(cases)
    local all, x, exact = cases:where { cell = 0.03 }, {}, {}
    local p = all[1].p
    for k = 0, 30 do
      x[k + 1] = 1e-3 * 10 ^ (k / 30 * 2.5)
      local _, d = solid { R = p.R, w = p.w, gamma = p.gamma, poisson = p.poisson, softness = x[k + 1] }
      exact[k + 1] = d / liquid(p)
    end
    local softness = numeric.map(all, function(c) return c.p.softness end)
    return { stiction.figure.lines { name = "depth", title = "A bead that rests on a gel", legend = "below", curves = {
        { label = "JKR", x = x, y = exact, style = "dash" },
        { label = "a liquid", x = { softness[1], softness[#softness] }, y = { 1, 1 }, style = "dot" },
        { label = "computed", x = softness, y = all:values "of_liquid", style = "points" } },
      x = { label = "gamma / (E R)", log = true }, y = { label = "depth / (w R / gamma)" } },
      stiction.figure.field { name = "gel", case = all[#all - 1], array = "von_mises", label = "von Mises stress", unit = "Pa", deformed = true,
        window = { 0*um, 18*um, -9*um, 9*um }, mesh = true, title = "gamma/(E R) = 10, drawn off" } }
  end,
}
