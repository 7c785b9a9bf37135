-- Makes the measured curves of this folder: the study with other parameters, and noise added.
--
--     ./stiction run studies/fit/friction_trace/data.lua --trust --no-figures
local study = require "study"
local u = require "stiction".units

local points, noise = 30, 10 -- N/m

--- A normal random number (Box and Muller); math.random gives the same numbers in every run.
local function normal()
  return math.sqrt(-2 * math.log(1 - math.random())) * math.cos(2 * math.pi * math.random())
end

local function write(case, name)
  local way, drag = study.definition.fit.data[name].against(case, case.p)
  local file = io.open(("studies/fit/friction_trace/%s.csv"):format(name), "w")
  file:write("# computed by data.lua with noise of 10 N/m; nobody measured this\nway [mm],drag [N/m]\n")
  for i = 1, points do
    local x = way[#way] * i / points
    local y = require "stiction".numeric.interpolate(way, drag, x) + noise * normal()
    file:write(("%.5f,%.2f\n"):format(1e3 * x, y))
  end
  file:close()
end

return study:variant {
  chosen = { young = { 2*u.MPa, "the truth" }, mu = { 0.3, "the truth" }, w = { 0.8*u.J/u.m^2, "the truth" } },
  check = function(cases, check)
    for i, name in ipairs { "light", "heavy" } do
      write(cases[i], name)
    end
    check.holds("written", true)
  end,
  fit = false, sample = false,
}
