-- A steel cylinder on an aluminium block: NAFEMS benchmark CGS-1 (Feng and Prinja 2001), half of it by symmetry.
--
--      | u_y   quarter of the disc, R = 50 mm, driven down on its flat side until it carries 17.5 kN/mm
--     (    )
--   ----------   block 100 mm x 200 mm, held below
--
-- The benchmark's numbers are those of small strains, but its strains reach 5 %. So radius and moduli are `scale`
-- times the benchmark's: linear elasticity then gives the same a and p0, and u scale times smaller; the strains are
-- scale times smaller too. The force grows with the depth, so every quantity is read where it reaches the benchmark's.
--
--     ./stiction run studies/proofs/hertz_2d
local stiction = require "stiction"
local units = stiction.units
local mm, GPa, s, kg, m, kN = units.mm, units.GPa, units.s, units.kg, units.m, units.kN
local hertz, numeric = stiction.reference.line_contact, stiction.numeric
local reading = require "reading"

local function scene(p)
  return stiction.scene {
    bodies = {
      cylinder = stiction.body {
        mesh = stiction.mesh.quarter_disc { centre = { 0*mm, p.radius * p.scale }, radius = p.radius * p.scale,
          fine = { 9*mm, 6*mm }, fine_size = p.cell, coarse_size = 0.75 * p.coarse * p.scale, kind = p.kind },
        material = stiction.material.linear_elastic { young = p.young_1 * p.scale, poisson = p.poisson }, density = p.density,
      },
      block = stiction.body {
        mesh = stiction.mesh.graded_block { origin = { 0*mm, -p.height }, size = { p.width, p.height },
          fine = { 9*mm, 6*mm }, fine_size = p.cell, coarse_size = p.coarse, kind = p.kind },
        material = stiction.material.linear_elastic { young = p.young_2 * p.scale, poisson = p.poisson }, density = p.density,
      },
    },
    pairs = { touch = stiction.pair { secondary = "cylinder.arc", primary = "block.top" } },
    motions = {
      stiction.motion.drive { set = "cylinder.flat", times = { 0*s, 1*s }, y = { 0*mm, -p.depth / p.scale } },
      stiction.motion.fix { set = "cylinder.axis", y = false },
      stiction.motion.fix { set = "block.left", y = false },
      stiction.motion.fix { set = "block.bottom", x = false },
    },
    scheme = stiction.scheme.quasi_static {},
    schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = p.steps } } },
    probes = {
      force = stiction.probe.force { set = "cylinder.flat" },
      line = stiction.probe.contact_line { pair = "touch" },
      centre = stiction.probe.node { set = "block.top", near = { 0*mm, 0*mm } },
      energy = stiction.probe.energy {},
    },
  }
end

--- p^2 = p0^2 (1 - x^2/a^2) is a straight line over x^2: its ordinate and its zero by least squares.
local function fit(run, p)
  local x, pressure = reading.profile(run, p)
  local highest = numeric.max(pressure)
  local n, sx, sy, sxx, sxy = 0, 0, 0, 0, 0
  for k = 1, #x do
    if pressure[k] > 0.3 * highest then
      local u, v = x[k] ^ 2, pressure[k] ^ 2
      n, sx, sy, sxx, sxy = n + 1, sx + u, sy + v, sxx + u * u, sxy + u * v
    end
  end
  local slope = (n * sxy - sx * sy) / (n * sxx - sx * sx)
  local ordinate = (sy - slope * sx) / n
  return math.sqrt(ordinate), math.sqrt(-ordinate / slope)
end

