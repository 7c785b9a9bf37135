-- Two squares collide off centre: the corner of one pokes between two nodes of the other, one of which then slides in
-- past the border of the face that it bulged by. Pushed out through that face it would leap half a cell. So with a rigid
-- profile that has an open end.
local stiction = require "stiction"
local units = stiction.units
local m, mm, s, ms, MPa, kg = units.m, units.mm, units.s, units.ms, units.MPa, units.kg

local function square(p, x, y, speed)
  return stiction.body {
    mesh = stiction.mesh.block { origin = { x, y }, size = { 10*mm, 10*mm }, cells = { p.cells, p.cells } },
    material = stiction.material.neo_hookean { young = 1*MPa, poisson = 0.3 }, density = 1000*kg/m^3,
    velocity = { speed, 0*m/s } }
end

local function scene(p)
  local bodies, obstacles = { striker = square(p, 0*mm, 0*mm, 4*m/s) }
  if p.rigid then
    obstacles = { struck = stiction.obstacle { shape = stiction.rigid.polyline {
      points = { 10.2*mm, 24*mm, 10.2*mm, p.offset }, smoothing = "polyline" } } }
  else
    bodies.struck = square(p, 10.2*mm, p.offset, 0*m/s)
  end
  return stiction.scene {
    bodies = bodies, obstacles = obstacles,
    pairs = { hit = stiction.pair { secondary = "striker.right", primary = p.rigid and "struck" or "struck.left",
      friction = stiction.friction.coulomb { mu = p.mu } } },
    schedule = stiction.schedule { stages = { stiction.stage { to = 2*ms, steps = 100 } } },
    output = stiction.output { frames = 0 },
    probes = { energy = stiction.probe.energy {}, momentum = stiction.probe.momentum {} },
  }
end

return stiction.study {
  title = "A node that came in past a border", question = "Is it left alone until it is out?",
  scene = scene,
  sweep = {
    { offset = 4*mm, mu = 0.2, rigid = false }, { offset = 4*mm, mu = 0, rigid = false },
    { offset = 2.6*mm, mu = 0.2, rigid = false },
    { offset = 4*mm, mu = 0, rigid = true }, { offset = 6*mm, mu = 0.2, rigid = true }, { offset = 8*mm, mu = 0, rigid = true },
  },
  given = { cells = { 8, "along each side" } },
  case_id = function(p) return ("%soffset%g_mu%g"):format(p.rigid and "rigid_" or "", p.offset:to "mm", p.mu) end,
  results = {
    { name = "made", unit = "1", meaning = "energy made, over that at the start", function(run)
      return math.max(0, -run:min("energy", "scheme_loss")) / run:series("energy", "kinetic")[1] end },
    { name = "turned_back", unit = "1", meaning = "momentum that the striker lost, over that at the start",
      function(run)
        local values = run:series("momentum", "striker_p_x")
        return 1 - values[#values] / values[1]
      end },
  },
  check = function(cases, check)
    for _, case in ipairs(cases) do
      check.within("no energy is made, " .. case.id, case.results.made, 0, 1e-3)
      check.within("the squares part, " .. case.id, case.results.turned_back, case.p.rigid and 0.8 or 0.5, case.p.rigid and 2 or 1)
    end
  end,
}
