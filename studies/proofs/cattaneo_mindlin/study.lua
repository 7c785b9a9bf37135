-- Two equal crowned blocks pressed together, shifted sideways and back: the partial slip of Cattaneo and Mindlin.
--
--      ___________________   -> shifted and back, after it was pressed down
--     |                   |
--     |__       o       __|   equal blocks, half width and height `size` times a, each crown of radius 2 R, R = a / slope;
--      __'''---___---'''__    under the other they are a cylinder of radius R on a plane
--     |                   |
--     |___________________|   held below
--
-- Turned by half a turn about the middle o, the pair is itself again, loads included. So shear turns both crowns
-- alike and presses them neither together nor apart: it cannot change the pressure, as in the closed solution.
-- Everything is compared with that solution at the forces P and Q which the run reached.
--
--     ./stiction run studies/proofs/cattaneo_mindlin
local stiction = require "stiction"
local units = stiction.units
local mm, m, s, kg, GPa = units.mm, units.m, units.s, units.kg, units.GPa
local hertz, numeric = stiction.reference.line_contact, stiction.numeric

local function radius(p) return p.a / p.slope end

--- The block above the origin (side = 1) or below it (side = -1); its crown passes through the origin.
local function block(p, side)
  local R, w, near = 2 * radius(p), p.size * p.a, p.fine * p.a
  local centre, edge = { 0*mm, side * R }, stiction.edge
  local function rim(x) return { x, side * (R.si - math.sqrt(R.si ^ 2 - x.si ^ 2)) * m } end
  return stiction.body {
    mesh = stiction.mesh.gmsh {
      size = w / 8, kind = p.kind, start = rim(-w),
      edges = {
        edge { to = rim(-near), centre = centre },
        edge { to = { 0*mm, 0*mm }, centre = centre, name = "crown" },
        edge { to = rim(near), centre = centre, name = "crown" },
        edge { to = rim(w), centre = centre },
        edge { to = { w, side * w } },
        edge { to = { -w, side * w }, name = "flat" },
        edge { to = rim(-w) },
      },
      refine = { stiction.refinement { near = "crown", size = p.a / p.cells, within = p.deep * p.a, beyond = w } },
    },
    material = stiction.material.linear_elastic { young = p.young, poisson = p.poisson }, density = p.density,
  }
end

local function scene(p)
  local down, aside = -p.press * p.a * p.slope, p.shift * p.mu * p.a * p.slope
  return stiction.scene {
    bodies = { upper = block(p, 1), lower = block(p, -1) },
    pairs = { touch = stiction.pair {
      secondary = "upper.crown", primary = "lower.crown", friction = stiction.friction.coulomb { mu = p.mu } } },
    motions = {
      stiction.motion.fix { set = "lower.flat" },
      stiction.motion.drive { set = "upper.flat", times = { 0*s, 1*s, 2*s, 3*s }, x = { 0*mm, 0*mm, aside, 0*mm },
        y = { 0*mm, down, down, down } },
    },
    scheme = stiction.scheme.quasi_static {},
    schedule = stiction.schedule { stages = {
      stiction.stage { to = 1*s, steps = p.steps_press }, stiction.stage { to = 2*s, steps = p.steps_shift },
      stiction.stage { to = 3*s, steps = p.steps_shift } } },
    probes = {
      touch = stiction.probe.contact { pair = "touch" },
      line = stiction.probe.contact_line { pair = "touch" },
      energy = stiction.probe.energy {},
    },
  }
end

local function modulus(p)
  return hertz.combined_modulus(p.young.si, p.poisson, p.young.si, p.poisson)
end

--- Normal and tangential force, N/m, at a time; the shift to the right is resisted by Q > 0.
local function forces(run, time)
  return math.abs(run:at(time, "touch", "force_y")), -run:at(time, "touch", "force_x")
end

--- The time at which Q / (mu P) reaches a level, from `start` on.
local function time_of(run, p, level, start)
  local function above(k)
    local P, Q = forces(run, run.time[k])
    return Q / (p.mu * P) - level
  end
  local first = numeric.first_where(run.time, function(time) return time >= (start or 1) end)
  for k = first + 1, #run.time do
    local before, now = above(k - 1), above(k)
    if before * now <= 0 then
      return run.time[k - 1] + before / (before - now) * (run.time[k] - run.time[k - 1])
    end
  end
  error(("Q never is %g mu P; shift farther"):format(level))
end

