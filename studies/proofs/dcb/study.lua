-- Double cantilever beam under end moments: the moment at which the bond runs does not depend on the length of the
-- crack nor on the stiffness of the bond.
--
--    M (<--+=======================+|     one arm on a rigid plane, by symmetry: half the opening, so
--          |  crack a0 | bonded      |     twice the stiffness and half the energy of the bond between two arms
--   -------+-----------+-------------   the far end is held, and not bonded: a held node has no compliance
--
-- The arm's end is turned by a couple of forces at its corners, so the moment follows from the rotation and may fall.
--
--     ./stiction run studies/proofs/dcb
local stiction = require "stiction"
local units = stiction.units
local mm, GPa, s, kg, m, J, N = units.mm, units.GPa, units.s, units.kg, units.m, units.J, units.N
local numeric, beam = stiction.numeric, stiction.reference.beam

local function scene(p)
  return stiction.scene {
    bodies = {
      arm = stiction.body {
        mesh = stiction.mesh.gmsh { size = p.cell, kind = "quad8", start = { 0*mm, 0*mm },
          edges = {
            stiction.edge { to = { p.crack, 0*mm }, name = "crack" },
            stiction.edge { to = { p.length - p.rest, 0*mm }, name = "bond" },
            stiction.edge { to = { p.length, 0*mm }, name = "rest" },
            stiction.edge { to = { p.length, p.height }, name = "far" },
            stiction.edge { to = { 0*mm, p.height }, name = "top" },
            stiction.edge { to = { 0*mm, 0*mm }, name = "near" },
          } },
        material = stiction.material.linear_elastic { young = p.young, poisson = 0 }, density = p.density,
      },
    },
    obstacles = { middle = stiction.obstacle { shape = stiction.rigid.plane {} } },
    pairs = {
      bond = stiction.pair { secondary = "arm.bond", primary = "middle",
        adhesion = stiction.adhesion.rcc { w = p.w / 2, C_n = 2 * p.C, C_t = 0*N/m^3, b = 0*N*s/m, beta0 = 1,
          bonding = "never" } },
    },
    motions = {
      stiction.motion.drive { set = "arm.near", near = { 0*mm, p.height }, times = { 0*s, 1*s }, x = { 0*mm, p.turn } },
      stiction.motion.drive { set = "arm.near", near = { 0*mm, 0*mm }, times = { 0*s, 1*s }, x = { 0*mm, -p.turn } },
      stiction.motion.fix { set = "arm.far" },
    },
    scheme = stiction.scheme.quasi_static {},
    schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = p.steps } } },
    output = stiction.output { frames = 2 },
    probes = {
      force = stiction.probe.force { set = "arm.near", near = { 0*mm, p.height } },
      line = stiction.probe.contact_line { pair = "bond" },
      energy = stiction.probe.energy {},
    },
  }
end

--- Moment per depth over time, N.
local function moments(run, p)
  return numeric.map(run:series("force", "force_x"), function(f) return f * p.height.si end)
end

--- Where the bond begins at every time: the first point with beta > 1/2, m.
local function fronts(run)
  local columns = {}
  for k = 1, math.maxinteger do
    local found, beta = pcall(run.series, run, "line", "beta", k)
    if not found then
      break
    end
    columns[k] = { x = run:series("line", "X", k)[1], beta = beta }
  end
  local front = {}
  for i in ipairs(run.time) do
    front[i] = math.huge
    for _, column in ipairs(columns) do
      if column.beta[i] > 0.5 then
        front[i] = math.min(front[i], column.x)
      end
    end
  end
  return front
end

--- Mean moment while the front runs over a part, from 6 to 18 mm, of what lies beyond the first crack.
local function plateau(run, p, from, to)
  local moment, front = moments(run, p), fronts(run)
  local sum, count = 0, 0
  for i, x in ipairs(front) do
    local grown = x - p.crack.si
    if grown > (from or 6e-3) and grown < (to or 18e-3) then
      sum, count = sum + moment[i], count + 1
    end
  end
  if count < 5 then
    error(("the crack grew by %g m only at the end; turn further"):format(front[#front] - p.crack.si))
  end
  return sum / count
end

return stiction.study {
  title = "Double cantilever beam under end moments",
  question = "Does the bond run at the moment that its energy of decohesion demands?",
  given = { young = { 1*GPa, "" }, w = { 1*J/m^2, "between two arms" }, density = { 1000*kg/m^3, "not used" } },
  chosen = {
    height = { 2*mm, "of one arm" }, length = { 60*mm, "far end 20 mm beyond the last front" },
    crack = { 20*mm, "ten heights: a beam" }, turn = { 0.055*mm, "front runs beyond 18 mm" },
    rest = { 2*mm, "at the far end, without bond" },
    steps = { 220, "front moves less than a cell a step" },
  },
  sweep = { { "C", { 1e9*N/m^3, 1e10*N/m^3 } }, { "cell", { 1*mm, 0.5*mm } } },
  quick = { sweep = { { "C", { 1e10*N/m^3 } }, { "cell", { 1*mm, 0.5*mm } } } },
  case_id = function(p) return ("C%.0e_%g"):format(p.C.si, p.cell:to("um")) end,
  scene = scene,
  results = {
    { name = "moment", unit = "N", meaning = "mean moment per depth while the crack grows",
      function(run, p) return plateau(run, p) end },
    { name = "drift", unit = "1", meaning = "of that moment, from the crack's first half of growth to its second",
      function(run, p) return plateau(run, p, 12e-3, 18e-3) / plateau(run, p, 6e-3, 12e-3) - 1 end },
  },
  check = function(cases, check)
    for _, C in ipairs { 1e9*N/m^3, 1e10*N/m^3 } do
      local group, values = cases:where { C = C }, {}
      for k, case in ipairs(group) do
        values[k] = { case.p.cell, case.results.moment }
      end
      local p = cases[1].p
      if #group > 0 then
        check.proof { case = "DCB under end moments", quantity = ("moment, C = %.0e N/m³"):format(C.si), unit = "N",
          kind = "exact", source = "M = sqrt(w E' h^3 / 12)", values = values, resolution = "m cell", tolerance = 0.02,
          reference = beam.dcb_moment(p.w.si, p.young.si, p.height.si), run = group[#group] }
      end
    end
    for _, case in ipairs(cases) do
      check.within("the moment does not depend on the crack's length, " .. case.id, case.results.drift, -0.02, 0.02)
      local e = function(name) local y = case:series("energy", name); return y[#y] - y[1] end
      local work = e "motion_work"
      local spent = -e "scheme_loss"
      check.within("energy left over, " .. case.id, spent / work, -1, 1e-3)
    end
  end,
  figures = function(cases)
    local curves = {}
    for _, case in ipairs(cases) do
      curves[#curves + 1] = { label = case.id:gsub("_", " N/m³, cell ") .. " um", x = fronts(case),
        y = moments(case, case.p) }
    end
    local p = cases[1].p
    local M = beam.dcb_moment(p.w.si, p.young.si, p.height.si)
    curves[#curves + 1] = { label = "exact", x = { 20e-3, 40e-3 }, y = { M, M }, style = "dash" }
    return { stiction.figure.lines { name = "moment", title = "Moment over the front of the crack",
      x = { label = "front", unit = "mm", range = { 20*mm, 40*mm } }, y = { label = "moment per depth", unit = "N" },
      curves = curves } }
  end,
}
