-- What accuracy costs at an impact: energy and pressure of every scheme against mesh and step.
--
--     ./stiction trade studies/trade/bar_impact
local stiction = require "stiction"
local proof = require "../../proofs/bar_impact"

local function exact(p)
  return stiction.reference.bar.impact {
    young = p.young.si, density = p.density.si, length = p.length.si, speed = p.speed.si,
  }
end

--- Pressure over time while the bar surely presses: from 0.1 s after it touches to 0.1 s before it leaves.
local function pressure(run, p)
  local touch, times, values = p.gap.si / p.speed.si, {}, {}
  local its = run:series("foot", "pressure")
  for i, t in ipairs(run.time) do
    if t > touch + 0.1 and t < touch + exact(p).duration - 0.1 then
      times[#times + 1], values[#values + 1] = t, its[i]
    end
  end
  return times, values
end

return proof:variant {
  title = "What accuracy costs: the impact of a bar",
  question = "Which scheme keeps energy and pressure at the least cost?",
  check = false, figures = false, case_id = false,
  chosen = { scheme = { "default", "the workbench's own" }, cells = { 100, "the classical mesh" } },
  sweep = {}, quick = {},
  trade = {
    quantities = {
      { name = "energy_kept", reference = 1 },
      { name = "pressure_mean", reference = function(p) return exact(p).pressure end },
      { name = "pressure", curve = pressure, reference = function(_, p) return exact(p).pressure end },
    },
    knobs = {
      { "cells", { 25, 50, 100, 200, 400 } },
      { "courant", { 4, 2, 1, 0.5 } },
      { "scheme", stiction.schemes.names() },
    },
    combinations = 20, -- many are of central differences beyond their limit
    quick = { set = { cells = 50 }, knobs = {
      { "cells", { 25, 50, 100 } }, { "courant", { 2, 1, 0.5 } },
      { "scheme", { "default", "paper", "backward_euler", "massless", "moreau_jean", "generalised_alpha_full",
        "central_difference" } },
    } },
  },
}
