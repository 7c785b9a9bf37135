-- Pull-off of a rigid sphere from a soft block under Dugdale's adhesion, between DMT and JKR (Maugis 1992).
--
--             .-'''-.       down by `depth`, then up to `above` over the surface
--            | R, rigid|
--      _______'-._.-'_______   traction sigma0 up to the opening h0 = w/sigma0, from the contact
--     |    c a     a c      |  radius a to c; lambda = sigma0 (9 R/(2 pi w E*^2))^1/3
--     |    block            |
--     |_____________________|  axisymmetric, frictionless, small strains, held at the bottom
--
--     ./stiction run studies/proofs/maugis_dugdale
local stiction = require "stiction"
local jkr, maugis = stiction.reference.jkr, stiction.reference.maugis
local units = stiction.units
local mm, um, s, kg, m, J, MPa, Pa = units.mm, units.um, units.s, units.kg, units.m, units.J, units.MPa, units.Pa

local function modulus(p) return jkr.modulus(p.young.si, p.poisson) end
local function traction(p) return maugis.traction(modulus(p), p.radius.si, p.w.si, p.lambda) end
local function cell(p) return p.coarse / (p.lambda * p.refine) end
local function exact(p) return maugis.pull_off(p.lambda) * math.pi * p.w.si * p.radius.si end

local function scene(p)
  local zero, sigma0 = 0*mm, traction(p)
  local down, over = 1*s, (2 + p.above / p.depth) * s
  return stiction.scene {
    kinematics = "axisymmetric",
    bodies = { block = stiction.body {
      mesh = stiction.mesh.graded_block {
        origin = { zero, -p.size }, size = { p.size, p.size }, fine = { p.fine / math.sqrt(p.lambda), 6 * cell(p) }, fine_size = cell(p),
        coarse_size = p.size / 12, growth = p.growth,
      },
      material = stiction.material.linear_elastic { young = p.young, poisson = p.poisson },
      density = 1000*kg/m^3, interpolation = "mean_dilatation",
    } },
    obstacles = { sphere = stiction.obstacle {
      shape = stiction.rigid.sphere { centre = { zero, p.radius }, radius = p.radius },
      times = { 0*s, down, over }, y = { zero, -p.depth, p.above },
    } },
    motions = { stiction.motion.fix { set = "block.bottom" }, stiction.motion.fix { set = "block.left", y = false } },
    pairs = { contact = stiction.pair {
      secondary = "block.top", primary = "sphere",
      adhesion = stiction.adhesion.dugdale { sigma0 = sigma0*Pa, h0 = p.w.si / sigma0 * m, ramp = p.ramp },
    } },
    scheme = stiction.scheme.quasi_static {},
    schedule = stiction.schedule { stages = {
      stiction.stage { to = down, steps = p.steps_down },
      stiction.stage { to = over, steps = p.steps_up },
    } },
    output = stiction.output { frames = 1 },
    probes = { contact = stiction.probe.contact { pair = "contact" }, energy = stiction.probe.energy {} },
  }
end

return stiction.study {
  title = "Pull-off of a sphere under Dugdale's adhesion",
  question = "Does a constant traction of short range give the pull-off of Maugis between DMT and JKR?",
  given = {
    radius = { 5*mm, "" }, young = { 5*MPa, "E* = 6.497 MPa" }, poisson = { 0.48, "" }, w = { 1*J/m^2, "" },
  },
  chosen = {
    depth = { 1*um, "so that it sticks and can be pulled" },
    above = { 9*um, "beyond the largest force" },
    size = { 5*mm, "20 contact radii wide and deep" },
    fine = { 0.38*mm, "more than the zone of traction at lambda = 1, whose edge coarser cells would trap; wider as lambda^-1/2" },
    coarse = { 5*um, "coarsest cell at lambda = 1; the traction's end wants cells well below E* ramp h0/sigma0 ~ 1/lambda^2" },
    growth = { 1.25, "of the cells outside the fine zone" },
    ramp = { 0.05, "of the range, along which the traction rises and falls" },
    steps_down = { 4, "the way down does not matter: the law has no memory" },
    steps_up = { 68, "0.15 um a step" },
  },
  sweep = { { "lambda", { 0.25, 0.5, 1 } }, { "refine", { 1, 2, 4 } } },
  quick = { sweep = { { "lambda", { 0.25, 0.5 } }, { "refine", { 2, 4 } } } },
  case_id = function(p) return ("lambda%g_%g"):format(p.lambda, cell(p):to("um")) end,
  scene = scene,
  results = {
    { name = "pull_off", unit = "N", meaning = "largest force that the sphere holds",
      function(run) return run:max("contact", "force_y") end },
    { name = "ratio", unit = "1", meaning = "that force over pi w R: 2 by DMT, 3/2 by JKR",
      function(run, p) return run:max("contact", "force_y") / (math.pi * p.w.si * p.radius.si) end },
  },
  check = function(cases, check)
    for _, lambda in ipairs { 0.25, 0.5, 1 } do
      local values, finest = {}, nil
      for _, c in ipairs(cases:where { lambda = lambda }) do
        values[#values + 1], finest = { cell(c.p), c.results.pull_off }, c
      end
      if finest then
        check.proof {
          case = "Maugis-Dugdale sphere", quantity = ("pull-off, lambda = %g"):format(lambda), unit = "N", kind = "exact",
          source = "Maugis 1992", resolution = "cell under the contact, m", reference = exact(finest.p), values = values,
          tolerance = 0.02, run = finest,
          note = "a mesh traps the edge of the traction at its nodes: the error falls with the cell",
        }
      end
    end
  end,
  figures = function(cases)
    local curves, p = {}, cases[1].p
    local _, unit, depth = maugis.units(modulus(p), p.radius.si, p.w.si)
    for _, lambda in ipairs { 0.25, 0.5, 1 } do
      local group = cases:where { lambda = lambda }
      local c = group[#group]
      if c then
        local x, y, force = {}, {}, c:series("contact", "force_y")
        for k, t in ipairs(c.time) do
          if t > 1 then x[#x + 1], y[#y + 1] = (2 - t) * p.depth.si, -force[k] end
        end
        curves[#curves + 1] = { label = ("λ = %g"):format(lambda), x = x, y = y, colour = #curves + 1 }
        local d, f = {}, {}
        for i = 0, 60 do
          local a = 0.2 + 1.2 * i / 60
          d[#d + 1], f[#f + 1] = maugis.depth(lambda, a) * depth, maugis.force(lambda, a) * unit
        end
        curves[#curves + 1] = { label = ("Maugis, λ = %g"):format(lambda), x = d, y = f,
          colour = #curves, style = "dash" }
      end
    end
    return { stiction.figure.lines {
      name = "pull_off", title = "pulling a sphere off", x = { label = "approach", unit = "um" },
      y = { label = "force, pressing > 0", unit = "mN" }, curves = curves, legend = "below",
    } }
  end,
}
