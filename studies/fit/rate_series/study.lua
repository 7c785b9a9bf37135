-- Pull-off forces over speed, a case each: what they tell of work of adhesion and viscosity of the bonds.
--
-- The forces are ours: computed by data.lua with w = 0.6 J/m^2, b = 0.03 N s/m on these cells, with noise of 3 %. Modulus and
-- stiffness are taken as known.
--
--     ./stiction fit studies/fit/rate_series
local stiction = require "stiction"
local u = stiction.units

return (require "../pull_off"):variant {
  title = "Pull-off over speed: what the largest forces tell",
  question = "Do pull-off forces at several speeds tell work of adhesion and viscosity of the bonds apart, and which speed tells more?",
  chosen = { young = { 0.8*u.MPa, "known from elsewhere" }, steps = { 100, "way up; fit.finer doubles it" } },
  sample = false,
  fit = {
    parameters = {
      w = { 0.1*u.J/u.m^2, 10*u.J/u.m^2, scale = "log" },
      b = { 1e-3*u.N*u.s/u.m, 1*u.N*u.s/u.m, scale = "log" },
    },
    data = { rate = { file = "rate.csv", x = "speed", y = "pull_off", relative = 0.03, each = { speed = "speed" },
      against = function(run) return (run:max("joint", "force_y")) end } },
    finer = { cell = 0.025*u.mm, steps = 200 },
    quick = { profiles = false },
  },
}
