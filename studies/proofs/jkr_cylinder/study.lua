-- Pull-off of a rigid cylinder from a soft adhesive block: how near the law RCC comes to JKR.
--
--             .-'''-.       down by `depth`, then up to `above` over the surface
--            | R, rigid|
--      _______'-._.-'_______
--     |      a     a        |   E* = E/(1 - nu^2), frictionless, bonds of energy w, b = 0
--     |    block            |   plane strain, right half, small strains
--     |_____________________|   held at the bottom
--
-- Each stiffness is run with two meshes, 4 and 8 cells to the cohesive length E*/C (to 40 um
-- where that is longer). The pull-off is a maximum of the force over the contact width, not of
-- the approach: the size of the block does not enter, but it must be pulled past that maximum.
--
--     ./stiction run studies/proofs/jkr_cylinder
local stiction = require "stiction"
local jkr = stiction.reference.jkr
local units = stiction.units
local mm, um, s, kg, m, J, N, MPa = units.mm, units.um, units.s, units.kg, units.m, units.J, units.N, units.MPa

local full = 1.04e12 -- N/m^3, least for JKR: (5 E*^2/3/(R^1/3 w^1/6))^2

local function modulus(p) return jkr.modulus(p.young.si, p.poisson) end
local function exact(p) return jkr.cylinder.pull_off(modulus(p), p.radius.si, p.w.si) end

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
    kinematics = "plane_strain",
    bodies = { block = stiction.body {
      mesh = stiction.mesh.graded_block {
        origin = { zero, -size }, size = { size, size }, fine = { p.fine, 6 * h }, fine_size = h,
        coarse_size = size / 12, growth = p.growth,
      },
      material = stiction.material.linear_elastic { young = p.young, poisson = p.poisson },
      density = 1000*kg/m^3, interpolation = "mean_dilatation",
    } },
    obstacles = { cylinder = stiction.obstacle {
      shape = stiction.rigid.circle { centre = { zero, p.radius }, radius = p.radius },
      times = { 0*s, down, over }, y = path,
    } },
    motions = { stiction.motion.fix { set = "block.bottom" }, stiction.motion.fix { set = "block.left", y = false } },
    pairs = { contact = stiction.pair {
      secondary = "block.top", primary = "cylinder",
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
      cylinder = stiction.probe.rigid { obstacle = "cylinder" },
      energy = stiction.probe.energy {},
    },
  }
end

return stiction.study {
  title = "Pull-off of a rigid cylinder from a soft adhesive block",
  question = "How near does RCC with b = 0 come to the pull-off of JKR as its stiffness grows?",
  given = {
    radius = { 5*mm, "" }, young = { 5*MPa, "E* = 6.497 MPa" }, poisson = { 0.48, "" }, w = { 1*J/m^2, "" },
  },
  chosen = {
    depth = { 20*um, "touches 0.24 to 0.31 mm wide: the contact at the largest force and its cohesive zone" },
    above = { 24*um, "beyond the largest force" },
    size = { 5*mm, "20 half widths wide and deep; less at the finest cells" },
    fine = { 0.34*mm, "more than what touches: in coarser cells the edge of the bonds would be trapped" },
    growth = { 1.25, "of the cells outside the fine zone" },
    coarsest = { 40*um, "so many cells lie at least in this length" },
    steps_down = { 10, "no bond breaks on the way down" },
    steps_up = { 220, "0.2 um a step" },
  },
  sweep = { { "stiffness", { 0.1, 0.3, 1 } }, { "cells", { 4, 8 } } },
  quick = { sweep = { { "stiffness", { 0.1, 0.3 } }, { "cells", { 2, 4 } } } },
  scene = scene,
  results = {
    { name = "pull_off", unit = "N/m", meaning = "largest force per length that the bonds hold, both halves",
      function(run) return 2 * run:max("contact", "force_y") end },
    { name = "touched", unit = "m", meaning = "largest half width of the contact",
      function(run) return (run:max("contact", "closed_area")) end },
  },
  check = function(cases, check)
    local nearer = {}
    for _, stiffness in ipairs { 0.1, 0.3, 1 } do
      local values, finest = {}, nil
      for _, c in ipairs(cases:where { stiffness = stiffness }) do
        values[#values + 1], finest = { cell(c.p), c.results.pull_off }, c
      end
      if finest then
        nearer[#nearer + 1] = -math.abs(finest.results.pull_off / exact(finest.p) - 1)
      end
      if finest and stiffness > 0.1 then
        check.proof {
          case = "JKR cylinder", quantity = string.format("pull-off, C = %.3g N/m^3", stiffness * full), unit = "N/m",
          kind = "exact", source = "Johnson, Kendall and Roberts 1971", resolution = "cell under the contact, m",
          reference = exact(finest.p), values = values, tolerance = 0.05, run = finest,
          note = "JKR is the limit of large C; the error of a finite C and of the mesh are both in it",
        }
      end
    end
    if #nearer > 1 then
      check.increasing("from 0.1 to 0.3 of 1.04e12 N/m^3 the pull-off comes nearer to JKR", { nearer[1], nearer[2] })
    end
  end,

  figures = function(cases)
    local p, curves = cases[1].p, {}
    for _, c in ipairs(cases) do
      if c.p.cells == cases[#cases].p.cells then
        local x, y, force = {}, {}, c:series("contact", "force_y")
        for k, t in ipairs(c.time) do
          if t > 1 then x[#x + 1], y[#y + 1] = (2 - t) * p.depth.si, -2 * force[k] end
        end
        curves[#curves + 1] = { label = string.format("C = %.2g N/m³", c.p.stiffness * full), x = x, y = y,
          colour = #curves + 1 }
      end
    end
    curves[#curves + 1] = { label = "pull-off by JKR", colour = 4, x = { -p.above.si, p.depth.si },
      y = { -exact(p), -exact(p) }, style = "dash" }
    return { stiction.figure.lines {
      name = "pull_off", title = "pulling a cylinder off", x = { label = "approach", unit = "um" },
      y = { label = "force per length, pressing > 0", unit = "N/m" }, curves = curves, legend = "below",
    } }
  end,
}
