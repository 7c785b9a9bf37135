-- Makes the measured forces of this folder: the study with other parameters, and noise added.
--
--     ./stiction run studies/fit/rate_series/data.lua --trust --no-figures
local study = require "study"
local u = require "stiction".units

local noise = 0.03 -- of each force

--- A normal random number (Box and Muller); math.random gives the same numbers in every run.
local function normal()
  return math.sqrt(-2 * math.log(1 - math.random())) * math.cos(2 * math.pi * math.random())
end

return study:variant {
  chosen = { w = { 0.6*u.J/u.m^2, "the truth" }, b = { 0.03*u.N*u.s/u.m, "the truth" } },
  sweep = { speed = { 10*u.um/u.s, 50*u.um/u.s, 200*u.um/u.s, 500*u.um/u.s, 1000*u.um/u.s, 2000*u.um/u.s } },
  check = function(cases, check)
    local file = io.open("studies/fit/rate_series/rate.csv", "w")
    file:write("# computed by data.lua with noise of 3 %; nobody measured this\nspeed [um/s],pull_off [mN]\n")
    for _, case in ipairs(cases) do
      file:write(("%g,%.3f\n"):format(case.p.speed:to "um/s", 1e3 * case.results.pull_off * (1 + noise * normal())))
    end
    check.holds("written", file:close())
  end,
  fit = false, sample = false,
}
