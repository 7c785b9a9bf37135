-- A ring pinched between rods until its walls touch: contact of a surface with itself against the same by symmetry.
--
--         o      rod, comes down
--       .--.
--      /    \     Right of its axis the ring is one outline whose inner side meets itself. A quarter of it on a rigid plane at
--     |      |    y = 0 needs no such contact, and must bear the same: its nodes meet the plane where those of the whole meet
--      \    /     each other, half-way.
--       `--'
--         o      rod, comes up
--
--     ./stiction run studies/proofs/pinched_ring
local stiction = require "stiction"
local units = stiction.units
local mm, s, kg, m, MPa = units.mm, units.s, units.kg, units.m, units.MPa

--- A point at a radius (m) and an angle (rad) from the x axis.
local function at(r, angle)
  return { r * math.cos(angle)*m, r * math.sin(angle)*m }
end

--- From the angle `from` up to 90 degrees.
local function outline(p, from)
  local edge, inner, outer, centre = stiction.edge, p.R.si - p.t.si / 2, p.R.si + p.t.si / 2, { 0*m, 0*m }
  local start, mid, top = math.rad(from), math.rad((90 + from) / 2), math.rad(90)
  return {
    edge { to = at(outer, start), name = "start" },
    edge { to = at(outer, mid), centre = centre, name = "outer" }, edge { to = at(outer, top), centre = centre, name = "outer" },
    edge { to = at(inner, top), name = "axis" },
    edge { to = at(inner, mid), centre = centre, name = "inner" }, edge { to = at(inner, start), centre = centre, name = "inner" },
  }
end

local function scene(p)
  local whole = p.model == "itself"
  local pinch, from = p.pinch.si, whole and -90 or 0
  local function rod(side)
    return stiction.obstacle { shape = stiction.rigid.circle { radius = p.rod, centre = { 0*mm, side * (p.R + p.t / 2 + p.rod) } },
      times = { 0*s, 1*s }, y = { 0*m, -side * pinch*m } }
  end
  local fixed = { stiction.motion.fix { set = "ring.axis", x = true } }
  if whole then
    fixed[#fixed + 1] = stiction.motion.fix { set = "ring.start", x = true }
  else
    fixed[#fixed + 1] = stiction.motion.fix { set = "ring.start", y = true }
  end
  return stiction.scene {
    bodies = { ring = stiction.body { density = 1000*kg/m^3,
      mesh = stiction.mesh.gmsh { size = p.h, kind = "quad8", start = at(p.R.si - p.t.si / 2, math.rad(from)), edges = outline(p, from) },
      material = stiction.material.neo_hookean { young = p.young, poisson = 0.4 } } },
    obstacles = { upper = rod(1), lower = whole and rod(-1) or stiction.obstacle { shape = stiction.rigid.plane {} } },
    pairs = {
      above = stiction.pair { secondary = "ring.outer", primary = "upper" },
      below = whole and stiction.pair { secondary = "ring.outer", primary = "lower" } or nil,
      inside = stiction.pair { secondary = "ring.inner", primary = whole and "ring.inner" or "lower" } },
    motions = fixed,
    scheme = stiction.scheme.quasi_static { stabilisation = whole and 1e-6 or 0 }, -- along y the plates alone hold the whole
    schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = 40 } } },
    output = stiction.output { frames = 1 },
    probes = { above = stiction.probe.contact { pair = "above" }, inside = stiction.probe.contact { pair = "inside" } },
  }
end

return stiction.study {
  title = "Pinched ring",
  question = "Does a surface that touches itself bear what it bears on its plane of symmetry?",
  given = { R = { 10*mm, "mean radius" }, t = { 1*mm, "wall" }, rod = { 3*mm, "radius" }, young = { 1*MPa, "neo-Hookean" },
    pinch = { 10*mm, "of each rod; the walls are 9.5 mm from the middle" } },
  chosen = { h = { 0.5*mm, "four quad8 cells through the wall" } },
  sweep = { { "model", { "itself", "quarter" } } },
  quick = { set = { h = 1*mm } },
  scene = scene,
  results = {
    force = { unit = "N/m", meaning = "half of what a rod bears", function(run) return -run:at(1*s, "above", "force_y") end },
    touching = { unit = "mm", meaning = "length of the walls that touch at the end, in the reference",
      function(run) return run:at(1*s, "inside", "closed_area") end },
  },
  check = function(cases, check)
    local whole, quarter = cases[1].results, cases[2].results
    check.close("a rod bears as much", whole.force, quarter.force, 0.01 * (cases[1].p.h.si / 1e-3) ^ 2)
    check.within("the walls touch over some cells", whole.touching, 0.5e-3, 2e-3)
  end,
  figures = function(cases)
    return { stiction.figure.field { name = "ring", case = cases[1], time = "last", array = "von_mises", label = "von Mises stress",
      unit = "MPa", deformed = true, title = "pinched by 10 mm on either side" } }
  end,
}