--- The closed solution at the forces of that time.
local function exact(run, p, time)
  local P, Q = forces(run, time)
  local a = hertz.half_width(P, radius(p).si, modulus(p))
  return { a = a, p0 = hertz.peak_pressure(P, radius(p).si, modulus(p)), P = P, Q = Q,
    c = hertz.stick_half_width(a, Q, p.mu, P) }
end

--- The contact points at a time, from left to right: {x =, p =, q =, slip = since the shift began, status =}.
local function points(run, time)
  local list, sign = {}, 0
  for k = 1, math.maxinteger do
    local found, X = pcall(run.series, run, "line", "X", k)
    if not found then
      break
    end
    local function value(name, at) return run:at(at or time, "line", name, k) end
    list[k] = { x = X[1], p = value "pressure", q = value "friction", slip = value "slip" - value("slip", 1),
      status = value "status" }
    sign = sign + value("friction", 2)
  end
  table.sort(list, function(a, b) return a.x < b.x end)
  for _, point in ipairs(list) do
    point.q = sign < 0 and -point.q or point.q
  end
  return list
end

--- Zero of y^2 = y0^2 (1 - x^2/r^2), a straight line over x^2, by least squares; also y0.
local function fit(list, value)
  local least = 0.3 * numeric.max(numeric.map(list, value))
  local n, su, sv, suu, suv = 0, 0, 0, 0, 0
  for _, point in ipairs(list) do
    if value(point) > least then
      local u, v = point.x ^ 2, value(point) ^ 2
      n, su, sv, suu, suv = n + 1, su + u, sv + v, suu + u * u, suv + u * v
    end
  end
  local slope = (n * suv - su * sv) / (n * suu - su * su)
  local ordinate = (sv - slope * su) / n
  return math.sqrt(-ordinate / slope), math.sqrt(ordinate)
end

--- c/a of a time: mu p - q is mu p0 c/a sqrt(1 - x^2/c^2) where the bodies stick, a half ellipse as p is.
local function stick_share(run, p, time)
  local list = points(run, time)
  return fit(list, function(o) return p.mu * o.p - o.q end) / fit(list, function(o) return o.p end)
end

--- Half the length that sticks by the points' status, over that of the closed solution, at the step after the share.
local function stick_points(run, p)
  local share = time_of(run, p, p.share)
  local at = run.time[numeric.first_where(run.time, function(time) return time >= share end)]
  local n = 0
  for _, point in ipairs(points(run, at)) do
    n = n + (point.status == 1 and 1 or 0)
  end
  return n * (p.a.si / p.cells) / 2 / exact(run, p, at).c
end

--- L2 of value(point) - wanted(point) over that of wanted.
local function difference(list, value, wanted)
  local above, below = 0, 0
  for _, point in ipairs(list) do
    above, below = above + (value(point) - wanted(point)) ^ 2, below + wanted(point) ^ 2
  end
  return math.sqrt(above / below)
end

local function shear(point) return point.q end

local function shear_error(run, p)
  local time = time_of(run, p, p.share)
  local e = exact(run, p, time)
  return difference(points(run, time), shear, function(o) return hertz.shear(o.x, e.a, e.p0, e.c, p.mu) end)
end

local function slip_error(run, p)
  local time = time_of(run, p, p.share)
  local e = exact(run, p, time)
  return difference(points(run, time), function(o) return math.abs(o.x) < e.a and math.abs(o.slip) or 0 end,
    function(o) return hertz.slip(o.x, e.a, e.p0, e.c, p.mu, modulus(p)) end)
end

--- Largest |q - wanted(x)| two cells and more off the kinks at these |x|, over the largest wanted.
local function away(list, cell, kinks, wanted)
  local worst, peak = 0, 0
  for _, point in ipairs(list) do
    local q, off = wanted(point.x), true
    for _, kink in ipairs(kinks) do
      off = off and math.abs(math.abs(point.x) - kink) > 2 * cell
    end
    worst, peak = math.max(worst, off and math.abs(point.q - q) or 0), math.max(peak, math.abs(q))
  end
  return worst / peak
end

local function shear_away(run, p)
  local time = time_of(run, p, p.share)
  local e = exact(run, p, time)
  return away(points(run, time), p.a.si / p.cells, { e.c, e.a },
    function(x) return hertz.shear(x, e.a, e.p0, e.c, p.mu) end)
end

--- Time at which Q is gone on the way back, the closed q there, and where that has its kinks.
local function unsheared(run, p)
  local time, _, forward = time_of(run, p, 0, 2), forces(run, 2)
  local e = exact(run, p, time)
  local paths = { normal = e.P, forward = forward, now = e.Q }
  return time, function(x) return hertz.shear_back(x, e.a, e.p0, p.mu, paths) end,
    { e.a, hertz.stick_half_width(e.a, forward, p.mu, e.P), hertz.stick_half_width(e.a, forward - e.Q, 2 * p.mu, e.P) }
