-- A film lifted at its end, at a state in which the part still bonded is pressed along and next to buckling: without its
-- bonds it would give way by hundreds of times the opening at which they break, and the contact problem's answer lay there.
-- Its bonds hold it while Newton's method is under way; steps were cut, and a longer film's run failed.
local stiction = require "stiction"
local units = stiction.units
local m, mm, s, kg, J, N, MPa = units.m, units.mm, units.s, units.kg, units.J, units.N, units.MPa
local steps = 2

return stiction.study {
  title = "A film next to buckling", question = "Does a film that is next to buckling stop its peeling?",
  given = { length = { 5*mm, "long beside its thickness" }, thickness = { 0.1*mm, "thin" } },
  sweep = { C = { 3e9*N/m^3 } },
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
        stiction.motion.drive { set = "film.left", near = { 0*mm, p.thickness }, times = { 0*s, 1*s }, y = { 0*mm, 2.5*mm } },
      },
      scheme = stiction.scheme.quasi_static {},
      schedule = stiction.schedule { stages = { stiction.stage { to = 0.05*s, steps = steps } } },
      probes = { bond = stiction.probe.contact { pair = "bond" } },
    }
  end,
  check = function(cases, check)
    check.within("steps cut", cases[1].cost.cuts, 0, 0)
    check.within("steps", cases[1].cost.steps, steps, steps)
  end,
}
