-- Surface stress: the pressure that it makes in a ball and a cylinder, and how it rounds a soft stadium.
--
--        y                  y
--        |--.               |------.        ball, cylinder: linear elastic, pressed by 2 gamma/R and gamma/R (Young-Laplace)
--        |    \             |       \       stadium: a square with half a disc on either side becomes a disc the sooner,
--        o-----|-- x        o--------|-- x  the softer it is
--
--     ./stiction run studies/proofs/soft_drop
local stiction = require "stiction"
local units, numeric = stiction.units, stiction.numeric
local mm, s, kg, m, mN = units.mm, units.s, units.kg, units.m, 1e-3 * units.N

local function young(p) return p.gamma / (p.R * p.softness) end

local function mesh(p)
  if p.shape ~= "stadium" then
    return stiction.mesh.quarter_disc { radius = p.R, fine = { 1.6 * p.R, p.R }, fine_size = p.h * p.R, coarse_size = p.h * p.R,
      kind = "quad8" }
  end
  local edge, R = stiction.edge, p.R
  return stiction.mesh.gmsh { size = p.h * R, kind = "quad8", start = { 0*m, 0*m }, edges = {
    edge { to = { 2 * R, 0*m }, name = "flat" }, edge { to = { R, R }, centre = { R, 0*m }, name = "arc" },
    edge { to = { 0*m, R }, name = "arc" }, edge { to = { 0*m, 0*m }, name = "axis" } } }
end

local function scene(p)
  local stadium = p.shape == "stadium"
  local law = stiction.material[stadium and "neo_hookean" or "linear_elastic"]
  return stiction.scene {
    kinematics = p.shape == "ball" and "axisymmetric" or "plane_strain",
    bodies = { drop = stiction.body { mesh = mesh(p), density = 1000*kg/m^3,
      material = law { young = young(p), poisson = stadium and p.stadium_poisson or p.poisson } } },
    motions = { stiction.motion.fix { set = "drop.axis", x = true }, stiction.motion.fix { set = "drop.flat", y = true } },
    loads = { stiction.load.surface_stress { set = "drop.arc", gamma = p.gamma } },
    scheme = stiction.scheme.quasi_static { stabilisation = stadium and p.flow or 0 },
    schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = stadium and p.steps or 1 } } },
    output = stiction.output { frames = 1 },
    probes = {
      side = stiction.probe.node { set = "drop.arc", near = { (stadium and 2 or 1) * p.R, 0*m } },
      top = stiction.probe.node { set = "drop.arc", near = { 0*m, p.R } },
      energy = stiction.probe.energy {},
    },
  }
end

--- Part of its radius by which Young-Laplace's pressure shortens a linear elastic ball, or a cylinder held along its axis.
local function shortening(p)
  local nu = p.poisson
  return p.softness * (p.shape == "ball" and 2 * (1 - 2 * nu) or (1 + nu) * (1 - 2 * nu))
end

local function proof(cases, check, t)
  local of = cases:where { shape = t.shape }
  check.proof { case = "Soft drop", quantity = t.quantity, unit = "1", kind = "exact", source = t.source, reference = t.reference(of[1].p),
    values = numeric.map(of, function(c) return { t.resolution(c.p), c.results[t.result] } end), resolution = t.of,
    tolerance = t.tolerance, order = t.order, run = of[#of] }
end

local sweep = {}
for _, shape in ipairs { "cylinder", "ball" } do
  for _, h in ipairs { 0.4, 0.2, 0.1 } do sweep[#sweep + 1] = { shape = shape, h = h, softness = 1e-7 } end
end
for _, softness in ipairs { 2.5, 5, 10 } do sweep[#sweep + 1] = { shape = "stadium", h = 0.2, softness = softness } end

return stiction.study {
  title = "Soft drop", question = "Does surface stress press by Young and Laplace's pressure, and round what is soft?",
  given = { R = { 1*mm, "radius; half the stadium's height" }, gamma = { 30*mN/m, "of a gel" }, poisson = { 0.3, "ball and cylinder" },
    stadium_poisson = { 0.4995, "neo-Hookean" } },
  chosen = { flow = { 1, "stabilisation of the stadium: surface stress acts at once, and it flows until it stands still" },
    steps = { 50, "of the stadium" } },
  sweep = sweep,
  quick = { sweep = { sweep[2], sweep[3], sweep[5], sweep[6], sweep[7], sweep[9] } },
  case_id = function(p) return ("%s_%g_%g"):format(p.shape, p.h, p.softness) end,
  scene = scene,
  results = {
    { name = "shortening", unit = "1", meaning = "of the radius, ball and cylinder", function(run)
      return -run:at(1*s, "side", "u_x") / run.p.R.si end },
    { name = "out_of_round", unit = "1", meaning = "half width over half height, less 1, of the stadium", function(run)
      local R = run.p.R.si
      return run.p.shape ~= "stadium" and 0 or (2 * R + run:at(1*s, "side", "u_x")) / (R + run:at(1*s, "top", "u_y")) - 1 end },
  },
  check = function(cases, check)
    for _, shape in ipairs { "cylinder", "ball" } do
      proof(cases, check, { shape = shape, result = "shortening", quantity = "shortening of a " .. shape, source = "Young and Laplace",
        reference = shortening, resolution = function(p) return p.h end, of = "cell over radius", tolerance = 1e-4, order = 2.8 })
    end
    local soft = cases:where { shape = "stadium" }
    local first, last = soft[1], soft[#soft]
    check.within("what the stadium lacks of a disc falls as E R/gamma", last.results.out_of_round * last.p.softness
      / (first.results.out_of_round * first.p.softness), 0.9, 1.2)
    check.within("it is nearly round at last", last.results.out_of_round, 0, 0.04)
  end,
  figures = function(cases)
    local of = cases:where { shape = "stadium" }
    return { stiction.figure.field { name = "stadium", case = of[#of], time = "last", array = "von_mises", label = "von Mises stress",
      unit = "Pa", deformed = true, scale_bar = 0.5*mm,
      title = "A quarter of a stadium, rounded: gamma/(E R) = 10" } }
  end,
}
