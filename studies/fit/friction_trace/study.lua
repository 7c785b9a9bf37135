-- A friction trace: the force that drags a sticky block, from which friction, work of adhesion and modulus are to be told.
--
-- The traces are ours: computed by data.lua with mu = 0.3, w = 0.8 J/m^2, E = 2 MPa on these cells, with noise of 10 N/m. One pressing
-- alone does not tell friction and adhesion apart so well as two.
--
--     ./stiction fit studies/fit/friction_trace
--     ./stiction sample studies/fit/friction_trace     # what the fit's uncertainty means for the largest drag, once it was fitted
local stiction = require "stiction"
local u = stiction.units
local mm, s, N, m = u.mm, u.s, u.N, u.m

local function trace(file, depth)
  return { file = file, x = "way", y = "drag", sigma = 10*N/m, case = { depth = depth }, against = function(run, p)
    local way, drag, force = {}, {}, run:series("sole", "force_x")
    for i, t in ipairs(run.time) do
      if t >= 1 then
        way[#way + 1], drag[#drag + 1] = p.length.si * (t - 1), -force[i]
      end
    end
    return way, drag
  end }
end

return stiction.study {
  title = "A friction trace: what the drag of a sticky block tells",
  question = "Which friction, work of adhesion and modulus do two traces say, and how surely?",
  given = { length = { 0.4*mm, "way of the drag" } },
  chosen = {
    young = { 1*u.MPa, "where the search begins" }, mu = { 0.2, "where the search begins" }, w = { 1*u.J/m^2, "where the search begins" },
    cells = { 16, "along the sole; fit.finer doubles it" }, steps = { 60, "of the drag; fit.finer doubles it" },
  },
  sweep = { depth = { 0.05*mm, 0.2*mm } },
  scene = function(p)
    return stiction.scene {
      output = stiction.output { frames = 0 },
      bodies = { block = stiction.body { mesh = stiction.mesh.block { size = { 8*mm, 3*mm }, cells = { p.cells, p.cells // 2 } },
        material = stiction.material.neo_hookean { young = p.young, poisson = 0.4 }, density = 1000*u.kg/m^3 } },
      obstacles = { floor = stiction.obstacle { shape = stiction.rigid.plane {} } },
      pairs = { sole = stiction.pair { secondary = "block.bottom", primary = "floor",
        friction = stiction.friction.coulomb { mu = p.mu },
        adhesion = stiction.adhesion.rcc { w = p.w, C_n = 1e8*N/m^3, C_t = 1e8*N/m^3, b = 0.02*N*s/m } } },
      motions = { stiction.motion.drive { set = "block.top", times = { 0*s, 1*s, 2*s }, x = { 0*mm, 0*mm, p.length },
        y = { 0*mm, -p.depth, -p.depth } } },
      scheme = stiction.scheme.quasi_static {},
      schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = 10 }, stiction.stage { to = 2*s, steps = p.steps } } },
      probes = { sole = stiction.probe.contact { pair = "sole" } },
    }
  end,
  results = { { name = "largest", unit = "N/m", meaning = "largest drag", function(run) return -(run:min("sole", "force_x")) end } },
  check = function(cases, check)
    check.increasing("pressed harder it takes more", cases:values("largest"))
  end,
  fit = {
    parameters = {
      young = { 0.2*u.MPa, 10*u.MPa, scale = "log" },
      mu = { 0, 1 },
      w = { 0.05*u.J/m^2, 10*u.J/m^2, scale = "log" },
    },
    data = { light = trace("light.csv", 0.05*mm), heavy = trace("heavy.csv", 0.2*mm) },
    finer = { cells = 32, steps = 120 },
    further = { depth = { 0.4*mm } },
    quick = { profiles = false },
  },
  sample = { fit = true, set = { depth = 0.2*mm }, count = 32 },
}
