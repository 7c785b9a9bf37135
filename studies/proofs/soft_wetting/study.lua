-- A rigid bead that sticks to a gel without a load: from Johnson, Kendall and Roberts to wetting, as surface stress takes over.
--
--         .-'''-.      drawn off slowly until it bears nothing: it rests at the depth d
--        | bead  |
--   _____.'-._.-'._____   gel: neo-Hookean, nearly incompressible; surface stress gamma all over its top, bonds of energy w
--         gel
--
-- Stiff gel, gamma/(E R) << 1: JKR without a load, d = a^2 / (3 R), a^3 = 9 pi w R^2 / (2 E*).
-- Soft gel,  gamma/(E R) >> 1: the surface stays flat and the bead floats in it as in a liquid. With the energy
-- gamma (area outside + cap) - w cap = gamma (pi d^2 + const) - w 2 pi R d it rests at d = w R / gamma (Young and Dupre).
--
--     ./stiction run studies/proofs/soft_wetting
local stiction = require "stiction"
local bead = require "bead"
local units, numeric = stiction.units, stiction.numeric
local um, m, N, Pa = units.um, units.m, units.N, units.Pa
local mN = 1e-3 * N

--- The parameters of the bead's scene: as soft as gamma / (E R) says.
local function with_modulus(p)
  return setmetatable({ young = p.gamma.si / (p.R.si * p.softness) * Pa }, { __index = p })
end

return stiction.study {
  title = "From JKR to wetting",
  question = "How deep does a bead sink into a gel whose surface stress takes over?",
  given = { R = { 15*um, "bead" }, gamma = { 30*mN/m, "surface stress" }, w = { 1.5*mN/m, "a twentieth of it" }, poisson = { 0.495, "" } },
  chosen = bead.chosen,
  sweep = { { softness = 1e-3, cell = 0.03 }, { softness = 1e-2, cell = 0.03 }, { softness = 0.1, cell = 0.03 },
    { softness = 1, cell = 0.03 }, { softness = 1, cell = 0.015 }, { softness = 10, cell = 0.03 }, { softness = 30, cell = 0.03 } },
  quick = { sweep = { { softness = 1e-3, cell = 0.03 }, { softness = 1, cell = 0.03 }, { softness = 10, cell = 0.03 } } },
  case_id = function(p) return ("softness_%g_%g"):format(p.softness, p.cell) end,
  scene = function(p) return bead.scene(with_modulus(p)) end,
  results = {
    { name = "depth", unit = "m", meaning = "at rest", bead.rest },
    { name = "of_liquid", unit = "1", meaning = "depth over w R / gamma", function(run, p) return bead.rest(run) / bead.liquid(p) end },
    { name = "of_solid", unit = "1", meaning = "depth over JKR's", function(run, p)
      local _, d = bead.solid(with_modulus(p))
      return bead.rest(run) / d
    end },
  },
  check = function(cases, check)
    local all = cases:where { cell = 0.03 }
    local first, last = all[1], all[#all]
    check.within("stiff: as deep as JKR", first.results.of_solid, 0.94, 1)
    check.within("soft: as deep as in a liquid", last.results.of_liquid, 0.97, 1.04)
    check.non_decreasing("the softer the nearer to a liquid", all:values "of_liquid", 0.01)
    for _, c in ipairs(all) do check.ledger(c) end
  end,
  figures = function(cases)
    local all, x, exact = cases:where { cell = 0.03 }, {}, {}
    local p = all[1].p
    for k = 0, 30 do
      x[k + 1] = 1e-3 * 10 ^ (k / 30 * 2.5)
      local _, d = bead.solid(with_modulus(setmetatable({ softness = x[k + 1] }, { __index = p })))
      exact[k + 1] = d / bead.liquid(p)
    end
    local softness = numeric.map(all, function(c) return c.p.softness end)
    return { stiction.figure.lines { name = "depth", title = "A bead that rests on a gel", legend = "below", curves = {
        { label = "JKR", x = x, y = exact, style = "dash" },
        { label = "a liquid", x = { softness[1], softness[#softness] }, y = { 1, 1 }, style = "dot" },
        { label = "computed", x = softness, y = all:values "of_liquid", style = "points" } },
      x = { label = "gamma / (E R)", log = true }, y = { label = "depth / (w R / gamma)" } },
      stiction.figure.field { name = "gel", case = all[#all - 1], array = "von_mises", label = "von Mises stress", unit = "Pa",
        deformed = true, window = { 0*um, 18*um, -9*um, 9*um }, mesh = true, title = "gamma/(E R) = 10, drawn off" } }
  end,
}
