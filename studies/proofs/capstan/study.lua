-- A belt round a drum, held back at one end and drawn round at the other until all of it slides: T2 = T1 exp(mu phi).
--
--        ___ T2       The friction acts at the radius R and the tension at R + t/2, so the exponent is
--      /  _  \        mu phi R / (R + t/2). The belt is elastic and rests on contact and friction alone but for
--     | ( R ) |       the drawn section, which turns with the drum.
--      \     | T1
--
--     ./stiction run studies/proofs/capstan
local stiction = require "stiction"
local units = stiction.units
local mm, s, kg, m, MPa, Pa = units.mm, units.s, units.kg, units.m, units.MPa, units.Pa

--- A point at a radius (m) and an angle (rad).
local function at(r, angle)
  return { r * math.cos(angle)*m, r * math.sin(angle)*m }
end

--- Ring sector; an arc may not be half a turn or more.
local function outline(p, phi)
  local edge, R, out, pieces = stiction.edge, p.R.si, p.R.si + p.t.si, math.ceil(phi / math.rad(120))
  local centre = { 0*m, 0*m }
  local edges = { edge { to = at(out, 0), name = "slack" } }
  for k = 1, pieces do
    edges[#edges + 1] = edge { to = at(out, phi * k / pieces), centre = centre, name = "outer" }
  end
  edges[#edges + 1] = edge { to = at(R, phi), name = "tight" }
  for k = pieces - 1, 0, -1 do
    edges[#edges + 1] = edge { to = at(R, phi * k / pieces), centre = centre, name = "inner" }
  end
  return edges
end

--- The nodes of the drawn section go round the drum: held there, a section would bend the belt beside it.
local function drawn(p, phi, way)
  local motions, count = {}, 2 * math.max(1, math.floor(p.t.si / p.h.si + 0.5))
  for k = 0, count do
    local r = p.R.si + k * p.t.si / count
    local d = way * r / p.R.si * m
    motions[#motions + 1] = stiction.motion.drive { set = "belt.tight", near = at(r, phi), times = { 0*s, 1*s, 2*s },
      x = { 0*m, 0*m, -math.sin(phi) * d }, y = { 0*m, 0*m, math.cos(phi) * d } }
  end
  return motions
end

local function scene(p)
  local phi, young = math.rad(p.phi), p.phi > 120 and p.stiff * p.young or p.young
  local way = 3 * p.R.si * p.T1.si * math.exp(p.mu * phi) / young.si -- thrice what the belt stretches about
  return stiction.scene {
    bodies = { belt = stiction.body {
      mesh = stiction.mesh.gmsh { size = p.h, kind = "quad8", start = at(p.R.si, 0), edges = outline(p, phi) },
      material = stiction.material.linear_elastic { young = young, poisson = 0 }, density = 1000*kg/m^3 } },
    obstacles = { drum = stiction.obstacle { shape = stiction.rigid.circle { radius = p.R } } },
    pairs = { wrap = stiction.pair { secondary = "belt.inner", primary = "drum",
      friction = stiction.friction.coulomb { mu = p.mu } } },
    motions = drawn(p, phi, way),
    loads = { stiction.load.traction { set = "belt.slack", times = { 0*s, 1*s, 2*s }, y = { 0*Pa, -p.T1, -p.T1 } } },
    scheme = stiction.scheme.quasi_static {},
    schedule = stiction.schedule {
      stages = { stiction.stage { to = 1*s, steps = 10 }, stiction.stage { to = 2*s, steps = 40 } } },
    output = stiction.output { frames = 1 },
    probes = { tight = stiction.probe.force { set = "belt.tight" }, wrap = stiction.probe.contact { pair = "wrap" } },
  }
end

--- Tension of the drawn end over that of the other.
local function tensions(run, p)
  local x, y, phi = run:series("tight", "force_x"), run:series("tight", "force_y"), math.rad(p.phi)
  return (-x[#x] * math.sin(phi) + y[#y] * math.cos(phi)) / (p.T1.si * p.t.si)
end

local function exponent(p)
  return p.mu * math.rad(p.phi) * p.R.si / (p.R.si + p.t.si / 2)
end

return stiction.study {
  title = "Belt round a drum",
  question = "Does the tension grow as exp(mu phi)?",
  given = { R = { 20*mm, "drum" }, t = { 1*mm, "belt" },
    T1 = { 1e5*Pa, "over the slack end" },
    stiff = { 10, "times as stiff where longer: drawn further, it must turn little" },
    young = { 1000*MPa, "up to a third of a turn" } },
  chosen = { h = { 1*mm, "one quad8 cell through the belt" } },
  sweep = { { "phi", { 30, 90, 120, 180, 270, 360 } }, { "mu", { 0.1, 0.3, 0.6 } } },
  quick = { sweep = { { phi = 90, mu = 0.3 }, { phi = 180, mu = 0.6 } } },
  case_id = function(p) return ("phi%d_mu%g"):format(p.phi, p.mu) end,
  scene = scene,
  results = {
    { name = "T2_T1", unit = "1", meaning = "ratio of the tensions", tensions },
    { name = "ratio", unit = "1", meaning = "ln(T2/T1) over mu phi R / (R + t/2)",
      function(run, p) return math.log(tensions(run, p)) / exponent(p) end },
  },
  check = function(cases, check)
    for _, case in ipairs(cases) do
      check.proof { case = "belt round a drum", quantity = "ln(T2/T1), " .. case.id, kind = "exact",
        source = "Euler 1769; tension at R + t/2", reference = exponent(case.p), tolerance = 0.02,
        resolution = "m cell", values = { { case.p.h, math.log(case.results.T2_T1) } }, run = case }
    end
  end,
  figures = function(cases)
    local curves = {}
    for _, mu in ipairs { 0.1, 0.3, 0.6 } do
      local x, y = {}, {}
      for _, case in ipairs(cases:where { mu = mu }) do
        x[#x + 1], y[#y + 1] = case.p.phi, case.results.T2_T1
      end
      if #x > 0 then
        curves[#curves + 1] = { label = ("mu = %g"):format(mu), x = x, y = y }
      end
    end
    return { stiction.figure.lines { name = "tension", title = "Tension over the angle of wrap", curves = curves,
      x = { label = "angle, degrees" }, y = { label = "T2 / T1" } } }
  end,
}
