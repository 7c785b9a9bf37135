-- A cylinder pressed onto a half space and moved along: an edge slips, the middle sticks (Cattaneo 1938; Mindlin 1949).
--
--          .-'''-.  ->   pressed by P, then moved along by u
--         |   R   |
--     _____'-._.-'_____   n points of a half space in plane strain, free around them
--
-- At nu = 1/2 pressure and shear of a half space under a rigid counterpart do not couple, and theory is exact. `unlike`
-- bodies couple: then they share the load as before, and slip a little from the first touch.
--
--     ./stiction run studies/proofs/half_space_friction
local stiction = require "stiction"
local units = stiction.units
local mm, s, MPa, N = units.mm, units.s, units.MPa, units.N
local line = stiction.reference.line_contact

local function modulus(p) return line.combined_modulus(p.young.si, p.poisson) end
local function radius(p) return p.a / p.slope end
local function force(p) return math.pi * modulus(p) * p.a.si ^ 2 / (4 * radius(p).si) end

--- Where they are not, points slip a little and stick again from the first touch on: so many more follow that.
local function steps(p) return p.poisson < 0.5 and 10 * p.steps or p.steps end

local function scene(p)
  return stiction.scene {
    bodies = { base = stiction.body.half_space { young = p.young, poisson = p.poisson, size = { p.size * p.a },
      points = { p.points }, boundary = "free" } },
    obstacles = { cylinder = stiction.obstacle.height_map { surface = stiction.surface.cylinder { radius = radius(p) },
      times = { 0*s, 1*s, 2*s }, force = { 0*N, force(p)*N, force(p)*N },
      x = { 0*mm, 0*mm, p.way * p.mu * p.a * p.slope } } },
    pairs = { touch = stiction.pair { secondary = "base.surface", primary = "cylinder",
      friction = stiction.friction.coulomb { mu = p.mu } } },
    scheme = stiction.scheme.quasi_static {},
    schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = steps(p) },
      stiction.stage { to = 2*s, steps = steps(p) } } },
    probes = {
      touch = stiction.probe.contact { pair = "touch" },
      line = stiction.probe.contact_line { pair = "touch" },
      energy = stiction.probe.energy {},
    },
  }
end

--- The shear tractions at the end over mu p0, and those of theory with the same force along: {x, q, exact}.
local function shear(run, p)
  local a, P, Q = p.a.si, force(p), run:last("touch", "force_x")
  local p0, c = line.peak_pressure(P, radius(p).si, modulus(p)), line.stick_half_width(a, Q, p.mu, P)
  local x, q, exact = {}, {}, {}
  for k = 1, p.points do
    x[k] = run:last("line", "X", k)
    q[k] = run:last("line", "friction", k) / (p.mu * p0)
    exact[k] = line.shear(x[k], a, p0, c, p.mu) / (p.mu * p0)
  end
  return x, q, exact
end

local function deviation(run, p)
  local _, q, exact = shear(run, p)
  local sum = 0
  for k = 1, #q do
    sum = sum + math.abs(q[k] - exact[k])
  end
  return sum / #q * p.size
end

return stiction.study {
  title = "Cylinder on a half space with friction (Cattaneo, Mindlin)",
  question = "Shear and the zone that sticks when a pressed cylinder is moved along.",
  given = { a = { 1*mm, "half width of the contact" }, slope = { 0.05, "a / R" }, young = { 3*MPa, "" }, mu = { 0.5, "" } },
  chosen = { size = { 3, "extent of the points over a" }, steps = { 5, "while pressed, and while moved, where sides are alike" },
    way = { 0.6, "of the counterpart along, over mu a^2 / R" } },
  sweep = { { poisson = 0.5, points = 64 }, { poisson = 0.5, points = 128 }, { poisson = 0.5, points = 256 },
    { poisson = 0.5, points = 512 }, { poisson = 0.3, points = 256 } },
  quick = { sweep = { { poisson = 0.5, points = 64 }, { poisson = 0.5, points = 128 }, { poisson = 0.5, points = 256 },
    { poisson = 0.3, points = 128 } } },
  case_id = function(p) return ("nu%g_%d"):format(p.poisson, p.points) end,
  scene = scene,
  results = {
    { name = "along", unit = "1", meaning = "force along over mu P",
      function(run, p) return run:last("touch", "force_x") / (p.mu * force(p)) end },
    { name = "stick", unit = "1", meaning = "width that sticks over that in contact",
      function(run) return run:last("touch", "stick") / (run:last("touch", "stick") + run:last("touch", "slip")) end },
    { name = "deviation", unit = "1", meaning = "mean deviation of the shear from theory over mu p0, times the extent over a",
      function(run, p) return deviation(run, p) end },
  },
  check = function(cases, check)
    local its, values = cases:where { poisson = 0.5 }, {}
    for k, case in ipairs(its) do
      local spacing = case.p.size * case.p.a.si / case.p.points
      values[k] = { spacing, case.results.deviation + 1 }
      check.close(case.id .. ": width that sticks, within two points", case.results.stick,
        math.sqrt(1 - case.results.along), 2 * spacing / case.p.a.si)
    end
    local fine = its[#its]
    check.proof { case = "Cylinder on a half space, friction", quantity = "1 + mean deviation of the shear over mu p0", unit = "1",
      kind = "exact", source = "Cattaneo 1938, Mindlin 1949; Johnson 1985, 7.2", reference = 1, values = values,
      resolution = "m spacing", tolerance = 2e-3, run = fine }
  end,
  figures = function(cases)
    local its = cases:where { poisson = 0.5 }
    local curves = {}
    local x, q, exact = shear(its[#its], its[#its].p)
    curves[1] = { label = "nu = 0.5", x = x, y = q, style = "points" }
    curves[2] = { label = "Cattaneo, Mindlin", x = x, y = exact }
    local unlike = cases:where { poisson = 0.3 }[1]
    local there, shears = shear(unlike, unlike.p)
    curves[3] = { label = "nu = 0.3 under a rigid cylinder", x = there, y = shears }
    return { stiction.figure.lines { name = "shear", title = "Shear traction", x = { label = "x", unit = "mm" },
      y = { label = "shear over mu p0" }, curves = curves } }
  end,
}
