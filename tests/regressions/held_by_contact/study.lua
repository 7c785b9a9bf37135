-- A ball that nothing but two plates holds, with stabilisations of different size.
local stiction = require "stiction"
local units = stiction.units
local mm, s, kg, m, MPa = units.mm, units.s, units.kg, units.m, units.MPa

local function ball(p)
  local R, edge, centre = p.radius, stiction.edge, { 0*mm, 0*mm }
  return stiction.mesh.gmsh { start = { 0*mm, -R }, size = p.cell, edges = {
    edge { to = { R, 0*mm }, centre = centre, name = "bottom" }, edge { to = { 0*mm, R }, centre = centre, name = "top" },
    edge { to = { 0*mm, -R }, name = "axis" } } }
end

local function last(run, probe, column)
  local values = run:series(probe, column)
  return values[#values]
end

return stiction.study {
  title = "A ball between two plates", question = "Does a stabilisation that vanishes leave the answer alone?",
  chosen = { radius = { 5*mm, "a ball" }, cell = { 0.8*mm, "coarse" }, press = { 0.5*mm, "a tenth of the radius" } },
  sweep = { { "part", { 1e-3, 1e-5, 1e-6 } } },
  scene = function(p)
    local R = p.radius
    local plate = stiction.rigid.plane
    return stiction.scene {
      kinematics = "axisymmetric",
      bodies = { ball = stiction.body { mesh = ball(p), density = 1000*kg/m^3,
        material = stiction.material.neo_hookean { young = 1*MPa, poisson = 0.4 } } },
      obstacles = {
        floor = stiction.obstacle { shape = plate { point = { 0*mm, -R }, normal = { 0, 1 } } },
        lid = stiction.obstacle { shape = plate { point = { 0*mm, R }, normal = { 0, -1 } },
          times = { 0*s, 1*s, 2*s }, y = { 0*mm, -p.press, -p.press } } },
      pairs = { below = stiction.pair { secondary = "ball.bottom", primary = "floor" },
        above = stiction.pair { secondary = "ball.top", primary = "lid" } },
      scheme = stiction.scheme.quasi_static { stabilisation = p.part },
      schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = 10 }, stiction.stage { to = 1.3*s, steps = 3 } } },
      probes = { below = stiction.probe.contact { pair = "below" }, above = stiction.probe.contact { pair = "above" },
        energy = stiction.probe.energy {} },
    }
  end,
  results = {
    { name = "force", unit = "N", meaning = "of the floor on the ball", function(run) return last(run, "below", "force_y") end },
    { name = "unmet", unit = "1", meaning = "share of it that the lid does not answer",
      function(run) return last(run, "above", "force_y") / last(run, "below", "force_y") + 1 end },
    { name = "share", unit = "1", meaning = "work of the stabilisation over the strain energy",
      function(run) return last(run, "energy", "stabilisation_loss") / last(run, "energy", "strain") end },
  },
  check = function(cases, check)
    local least = cases:find { part = 1e-6 }.results
    for _, part in ipairs { 1e-3, 1e-5 } do
      local own = cases:find { part = part }.results
      check.close(("force at %g"):format(part), own.force, least.force, 1e-6)
      check.within(("balance at %g"):format(part), own.unmet, -1e-6, 1e-6)
      check.within(("work at %g"):format(part), own.share, 1e-12, 10 * part)
    end
  end,
}
