-- A rubber foot driven down and aside by more than the height of its cells in a step: what is driven must take its
-- neighbourhood along, or the cells beside it turn inside out and the steps are cut. Either body carries the points.
local stiction = require "stiction"
local units = stiction.units
local m, mm, s, kg, MPa = units.m, units.mm, units.s, units.kg, units.MPa
local down, aside = 3, 4 -- steps

local function rubber(law)
  if law == "blatz_ko" then return stiction.material.blatz_ko { shear_modulus = 10*MPa } end
  return stiction.material.neo_hookean { young = 25*MPa, poisson = 0.25 }
end

local function scene(p)
  local zero = 0*mm
  local function body(x, y, length, height, cells)
    return stiction.body { mesh = stiction.mesh.block { origin = { x, y }, size = { length, height }, cells = cells },
      material = rubber(p.law), density = 1000*kg/m^3 }
  end
  return stiction.scene {
    bodies = { foot = body(-2*mm, zero, 4*mm, 1*mm, { 16, 20 }), ground = body(-4*mm, -2*mm, 8*mm, 2*mm, { 24, 8 }) },
    pairs = { sole = stiction.pair { secondary = p.foot and "foot.bottom" or "ground.top",
      primary = p.foot and "ground.top" or "foot.bottom", discretisation = p.discretisation,
      friction = stiction.friction.coulomb { mu = 0.5 } } },
    motions = { stiction.motion.fix { set = "ground.bottom" },
      stiction.motion.drive { set = "foot.top", times = { 0*s, 1*s, 2*s }, x = { zero, zero, 0.4*mm },
        y = { zero, -0.2*mm, -0.2*mm } } },
    scheme = stiction.scheme.quasi_static {},
    schedule = stiction.schedule { stages = {
      stiction.stage { to = 1*s, steps = down }, stiction.stage { to = 2*s, steps = aside } } },
    output = stiction.output { frames = 0 }, probes = { top = stiction.probe.force { set = "foot.top" } },
  }
end

local sweep = {}
for _, law in ipairs { "blatz_ko", "neo_hookean" } do
  for _, foot in ipairs { true, false } do
    for _, discretisation in ipairs { "node_to_segment", "mortar" } do
      sweep[#sweep + 1] = { law = law, foot = foot, discretisation = discretisation }
    end
  end
end

return stiction.study {
  title = "A foot driven by more than its cells", question = "Do driven nodes take their neighbourhood along?",
  scene = scene, sweep = sweep, quick = {},
  case_id = function(p) return ("%s_%s_%s"):format(p.law, p.foot and "foot" or "ground", p.discretisation) end,
  results = {
    { name = "steps", unit = "1", meaning = "steps beyond those asked for",
      function(run) return #run.time - 1 - down - aside end },
  },
  check = function(cases, check)
    for _, one in ipairs(cases) do check.within("steps beyond those asked for, " .. one.id, one.results.steps, 0, 0) end
  end,
}
