-- Small scenes whose contact problems are hard in ways that the other studies' are not; README.md says which of
-- their steps are kept in this folder.
--
--     ./stiction run tests/contact/problems --out /tmp/problems
local stiction = require "stiction"
local units = stiction.units
local mm, m, s, kg, MPa, Pa, N, J = units.mm, units.m, units.s, units.kg, units.MPa, units.Pa, units.N, units.J
local mesh, motion, material, friction = stiction.mesh, stiction.motion, stiction.material, stiction.friction

local zero = 0*mm
local rubber = material.linear_elastic { young = 5*MPa, poisson = 0.3 }

local function stage(to, steps)
  return stiction.schedule { stages = { stiction.stage { to = to, steps = steps } } }
end

local function output(every)
  return stiction.output { frames = 0, problems_every = every }
end

local scenes = {}

-- A fine punch, held, on a block of two columns: 50 components of contact feel few degrees of freedom.
function scenes.coarse_primary()
  return stiction.scene {
    bodies = {
      punch = stiction.body { mesh = mesh.block { size = { 8*mm, 2*mm }, cells = { 24, 1 } }, material = rubber,
        density = 1000*kg/m^3 },
      block = stiction.body { mesh = mesh.block { origin = { -2*mm, -6*mm }, size = { 12*mm, 6*mm }, cells = { 2, 1 } },
        material = rubber, density = 1000*kg/m^3 },
    },
    pairs = { touch = stiction.pair { secondary = "punch.bottom", primary = "block.top", smoothing = "polyline",
      friction = friction.coulomb { mu = 0.3 } } },
    motions = {
      motion.drive { set = "punch.all", times = { 0*s, 1*s, 2*s }, x = { zero, zero, 0.2*mm }, y = { zero, -0.2*mm, -0.2*mm } },
      motion.fix { set = "block.bottom" },
    },
    scheme = stiction.scheme.quasi_static {}, schedule = stage(2*s, 10), output = output(5),
  }
end

-- A free rigid plate of three degrees of freedom falls on 21 held nodes, with a spin and a slide.
function scenes.rigid_plate()
  return stiction.scene {
    bodies = { bed = stiction.body { mesh = mesh.block { size = { 20*mm, 2*mm }, cells = { 20, 1 } }, material = rubber,
      density = 1000*kg/m^3 } },
    obstacles = { plate = stiction.obstacle { shape = stiction.rigid.plane { point = { 10*mm, 2.01*mm }, normal = { 0, -1 } },
      pivot = { 10*mm, 4*mm }, mass = 1*kg, inertia = 1e-4*kg*m^2, velocity = { 0.1*m/s, -0.2*m/s } } },
    pairs = { touch = stiction.pair { secondary = "bed.top", primary = "plate", friction = friction.coulomb { mu = 0.3 } } },
    motions = { motion.fix { set = "bed.all" } },
    schedule = stage(1e-3*s, 20), output = output(4),
  }
end

-- A stiff rod stands at an angle whose tangent is 2 on a plane: W_nn = 4/3 |W_nt|, so mu = 1.6 is past the single
-- answer. Up the plane it slides; down the plane it cannot slide and jams; the step is not halved.
local function rod(slide)
  local normal = 0.1*m/s
  return stiction.scene {
    bodies = { rod = stiction.body { mesh = mesh.block { size = { 4*mm, 100*mm }, cells = { 1, 20 }, kind = "quad8" },
      material = material.linear_elastic { young = 2e5*MPa, poisson = 0.3 }, density = 7800*kg/m^3,
      velocity = { 0.9 * slide - 0.45 * normal, -0.45 * slide - 0.9 * normal } } },
    obstacles = { plane = stiction.obstacle { shape = stiction.rigid.plane { normal = { 0.5, 1 } } } },
    pairs = { tip = stiction.pair { secondary = "rod.bottom", primary = "plane", friction = friction.coulomb { mu = 1.6 } } },
    scheme = stiction.scheme.theta_xi { theta = 1, xi = 1 },
    schedule = stiction.schedule { stages = { stiction.stage { to = 4e-3*s, steps = 4 } }, halvings = 0 },
    output = output(1),
  }
