-- A rubber plate pressed onto a half disc of the same rubber and drawn across it, in plane strain, as GetFEM and CalculiX give it.
--
--     ______________________
--    |        plate         |  down by `press` in ten steps, then across by `slide` in forty, held along its whole top
--    |______________________|
--          _.-'  '-._
--         /  half    \
--        |___disc_____|  held below
--
-- The same meshes: cells along an eighth of the arc and through the plate (mesh/ is written by common/meshes.py). The plate
-- carries the contact points.
--
--     ./stiction run studies/peers/slide2d
--     ./stiction peers slide2d
local stiction = require "stiction"
local checks = require "../common/checks.lua"
local known = require "peers"
local units = stiction.units
local mm, m, s, kg, MPa = units.mm, units.m, units.s, units.kg, units.MPa

local materials = {
  blatz_ko = function(p) return stiction.material.blatz_ko { shear_modulus = p.shear_modulus } end,
  neo_hookean = function(p) return stiction.material.neo_hookean { young = 2.5 * p.shear_modulus, poisson = 0.25 } end,
}

local function scene(p)
  local zero = 0*mm
  local function body(mesh)
    return stiction.body { mesh = mesh, material = materials[p.material](p), density = p.density }
  end
  return stiction.scene {
    bodies = {
      disc = body(stiction.mesh.msh_file { path = ("mesh/disc_%d.msh"):format(p.cells), scale = 1*mm }),
      plate = body(stiction.mesh.block { origin = { -12*mm, p.radius }, size = { p.length, p.thickness },
        cells = { 10 * p.cells, p.cells } }),
    },
    pairs = { sole = stiction.pair { secondary = p.secondary, primary = p.secondary == "disc.arc" and "plate.bottom" or "disc.arc",
      discretisation = p.discretisation, friction = stiction.friction.coulomb { mu = p.mu } } },
    motions = {
      stiction.motion.fix { set = "disc.flat" },
      stiction.motion.drive { set = "plate.top", times = { 0*s, 1*s, 2*s }, x = { zero, zero, p.slide },
        y = { zero, -p.press, -p.press } },
    },
    scheme = stiction.scheme.quasi_static {},
    schedule = stiction.schedule { stages = {
      stiction.stage { to = 1*s, steps = p.steps_down }, stiction.stage { to = 2*s, steps = p.steps_across } } },
    probes = { top = stiction.probe.force { set = "plate.top" } },
  }
end

return stiction.study {
  title = "A plate pressed onto a half disc and drawn across",
  question = "Are the forces those of GetFEM and CalculiX on the same meshes, at no more work than before?",
  given = {
    radius = 5*mm, length = 20*mm, thickness = 2*mm, shear_modulus = 10*MPa, press = 1*mm, slide = 4*mm,
    steps_down = 10, steps_across = 40, density = { 1000*kg/m^3, "not used in statics" },
  },
  chosen = {
    secondary = { "plate.bottom", "its cells are half as long as the disc's" },
    discretisation = { "node_to_segment", "the default" },
  },
  sweep = {
    { material = "blatz_ko", mu = 0.2, cells = 8 }, { material = "blatz_ko", mu = 0.5, cells = 8 },
    { material = "blatz_ko", mu = 0.2, cells = 16 }, { material = "blatz_ko", mu = 0.5, cells = 16 },
    { material = "neo_hookean", mu = 0.5, cells = 8 }, { material = "neo_hookean", mu = 0.5, cells = 16 },
  },
  quick = { sweep = { { material = "blatz_ko", mu = 0.5, cells = 8 } } },
  scene = scene,
  results = {
    { name = "press", unit = "N/mm", meaning = "normal force once it is pressed", checks.force("top", "y", 1*s, -1) },
    { name = "drag", unit = "N/mm", meaning = "friction at the end", checks.force("top", "x", 2*s, 1) },
    { name = "normal", unit = "N/mm", meaning = "normal force at the end", checks.force("top", "y", 2*s, -1) },
  },
  check = checks.of_cases(known),
}
