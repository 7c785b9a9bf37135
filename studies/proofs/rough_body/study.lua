-- A deformable body whose boundary is rough or wavy, pressed by a rigid plane: the force of the same heights on the rigid side, as
-- slopes get small, and Westergaard's contact of a wave.
--
--     ___________________        ___________________
--     |______plane______|        \__/\_/\___/\__/\_/     rigid
--      __/\_/\___/\__/\__         __________________
--     |    as high as   |        |                  |
--     |____it is wide___|        |__________________|    periodic at its sides, held below
--        side = "relief"             side = "rigid"
--
-- Both gaps are the same; the bodies are not: one is thinner by the mean height and its contact nodes lie on slopes. So forces differ by a
-- part that falls with the slope, on the same cells. Of the wave q = p* sin^2(pi a / L), p* = pi E* D / L.
--
--     ./stiction run studies/proofs/rough_body
local stiction = require "stiction"
local units = stiction.units
local m, s, kg, MPa = units.m, units.s, units.kg, units.MPa
local line = stiction.reference.line_contact

--- Mean pressure at which the wave touches everywhere, Pa.
local function full(p)
  return math.pi * line.combined_modulus(p.young.si, p.poisson) * p.amplitude.si / p.width.si
end

local function heights(p)
  if p.of == "wave" then
    return stiction.surface.wave { amplitude = p.amplitude, wavelengths = { p.width } }
  end
  return stiction.surface.rough { hurst = 0.8, longest = p.width / 2, shortest = p.width / 8, rms_slope = p.slope, seed = 1 }
end

local function sink(p)
  return p.of == "wave" and p.press * p.amplitude or p.sink * p.slope * p.width
end

local function scene(p)
  local map = { surface = heights(p), size = { p.width }, points = { p.points } }
  local body = { density = 1000*kg/m^3, material = stiction.material.linear_elastic { young = p.young, poisson = p.poisson },
    mesh = stiction.mesh.block { origin = { -p.width / 2, -p.width }, size = { p.width, p.width }, cells = { p.cells, p.cells / 2 },
      grading = { 1, p.grading } } }
  local shape = stiction.rigid.plane { normal = { 0, -1 } }
  if p.side == "rigid" then
    map.normal = { 0, -1 }
    shape = stiction.rigid.height_map(map)
  else
    map.set = "top"
    body.relief = stiction.relief(map)
  end
  return stiction.scene {
    bodies = { block = stiction.body(body) },
    obstacles = { stamp = stiction.obstacle { times = { 0*s, 1*s }, y = { 0*m, -sink(p) }, shape = shape } },
    motions = { stiction.motion.fix { set = "block.bottom" } },
    constraints = { stiction.constraint.periodic { set = "block.right", to = "block.left" } },
    pairs = { touch = stiction.pair { secondary = "block.top", primary = "stamp" } },
    scheme = stiction.scheme.quasi_static {},
    schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = p.of == "wave" and p.steps or 4 } } },
    probes = { touch = stiction.probe.contact { pair = "touch" } },
  }
end

--- Of the wave: mean pressures over p* and parts in contact, lists over the steps.
local function curve(run, p)
  local load, part = {}, {}
  local force, area = run:series("touch", "force_y"), run:series("touch", "closed_area")
  for k = 1, #force do
    load[k], part[k] = math.abs(force[k]) / (p.width.si * full(p)), area[k] / p.width.si
  end
  return load, part
end

local function exact_part(load)
  return load >= 1 and 1 or 2 / math.pi * math.asin(math.sqrt(load))
end

--- Largest deviations of the part in contact and, of the largest pressure, relative.
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

