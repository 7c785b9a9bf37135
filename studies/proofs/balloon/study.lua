-- A hollow ball of rubber, blown up by a pressure and, past the largest that it bears, by volume.
--
--        y
--        |--.
--     p  |   `.     A quarter of its section, about the y axis; the inner side is the wall of the cavity.
--        |--.  \
--        |   \  |
--        o----|-|-- x
--
--     ./stiction run studies/proofs/balloon
local stiction = require "stiction"
local units, numeric = stiction.units, stiction.numeric
local mm, s, kg, m, MPa, Pa = units.mm, units.s, units.kg, units.m, units.MPa, units.Pa

--- Pressure (Pa) at the stretch `stretch` of the inner side, incompressible: mu (F(outer stretch) - F(inner stretch)).
local function pressure(p, stretch)
  local function F(x) return 2 / x + 1 / (2 * x ^ 4) end
  local outer = (1 + (stretch ^ 3 - 1) * (p.inner / p.outer) ^ 3) ^ (1 / 3)
  return p.young.si / 3 * (F(outer) - F(stretch))
end

--- The largest pressure, and the stretch there, by steps of 1e-4.
local function limit(p)
  local most, where = 0, 1
  for k = 1, 20000 do
    local here = pressure(p, 1 + k * 1e-4)
    if here > most then most, where = here, 1 + k * 1e-4 end
  end
  return most, where
end

--- The stretch below the limit at a pressure (Pa).
local function stretch_at(p, wanted)
  local low, _, high = 1, limit(p)
  for _ = 1, 60 do
    local middle = (low + high) / 2
    if pressure(p, middle) < wanted then low = middle else high = middle end
  end
  return low
end

local function load(p)
  if p.by == "pressure" then
    return stiction.load.pressure { set = "ball.inner", times = { 0*s, 1*s }, pressure = { 0*Pa, p.part * limit(p) * Pa } }
  end
  return stiction.load.gas { set = "ball.inner", times = { 0*s, 1*s }, volume = { 1, p.stretch ^ 3 } }
end

local function scene(p)
  local edge, centre = stiction.edge, { 0*m, 0*m }
  return stiction.scene {
    kinematics = "axisymmetric",
    bodies = { ball = stiction.body {
      mesh = stiction.mesh.gmsh { size = p.h, kind = "quad8", start = { p.inner, 0*m }, edges = {
        edge { to = { p.outer, 0*m }, name = "flat" }, edge { to = { 0*m, p.outer }, centre = centre, name = "outside" },
        edge { to = { 0*m, p.inner }, name = "axis" }, edge { to = { p.inner, 0*m }, centre = centre, name = "inner" } } },
      density = 1000*kg/m^3, material = stiction.material.neo_hookean { young = p.young, poisson = p.poisson } } },
    motions = { stiction.motion.fix { set = "ball.flat", y = true } },
    loads = { load(p) },
    scheme = stiction.scheme.quasi_static {},
    schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = p.steps } } },
    output = stiction.output { frames = 1 },
    probes = {
      gas = p.by == "volume" and stiction.probe.gas { set = "ball.inner" } or nil,
      wall = stiction.probe.node { set = "ball.inner", near = { p.inner, 0*m } },
      energy = stiction.probe.energy { audit = true },
    },
  }
end

local function proof(cases, check, t)
  local of = cases:where { by = t.by }
  local values = numeric.map(of, function(c) return { c.p.h.si, c.results[t.result] } end)
  check.proof { case = "Balloon", quantity = t.quantity, unit = t.unit, kind = "exact", source = "incompressible neo-Hookean ball",
    reference = t.reference(of[1].p), values = values, resolution = "m cell", tolerance = t.tolerance, run = of[#of] }
end

local sweep = {}
for _, by in ipairs { "pressure", "volume" } do
  for _, h in ipairs { 3*mm, 1.5*mm } do sweep[#sweep + 1] = { by = by, h = h } end
end

return stiction.study {
  title = "Balloon", question = "Is a hollow ball blown up as it should be, past the largest pressure too?",
  given = { inner = { 10*mm, "" }, outer = { 13*mm, "" }, young = { 1*MPa, "neo-Hookean" }, part = { 0.8, "of the largest pressure" },
    stretch = { 2, "of the inner side at the end, by volume" } },
  chosen = { poisson = { 0.4995, "1/3 of p/K, 10^-4, from incompressible" }, steps = { 56, "of the hardly compressible" } },
  sweep = sweep,
  quick = { sweep = { sweep[1], sweep[3] } },
  case_id = function(p) return ("%s_%g"):format(p.by, p.h.si * 1e3) end,
  scene = scene,
  results = {
    { name = "stretch", unit = "1", meaning = "of the inner side at the end", function(run)
      return 1 + run:at(1*s, "wall", "u_x") / run.p.inner.si end },
    { name = "last", unit = "Pa", meaning = "pressure at the end, by volume", function(run)
      return run.p.by == "volume" and run:at(1*s, "gas", "pressure") or 0 end },
    { name = "largest", unit = "Pa", meaning = "pressure, by volume", function(run)
      return run.p.by == "volume" and math.max(table.unpack((run:series("gas", "pressure")))) or 0 end },
  },
  check = function(cases, check)
    proof(cases, check, { by = "pressure", result = "stretch", quantity = "stretch at 0.8 of the largest pressure", unit = "1",
      reference = function(p) return stretch_at(p, p.part * limit(p)) end, tolerance = 2e-3 })
    proof(cases, check, { by = "volume", result = "largest", quantity = "largest pressure", unit = "Pa",
      reference = function(p) return (limit(p)) end, tolerance = 2e-3 })
    proof(cases, check, { by = "volume", result = "last", quantity = "pressure at the stretch 2", unit = "Pa",
      reference = function(p) return pressure(p, p.stretch) end, tolerance = 2e-3 })
    for _, c in ipairs(cases) do
      check.ledger(c)
    end
  end,
  figures = function(cases)
    local of = cases:where { by = "volume" }
    local last = of[#of]
    local stretches = numeric.map(last:series("wall", "u_x"), function(u) return 1 + u / last.p.inner.si end)
    return { stiction.figure.lines { name = "pressure", title = "A hollow ball of rubber, blown up by volume",
      x = { label = "stretch of the inner side", unit = "1" }, y = { label = "pressure", unit = "kPa" }, curves = {
        { label = "incompressible, exact", x = stretches, y = numeric.map(stretches, function(x) return pressure(last.p, x) end) },
        { label = ("cells of %g mm"):format(last.p.h.si * 1e3), x = stretches, y = last:series("gas", "pressure"),
          style = "points" } } } }
  end,
}