return stiction.study {
  title = "Cylinder on a block (NAFEMS CGS-1)",
  question = "Half width, largest pressure and sinking of a line contact between two elastic bodies.",
  given = {
    radius = { 50*mm, "" }, young_1 = { 210*GPa, "cylinder" }, young_2 = { 70*GPa, "block" },
    poisson = { 0.3, "" }, force = { 17.5*kN/mm, "on the half" }, density = { 1000*kg/m^3, "not used in statics" },
  },
  chosen = {
    width = { 100*mm, "half of the benchmark's block" }, height = { 200*mm, "the benchmark's block" },
    scale = { 10, "on radius and moduli: the same a, p0 and E u by linear elasticity, a tenth of the strains" },
    coarse = { 8*mm, "largest cells of the block; the cylinder's are 0.75 scale times as large" },
    depth = { 2.6*mm, "takes the force beyond the benchmark's" }, steps = { 13, "smooth enough to interpolate" },
  },
  sweep = { { kind = "quad4", cell = 1*mm }, { kind = "quad4", cell = 0.5*mm }, { kind = "quad4", cell = 0.25*mm },
    { kind = "quad8", cell = 0.5*mm } },
  quick = { sweep = { { kind = "quad4", cell = 1*mm }, { kind = "quad4", cell = 0.5*mm } } },
  case_id = function(p) return ("%s_%g"):format(p.kind, p.cell:to("um")) end,
  scene = scene,
  results = {
    { name = "peak", unit = "Pa", meaning = "largest pressure", function(run, p) return (fit(run, p)) end },
    { name = "half_width", unit = "m", meaning = "half width", function(run, p) return (select(2, fit(run, p))) end },
    { name = "sinking", unit = "m", meaning = "u_y at the block's top centre, times scale",
      function(run, p) return p.scale * run:at(reading.load_time(run, p), "centre", "u_y") end },
  },
  check = function(cases, check)
    local quads = cases:where { kind = "quad4" }
    local fine = quads[#quads]
    local function row(quantity, unit, kind, name, reference, tolerance, note)
      local values = {}
      for k, case in ipairs(quads) do
        values[k] = { case.p.cell, case.results[name] }
      end
      check.proof { case = "Cylinder on block, NAFEMS CGS-1", quantity = quantity, unit = unit, kind = kind,
        source = "NAFEMS CGS-1; Hertz", reference = reference, values = values, resolution = "m cell",
        tolerance = tolerance, run = fine, note = note }
    end
    local p = fine.p
    local modulus = hertz.combined_modulus(p.young_1.si, p.poisson, p.young_2.si, p.poisson)
    row("half width a", "mm", "exact", "half_width", hertz.half_width(2 * p.force.si, p.radius.si, modulus),
      p.cell.si / 6.2146e-3)
    row("largest pressure p0", "MPa", "exact", "peak", hertz.peak_pressure(2 * p.force.si, p.radius.si, modulus), 0.03)
    if not cases.quick then
      local quad8 = cases:find { kind = "quad8", cell = 0.5*mm }
      check.close("quadratic cells: largest pressure", quad8.results.peak, fine.results.peak, 0.003)
      check.close("quadratic cells: half width", quad8.results.half_width, fine.results.half_width, 0.003)
    end
    row("u_y at the block's top centre", "mm", "published", "sinking", -1.3069e-3, 0.01)
  end,
  figures = function(cases)
    local curves = {}
    for _, case in ipairs(cases) do
      local x, pressure = reading.profile(case, case.p)
      curves[#curves + 1] = { label = ("%s, %g mm"):format(case.p.kind, case.p.cell:to("mm")), x = x, y = pressure,
        style = "points" }
    end
    local p = cases[1].p
    local modulus = hertz.combined_modulus(p.young_1.si, p.poisson, p.young_2.si, p.poisson)
    local a = hertz.half_width(2 * p.force.si, p.radius.si, modulus)
    local p0 = hertz.peak_pressure(2 * p.force.si, p.radius.si, modulus)
    local x, y = {}, {}
    for i = 0, 100 do
      x[i + 1] = a * i / 100
      y[i + 1] = hertz.pressure(x[i + 1], a, p0)
    end
    curves[#curves + 1] = { label = "Hertz", x = x, y = y }
    return { stiction.figure.lines { name = "pressure", title = "Pressure at 35 kN/mm",
      x = { label = "x", unit = "mm", range = { 0*mm, 9*mm } }, y = { label = "pressure", unit = "MPa" },
      curves = curves } }
  end,
}