local function sweep(slopes, cells)
  local list = {}
  for _, slope in ipairs(slopes) do
    for _, side in ipairs { "relief", "rigid" } do
      list[#list + 1] = { of = "rough", side = side, slope = slope, cells = 128 }
    end
  end
  for _, count in ipairs(cells) do
    list[#list + 1] = { of = "wave", side = "relief", slope = 0, cells = count }
  end
  return list
end

local function only_wave(f)
  return function(run, p)
    return p.of == "wave" and f(run, p) or 0
  end
end

--- {slope =, error = of the relief's force against that of the rigid map, relative}, slopes falling.
local function differences(cases)
  local list = {}
  for _, relief in ipairs(cases:where { of = "rough", side = "relief" }) do
    local rigid = cases:where { side = "rigid", slope = relief.p.slope }[1]
    list[#list + 1] = { slope = relief.p.slope, error = math.abs(relief.results.pressure / rigid.results.pressure - 1) }
  end
  table.sort(list, function(a, b) return a.slope > b.slope end)
  return list
end

return stiction.study {
  title = "A body whose surface is rough or wavy",
  question = "Do heights of a deformable body press as those of a rigid one do, and as Westergaard's wave?",
  given = { width = { 1*m, "of the block and of the wave; the block is as high" }, young = { 1*MPa, "" }, poisson = { 0.3, "" },
    amplitude = { 1e-4*m, "of the wave" } },
  chosen = { points = { 256, "of the map" }, sink = { 0.3, "of the rough surface over slope and width" },
    press = { 3.8, "amplitudes that the plane sinks into the wave: contact gets full" },
    steps = { 24, "equal steps of the plane" }, grading = { 0.25, "of the uppermost cells over the lowest" } },
  sweep = sweep({ 0.04, 0.02, 0.01, 0.005, 0.0025 }, { 64, 128, 256 }),
  quick = { sweep = sweep({ 0.02, 0.01 }, { 32, 64 }) },
  case_id = function(p)
    return p.of == "wave" and ("wave_%d"):format(p.cells) or ("rough_%s_%g"):format(p.side, p.slope):gsub("%.", "_")
  end,
  scene = scene,
  results = {
    { name = "pressure", unit = "1", meaning = "rough: mean at the end over E* slope",
      function(run, p)
        local force = run:series("touch", "force_y")
        local scale = p.of == "wave" and full(p) or p.slope * line.combined_modulus(p.young.si, p.poisson)
        return math.abs(force[#force]) / (p.width.si * scale)
      end },
    { name = "area", unit = "1", meaning = "wave: part in contact, largest deviation",
      only_wave(function(run, p) return (deviation(run, p)) end) },
    { name = "peak", unit = "1", meaning = "wave: largest pressure, largest deviation",
      only_wave(function(run, p) return (select(2, deviation(run, p))) end) },
    { name = "half", unit = "1", meaning = "wave: largest pressure over p* where a quarter of p* presses",
      only_wave(function(run, p)
        local squares = stiction.numeric.map(run:series("touch", "pressure_max"), function(one) return (one / full(p)) ^ 2 end)
        return math.sqrt(stiction.numeric.interpolate(curve(run, p), squares, 0.25)) -- they rise as the load does
      end) },
  },
  check = function(cases, check)
    local list = differences(cases)
    for k, one in ipairs(list) do
      if k > 1 then
        local before = list[k - 1]
        check.within(("order of the difference from slope %g to %g"):format(before.slope, one.slope),
          math.log(before.error / one.error) / math.log(before.slope / one.slope), 0.8, 1.2)
      end
    end
    local waves, values = cases:where { of = "wave" }, {}
    for k, case in ipairs(waves) do
      local p = case.p
      values[k] = { p.width.si / p.cells, case.results.half }
      check.close(("%s: part in contact, within two nodes"):format(case.id), 1 + case.results.area, 1, 2 / p.cells)
      check.close(("%s: largest pressure"):format(case.id), 1 + case.results.peak, 1, 15 / p.cells ^ 1.5)
    end
    check.proof { case = "Wavy block", quantity = "largest pressure over p* at p*/4", unit = "1", kind = "exact",
      source = "Westergaard 1939; Johnson 1985, 13.2", reference = 1, values = values, resolution = "m cell",
      tolerance = 1e-3, run = waves[#waves] }
  end,
  figures = function(cases)
    local list, slope, error, first = differences(cases), {}, {}, {}
    for k, one in ipairs(list) do
      slope[k], error[k] = one.slope, one.error
      first[k] = list[#list].error * one.slope / list[#list].slope
    end
    local waves, curves, x, y = cases:where { of = "wave" }, {}, {}, {}
    for k, case in ipairs { waves[1], waves[#waves] } do
      local load, part = curve(case, case.p)
      curves[k] = { label = ("%d cells"):format(case.p.cells), x = load, y = part, style = "points" }
    end
    for i = 0, 110 do
      x[i + 1], y[i + 1] = i / 100, exact_part(i / 100)
    end
    curves[3] = { label = "Westergaard", x = x, y = y }
    return {
      stiction.figure.lines { name = "slopes", title = "Heights of the body, of the stamp", x = { label = "rms slope", log = true },
        y = { label = "difference of the forces", log = true }, curves = {
          { label = "computed", x = slope, y = error, style = "points" }, { label = "first order", x = slope, y = first } } },
      stiction.figure.lines { name = "wave", title = "Contact of a wavy block", x = { label = "mean pressure over p*" },
        y = { label = "part in contact" }, curves = curves },
    }
  end,
}
