-- Glass beads on silicone gels [style2013]: how deep does adhesion alone draw a bead into a gel?
--
--         .-'''-.      pushed in and drawn back slowly; at both passages without a load the depth is read off
--        | bead  |
--   _____.'-._.-'._____   gel: neo-Hookean, nearly incompressible, large strains; bonds of work w that heal where near
--         gel
--
-- Published: the profiles beside beads of 15 um in radius on gels of 500, 85 and 3 kPa, with the theory of Johnson, Kendall and Roberts
-- and its extension to whole spheres drawn for w = 71 mN/m.
--
--     ./stiction run studies/experiments/gel_beads
local stiction = require "stiction"
local jkr = stiction.reference.jkr
local units = stiction.units
local um, m, N, s, kPa, kg = units.um, units.m, units.N, units.s, 1e3 * units.Pa, units.kg
local mN = 1e-3 * N

local function modulus(p) return jkr.modulus(p.young.si, p.poisson) end

-- JKR's force over E* R^2 and depth over R at the contact radius a R: of a whole sphere [maugis1995],
-- ((1 + a^2) L - 2 a) / 2 - sqrt(8 pi k a^3) and a L / 2 - sqrt(2 pi k a), L = ln((1 + a) / (1 - a)), k = w / (E* R).
local function softness(p) return p.w.si / (modulus(p) * p.R.si) end -- k
local function logarithm(a) return math.log((1 + a) / (1 - a)) end
local function load(a, k) return ((1 + a ^ 2) * logarithm(a) - 2 * a) / 2 - math.sqrt(8 * math.pi * k * a ^ 3) end
local function depth(a, k) return a * logarithm(a) / 2 - math.sqrt(2 * math.pi * k * a) end
local function radius(k) -- without a load
  local low, high = 0, 1
  for _ = 1, 60 do
    local a = (low + high) / 2
    if load(a, k) < 0 then low = a else high = a end
  end
  return low
end

local function pressed(p) -- how deep, m: where it touches farther than it will without bonds
  local a = radius(softness(p))
  return p.deep * a * logarithm(a) / 2 * p.R.si
end

local function scene(p)
  local R, zero = p.R.si, 0*um
  local h, size = p.cell * R, p.size * R
  local C = 2 * p.w.si / (p.range * R) ^ 2 * N/m^3
  return stiction.scene {
    kinematics = "axisymmetric",
    bodies = { gel = stiction.body { density = 1000*kg/m^3, interpolation = "mean_dilatation",
      mesh = stiction.mesh.graded_block { origin = { zero, -size*m }, size = { size*m, size*m }, growth = 1.2,
        fine = { 1.4 * radius(softness(p)) * R*m, 6 * h*m }, fine_size = h*m, coarse_size = size / 12 * m },
      material = stiction.material.neo_hookean { young = p.young, poisson = p.poisson } } },
    obstacles = { bead = stiction.obstacle { shape = stiction.rigid.sphere { centre = { zero, p.R }, radius = p.R },
      times = { 0*s, 1*s, 2*s }, y = { zero, -pressed(p)*m, zero } } },
    pairs = { touch = stiction.pair { secondary = "gel.top", primary = "bead",
      adhesion = stiction.adhesion.rcc { w = p.w, C_n = C, C_t = p.along * C, b = p.slack * p.w, bonding = "proximity" } } },
    loads = p.gamma.si > 0 and { stiction.load.surface_stress { set = "gel.top", gamma = p.gamma } } or {},
    motions = { stiction.motion.fix { set = "gel.bottom" }, stiction.motion.fix { set = "gel.left", y = false },
      stiction.motion.fix { set = "gel.right", y = false } },
    scheme = stiction.scheme.quasi_static {}, output = stiction.output { frames = 2 },
    schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = 40 }, stiction.stage { to = 2*s, steps = p.steps } } },
    probes = { touch = stiction.probe.contact { pair = "touch" }, bead = stiction.probe.rigid { obstacle = "bead" },
      energy = stiction.probe.energy { audit = true } },
  }
end

-- Depth over R at which the bead bears nothing while time is between from and to.
local function rest(run, p, from, to)
  local force, y = run:series("touch", "force_y"), run:series("bead", "u_y")
  local found
  for i = 2, #force do
    local before, after = force[i - 1], force[i]
    if run.time[i - 1] >= from and run.time[i] <= to and (before < 0) ~= (after < 0) then
      found = -(y[i] + after / (after - before) * (y[i - 1] - y[i])) / p.R.si
    end
  end
  return found
end

return stiction.study {
  title = "Glass beads on gels",
  question = "How deep does adhesion alone draw a bead into a gel?",
  given = { R = { 15*um, "beads, figure 4 of [style2013]" }, w = { 71*mN/m, "there" } },
  chosen = { poisson = { 0.495, "nearly incompressible" }, size = { 12, "of the gel, in R" },
    deep = { 1.3, "pressed, in depths at which it touches as far without bonds" }, along = { 1e-3, "C_t / C_n: it slides on the bead" },
    slack = { 1e-3*s, "b / w: bonds that snap do it within a step" }, steps = { 80, "on the way back" } },
  sweep = { { young = 500*kPa, gamma = 0*N/m, cell = 0.01, range = 0.04 }, { young = 500*kPa, gamma = 0*N/m, cell = 0.005, range = 0.04 },
    { young = 500*kPa, gamma = 30*mN/m, cell = 0.01, range = 0.04 },
    { young = 500*kPa, gamma = 0*N/m, cell = 0.01, range = 0.08 }, { young = 85*kPa, gamma = 0*N/m, cell = 0.02, range = 0.26 },
    { young = 85*kPa, gamma = 0*N/m, cell = 0.02, range = 0.13 }, { young = 85*kPa, gamma = 0*N/m, cell = 0.01, range = 0.13 },
    { young = 85*kPa, gamma = 30*mN/m, cell = 0.02, range = 0.13 } },
  quick = { sweep = { { young = 500*kPa, gamma = 0*N/m, cell = 0.01, range = 0.04 } } },
  case_id = function(p) return ("%gkPa_gamma%g_range%g_cell%g"):format(p.young.si / 1e3, 1e3 * p.gamma.si, p.range, p.cell) end,
  scene = scene,
  results = {
    { name = "inwards", unit = "1", meaning = "depth over R where it bears nothing, going in",
      function(run, p) return rest(run, p, 0.02, 1) end },
    { name = "outwards", unit = "1", meaning = "the same, drawn back", function(run, p) return rest(run, p, 1, 2) end },
    { name = "parabola", unit = "1", meaning = "JKR's", function(_, p) return (9 * math.pi / 2 * softness(p)) ^ (2 / 3) / 3 end },
    { name = "sphere", unit = "1", meaning = "JKR's of a whole sphere",
      function(_, p) return depth(radius(softness(p)), softness(p)) end },
  },
  check = function(cases, check)
    local longest = { [500e3] = 0.08, [85e3] = 0.26 }
    for _, c in ipairs(cases) do
      local r = c.results
      check.ledger(c)
      check.within(c.id .. ": as deep on the way in as on the way back", r.inwards / r.outwards, 0.95, 1.02)
      if c.p.gamma.si == 0 then
        check.within(c.id .. ": as deep as JKR", r.outwards / r.parabola, 0.94, c.p.range == longest[c.p.young.si] and 1.1 or 1.06)
      else
        local without = cases:where { young = c.p.young, range = c.p.range, cell = c.p.cell, gamma = 0*N/m }[1].results
        check.within(c.id .. ": surface stress takes some of it", r.outwards / without.outwards, 0.9, 0.99)
      end
    end
  end,
  figures = function(cases)
    local panels = {}
    for _, young in ipairs { 500*kPa, 85*kPa } do
      local of, curves = cases:where { young = young }, {}
      for i, c in ipairs(of) do
        local p, force, y, x, P = c.p, c:series("touch", "force_y"), c:series("bead", "u_y"), {}, {}
        for k = 1, #y do x[k], P[k] = -y[k] / p.R.si, -force[k] / (p.w.si * p.R.si) end
        curves[i] = { label = ("gamma %g mN/m, range %g R, cell %g R"):format(1e3 * p.gamma.si, p.range, p.cell), x = x, y = P, colour = i }
      end
      if #of > 0 then
        local k, d, P = softness(of[1].p), {}, {}
        local farthest = 1.15 * radius(k)
        for i = 1, 100 do
          local a = farthest * i / 100
          d[i], P[i] = depth(a, k), load(a, k) / k
        end
        curves[#curves + 1] = { label = "JKR, a whole sphere", x = d, y = P, colour = 0, style = "dash" }
        panels[#panels + 1] = stiction.figure.lines { name = ("%gkPa"):format(young.si / 1e3), legend = "below", curves = curves,
          title = ("%g kPa"):format(young.si / 1e3), x = { label = "depth / R" }, y = { label = "force / (w R)" } }
      end
    end
    return { stiction.figure.panel { name = "beads", width = "double", columns = 2, figures = panels } }
  end,
}
