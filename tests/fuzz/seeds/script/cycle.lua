local stiction = require "stiction"
local units = stiction.units
local mm, s, MPa, kg, m, J, N = units.mm, units.s, units.MPa, units.kg, units.m, units.J, units.N

return stiction.study {
  title = "A block on a plane",
  given = { side = 1*mm },
  chosen = { cells = { 2, "few" } },
  sweep = { mu = { 0, 0.2 } },
  scene = function(p)
    local deep = {}
    deep.deep = deep
    return stiction.scene { gravity = deep,
      bodies = { block = stiction.body {
        mesh = stiction.mesh.block { size = { p.side, p.side }, cells = { p.cells, p.cells } },
        material = stiction.material.neo_hookean { young = 1*MPa, poisson = 0.3 }, density = 1000*kg/m^3 } },
      obstacles = { floor = stiction.obstacle { shape = stiction.rigid.plane { point = { 0*mm, 0*mm }, normal = { 0, 1 } } } },
      pairs = { sole = stiction.pair { secondary = "block.bottom", primary = "floor",
        friction = stiction.friction.coulomb { mu = p.mu },
        adhesion = stiction.adhesion.rcc { w = 1*J/m^2, C_n = 1e3*N/m^3, C_t = 1e3*N/m^3, b = 2*N*s/m } } },
      motions = { stiction.motion.drive { set = "block.top", times = { 0*s, 1*s }, y = { 0*mm, -0.02*mm } } },
      scheme = stiction.scheme.theta_xi { theta = 0.5, xi = 0.5 },
      schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = 3 } } },
      probes = { sole = stiction.probe.contact { pair = "sole" }, energy = stiction.probe.energy {} },
    }
  end,
  results = { { name = "force_y", unit = "N/m", meaning = "force", function(run) return run:at(1*s, "sole", "force_y") end } },
  quick = { sweep = { mu = { 0.2 } }, set = { cells = 1 } },
}
