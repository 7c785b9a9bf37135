-- Rough surfaces pressed onto a half space: full contact, where the pressures are known, and the part that touches at
-- small loads, between the theories of Bush, Gibson and Thomas and of Persson.
--
--      /\  _/\    /\_/\/\        waves between `longest` and `shortest`, self-affine below the roll-off
--     ____________________       points, periodic
--
-- Small loads: part = kappa q / (E* h'), q the mean pressure, h' the rms gradient. kappa = sqrt(2 pi) by Bush et al.,
-- sqrt(8 / pi) by Persson. Full contact: rms pressure about the mean E* h' / 2.
--
--     ./stiction run studies/proofs/half_space_rough
local stiction = require "stiction"
local units = stiction.units
local mm, s, MPa, N = units.mm, units.s, units.MPa, units.N

local bush, persson = math.sqrt(2 * math.pi), math.sqrt(8 / math.pi)

--- E* h', the pressure that others are told by.
local function scale(p)
  return p.young.si / (1 - p.poisson ^ 2) * p.slope
end

local function is_line(p) return p.kinematics == "plane_strain" end

local function scene(p)
  local L, line = p.length, is_line(p)
  local waves = stiction.surface.rough { hurst = p.hurst, longest = L / p.longest, roll_off = L / p.longest, shortest = L / p.shortest,
    rms_slope = p.slope, seed = p.seed }
  local area = line and L.si or L.si ^ 2
  return stiction.scene {
    kinematics = p.kinematics,
    bodies = { base = stiction.body.half_space { young = p.young, poisson = p.poisson, size = line and { L } or { L, L },
      points = line and { p.points } or { p.points, p.points }, boundary = "periodic" } },
    obstacles = { rough = stiction.obstacle.height_map { surface = waves, times = { 0*s, 1*s },
      force = { 0*N, p.most * scale(p) * area * N } } },
    pairs = { touch = stiction.pair { secondary = "base.surface", primary = "rough" } },
    scheme = stiction.scheme.quasi_static {},
    schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = p.steps } } },
    probes = { touch = stiction.probe.contact { pair = "touch" }, energy = stiction.probe.energy {} },
  }
end

--- Mean pressure over E* h', and the part in contact: lists over the loads, from the first on.
local function curve(run, p)
  local load, part, area = {}, {}, is_line(p) and p.length.si or p.length.si ^ 2
  local closed = run:series("touch", "closed_area")
  for k = 1, #closed - 1 do
    load[k], part[k] = p.most * k / p.steps, closed[k + 1] / area
  end
  return load, part
end

--- One surface on each grid, pressed little.
local function add_small(list, hurst, seed, grids, waves)
  for _, points in ipairs(grids) do
    list[#list + 1] = { kinematics = "three_dimensional", most = 0.04, steps = 4, hurst = hurst, seed = seed, points = points,
      longest = waves[1], shortest = waves[2] }
  end
end

--- Surfaces in space and on a line, pressed until all touches.
local function add_full(list, hurst, points, waves)
  list[#list + 1] = { kinematics = "three_dimensional", most = 4, steps = 1, hurst = hurst, seed = 1, points = points,
    longest = waves[1], shortest = waves[2] }
  list[#list + 1] = { kinematics = "plane_strain", most = 4, steps = 1, hurst = hurst, seed = 1, points = 1024, longest = 2,
    shortest = 128 }
end

local exponents = { 0.3, 0.5, 0.8 }

--- grids_of(seed); waves: the longest and the shortest in parts of the length.
local function sweep(seeds, grids_of, waves)
  local list = {}
  for _, hurst in ipairs(exponents) do
    for seed = 1, seeds do
      add_small(list, hurst, seed, grids_of(seed), waves)
    end
    add_full(list, hurst, grids_of(1)[1], waves)
  end
  return list
end

local function id(p)
  if p.most > 1 then
    return ("full_%s_H%.1f"):format(is_line(p) and "line" or "plane", p.hurst)
  end
  return ("H%.1f_seed%02d_n%d"):format(p.hurst, p.seed, p.points)
end

--- The parts in contact of one surface at all loads, of grids `k` and `k` + 1, each half as coarse as the one before: errors are
--- of the rim of the contact, and fall with the spacing.
local function extrapolated(cases, hurst, seed, k)
  local grids = cases:where { most = 0.04, hurst = hurst, seed = seed }
  local load, coarse = curve(grids[k], grids[k].p)
  local _, fine = curve(grids[k + 1], grids[k + 1].p)
  local part = {}
  for i = 1, #load do
    part[i] = 2 * fine[i] - coarse[i]
  end
  return load, part, #grids
end

--- Over the seeds: loads, mean of the parts in contact, and their standard deviation.
local function ensemble(cases, hurst)
  local sums, squares, count, load = {}, {}, 0, nil
  while #cases:where { most = 0.04, hurst = hurst, seed = count + 1 } > 0 do
    count = count + 1
    local part
    load, part = extrapolated(cases, hurst, count, 1)
    for i = 1, #load do
      sums[i], squares[i] = (sums[i] or 0) + part[i], (squares[i] or 0) + part[i] ^ 2
    end
  end
  local mean, scatter = {}, {}
  for i = 1, #load do
    mean[i] = sums[i] / count
    scatter[i] = math.sqrt(math.max(0, squares[i] / count - mean[i] ^ 2) * count / (count - 1))
  end
  return load, mean, scatter
