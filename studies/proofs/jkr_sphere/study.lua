-- Pull-off of a rigid sphere from a soft adhesive block: how near the law RCC comes to JKR.
--
--             .-'''-.       down by `depth`, then up to `above` over the surface
--            | R, rigid|
--      _______'-._.-'_______
--     |      a     a        |   E* = E/(1 - nu^2), frictionless, bonds of energy w, b = 0
--     |    block            |   axisymmetric, small strains
--     |_____________________|   held at the bottom
--
-- Each stiffness is run with two meshes, 4 and 8 cells to the cohesive length E*/C (to 40 um
-- where that is longer).
--
--     ./stiction run studies/proofs/jkr_sphere
local stiction = require "stiction"
local jkr = stiction.reference.jkr
local units = stiction.units
local mm, um, s, kg, m, J, N, MPa = units.mm, units.um, units.s, units.kg, units.m, units.J, units.N, units.MPa

local full = 1.04e12 -- N/m^3, least for JKR: (5 E*^2/3/(R^1/3 w^1/6))^2

local function modulus(p) return jkr.modulus(p.young.si, p.poisson) end

-- Cell under the contact: so many to the cohesive length, at most `coarsest`.
local function cell(p)
  return math.min(modulus(p) / (p.stiffness * full), p.coarsest.si) / p.cells * m
end

local function scene(p)
  local zero, h = 0*mm, cell(p)
  local size = math.min(p.size.si, 1900 * h.si) * m -- graded_block takes 2000 of its cells at most
  local path = { zero, -p.depth, p.above }
  local down, over = 1*s, (2 + p.above / p.depth) * s
  return stiction.scene {
    kinematics = "axisymmetric",
    bodies = { block = stiction.body {
      mesh = stiction.mesh.graded_block {
        origin = { zero, -size }, size = { size, size }, fine = { p.fine, 6 * h }, fine_size = h,
        coarse_size = size / 12, growth = p.growth,
      },
      material = stiction.material.linear_elastic { young = p.young, poisson = p.poisson },
      density = 1000*kg/m^3, interpolation = "mean_dilatation",
    } },
    obstacles = { sphere = stiction.obstacle {
      shape = stiction.rigid.sphere { centre = { zero, p.radius }, radius = p.radius },
      times = { 0*s, down, over }, y = path,
    } },
    motions = { stiction.motion.fix { set = "block.bottom" }, stiction.motion.fix { set = "block.left", y = false } },
    pairs = { contact = stiction.pair {
      secondary = "block.top", primary = "sphere",
      adhesion = stiction.adhesion.rcc { w = p.w, C_n = p.stiffness * full*N/m^3, C_t = 0*N/m^3, b = 0*N*s/m },
    } },
    scheme = stiction.scheme.quasi_static {},
    schedule = stiction.schedule { stages = {
      stiction.stage { to = down, steps = p.steps_down },
      stiction.stage { to = over, steps = p.steps_up },
    } },
    output = stiction.output { frames = 1 },
    probes = {
      contact = stiction.probe.contact { pair = "contact" },
      sphere = stiction.probe.rigid { obstacle = "sphere" },
      energy = stiction.probe.energy {},
    },
  }
end

return stiction.study {
  title = "Pull-off of a rigid sphere from a soft adhesive block",
  question = "How near does RCC with b = 0 come to the pull-off of JKR as its stiffness grows?",
  given = {
    radius = { 5*mm, "" }, young = { 5*MPa, "E* = 6.497 MPa" }, poisson = { 0.48, "" }, w = { 1*J/m^2, "" },
  },
  chosen = {
    depth = { 16*um, "contact radius 0.28 mm by Hertz" },
    above = { 7*um, "beyond the largest force" },
    size = { 5*mm, "20 contact radii wide and deep; less at the finest cells" },
    fine = { 0.34*mm, "more than the largest contact radius" },
    growth = { 1.25, "of the cells outside the fine zone" },
    coarsest = { 40*um, "so many cells lie at least in this length" },
    steps_down = { 10, "no bond breaks on the way down" },
    steps_up = { 150, "0.15 um a step; with 8 cells twice as many change 0.4 %" },
  },
  sweep = { { "stiffness", { 0.03, 0.1, 0.3, 1 } }, { "cells", { 4, 8 } } },
  quick = { sweep = { { "stiffness", { 0.03, 0.1 } }, { "cells", { 4, 8 } } } },
  scene = scene,
  results = {
    { name = "pull_off", unit = "N", meaning = "largest force that the bonds hold",
      function(run) return run:max("contact", "force_y") end },
    { name = "contact_radius", unit = "m", meaning = "contact radius at that force",
      function(run)
        local at = stiction.numeric.argmax((run:series("contact", "force_y")))
        return math.sqrt(run:series("contact", "closed_area")[at] / math.pi)
      end },
    { name = "touched", unit = "m", meaning = "largest contact radius",
      function(run) return math.sqrt(run:max("contact", "closed_area") / math.pi) end },
  },
  check = function(cases, check)
    for _, stiffness in ipairs { 0.1, 0.3, 1 } do
      local values, finest = {}, nil
      for _, c in ipairs(cases:where { stiffness = stiffness }) do
        values[#values + 1], finest = { cell(c.p), c.results.pull_off }, c
      end
      if finest then
        check.proof {
          case = "JKR sphere", quantity = string.format("pull-off, C = %.3g N/m^3", stiffness * full), unit = "N",
          kind = "exact", source = "Johnson, Kendall and Roberts 1971", resolution = "cell under the contact, m",
          reference = jkr.sphere.pull_off(finest.p.radius.si, finest.p.w.si), values = values, tolerance = 0.05,
          run = finest, note = "JKR is the limit of large C; the error of a finite C and of the mesh are both in it",
        }
      end
    end
    local soft, stiff = cases:find { stiffness = 0.03, cells = 8 }, cases:find { stiffness = 0.1, cells = 8 }
    local exact = jkr.sphere.pull_off(soft.p.radius.si, soft.p.w.si)
    local function error_of(c) return math.abs(c.results.pull_off / exact - 1) end
    check.increasing("from 0.03 to 0.1 of 1.04e12 N/m^3 the pull-off comes nearer to JKR",
      { -error_of(soft), -error_of(stiff) })
  end,

  figures = function(cases)
    local p, curves = cases[1].p, {}
    local E, R, w, d, force = modulus(p), p.radius.si, p.w.si, {}, {}
    for i = 0, 60 do
      local a = (0.17 + i * 0.12 / 60) * 1e-3
      d[#d + 1], force[#force + 1] = jkr.sphere.depth(E, R, w, a), jkr.sphere.force(E, R, w, a)
    end
    for i, c in ipairs(cases:where { cells = 8 }) do
      local x, y, series = {}, {}, c:series("contact", "force_y")
      for k, t in ipairs(c.time) do
        if t > 1 then x[#x + 1], y[#y + 1] = (2 - t) * p.depth.si, -series[k] end
      end
      curves[i] = { label = string.format("C = %.2g N/m³", c.p.stiffness * full), x = x, y = y, colour = i }
    end
    curves[#curves + 1] = { label = "JKR", colour = 4, x = d, y = force, style = "dash" }
    return { stiction.figure.lines {
      name = "pull_off", title = "pulling a sphere off", x = { label = "approach", unit = "um" },
      y = { label = "force, pressing > 0", unit = "mN" }, curves = curves, legend = "below",
    } }
  end,
}
