-- Makes the measured curves of this folder: the study with other parameters, and noise added.
--
--     ./stiction run studies/fit/pull_off/data.lua --trust --no-figures
local study = require "study"
local u = require "stiction".units

local points, noise = 40, 0.3e-3 -- N

--- A normal random number (Box and Muller); math.random gives the same numbers in every run.
local function normal()
  return math.sqrt(-2 * math.log(1 - math.random())) * math.cos(2 * math.pi * math.random())
end

local function write(case, name)
  local height, pull = study.definition.fit.data[name].against(case, case.p)
  local file = io.open(("studies/fit/pull_off/%s.csv"):format(name), "w")
  file:write("# computed by data.lua with noise of 0.3 mN; nobody measured this\nheight [um],pull [mN]\n")
  for i = 0, points - 1 do
    local x = height[1] + (height[#height] - height[1]) * i / (points - 1)
    local y = require "stiction".numeric.interpolate(height, pull, x) + noise * normal()
    file:write(("%.3f,%.4f\n"):format(1e6 * x, 1e3 * y))
  end
  file:close()
end

return study:variant {
  chosen = { young = { 0.8*u.MPa, "the truth" }, w = { 0.6*u.J/u.m^2, "the truth" }, b = { 0.03*u.N*u.s/u.m, "the truth" }, },
  check = function(cases, check)
    for i, name in ipairs { "slow", "middle", "quick" } do
      write(cases[i], name)
    end
    check.holds("written", true)
  end,
  fit = false, sample = false,
}
