-- What accuracy costs in a line contact: cell size, cell order, discretisation of NAFEMS CGS-1.
--
--     ./stiction trade studies/trade/hertz
local stiction = require "stiction"
local proof = require "../../proofs/hertz_2d"
local reading = require "../../proofs/hertz_2d/reading.lua"
local mm = stiction.units.mm
local hertz = stiction.reference.line_contact

local function scene(p)
  local made = proof.scene(p)
  made.pairs.touch.discretisation = p.discretisation
  return made
end

--- Pressure over x at the benchmark's force, out to 9 mm, where the small cells end.
local function pressure(run, p)
  local x, y = reading.profile(run, p)
  local order, xs, ys = {}, {}, {}
  for i = 1, #x do order[i] = i end
  table.sort(order, function(a, b) return x[a] < x[b] end)
  for _, i in ipairs(order) do
    if x[i] < 9e-3 then xs[#xs + 1], ys[#ys + 1] = x[i], y[i] end
  end
  return xs, ys
end

--- What Hertz says of it; SI.
local function exact(x, p)
  local modulus = hertz.combined_modulus(p.young_1.si, p.poisson, p.young_2.si, p.poisson)
  local load, radius = 2 * p.force.si, p.radius.si
  return hertz.pressure(x, hertz.half_width(load, radius, modulus), hertz.peak_pressure(load, radius, modulus))
end

return proof:variant {
  title = "What accuracy costs: a cylinder on a block",
  question = "Small linear cells or larger quadratic ones, nodes or mortar?",
  scene = scene, check = false, figures = false, case_id = false,
  chosen = {
    cell = { 0.5*mm, "12 cells to the half width" }, kind = { "quad4", "the default" },
    discretisation = { "node_to_segment", "the default" },
  },
  sweep = {}, quick = {},
  trade = {
    quantities = { "peak", "sinking", { name = "profile", curve = pressure, reference = exact } },
    knobs = {
      { "cell", { 2*mm, 1*mm, 0.5*mm, 0.25*mm, 0.125*mm } },
      { "coarse", { 16*mm, 8*mm, 4*mm, 2*mm } },
      { "kind", { "quad4", "quad8" } },
      { "discretisation", { "node_to_segment", "mortar" } },
    },
    quick = { set = { cell = 1*mm }, knobs = {
      { "cell", { 2*mm, 1*mm, 0.5*mm } }, { "coarse", { 16*mm, 8*mm, 4*mm } }, { "kind", { "quad4", "quad8" } },
      { "discretisation", { "node_to_segment", "mortar" } },
    } },
  },
}