end

--- By its series, for arguments well below 1.
local function erf(x)
  local sum, term = 0, x
  for n = 0, 12 do
    sum = sum + term / (2 * n + 1)
    term = -term * x * x / (n + 1)
  end
  return 2 / math.sqrt(math.pi) * sum
end

return stiction.study {
  title = "Rough surfaces on a half space",
  question = "The part of a self-affine rough surface that touches at small loads, and the pressures of full contact.",
  given = { young = { 3*MPa, "" }, poisson = { 0.5, "" }, length = { 1*mm, "of a period" }, slope = { 0.05, "rms gradient h'" } },
  chosen = {},
  sweep = sweep(10, function(seed) return seed == 1 and { 256, 512, 1024 } or { 256, 512 } end, { 4, 32 }),
  quick = { sweep = sweep(3, function() return { 128, 256 } end, { 2, 16 }) },
  case_id = id,
  scene = scene,
  results = {
    { name = "part", unit = "1", meaning = "part in contact at the largest load",
      function(run, p) local _, part = curve(run, p); return part[#part] end },
    { name = "first", unit = "1", meaning = "part in contact at the smallest load",
      function(run, p) local _, part = curve(run, p); return part[1] end },
    { name = "rms", unit = "1", meaning = "rms pressure about the mean, over E* h'",
      function(run, p) local rms = run:series("touch", "pressure_rms"); return rms[#rms] / scale(p) end },
  },
  check = function(cases, check)
    for _, hurst in ipairs(exponents) do
      for _, kinematics in ipairs { "three_dimensional", "plane_strain" } do
        local case = cases:where { most = 4, hurst = hurst, kinematics = kinematics }[1]
        check.close(case.id .. ": all touches", case.results.part, 1, 1e-12)
        check.proof { case = is_line(case.p) and "Rough line, full contact" or "Rough surface, full contact",
          quantity = ("rms pressure over E* h', H = %.1f"):format(hurst), unit = "1", kind = "exact", source = "Persson 2001",
          reference = 0.5, values = { { case.p.length.si / case.p.points, case.results.rms } }, resolution = "m spacing",
          tolerance = 1e-8, run = case }
      end
      local load, part = ensemble(cases, hurst)
      check.within(("H = %.1f: part in contact over q / (E* h') at q = %.2f E* h'"):format(hurst, load[1]), part[1] / load[1],
        persson, bush)
      local first, by_coarse, grids = extrapolated(cases, hurst, 1, 1)
      if grids > 2 then
        local _, by_fine = extrapolated(cases, hurst, 1, 2)
        check.close(("H = %.1f: extrapolated from finer grids"):format(hurst), by_fine[#first], by_coarse[#first], 0.01)
      end
    end
  end,
  figures = function(cases)
    local areas, slopes, x, of_bush, of_persson = {}, {}, {}, {}, {}
    for k, hurst in ipairs(exponents) do
      local load, mean, scatter = ensemble(cases, hurst)
      local over = function(list)
        local slope = {}
        for i, value in ipairs(list) do
          slope[i] = value / load[i]
        end
        return slope
      end
      local beside = {} -- so that none hides another
      for i, value in ipairs(load) do
        beside[i] = value + (k - 2) * 0.0006
      end
      areas[k] = { label = ("H = %.1f"):format(hurst), x = load, y = mean, error = scatter, style = "points" }
      slopes[k] = { label = areas[k].label, x = beside, y = over(mean), error = over(scatter), style = "points" }
    end
    for i = 1, 44 do
      x[i] = i / 1000
      of_bush[i], of_persson[i] = bush * x[i], erf(math.sqrt(2) * x[i])
    end
    areas[#areas + 1] = { label = "Bush, Gibson, Thomas", x = x, y = of_bush }
    areas[#areas + 1] = { label = "Persson", x = x, y = of_persson }
    for k = 1, 2 do
      local theory, y = areas[#exponents + k], {}
      for i, value in ipairs(theory.y) do
        y[i] = value / x[i]
      end
      slopes[#slopes + 1] = { label = theory.label, x = x, y = y }
    end
    return {
      stiction.figure.lines { name = "area", title = "Contact of rough surfaces",
        x = { label = "mean pressure / (E* h')" }, y = { label = "part in contact" }, curves = areas },
      stiction.figure.lines { name = "kappa", title = "Contact of rough surfaces (bars: scatter over seeds)",
        x = { label = "mean pressure / (E* h')" }, y = { label = "part in contact x E* h' / mean pressure" }, curves = slopes },
      stiction.figure.field { name = "map", title = "Contact pressure", array = "contact_pressure", unit = "MPa",
        case = cases:where { most = 0.04, hurst = 0.8, seed = 1 }[2] },
    }
  end,
}