end

function scenes.sliding_rod()
  return rod(-1*m/s)
end

function scenes.jamming_rod()
  return rod(1*m/s)
end

-- Two rows of cells peel off a plane with cohesive damage and friction.
function scenes.peel()
  return stiction.scene {
    bodies = { strip = stiction.body { mesh = mesh.block { size = { 30*mm, 1*mm }, cells = { 60, 2 } }, material = rubber,
      density = 1000*kg/m^3 } },
    obstacles = { plane = stiction.obstacle { shape = stiction.rigid.plane {} } },
    pairs = { glue = stiction.pair { secondary = "strip.bottom", primary = "plane", friction = friction.coulomb { mu = 0.5 },
      adhesion = stiction.adhesion.bilinear { K = 1e9*N/m^3, sigma_n = 5e4*Pa, sigma_t = 5e4*Pa, G_I = 5*J/m^2,
        G_II = 8*J/m^2 } } },
    motions = { motion.drive { set = "strip.left", times = { 0*s, 1*s }, y = { zero, 3*mm }, x = { zero, 1*mm } } },
    scheme = stiction.scheme.quasi_static {}, schedule = stage(1*s, 40), output = output(10),
  }
end

-- A bar on bonds that soften twice as fast as it can follow.
function scenes.snap()
  local stiffness, length = 1e9, 2.5 -- E / L = 2 C
  return stiction.scene {
    bodies = { bar = stiction.body { mesh = mesh.block { size = { 1*mm, length*mm }, cells = { 2, 5 } },
      material = material.linear_elastic { young = 2 * stiffness * length * 1e-3*Pa, poisson = 0 }, density = 1000*kg/m^3 } },
    obstacles = { plane = stiction.obstacle { shape = stiction.rigid.plane {} } },
    pairs = { glue = stiction.pair { secondary = "bar.bottom", primary = "plane", adhesion = stiction.adhesion.rcc {
      w = 1*J/m^2, C_n = stiffness*N/m^3, C_t = stiffness*N/m^3, b = 0*units.N*s/m, beta0 = 1 } } },
    motions = { motion.drive { set = "bar.top", times = { 0*s, 1*s }, x = { zero, zero }, y = { zero, 0.08*mm } } },
    scheme = stiction.scheme.quasi_static {}, schedule = stage(1*s, 40), output = output(1),
  }
end

-- A cube pressed on a plane and pushed along it, 81 points in space.
function scenes.pushed_cube()
  return stiction.scene {
    kinematics = "three_dimensional",
    bodies = { cube = stiction.body { mesh = mesh.box { size = { 8*mm, 8*mm, 8*mm }, cells = { 8, 8, 8 } }, material = rubber,
      density = 1000*kg/m^3 } },
    obstacles = { plane = stiction.obstacle { shape = stiction.rigid.plane {} } },
    pairs = { foot = stiction.pair { secondary = "cube.bottom", primary = "plane", friction = friction.coulomb { mu = 0.6 } } },
    motions = { motion.drive { set = "cube.top", times = { 0*s, 1*s }, x = { zero, 0.5*mm }, y = { zero, 0.3*mm },
      z = { zero, -0.4*mm } } },
    scheme = stiction.scheme.quasi_static {}, schedule = stage(1*s, 4), output = output(1),
  }
end

return stiction.study {
  title = "Contact problems for the solvers",
  question = "Which contact problems are hard: rank deficient, softening, with friction past the single answer?",
  sweep = { scene = { "coarse_primary", "rigid_plate", "sliding_rod", "jamming_rod", "peel", "snap", "pushed_cube" } },
  case_id = function(p) return p.scene end,
  scene = function(p) return scenes[p.scene](p) end,
}
