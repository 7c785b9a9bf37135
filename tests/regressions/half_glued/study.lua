-- A stiff block glued over half of its bottom and dry over the other half, on a body: one node is in both pairs, where the
-- compliance of its two points is the same to the last digits.
local stiction = require "stiction"
local u = stiction.units
local mm, s, N, m, J, MPa = u.mm, u.s, u.N, u.m, u.J, u.MPa

local laws = {
  rcc = function(K) return stiction.adhesion.rcc { w = 300*J/m^2, C_n = K, C_t = K, b = 0*N*s/m, beta0 = 1, bonding = "never" } end,
  bilinear = function(K)
    return stiction.adhesion.bilinear { K = K, sigma_n = 7*MPa, sigma_t = 8*MPa, G_I = 250*J/m^2, G_II = 700*J/m^2 }
  end,
}

local function scene(p)
  local function to(x, y, name) return stiction.edge { to = { x*mm, y*mm }, name = name } end
  local metal = stiction.material.linear_elastic { young = 70*u.GPa, poisson = 0.3 }
  local function body(mesh) return stiction.body { mesh = mesh, material = metal, density = 2700*u.kg/m^3 } end
  return stiction.scene {
    bodies = {
      block = body(stiction.mesh.gmsh { size = 0.5*mm, kind = "quad4", start = { 0*mm, 0*mm },
        edges = { to(5, 0, "glued"), to(10, 0, "dry"), to(10, 5), to(0, 5, "top"), to(0, 0) } }),
      base = body(stiction.mesh.block { origin = { -2*mm, -5*mm }, size = { 14*mm, 5*mm }, cells = { 28, 10 } }),
    },
    pairs = { glue = stiction.pair { secondary = "block.glued", primary = "base.top", adhesion = laws[p.law](p.K) },
      dry = stiction.pair { secondary = "block.dry", primary = "base.top" } },
    motions = { stiction.motion.drive { set = "block.top", times = { 0*s, 1*s }, x = { 0*mm, 1e-4*mm }, y = { 0*mm, -1e-3*mm } },
      stiction.motion.fix { set = "base.bottom" } },
    scheme = stiction.scheme.quasi_static {},
    schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = 10 } } },
    output = stiction.output { frames = 0 },
    probes = { top = stiction.probe.force { set = "block.top" } },
  }
end

return stiction.study {
  title = "A block half glued", question = "Does the node that both halves share keep a step from its answer?",
  scene = scene,
  sweep = { law = { "rcc", "bilinear" }, K = { 1e11*N/m^3, 1e13*N/m^3 } },
  results = { { name = "press", unit = "N/m", meaning = "force of the motion, downwards",
    function(run) return -run:last("top", "force_y") end } },
  check = function(cases, check)
    for _, case in ipairs(cases) do
      check.close(case.id .. ": pressed as by sweeps alone", case.results.press, 88.44e3, 0.005)
    end
  end,
}
