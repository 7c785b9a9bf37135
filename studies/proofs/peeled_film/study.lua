-- A thin film peeled off a rigid plane by a vertical force at its end: once the arm stands upright, the force per
-- depth is the energy of decohesion, whatever the law of the bond.
--
--     ^ P            P + P^2 / (2 E h) = w    (Kendall 1975, at 90 degrees, plane strain, nu = 0)
--     |
--     |              The arm stands upright once it is several sqrt(E h^3 / (12 w)) long. The bond holds the film
--     |__________    on either side of its front, so the force neither depends on the cell nor, as long as b is
--   --------------   small, on the speed.
--
--     ./stiction run studies/proofs/peeled_film
local stiction = require "stiction"
local units, numeric = stiction.units, stiction.numeric
local mm, s, kg, m, J, N, MPa = units.mm, units.s, units.kg, units.m, units.J, units.N, units.MPa

local function scene(p)
  return stiction.scene {
    bodies = {
      film = stiction.body { mesh = stiction.mesh.block { size = { p.length, p.h },
          cells = { math.floor(p.length / p.cell + 0.5), 1 }, kind = "quad8" },
        material = stiction.material.st_venant_kirchhoff { young = p.young, poisson = 0 }, density = 1000*kg/m^3 },
    },
    obstacles = { floor = stiction.obstacle { shape = stiction.rigid.plane {} } },
    pairs = {
      bond = stiction.pair { secondary = "film.bottom", primary = "floor",
        adhesion = stiction.adhesion.rcc { w = p.w, C_n = p.C, C_t = p.C, b = p.b, beta0 = 1, bonding = "never" } },
    },
    motions = {
      stiction.motion.fix { set = "film.right" },
      stiction.motion.drive { set = "film.left", near = { 0*mm, p.h }, times = { 0*s, p.time }, y = { 0*mm, p.lift } },
    },
    scheme = stiction.scheme.quasi_static {},
    schedule = stiction.schedule { stages = { stiction.stage { to = p.time, steps = p.steps } } },
    output = stiction.output { frames = 4 },
    probes = {
      force = stiction.probe.force { set = "film.left", near = { 0*mm, p.h } },
      energy = stiction.probe.energy {},
    },
  }
end

--- Mean force per depth while the end rises from three quarters of the way to its end.
local function plateau(run, p)
  local force, sum, count = run:series("force", "force_y"), 0, 0
  for k, t in ipairs(run.time) do
    if t > 0.75 * p.time.si then
      sum, count = sum + force[k], count + 1
    end
  end
  return sum / count
end

--- The force that Kendall's equation gives.
local function exact(p)
  local stiffness = p.young.si * p.h.si
  return stiffness * (math.sqrt(1 + 2 * p.w.si / stiffness) - 1)
end

return stiction.study {
  title = "Peeled film",
  question = "Does a film peel at its energy of decohesion, on any mesh and at any speed?",
  given = { young = { 100*MPa, "" }, h = { 0.1*mm, "film" }, w = { 10*J/m^2, "" },
    C = { 1e9*N/m^3, "bond" }, b = { 1e-4*N*s/m, "a thousandth of w at the highest speed" } },
  chosen = { length = { 6.4*mm, "four lengths of the bond's zone are left at the end" },
    lift = { 4*mm, "more than four sqrt(E h^3 / (12 w))" }, steps = { 200, "front moves less than a cell a step" } },
  sweep = { { cell = 0.2*mm, time = 1*s }, { cell = 0.1*mm, time = 1*s }, { cell = 0.05*mm, time = 1*s },
    { cell = 0.2*mm, time = 0.1*s }, { cell = 0.2*mm, time = 10*s } },
  quick = { sweep = { { cell = 0.2*mm, time = 0.1*s } } },
  case_id = function(p) return ("cell%g_in%gs"):format(p.cell:to("um"), p.time.si) end,
  scene = scene,
  results = {
    { name = "force", unit = "N/m", meaning = "mean force per depth over the last quarter of the way", plateau },
    { name = "ratio", unit = "1", meaning = "over Kendall's",
      function(run, p) return plateau(run, p) / exact(p) end },
    { name = "energy_rate", unit = "1", meaning = "work less strain over energy of broken bonds, last quarter",
      function(run)
        local work, strain, bond = run:series("energy", "motion_work"), run:series("energy", "strain"),
          run:series("energy", "bond")
        local n = #work
        local k = math.floor(0.75 * n)
        return (work[n] - work[k] - strain[n] + strain[k]) / (bond[n] - bond[k])
      end },
  },
  check = function(cases, check)
    for _, case in ipairs(cases) do
      check.proof { case = "peeled film", quantity = "force, " .. case.id, unit = "N/m", kind = "exact",
        source = "Kendall 1975: P + P^2 / (2 E h) = w", reference = exact(case.p), tolerance = 0.02,
        resolution = "m cell", values = { { case.p.cell, case.results.force } }, run = case }
    end
  end,
  figures = function(cases)
    local curves = {}
    for _, case in ipairs(cases) do
      local p = case.p
      curves[#curves + 1] = { label = case.id:gsub("_in", " um in "),
        x = numeric.map(case.time, function(t) return t / p.time.si * p.lift.si end), y = case:series("force", "force_y") }
    end
    local p = cases[1].p
    curves[#curves + 1] = { label = "Kendall", x = { 0, p.lift.si }, y = { exact(p), exact(p) }, style = "dash" }
    return { stiction.figure.lines { name = "force", title = "Force over the way of the film's end",
      x = { label = "way", unit = "mm" }, y = { label = "force per depth", unit = "N/m" }, curves = curves } }
  end,
}
