-- Makes the measured curves of this folder: the study with other parameters, and noise added.
--
--     ./stiction run studies/fit/bond_range/data.lua --trust --no-figures
local study = require "study"
local u = require "stiction".units

local points, noise = 40, 0.05e-3 -- N
local ends = { long = 8e-6, short = 2.1e-6 } -- m: short bonds let go at 2.4 um

--- A normal random number (Box and Muller); math.random gives the same numbers in every run.
local function normal()
  return math.sqrt(-2 * math.log(1 - math.random())) * math.cos(2 * math.pi * math.random())
end

local function write(case, name)
  local height, pull = study.definition.fit.data.pull.against(case, case.p)
  local file = io.open(("studies/fit/bond_range/%s.csv"):format(name), "w")
  file:write("# computed by data.lua with noise of 0.05 mN; nobody measured this\nheight [um],pull [mN]\n")
  for i = 0, points - 1 do
    local x = height[1] + (ends[name] - height[1]) * i / (points - 1)
    local y = require "stiction".numeric.interpolate(height, pull, x) + noise * normal()
    file:write(("%.4f,%.5f\n"):format(1e6 * x, 1e3 * y))
  end
  file:close()
end

return study:variant {
  chosen = { w = { 0.05*u.J/u.m^2, "the truth" }, steps = { 2000, "way up" } },
  sweep = { sigma0 = { 10*u.kPa, 500*u.kPa } },
  check = function(cases, check)
    for i, name in ipairs { "long", "short" } do
      write(cases[i], name)
    end
    check.holds("written", true)
  end,
  fit = false, sample = false,
}
