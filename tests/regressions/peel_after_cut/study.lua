-- A tape peeled from glass in steps so long that the first must be cut: what the failed attempt leaves must not reach
-- the next.
local stiction = require "stiction"
local units = stiction.units
local mm, s, kg, MPa, J, N, m = units.mm, units.s, units.kg, units.MPa, units.J, units.N, units.m

return stiction.study {
  title = "Peel after a cut", question = "Does a step that was cut start afresh?",
  chosen = {
    length = { 15*mm, "steady state" }, thickness = { 0.5*mm, "a tape" }, lift = { 6*mm, "of the end" },
    speed = { 100*mm/s, "of the end" }, cell = { 0.25*mm, "coarse" }, part = { 1, "of the lift" },
  },
  sweep = { { "steps", { 100 } } }, quick = { set = { part = 0.2 } },
  scene = function(p)
    local T = p.lift / p.speed
    return stiction.scene {
      bodies = { tape = stiction.body {
        mesh = stiction.mesh.block { size = { p.length, p.thickness },
          cells = { p.length / p.cell, p.thickness / p.cell }, kind = "quad8" },
        material = stiction.material.neo_hookean { young = 5*MPa, poisson = 0.4 }, density = 1000*kg/m^3 } },
      obstacles = { glass = stiction.obstacle { shape = stiction.rigid.plane {} } },
      pairs = { bond = stiction.pair { secondary = "tape.bottom", primary = "glass",
        adhesion = stiction.adhesion.rcc { w = 10*J/m^2,
          C_n = 1e9*N/m^3, C_t = 1e9*N/m^3, b = 0.1*N*s/m, beta0 = 1, bonding = "never" } } },
      motions = { stiction.motion.drive { set = "tape.left", near = { 0*mm, p.thickness }, times = { 0*s, T }, y = { 0*mm, p.lift } },
        stiction.motion.fix { set = "tape.right" } },
      scheme = stiction.scheme.quasi_static {},
      schedule = stiction.schedule { stages = { stiction.stage { to = p.part * T, steps = math.floor(p.part * p.steps + 0.5) } } },
      output = stiction.output { frames = 0 },
      probes = { pull = stiction.probe.force { set = "tape.left", near = { 0*mm, p.thickness } } },
    }
  end,
  results = {
    { name = "peel_force", unit = "N/m", meaning = "largest peel force per width", function(run) return run:max("pull", "force_y") end },
    { name = "steps", unit = "1", meaning = "steps beyond those asked for",
      function(run, p) return #run.time - 1 - math.floor(p.part * p.steps + 0.5) end } },
  check = function(cases, check)
    for _, one in ipairs(cases) do check.within("steps that had to be cut", one.results.steps, 0, 3) end
  end,
}