end

local function back_error(run, p)
  local time, wanted = unsheared(run, p)
  return difference(points(run, time), shear, function(o) return wanted(o.x) end)
end

local function back_away(run, p)
  local time, wanted, kinks = unsheared(run, p)
  return away(points(run, time), p.a.si / p.cells, kinks, wanted)
end

--- Work of friction from the beginning of the shift over that of the closed solution.
local function work_ratio(run, p)
  local time = time_of(run, p, p.share)
  local e = exact(run, p, time)
  return (run:at(time, "energy", "friction_loss") - run:at(1, "energy", "friction_loss"))
    / hertz.friction_work(e.a, e.p0, e.c, p.mu, modulus(p))
end

local levels = { 0.3, 0.6, 0.9 } -- of Q over mu P in the figure

--- Two curves of q / (mu p0) over x / a at a time: closed and computed.
local function shear_curves(c, time, wanted, pen)
  local e, p = exact(c, c.p, time), c.p
  local x, q, exact_x, exact_q = {}, {}, {}, {}
  for k, point in ipairs(points(c, time)) do
    x[k], q[k] = point.x / e.a, point.q / (p.mu * e.p0)
  end
  for k = 0, 400 do
    exact_x[k + 1] = -1.2 + 2.4 * k / 400
    exact_q[k + 1] = wanted(exact_x[k + 1] * e.a, e) / (p.mu * e.p0)
  end
  return { label = "closed, " .. pen.label, x = exact_x, y = exact_q, colour = pen.colour },
    { label = "computed", x = x, y = q, colour = pen.colour, style = "points" }
end

local function shear_figure(c)
  local curves = {}
  for i, level in ipairs(levels) do
    curves[2 * i - 1], curves[2 * i] = shear_curves(c, time_of(c, c.p, level),
      function(x, e) return hertz.shear(x, e.a, e.p0, e.c, c.p.mu) end,
      { label = ("Q = %.1f µP"):format(level), colour = i })
  end
  local time, wanted = unsheared(c, c.p)
  curves[7], curves[8] = shear_curves(c, time, wanted, { label = "back to Q = 0", colour = 4 })
  return stiction.figure.lines { name = "shear", title = ("shear traction, %g cells to a"):format(c.p.cells),
    x = { label = "x / a", unit = "1", range = { -1.2, 1.2 } }, y = { label = "q / (µ p0)", unit = "1" }, curves = curves,
    legend = "below", width = "double" }
end

