-- Films peeled off a plane that would buckle without the bonds that hold them: one long and pressed a little along, whose
-- contact problem has compliances without a bound, and one next to buckling, whose contact problem's answer lay hundreds
-- of openings away. Steps were cut, and longer runs failed.
local stiction = require "stiction"
local units = stiction.units
local m, mm, s, kg, J, N, MPa = units.m, units.mm, units.s, units.kg, units.J, units.N, units.MPa

return stiction.study {
  title = "Films that would buckle", question = "Does a film's own instability stop its peeling?",
  given = { thickness = { 0.1*mm, "thin" } },
  sweep = {
    { length = 20*mm, C = 1e10*N/m^3, lift = 5*mm, duration = 0.01*s, steps = 4 },
    { length = 5*mm, C = 3e9*N/m^3, lift = 2.5*mm, duration = 0.05*s, steps = 2 },
  },
  case_id = function(p) return ("length%g"):format(p.length:to "mm") end,
  scene = function(p)
    local film = stiction.mesh.block { size = { p.length, p.thickness }, cells = { p.length / p.thickness, 1 }, kind = "quad8" }
    return stiction.scene {
      bodies = { film = stiction.body { mesh = film, density = 1000*kg/m^3,
        material = stiction.material.st_venant_kirchhoff { young = 100*MPa, poisson = 0 } } },
      obstacles = { floor = stiction.obstacle { shape = stiction.rigid.plane {} } },
      pairs = { bond = stiction.pair { secondary = "film.bottom", primary = "floor",
        adhesion = stiction.adhesion.rcc { w = 10*J/m^2, C_n = p.C, C_t = p.C, b = 1e-6*N*s/m, beta0 = 1, bonding = "never" } } },
      motions = {
        stiction.motion.fix { set = "film.right" },
        stiction.motion.drive { set = "film.left", near = { 0*mm, p.thickness }, times = { 0*s, 1*s }, y = { 0*mm, p.lift } },
      },
      scheme = stiction.scheme.quasi_static {},
      schedule = stiction.schedule { stages = { stiction.stage { to = p.duration, steps = p.steps } } },
      probes = { bond = stiction.probe.contact { pair = "bond" } },
    }
  end,
  check = function(cases, check)
    for _, case in ipairs(cases) do
      check.within("steps cut, " .. case.id, case.cost.cuts, 0, 0)
      check.within("steps, " .. case.id, case.cost.steps, case.p.steps, case.p.steps)
    end
  end,
}
