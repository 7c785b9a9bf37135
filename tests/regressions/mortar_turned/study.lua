-- Mortar with bonds in the plane, turned and far from the origin, with the tightest tolerance on the balance that the
-- contact solver's own allows: no step may be cut, and forces are the same in every frame.
local stiction = require "stiction"
local units = stiction.units
local m, mm, s, ms, kg, MPa, J, N = units.m, units.mm, units.s, units.ms, units.kg, units.MPa, units.J, units.N

local function body(name, p, young, poisson)
  return stiction.body { mesh = stiction.mesh.msh_file { path = ("%s_%d_%d.msh"):format(name, p.angle, p.far) },
    material = stiction.material.neo_hookean { young = young, poisson = poisson }, density = 1000*kg/m^3 }
end

local function scene(p)
  local c, d = math.cos(math.rad(p.angle)), math.sin(math.rad(p.angle))
  return stiction.scene {
    bodies = { low = body("low", p, 3*MPa, 0.4), up = body("up", p, 5*MPa, 0.3) },
    pairs = { touch = stiction.pair { secondary = "up.bottom", primary = "low.top", discretisation = "mortar",
      adhesion = stiction.adhesion.rcc { w = 10*J/m^2, C_n = 1e9*N/m^3, C_t = 1e9*N/m^3, b = 0.01*N*s/m } } },
    motions = { stiction.motion.fix { set = "low.bottom" }, stiction.motion.drive { set = "up.top", times = { 0*ms, 2*ms, 5*ms },
      x = { 0*mm, 0.2 * d*mm, (c + 0.3 * d)*mm }, y = { 0*mm, -0.2 * c*mm, (d - 0.3 * c)*mm } } },
    scheme = stiction.scheme.quasi_static {}, control = stiction.control { force_tolerance = 1e-10 },
    solver = stiction.solver.newton { tolerance = 1e-10 },
    schedule = stiction.schedule { stages = { stiction.stage { to = 2*ms, steps = 5 }, stiction.stage { to = 5*ms, steps = 10 } } },
    output = stiction.output { frames = 0 }, probes = { head = stiction.probe.force { set = "up.top" } } }
end

--- The last force along the frame's x or y.
local function along(k)
  return function(run, p)
    local x, y, a = run:series("head", "force_x"), run:series("head", "force_y"), math.rad(p.angle)
    local c, d = math.cos(a), math.sin(a)
    return k == 1 and x[#x] * c + y[#y] * d or y[#y] * c - x[#x] * d
  end
end

return stiction.study {
  title = "Mortar turned", question = "Does mortar contact converge to 1e-10 in every frame, to the same?",
  scene = scene,
  sweep = { { angle = 0, far = 0 }, { angle = 110, far = 0 }, { angle = 220, far = 0 }, { angle = 330, far = 1000 } },
  case_id = function(p) return ("turned_%d_far_%d"):format(p.angle, p.far) end,
  results = { { name = "along", unit = "N/m", meaning = "force along the surface", along(1) },
    { name = "across", unit = "N/m", meaning = "force across it", along(2) },
    { name = "steps", unit = "1", meaning = "steps made", function(run) return #run.time - 1 end } },
  check = function(cases, check)
    local first = cases[1].results
    for _, case in ipairs(cases) do
      check.within("steps as in the first frame, " .. case.id, case.results.steps, first.steps, first.steps)
      check.within("force along, " .. case.id, (case.results.along - first.along) / first.across, -1e-8, 1e-8)
      check.within("force across, " .. case.id, case.results.across / first.across - 1, -1e-8, 1e-8)
    end
  end,
}
