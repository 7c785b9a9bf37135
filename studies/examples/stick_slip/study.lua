-- A block drawn over a plane by a soft strip: it sticks until the strip pulls with mu_s P, slips, and sticks again.
--    P ______
--     |______|________   slow     The strip is the spring, k = E h / L; stiction.spring would do as well.
--   -------------------->         P presses as a dead traction on the block's top.
local stiction = require "stiction"
local units, numeric = stiction.units, stiction.numeric
local mm, m, s, kg, Pa, MPa = units.mm, units.m, units.s, units.kg, units.Pa, units.MPa

local function shape(p) -- a block of 10 mm by 4 mm, a strip 0.5 mm thick
  local function edge(x, y, name) return stiction.edge { to = { x*mm, y*mm }, name = name } end
  local far = 10 + p.length:to("mm")
  return stiction.mesh.gmsh { size = 1*mm, start = { 0*mm, 0*mm }, edges = { edge(10, 0, "sole"), edge(10, 0.5),
    edge(far, 0.5), edge(far, 1, "end"), edge(10, 1), edge(10, 4), edge(0, 4, "top"), edge(0, 0) } }
end

return stiction.study {
  title = "Stick-slip of a block on a spring", question = "At what forces does it start and stop?",
  given = { mu_s = 0.6, v_ref = 20*mm/s, pressure = 1000*Pa, young = 1*MPa, length = 40*mm, speed = 10*mm/s },
  chosen = { time = { 0.3*s, "several slips" }, steps = { 1200, "twenty in a slip" },
    damping = { 2e-4*s, "viscosity over Young's modulus: the block's shaking dies, the slips go on" } },
  sweep = { mu_k = { 0.3, 0.45 } },
  quick = { sweep = { mu_k = { 0.3 } }, set = { time = 0.1*s, steps = 400 } },
  scene = function(p)
    local viscosity, way, ends = p.damping * p.young, p.speed * p.time, { 0*s, p.time }
    return stiction.scene {
      bodies = { block = stiction.body { mesh = shape(p), density = 1000*kg/m^3,
        material = stiction.material.linear_elastic { young = p.young, poisson = 0 },
        damping = stiction.damping.kelvin_voigt { shear_viscosity = viscosity, bulk_viscosity = viscosity } } },
      obstacles = { plane = stiction.obstacle { shape = stiction.rigid.plane {} } },
      pairs = { sole = stiction.pair { secondary = "block.sole", primary = "plane",
        friction = stiction.friction.velocity { mu_s = p.mu_s, mu_k = p.mu_k, v_ref = p.v_ref } } },
      loads = { stiction.load.traction { set = "block.top", times = { 0*s, 1*s }, y = { -p.pressure, -p.pressure } } },
      motions = { stiction.motion.drive { set = "block.end", times = ends, x = { 0*mm, way }, y = { 0*mm, 0*mm } } },
      scheme = stiction.scheme.theta_xi { theta = 0.6, xi = 0.6 },
      schedule = stiction.schedule { stages = { stiction.stage { to = p.time, steps = p.steps } } },
      probes = { pull = stiction.probe.force { set = "block.end" } },
    }
  end,
  results = {
    { name = "start", unit = "N/m", meaning = "largest pull", function(run) return run:max("pull", "force_x") end },
    { name = "stop", unit = "N/m", meaning = "least pull after 0.04 s", function(run)
      local from = numeric.first_where(run.time, function(t) return t > 0.04 end)
      return numeric.min(table.move(run:series("pull", "force_x"), from, #run.time, 1, {})) end },
  },
  check = function(cases, check)
    for _, case in ipairs(cases) do
      local p, r, P = case.p, case.results, case.p.pressure.si * 10e-3
      check.close(case.id .. ": starts at mu_s P", r.start, p.mu_s * P, 0.03)
      check.within(case.id .. ": stops below mu_k P, no further than it was above", r.stop,
        (2 * p.mu_k - p.mu_s) * P, p.mu_k * P)
      local rise, way = case:at(0.03*s, "pull", "force_x") - case:at(0.01*s, "pull", "force_x"), p.speed.si * 0.02
      check.close(case.id .. ": the strip is E h / L stiff", rise / way, p.young.si * 0.5e-3 / p.length.si, 0.03)
    end
  end,
  figures = function(cases)
    local function curve(case) return { label = "μk = " .. case.p.mu_k, case = case, y = "pull/force_x" } end
    return { stiction.figure.lines { name = "force", title = "Pull on the strip", x = { label = "time", unit = "s" },
      y = { label = "pull per depth", unit = "N/m" }, legend = "below", curves = numeric.map(cases, curve) } }
  end,
}
