-- A viscous belt on a drum: the tangent must take the viscosity of contact nodes at the rates that the balance gives
-- them, or steps of any size do not converge.
local stiction = require "stiction"
local units = stiction.units
local m, mm, s, kg, MPa, Pa = units.m, units.mm, units.s, units.kg, units.MPa, units.Pa
local R, t = 20e-3, 1e-3

local function at(r, a) return { r * math.cos(a)*m, r * math.sin(a)*m } end

local function belt(p)
  local edge, phi = stiction.edge, math.rad(90)
  return stiction.body {
    mesh = stiction.mesh.gmsh { size = 1*mm, kind = p.kind, start = at(R, 0), edges = {
      edge { to = at(R + t, 0), name = "slack" }, edge { to = at(R + t, phi), centre = { 0*m, 0*m }, name = "outer" },
      edge { to = at(R, phi), name = "tight" }, edge { to = at(R, 0), centre = { 0*m, 0*m }, name = "inner" } } },
    material = stiction.material[p.law] { young = 1000*MPa, poisson = 0 }, density = 1000*kg/m^3,
    damping = stiction.damping.kelvin_voigt { shear_viscosity = p.eta*Pa*s, bulk_viscosity = p.eta*Pa*s } }
end

local function scene(p)
  return stiction.scene {
    bodies = { belt = belt(p) },
    obstacles = { drum = stiction.obstacle { shape = stiction.rigid.circle { radius = R*m } } },
    pairs = { wrap = stiction.pair { secondary = "belt.inner", primary = "drum", discretisation = p.pairing,
      friction = p.mu > 0 and stiction.friction.coulomb { mu = p.mu } or nil } },
    motions = { stiction.motion.fix { set = "belt.tight" } },
    loads = { stiction.load.traction { set = "belt.slack", times = { 0*s, 5e-3*s }, y = { 0*Pa, -1e5*Pa } } },
    scheme = stiction.schemes.make(p.scheme),
    schedule = stiction.schedule { stages = { stiction.stage { to = p.steps * 2.5e-5*s, steps = p.steps } } },
    output = stiction.output { frames = 0 }, probes = { energy = stiction.probe.energy {} } }
end

local function case(kind, scheme, mu, more)
  local p = { kind = kind, scheme = scheme, mu = mu, law = "linear_elastic", eta = 5e4, steps = 200, pairing = "node_to_segment" }
  for key, value in pairs(more or {}) do p[key] = value end
  return p
end
local sweep = { case("quad8", "default", 0.3, { pairing = "mortar" }), case("quad8", "massless", 0.3, { law = "neo_hookean" }) }
local quick = { sweep[1], sweep[2], case("quad4", "default", 0), case("quad4", "massless", 0.3), case("quad8", "default", 0.3) }
for _, kind in ipairs { "quad4", "quad8" } do
  for _, scheme in ipairs { "default", "massless", "backward_euler" } do
    for _, mu in ipairs { 0, 0.3 } do sweep[#sweep + 1] = case(kind, scheme, mu) end
  end
end

return stiction.study {
  title = "Viscous belt on a drum", question = "Do viscous bodies with contact converge under all schemes?",
  scene = scene, sweep = sweep, quick = { sweep = quick },
  case_id = function(p) return ("%s_%s_%s_%s_mu%g"):format(p.kind, p.scheme, p.law, p.pairing, p.mu) end,
  results = {
    { name = "iterations", unit = "1", meaning = "Newton iterations per step",
      function(run)
        local sum, all = 0, run:series("step", "iterations")
        for k = 2, #all do sum = sum + all[k] end
        return sum / (#all - 1)
      end },
    { name = "steps", unit = "1", meaning = "steps beyond those asked for", function(run, p) return #run.time - 1 - p.steps end } },
  check = function(cases, check)
    for _, one in ipairs(cases) do
      check.within("iterations per step, " .. one.id, one.results.iterations, 0, one.p.law == "linear_elastic" and 2 or 4)
      check.within("steps that had to be cut, " .. one.id, one.results.steps, 0, 4)
    end
  end,
}
