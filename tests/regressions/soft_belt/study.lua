-- A belt round three quarters of a drum, so soft that it would not stand by itself under forces that turn with their
-- normals, though on the drum it does: the steps must not stop.
local stiction = require "stiction"
local units = stiction.units
local m, mm, s, kg, MPa, Pa = units.m, units.mm, units.s, units.kg, units.MPa, units.Pa
local R, t, mu, phi, T1 = 20e-3, 1e-3, 0.3, math.rad(270), 1e5
local exponent = mu * phi * R / (R + t / 2)

local function at(r, a) return { r * math.cos(a)*m, r * math.sin(a)*m } end

local function belt()
  local edge, centre = stiction.edge, { 0*m, 0*m }
  local edges = { edge { to = at(R + t, 0), name = "slack" } }
  for k = 1, 3 do edges[#edges + 1] = edge { to = at(R + t, phi * k / 3), centre = centre, name = "outer" } end
  edges[#edges + 1] = edge { to = at(R, phi), name = "tight" }
  for k = 2, 0, -1 do edges[#edges + 1] = edge { to = at(R, phi * k / 3), centre = centre, name = "inner" } end
  return stiction.body { mesh = stiction.mesh.gmsh { size = 2*mm, kind = "quad8", start = at(R, 0), edges = edges },
    material = stiction.material.linear_elastic { young = 1000*MPa, poisson = 0 }, density = 1000*kg/m^3 }
end

--- The nodes of the drawn section go round the drum, by twice what the belt stretches about.
local function drawn()
  local motions = {}
  for k = 0, 2 do
    local r = R + k * t / 2
    local d = 2 * r * T1 * math.exp(mu * phi) / 1e9
    motions[#motions + 1] = stiction.motion.drive { set = "belt.tight", near = at(r, phi), times = { 0*s, 1*s, 2*s },
      x = { 0*m, 0*m, -math.sin(phi) * d*m }, y = { 0*m, 0*m, math.cos(phi) * d*m } }
  end
  return motions
end

local function scene()
  return stiction.scene {
    bodies = { belt = belt() },
    obstacles = { drum = stiction.obstacle { shape = stiction.rigid.circle { radius = R*m } } },
    pairs = { wrap = stiction.pair { secondary = "belt.inner", primary = "drum",
      friction = stiction.friction.coulomb { mu = mu } } },
    motions = drawn(),
    loads = { stiction.load.traction { set = "belt.slack", times = { 0*s, 1*s, 2*s }, y = { 0*Pa, -T1*Pa, -T1*Pa } } },
    scheme = stiction.scheme.quasi_static {},
    schedule = stiction.schedule {
      stages = { stiction.stage { to = 1*s, steps = 5 }, stiction.stage { to = 2*s, steps = 15 } } },
    output = stiction.output { frames = 0 }, probes = { tight = stiction.probe.force { set = "belt.tight" } } }
end

return stiction.study {
  title = "Soft belt round a drum", question = "Do forces that turn with their normals stop the steps?",
  sweep = { { phi = 270 } }, case_id = function(p) return ("phi%d"):format(p.phi) end,
  scene = scene,
  results = {
    { name = "T2_T1", unit = "1", meaning = "ratio of the tensions",
      function(run)
        local x = run:series("tight", "force_x")
        return x[#x] / (T1 * t)
      end },
    { name = "cuts", unit = "1", meaning = "steps beyond those asked for",
      function(run) return #run.time - 1 - 20 end } },
  check = function(cases, check)
    for _, one in ipairs(cases) do
      check.within("ln(T2/T1)", math.log(one.results.T2_T1), 0.98 * exponent, 1.02 * exponent)
      check.within("steps that had to be cut", one.results.cuts, 0, 0)
    end
  end,
}
