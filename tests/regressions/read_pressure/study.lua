-- A disc pressed flat onto a plane: the same pressure at every point, on the axis, at mid-side nodes and on the rim.
local stiction = require "stiction"
local numeric, units = stiction.numeric, stiction.units
local m, mm, s, kg, MPa = units.m, units.mm, units.s, units.kg, units.MPa

--- Value of a column at the last step for every point.
local function last(run, column)
  local values = {}
  for k = 1, run:max("line", "count") do
    local over_time = run:series("line", column, k)
    values[k] = over_time[#over_time]
  end
  return values
end

local function sum(values, weights)
  local total = 0
  for k, value in ipairs(values) do total = total + value * (weights and weights[k] or 1) end
  return total
end

return stiction.study {
  title = "Pressure under a disc pressed flat",
  question = "Does every contact point read the uniform pressure, and do pressures times areas sum to the force?",
  given = { young = { 10*MPa, "" }, radius = { 10*mm, "" }, height = { 5*mm, "" }, sinking = { 0.05*mm, "p = 1e5 Pa" } },
  sweep = { kind = { "tri3", "quad4", "quad8", "tri6" }, method = { "node_to_segment", "mortar" } },
  scene = function(p)
    return stiction.scene {
      kinematics = "axisymmetric",
      bodies = { disc = stiction.body {
        mesh = stiction.mesh.block { size = { p.radius, p.height }, cells = { 8, 4 }, kind = p.kind },
        material = stiction.material.linear_elastic { young = p.young, poisson = 0 }, density = 1000*kg/m^3 } },
      obstacles = { floor = stiction.obstacle { shape = stiction.rigid.plane {} } },
      pairs = { sole = stiction.pair { secondary = "disc.bottom", primary = "floor", discretisation = p.method } },
      motions = { stiction.motion.fix { set = "disc.left", y = false },
        stiction.motion.drive { set = "disc.top", times = { 0*s, 1*s }, y = { 0*mm, -p.sinking } } },
      scheme = stiction.scheme.quasi_static {},
      schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = 1 } } },
      control = stiction.control { force_tolerance = 1e-12 },
      output = stiction.output { frames = 0 },
      probes = { line = stiction.probe.contact_line { pair = "sole" }, floor = stiction.probe.rigid { obstacle = "floor" } },
    }
  end,
  results = {
    { name = "least", unit = "Pa", meaning = "least pressure of any point",
      function(run) return numeric.min(last(run, "pressure")) end },
    { name = "most", unit = "Pa", meaning = "largest pressure of any point",
      function(run) return numeric.max(last(run, "pressure")) end },
    { name = "area", unit = "m^2", meaning = "sum of the points' areas", function(run) return sum(last(run, "area")) end },
    { name = "carried", unit = "N", meaning = "sum of pressures times areas",
      function(run) return sum(last(run, "pressure"), last(run, "area")) end },
    { name = "floor", unit = "N", meaning = "force on the floor, down",
      function(run) return -run:min("floor", "force_y") end },
  },
  check = function(cases, check)
    for _, case in ipairs(cases) do
      local p, r = case.p, case.results
      local pressure, area = p.young.si * p.sinking.si / p.height.si, math.pi * p.radius.si ^ 2
      check.close(case.id .. ": least pressure", r.least, pressure, 1e-10)
      check.close(case.id .. ": largest pressure", r.most, pressure, 1e-10)
      check.close(case.id .. ": areas", r.area, area, 1e-12)
      check.close(case.id .. ": pressures times areas", r.carried, pressure * area, 1e-10)
      check.close(case.id .. ": force on the floor", r.floor, pressure * area, 1e-10)
    end
  end,
}
