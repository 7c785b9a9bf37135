-- A block in a corner of two smooth obstacles, one of which comes in and slides along it: the corner node is in both
-- pairs, and each pair must tell its own force and do its own work alone.
local stiction = require "stiction"
local units = stiction.units
local m, s, Pa = units.m, units.s, units.Pa

local function scene(p)
  return stiction.scene {
    bodies = { block = stiction.body {
      mesh = stiction.mesh.block { origin = { 0*m, 0*m }, size = { 1*m, 1*m }, cells = { 4, 4 } },
      material = stiction.material.linear_elastic { young = 1000*Pa, poisson = 0.3 }, density = 1*units.kg/m^3 } },
    obstacles = {
      floor = stiction.obstacle { shape = stiction.rigid.plane {} },
      wall = stiction.obstacle { shape = stiction.rigid.plane { normal = { 1, 0 } }, times = { 0*s, 1*s, 2*s },
        x = { 0*m, 0.01*m, 0.01*m }, y = { 0*m, 0*m, 0.1*m } },
    },
    pairs = { sole = stiction.pair { secondary = "block.bottom", primary = "floor", discretisation = p.discretisation },
      side = stiction.pair { secondary = "block.left", primary = "wall", discretisation = p.discretisation } },
    motions = { stiction.motion.fix { set = "block.right", y = false },
      stiction.motion.drive { set = "block.top", times = { 0*s, 1*s, 2*s }, y = { 0*m, -0.01*m, -0.01*m } } },
    scheme = stiction.scheme.quasi_static {},
    schedule = stiction.schedule { stages = { stiction.stage { to = 2*s, steps = 4 } } },
    output = stiction.output { frames = 0 },
    probes = { sole = stiction.probe.contact { pair = "sole" }, side = stiction.probe.contact { pair = "side" },
      energy = stiction.probe.energy {} },
  }
end

local function last(group, column)
  return function(run)
    local values = run:series(group, column)
    return values[#values]
  end
end

return stiction.study {
  title = "A corner in two pairs", question = "Does each pair tell and do what is its own?",
  scene = scene,
  sweep = { { discretisation = "node_to_segment" }, { discretisation = "mortar" } },
  case_id = function(p) return p.discretisation end,
  results = {
    { name = "pressed", unit = "N/m", meaning = "force of the floor across itself", last("sole", "force_y") },
    { name = "along_floor", unit = "N/m", meaning = "force of the floor along itself", last("sole", "force_x") },
    { name = "pushed", unit = "N/m", meaning = "force of the wall across itself", last("side", "force_x") },
    { name = "along_wall", unit = "N/m", meaning = "force of the wall along itself", last("side", "force_y") },
    { name = "slid", unit = "J/m", meaning = "work of all motions while the wall slides", function(run)
      local work = run:series("energy", "motion_work")
      return work[#work] - work[#work - 2]
    end },
  },
  check = function(cases, check)
    for _, case in ipairs(cases) do
      local r = case.results
      check.within("the floor presses, " .. case.id, r.pressed, 5, 20)
      check.within("the wall pushes, " .. case.id, r.pushed, 5, 20)
      check.within("the floor's force has no part along it, " .. case.id, r.along_floor / r.pressed, -1e-9, 1e-9)
      check.within("the wall's force has no part along it, " .. case.id, r.along_wall / r.pushed, -1e-9, 1e-9)
      check.within("a smooth wall that slides does no work, " .. case.id, r.slid / (r.pushed * 0.1), -1e-9, 1e-9)
    end
  end,
}
