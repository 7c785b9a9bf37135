-- A small block pressed onto a plane and dragged.
local stiction = require "stiction"
local u = stiction.units
local mm, s, ms, kg, m, MPa, N = u.mm, u.s, u.ms, u.kg, u.m, u.MPa, u.N
local laws = { linear = stiction.material.linear_elastic { young = 5*MPa, poisson = 0.3 },
  finite = stiction.material.neo_hookean { young = 5*MPa, poisson = 0.3 } }
local function of(time, column, sign)
  return function(run) return sign * run:at(time, "sole", column) end
end
return stiction.study {
  title = "A block on a plane", chosen = { steps = { 4, "few" }, plane = { 0, "1: in the plane" }, bulk = { "automatic", "or not" },
    relaxes = { 0, "1: by two networks" } },
  sweep = { law = { "linear", "finite" } },
  scene = function(p)
    local flat = p.plane == 1
    local z, depth, down = 0*mm, { 4*mm, 4*mm, 2*mm }, { 0*mm, -0.1*mm, -0.1*mm }
    return stiction.scene {
      kinematics = flat and "plane_strain" or "three_dimensional",
      bodies = { block = stiction.body { material = laws[p.law], density = 1000*kg/m^3,
        relaxing = p.relaxes == 1 and { { share = 2, time = 0.5*s }, { modulus = 1*MPa, time = 10*s } } or nil, mesh = flat
        and stiction.mesh.block { size = { 4*mm, 2*mm }, cells = { 8, 4 } }
        or stiction.mesh.box { size = depth, cells = { 8, 8, 4 } } } },
      obstacles = { floor = stiction.obstacle { shape = stiction.rigid.plane {} } },
      pairs = { sole = stiction.pair { secondary = "block.bottom", primary = "floor",
        friction = stiction.friction.coulomb { mu = 0.3 } } },
      motions = { flat and stiction.motion.drive { set = "block.top", times = { 0*s, 1*s, 2*s }, x = { z, z, 0.05*mm }, y = down }
        or stiction.motion.drive { set = "block.top", times = { 0*s, 1*s, 2*s }, x = { z, z, 0.05*mm }, y = { z, z, z }, z = down } },
      scheme = stiction.scheme.quasi_static {},
      control = stiction.control { bulk = p.bulk },
      schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = 2 }, stiction.stage { to = 2*s, steps = p.steps } } },
      probes = { sole = stiction.probe.contact { pair = "sole" }, ledger = stiction.probe.energy {} },
      output = stiction.output { frames = 1 },
    }
  end,
  results = {
    { name = "press", unit = "N", meaning = "normal force", of(1*s, "force_z", 1) },
    { name = "drag", unit = "N", meaning = "friction", of(2*s, "force_x", -1) },
    { name = "strain", unit = "J", meaning = "strain energy at the end",
      function(run) return run:at(2*s, "ledger", "strain") end },
    { name = "lost", unit = "J", meaning = "friction loss", function(run) return run:at(2*s, "ledger", "friction_loss") end },
  },
}
