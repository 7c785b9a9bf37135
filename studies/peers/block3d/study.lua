-- A soft block pressed onto a rigid plane and dragged until two thirds of its sole slip, as GetFEM and CalculiX give it.
--
--      _______________
--     |               |  down by `press` in one step, then across by `shear` in ten
--     |     block     |
--     |_______________|
--     ///////////////// mu = 0.3
--
-- Small strains; cells x cells x cells / 2 hexahedra of equal size.
--
--     ./stiction run studies/peers/block3d
--     ./stiction peers block3d
local stiction = require "stiction"
local checks = require "../common/checks.lua"
local known = require "peers"
local units = stiction.units
local mm, m, s, kg, MPa = units.mm, units.m, units.s, units.kg, units.MPa

local function scene(p)
  local zero = 0*mm
  return stiction.scene {
    kinematics = "three_dimensional",
    bodies = { block = stiction.body {
      mesh = stiction.mesh.box { size = { p.length, p.length, p.height }, cells = { p.cells, p.cells, p.cells / 2 } },
      material = stiction.material.linear_elastic { young = p.young, poisson = p.poisson }, density = p.density } },
    obstacles = { plane = stiction.obstacle { shape = stiction.rigid.plane {} } },
    pairs = { sole = stiction.pair { secondary = "block.bottom", primary = "plane",
      friction = stiction.friction.coulomb { mu = p.mu } } },
    motions = { stiction.motion.drive { set = "block.top", times = { 0*s, 1*s, 2*s },
      x = { zero, zero, p.shear }, y = { zero, zero, zero }, z = { zero, -p.press, -p.press } } },
    scheme = stiction.scheme.quasi_static {},
    schedule = stiction.schedule { stages = {
      stiction.stage { to = 1*s, steps = 1 }, stiction.stage { to = 2*s, steps = p.steps } } },
    probes = { sole = stiction.probe.contact { pair = "sole" } },
  }
end

return stiction.study {
  title = "A block pressed onto a rigid plane and dragged",
  question = "Are the forces those of GetFEM and CalculiX on the same mesh, at no more work than before?",
  given = {
    length = 40*mm, height = 20*mm, young = 5*MPa, poisson = 0.3, mu = 0.3, press = 0.4*mm, shear = 0.25*mm,
    steps = { 10, "while it is dragged" }, density = { 1000*kg/m^3, "not used in statics" },
  },
  sweep = { cells = { 8, 16, 24 } },
  quick = { sweep = { cells = { 8 } } },
  scene = scene,
  results = {
    { name = "press", unit = "N", meaning = "normal force once it is pressed", checks.force("sole", "z", 1*s, 1) },
    { name = "drag", unit = "N", meaning = "friction at the end", checks.force("sole", "x", 2*s, -1) },
    { name = "normal", unit = "N", meaning = "normal force at the end", checks.force("sole", "z", 2*s, 1) },
  },
  check = checks.of_cases(known),
}
