-- A wavy surface pressed onto a half space, without adhesion, until it touches everywhere (Westergaard 1939).
--
--      \__/      \__/      \__/      heights D (1 - cos(2 pi x / L)), pressed by the mean pressure q
--     --------------------------     n points along one wave length, periodic, plane strain
--
-- q = p* sin^2(pi a / L), p* = pi E* D / L: at p* the contact is full.
--
--     ./stiction run studies/proofs/half_space_wave
local stiction = require "stiction"
local units = stiction.units
local mm, um, s, MPa, N = units.mm, units.um, units.s, units.MPa, units.N
local line = stiction.reference.line_contact

local function full(p)
  return math.pi * line.combined_modulus(p.young.si, p.poisson) * p.amplitude.si / p.length.si
end

local function scene(p)
  return stiction.scene {
    bodies = { base = stiction.body.half_space { young = p.young, poisson = p.poisson, size = { p.length },
      points = { p.points }, boundary = "periodic" } },
    obstacles = { wave = stiction.obstacle.height_map {
      surface = stiction.surface.wave { amplitude = p.amplitude, wavelengths = { p.length } },
      times = { 0*s, 1*s }, force = { 0*N, p.most * full(p) * p.length.si * N } } },
    pairs = { touch = stiction.pair { secondary = "base.surface", primary = "wave" } },
    scheme = stiction.scheme.quasi_static {},
    schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = p.steps } } },
    probes = {
      touch = stiction.probe.contact { pair = "touch" },
      line = stiction.probe.contact_line { pair = "touch" },
      energy = stiction.probe.energy {},
    },
  }
end

--- Mean pressures over p*, and the part of the surface in contact: lists over the steps.
local function curve(run, p)
  local load, part = {}, {}
  local force, area = run:series("touch", "force_y"), run:series("touch", "closed_area")
  for k = 1, #force do
    load[k], part[k] = -force[k] / (p.length.si * full(p)), area[k] / p.length.si
  end
  return load, part
end

local function exact_part(load)
  return load >= 1 and 1 or 2 / math.pi * math.asin(math.sqrt(load))
end

--- Largest deviation of the part in contact, and of the largest pressure where contact is not full, relative.
local function deviation(run, p)
  local load, part = curve(run, p)
  local pressure, area, peak = run:series("touch", "pressure_max"), 0, 0
  for k = 2, #load do
    area = math.max(area, math.abs(part[k] - exact_part(load[k])))
    local exact = load[k] < 1 and 2 * math.sqrt(load[k]) * full(p) or (load[k] + 1) * full(p)
    peak = math.max(peak, math.abs(pressure[k] / exact - 1))
  end
  return area, peak
end

return stiction.study {
  title = "Wave on a half space (Westergaard)",
  question = "The part of a wavy surface that touches under a mean pressure.",
  given = { young = { 3*MPa, "" }, poisson = { 0.5, "" }, length = { 1*mm, "of a wave" },
    amplitude = { 10*um, "of the heights" } },
  chosen = { most = { 1.1, "largest mean pressure over p*" }, steps = { 22, "equal steps of force" } },
  sweep = { { "points", { 64, 128, 256, 512, 1024 } } },
  quick = { sweep = { { "points", { 64, 128, 256 } } } },
  case_id = function(p) return ("n%d"):format(p.points) end,
  scene = scene,
  results = {
    { name = "area", unit = "1", meaning = "part in contact: largest deviation",
      function(run, p) return (deviation(run, p)) end },
    { name = "peak", unit = "1", meaning = "largest pressure: largest deviation",
      function(run, p) return (select(2, deviation(run, p))) end },
    { name = "half", unit = "1", meaning = "largest pressure over p* where a quarter of p* presses",
      function(run, p)
        local load = curve(run, p)
        return stiction.numeric.interpolate(load, run:series("touch", "pressure_max"), 0.25) / full(p)
      end },
  },
  check = function(cases, check)
    local fine, values = cases[#cases], {}
    for k, case in ipairs(cases) do
      local p = case.p
      values[k] = { p.length.si / p.points, case.results.half }
      check.close(("%s: part in contact, within two points"):format(case.id), 1 + case.results.area, 1, 2 / p.points)
      check.close(("%s: largest pressure"):format(case.id), 1 + case.results.peak, 1, 15 / p.points ^ 1.5)
    end
    check.proof { case = "Wave on a half space", quantity = "largest pressure over p* at p*/4", unit = "1", kind = "exact",
      source = "Westergaard 1939; Johnson 1985, 13.2", reference = 1, values = values, resolution = "m spacing",
      tolerance = 5e-3, run = fine }
  end,
  figures = function(cases)
    local curves, x, y = {}, {}, {}
    for k, case in ipairs { cases[1], cases[#cases] } do
      local load, part = curve(case, case.p)
      curves[k] = { label = ("%d points"):format(case.p.points), x = load, y = part, style = "points" }
    end
    for i = 0, 110 do
      x[i + 1], y[i + 1] = i / 100, exact_part(i / 100)
    end
    curves[3] = { label = "Westergaard", x = x, y = y }
    return { stiction.figure.lines { name = "area", title = "Contact of a wave",
      x = { label = "mean pressure over p*" }, y = { label = "part in contact" }, curves = curves } }
  end,
}