--- c/a over Q / (mu P): every step of the shift, and the closed solution.
local function stick_figure(cases)
  local x, y, curves = {}, {}, {}
  for k = 0, 200 do
    x[k + 1], y[k + 1] = k / 200, math.sqrt(1 - k / 200)
  end
  curves[1] = { label = "closed", x = x, y = y }
  for _, c in ipairs(cases) do
    local share, stick = {}, {}
    for _, time in ipairs(c.time) do
      if time > 1 and time <= 2 then
        local P, Q = forces(c, time)
        share[#share + 1], stick[#stick + 1] = Q / (c.p.mu * P), stick_share(c, c.p, time)
      end
    end
    curves[#curves + 1] = { label = ("%g cells to a"):format(c.p.cells), x = share, y = stick, style = "points" }
  end
  return stiction.figure.lines { name = "stick", title = "half width that sticks", curves = curves,
    x = { label = "Q / (µ P)", unit = "1", range = { 0, 1 } }, y = { label = "c / a", unit = "1", range = { 0, 1.05 } } }
end

return stiction.study {
  title = "Partial slip of two equal bodies (Cattaneo, Mindlin)",
  question = "How much of a contact under normal load sticks while it is sheared, and what is the shear traction?",
  given = {
    young = { 10*GPa, "" }, poisson = { 0.3, "" }, mu = { 0.5, "" }, density = { 1000*kg/m^3, "not used in statics" },
  },
  chosen = {
    share = { 0.6, "of Q over mu P where the profiles are compared" },
    a = { 1*mm, "half width that `press` is meant for" }, slope = { 0.01, "a / R, small" },
    size = { 20, "half width and height of each block over a; 40 changes nothing" },
    fine = { 1.5, "half width of the zone of fine cells over a" }, deep = { 0.5, "their depth over a" },
    press = { 1.83, "approach over a^2/R" }, shift = { 2.6, "way sideways over mu a^2/R: takes Q beyond 0.9 mu P" },
    steps_press = { 20, "a point that lands slips along the slope in that step: 0.1 % of mu p0 is left" },
    steps_shift = { 26, "values between steps are interpolated" }, kind = { "quad4", "the corner nodes share an edge alike" },
  },
  sweep = { { cells = 8 }, { cells = 16 }, { cells = 32 } },
  quick = { sweep = { { cells = 8 }, { cells = 16 } } },
  case_id = function(p) return ("%s_%g"):format(p.kind, p.cells) end,
  scene = scene,
  results = {
    { name = "half_width", unit = "m", meaning = "half width under P by Hertz",
      function(run, p) return exact(run, p, 1).a end },
    { name = "width_ratio", unit = "1", meaning = "the run's over that",
      function(run, p) return fit(points(run, 1), function(o) return o.p end) / exact(run, p, 1).a end },
    { name = "peak_ratio", unit = "1", meaning = "largest pressure over Hertz's under P",
      function(run, p) return select(2, fit(points(run, 1), function(o) return o.p end)) / exact(run, p, 1).p0 end },
    { name = "before", unit = "1", meaning = "largest q over mu p0 before the shift",
      function(run, p)
        return numeric.max(numeric.map(points(run, 1), function(o) return math.abs(o.q) end)) / (p.mu * exact(run, p, 1).p0)
      end },
    { name = "force_change", unit = "1", meaning = "change of P by the shift",
      function(run) return (forces(run, 2)) / (forces(run, 1)) - 1 end },
    { name = "stick", unit = "1", meaning = "c/a at the chosen share",
      function(run, p) return stick_share(run, p, time_of(run, p, p.share)) end },
    { name = "stick_late", unit = "1", meaning = "c/a at Q = 0.9 mu P",
      function(run, p) return stick_share(run, p, time_of(run, p, 0.9)) end },
    { name = "stick_status", unit = "1", meaning = "c by status over that of the closed solution", stick_points },
    { name = "shear", unit = "1", meaning = "L2 difference of q over its L2", shear_error },
    { name = "shear_away", unit = "1", meaning = "largest difference of q over its peak, two cells off c and a", shear_away },
    { name = "back_away", unit = "1", meaning = "the same, back at Q = 0, two cells off all kinks", back_away },
    { name = "slip", unit = "1", meaning = "L2 difference of the slip over its L2", slip_error },
    { name = "work", unit = "1", meaning = "work of friction over the closed", work_ratio },
    { name = "back", unit = "1", meaning = "L2 difference of q over its L2, back at Q = 0", back_error },
  },
  check = function(cases, check)
    local fine = cases[#cases]
    local function row(quantity, result, reference, tolerance, more)
      local t = { case = "Cattaneo-Mindlin, equal bodies", quantity = quantity, kind = "exact", run = fine,
        source = "Johnson 1985, 7.2", reference = reference, tolerance = tolerance, resolution = "m cell",
        values = numeric.map(cases, function(c) return { c.p.a / c.p.cells, c.results[result] } end) }
      for key, value in pairs(more or {}) do t[key] = value end
      check.proof(t)
    end
    local c, late, one_cell = math.sqrt(1 - fine.p.share), math.sqrt(1 - 0.9), 1 / fine.p.cells
    row(("c/a at Q = %g mu P, from q"):format(fine.p.share), "stick", c, one_cell / c, { order = 1 })
    row("c/a at Q = 0.9 mu P, from q", "stick_late", late, one_cell / late)
    row(("c at Q = %g mu P by status, over the closed"):format(fine.p.share), "stick_status", 1, one_cell / c)
    row("q, L2 difference", "shear", 0, 0.03, { scale = 1, order = 1 })
    row("q away from c and a, largest difference over its peak", "shear_away", 0, 0.03, { scale = 1 })
    row("q back at Q = 0 off its kinks, largest difference over its peak", "back_away", 0, 0.03, { scale = 1 })
    row("slip, L2 difference", "slip", 0, 0.03, { scale = 1 })
    row("work of friction over the closed", "work", 1, 0.02)
    row("half width a over Hertz's", "width_ratio", 1, one_cell)
    row("p0 over Hertz's", "peak_ratio", 1, 0.03)
    check.equal("shear does not change P", fine.results.force_change, 0, 1e-4)
    check.equal("no shear before the shift, over mu p0", fine.results.before, 0, 0.005)
  end,
  figures = function(cases)
    return { shear_figure(cases[#cases]), stick_figure(cases) }
  end,
}
