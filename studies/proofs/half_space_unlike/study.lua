-- Sides of unlike stiffness couple pressure and shear: a cylinder that slides, and a punch that cannot slip.
--
--          .-'''-.  ->                      _________
--         |   R   |       slides           |  rigid  |  pressed down by d, bonded
--     _____'-._.-'______               ____|_________|_____
--
-- The surface of a half space that is no rubber moves along under a rigid counterpart that only presses it (Dundurs' beta > 0),
-- and is lifted or lowered by shear. Where all slides, and where nothing does, theory has closed forms.
--
--     ./stiction run studies/proofs/half_space_unlike
local stiction = require "stiction"
local units = stiction.units
local mm, s, MPa, N = units.mm, units.s, units.MPa, units.N
local line = stiction.reference.line_contact

local function modulus(p) return line.combined_modulus(p.young.si, p.poisson) end
local function radius(p) return p.a / p.slope end
local function force(p) return math.pi * modulus(p) * p.a.si ^ 2 / (4 * radius(p).si) end
local function beta(p) return (1 - 2 * p.poisson) / (2 * (1 - p.poisson)) end

--- Where all slides: half width, centre and pressure.
local function theory(p) return line.sliding(force(p), radius(p).si, modulus(p), beta(p) * p.mu) end

--- Force of a bonded round punch over that of one that slips: (1 - nu) ln(3 - 4 nu) / (1 - 2 nu).
local function bonded_over_free(p) return (1 - p.poisson) * math.log(3 - 4 * p.poisson) / (1 - 2 * p.poisson) end

local function pair(p)
  return stiction.pair { secondary = "base.surface", primary = "counterpart",
    friction = p.mu > 0 and stiction.friction.coulomb { mu = p.mu } or nil }
end

local function slide(p)
  return stiction.scene {
    bodies = { base = stiction.body.half_space { young = p.young, poisson = p.poisson, size = { p.extent * p.a },
      points = { p.points }, boundary = "free" } },
    obstacles = { counterpart = stiction.obstacle.height_map { surface = stiction.surface.cylinder { radius = radius(p) },
      times = { 0*s, 1*s, 2*s }, force = { 0*N, force(p) * N, force(p) * N },
      x = { 0*mm, 0*mm, p.way * p.a * p.slope } } },
    pairs = { touch = pair(p) },
    scheme = stiction.scheme.quasi_static {},
    schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = p.steps },
      stiction.stage { to = 2*s, steps = p.steps } } },
    probes = { touch = stiction.probe.contact { pair = "touch" }, line = stiction.probe.contact_line { pair = "touch" } },
  }
end

local function punch(p)
  local depth = p.depth * p.a
  return stiction.scene {
    kinematics = "three_dimensional",
    bodies = { base = stiction.body.half_space { young = p.young, poisson = p.poisson, size = { 3 * p.a, 3 * p.a },
      points = { p.points, p.points }, boundary = "free" } },
    obstacles = { counterpart = stiction.obstacle.height_map {
      surface = stiction.surface.punch { radius = p.a, clearance = 10 * depth }, times = { 0*s, 1*s }, z = { 0*mm, -depth } } },
    pairs = { touch = pair(p) },
    scheme = stiction.scheme.quasi_static {},
    schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = 1 } } },
    probes = { touch = stiction.probe.contact { pair = "touch" } },
  }
end

--- Pressure at the end over Hertz's without coupling, and theory's, over x / a: {x, p, exact}.
local function pressure(run, p)
  local exact, p0 = theory(p), line.peak_pressure(force(p), radius(p).si, modulus(p))
  local x, held, known = {}, {}, {}
  for k = 1, p.points do
    local at = run:last("line", "X", k)
    x[k] = at / p.a.si
    held[k] = run:last("line", "pressure", k) / p0
    known[k] = exact.pressure(at) / p0
  end
  return x, held, known
end

local function deviation(run, p)
  local x, held, known = pressure(run, p)
  local sum = 0
  for k = 1, #x do
    sum = sum + math.abs(held[k] - known[k])
  end
  return sum / #x * p.extent
end

local function sweep(slides, punches)
  local list = {}
  for _, points in ipairs(slides) do
    list[#list + 1] = { kind = "slide", mu = 0.8, points = points }
  end
  for _, points in ipairs(punches) do
    list[#list + 1] = { kind = "punch", mu = 0, points = points }
    list[#list + 1] = { kind = "punch", mu = 50, points = points }
  end
  return list
end

return stiction.study {
  title = "Unlike sides: a cylinder that slides, a punch that is bonded",
  question = "Are pressure and shear of sides of unlike stiffness coupled as theory says?",
  given = { a = { 1*mm, "half width of the contact if nothing coupled; radius of the punch" }, slope = { 0.05, "a / R" },
    young = { 3*MPa, "" }, poisson = { 0, "Dundurs' beta is largest: 1/2" } },
  chosen = { extent = { 3.2, "of the points over a" }, steps = { 10, "while pressed, and while moved" },
    way = { 3, "of the counterpart along, over a^2/R; its heights stay over the same points" }, depth = { 0.02, "of the punch over a" } },
  sweep = sweep({ 64, 128, 256, 512 }, { 32, 64, 128 }),
  quick = { sweep = sweep({ 64, 128, 256 }, { 32, 64 }) },
  case_id = function(p) return ("%s_mu%g_%d"):format(p.kind, p.mu, p.points) end,
  scene = function(p) return p.kind == "slide" and slide(p) or punch(p) end,
  results = {
    { name = "along", unit = "1", meaning = "force along over mu P; 0 for the punch",
      function(run, p) return p.kind == "slide" and run:last("touch", "force_x") / (p.mu * force(p)) or 0 end },
    { name = "deviation", unit = "1", meaning = "mean deviation of the pressure over p0, times extent / a; 0 for the punch",
      function(run, p) return p.kind == "slide" and deviation(run, p) or 0 end },
    { name = "pressed", unit = "N", meaning = "force that presses", function(run, p)
      return run:last("touch", p.kind == "slide" and "force_y" or "force_z")
    end },
    { name = "sticks", unit = "1", meaning = "part of the contact that sticks", function(run)
      return run:last("touch", "stick") / (run:last("touch", "stick") + run:last("touch", "slip"))
    end },
  },
  check = function(cases, check)
    local slides, values = cases:where { kind = "slide" }, {}
    for k, case in ipairs(slides) do
      values[k] = { case.p.extent * case.p.a.si / case.p.points, case.results.deviation + 1 }
      check.close(case.id .. ": all slides, Q over mu P", case.results.along, 1, 1e-8)
    end
    check.proof { case = "Cylinder sliding over a half space, unlike sides", quantity = "1 + mean deviation of the pressure over p0",
      unit = "1", kind = "exact", source = "Bufler 1959; Johnson 1985, 8.2", reference = 1, values = values,
      resolution = "m spacing", tolerance = 2e-3, run = slides[#slides] }
    local ratios, finest = {}, nil
    for _, bonded in ipairs(cases:where { kind = "punch", mu = 50 }) do
      local free = cases:where { kind = "punch", mu = 0, points = bonded.p.points }[1]
      ratios[#ratios + 1] = { 3 * bonded.p.a.si / bonded.p.points, bonded.results.pressed / free.results.pressed }
      finest = bonded
    end
    check.proof { case = "Round flat punch, bonded over free, unlike sides", quantity = "ratio of the forces at one depth",
      unit = "1", kind = "exact", source = "Spence 1968", reference = bonded_over_free(finest.p), values = ratios,
      resolution = "m spacing", tolerance = 5e-3, run = finest }
  end,
  figures = function(cases)
    local slides = cases:where { kind = "slide" }
    local finest = slides[#slides]
    local x, held, known = pressure(finest, finest.p)
    local p0 = line.peak_pressure(1, 1, 1)
    local alone = {}
    for k, at in ipairs(x) do
      alone[k] = line.pressure(at, 1, p0) / p0
    end
    return { stiction.figure.lines { name = "pressure", title = "Pressure under a cylinder that slides to the right",
      x = { label = "x / a", unit = "1" }, y = { label = "pressure over Hertz's p0" }, curves = {
        { label = "nu = 0, mu = 0.8", x = x, y = held, style = "points" },
        { label = "theory, coupled", x = x, y = known },
        { label = "Hertz, not coupled", x = x, y = alone, style = "dash" } } } }
  end,
}
