-- A tape bonded from the start, held by its bonds and one driven corner alone.
local stiction = require "stiction"
local units, numeric = stiction.units, stiction.numeric
local mm, m, s, kg, MPa, J, N = units.mm, units.m, units.s, units.kg, units.MPa, units.J, units.N

local function largest_difference(run, a, b)
  local first, second, largest = run:series("pull", a), run:series("bond", b), 0
  for k, force in ipairs(first) do
    largest = math.max(largest, math.abs(force + second[k]))
  end
  return largest / numeric.max(first)
end

return stiction.study {
  title = "A tape on whole bonds", question = "Do whole bonds count as what holds a body, and does nothing else hold it?",
  chosen = {
    length = { 8*mm, "longer than what peels" }, thickness = { 0.5*mm, "a tape" }, young = { 5*MPa, "soft" },
    w = { 10*J/m^2, "strong" }, C = { 1e9*N/m^3, "opens 0.1 mm" }, b = { 0.1*N*s/m, "depends on the rate" },
    lift = { 3*mm, "several openings" }, cell = { 0.25*mm, "coarse" }, steps = { 60, "small enough" },
  },
  sweep = { { "v", { 1*mm/s, 100*mm/s } } },
  quick = { sweep = { v = { 100*mm/s } } },
  scene = function(p)
    local duration = p.lift / p.v
    local corner = { 0*mm, p.thickness }
    return stiction.scene {
      bodies = { tape = stiction.body {
        mesh = stiction.mesh.block { size = { p.length, p.thickness }, cells = { p.length / p.cell, p.thickness / p.cell } },
        material = stiction.material.neo_hookean { young = p.young, poisson = 0.4 }, density = 1000*kg/m^3 } },
      obstacles = { glass = stiction.obstacle { shape = stiction.rigid.plane {} } },
      pairs = { bond = stiction.pair { secondary = "tape.bottom", primary = "glass",
        adhesion = stiction.adhesion.rcc { w = p.w, C_n = p.C, C_t = p.C, b = p.b, beta0 = 1, bonding = "never" } } },
      motions = { stiction.motion.drive { set = "tape.left", near = corner, times = { 0*s, duration }, y = { 0*mm, p.lift } } },
      scheme = stiction.scheme.quasi_static {},
      schedule = stiction.schedule { stages = { stiction.stage { to = duration, steps = p.steps } } },
      probes = { bond = stiction.probe.contact { pair = "bond" }, energy = stiction.probe.energy {},
        line = stiction.probe.contact_line { pair = "bond" },
        pull = stiction.probe.force { set = "tape.left", near = corner } },
    }
  end,
  results = {
    { name = "force", unit = "N/m", meaning = "largest peel force per width", function(run) return run:max("pull", "force_y") end },
    { name = "unmet", unit = "1", meaning = "largest share of the pull that the bonds do not answer",
      function(run) return largest_difference(run, "force_y", "force_y") end },
    { name = "left", unit = "1", meaning = "bond at the pulled end, in the end",
      function(run) return (run:series("line", "beta", 1))[#run.time] end },
    { name = "right", unit = "1", meaning = "bond at the far end, in the end",
      function(run)
        local points = math.tointeger(run.p.length / run.p.cell + 1)
        return (run:series("line", "beta", points))[#run.time]
      end },
    { name = "held", unit = "J/m", meaning = "work of a stabilisation nobody asked for",
      function(run) return run:max("energy", "stabilisation_loss") end },
  },
  check = function(cases, check)
    for _, case in ipairs(cases) do
      check.within("force " .. case.id, case.results.force, 1, 1e4)
      check.within("bonds answer the pull " .. case.id, case.results.unmet, 0, 1e-5)
      check.within("peeled " .. case.id, case.results.left, 0, 0.05)
      check.within("not yet peeled " .. case.id, case.results.right, 0.9, 1)
      check.equal("no stabilisation " .. case.id, case.results.held, 0, 0)
    end
  end,
}
