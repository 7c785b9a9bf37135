-- What accuracy costs at an impact: energy and pressure of every scheme against mesh and step.
--
--     ./stiction trade studies/trade/bar_impact
local stiction = require "stiction"
local proof = require "../../proofs/bar_impact"
local Pa = stiction.units.Pa

return proof:variant {
  title = "What accuracy costs: the impact of a bar",
  question = "Which scheme keeps energy and pressure at the least cost?",
  check = false, figures = false, case_id = false,
  chosen = { scheme = { "default", "the workbench's own" }, cells = { 100, "the classical mesh" } },
  sweep = {}, quick = {},
  trade = {
    quantities = { "energy_kept", "pressure_mean", { name = "pressure_rms", scale = 300*Pa } },
    knobs = {
      { "cells", { 25, 50, 100, 200, 400 } },
      { "courant", { 4, 2, 1, 0.5 } },
      { "scheme", stiction.schemes.names() },
    },
    quick = { set = { cells = 50 }, knobs = {
      { "cells", { 25, 50, 100 } }, { "courant", { 2, 1, 0.5 } },
      { "scheme", { "default", "paper", "backward_euler", "massless", "moreau_jean", "generalised_alpha_full",
        "central_difference" } },
    } },
  },
}
