-- The contact mechanics challenge: its elasticity, adhesion, load and spectrum, on a surface of our own, from the longest
-- roughness and the longest range of attraction on towards those of the challenge.
--
--      /\  _/\    /\_/\/\        self-affine, rigid: 0.1 mm square, roll-off at 20 um, H = 0.8; pressed by 0.25 MPa
--     ____________________       points, periodic, E* = 25 MPa; w = 50 mJ/m^2, w/range exp(-gap/range)
--
-- The challenge's waves end at 0.1 um, where the rms slope is 1, and its range is 2.07 nm: points 1 nm apart would bear that
-- without snapping one by one, 10^5 along each side. So waves end at `shortest` here, the longer ones being the challenge's, and
-- ranges are those that the points bear (`explain` tells which).
--
--     ./stiction run studies/rough/contact_challenge
local stiction = require "stiction"
local units = stiction.units
local um, nm, s, J, m, MPa, N = units.um, units.nm, units.s, units.J, units.m, units.MPa, units.N

local bush, persson = math.sqrt(2 * math.pi), math.sqrt(8 / math.pi)

--- Mean square slope of the challenge's spectrum from its longest wave down to a wavelength, in units of its own.
local function square_slope(p, shortest)
  local from, roll_off, to = 1 / p.length.si, 1 / p.roll_off.si, 1 / shortest
  local flat = roll_off ^ (-2 - 2 * p.hurst) * (roll_off ^ 4 - from ^ 4) / 4
  return flat + (to ^ (2 - 2 * p.hurst) - roll_off ^ (2 - 2 * p.hurst)) / (2 - 2 * p.hurst)
end

--- Rms slope of those of the challenge's waves that are there.
local function slope(p) return p.slope * math.sqrt(square_slope(p, p.shortest.si) / square_slope(p, p.last.si)) end

local function area(p) return p.length.si ^ 2 end

local function sticky(p) return p.w.si > 0 end

local function scene(p)
  local L = p.length
  return stiction.scene {
    kinematics = "three_dimensional",
    bodies = { base = stiction.body.half_space { young = 0.75 * p.modulus, poisson = 0.5, size = { L, L },
      points = { p.points, p.points }, boundary = "periodic" } },
    obstacles = { rough = stiction.obstacle.height_map {
      surface = stiction.surface.rough { hurst = p.hurst, longest = L, roll_off = p.roll_off, shortest = p.shortest,
        rms_slope = slope(p), seed = p.seed },
      times = { 0*s, 1*s }, force = { 0*N, p.pressure.si * area(p) * N } } },
    pairs = { touch = stiction.pair { secondary = "base.surface", primary = "rough",
      adhesion = sticky(p) and stiction.adhesion.attraction { w = p.w, range = p.range } or nil } },
    scheme = stiction.scheme.quasi_static {},
    schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = p.steps } } },
    output = stiction.output { frames = 1 },
    probes = { touch = stiction.probe.contact { pair = "touch" }, rough = stiction.probe.rigid { obstacle = "rough" } },
  }
end

--- t: points over waves, and what else differs; without a range it does not adhere.
local function case_of(t)
  return { points = t.points, shortest = t.shortest * um, w = (t.range and 0.05 or 0) * J/m^2, range = (t.range or 100) * nm,
    seed = t.seed or 1, steps = t.steps or 5 }
end

--- Eight points a wave.
local grids = { { points = 128, shortest = 6.4 }, { points = 256, shortest = 3.2 }, { points = 512, shortest = 1.6 },
  { points = 1024, shortest = 0.8 }, { points = 2048, shortest = 0.4 } }

local function sweep(most, ranges)
  local list = {}
  for k = 1, most do
    local grid = grids[k]
    list[#list + 1] = case_of(grid)
    for _, range in ipairs(ranges[k]) do
      list[#list + 1] = case_of { points = grid.points, shortest = grid.shortest, range = range }
    end
  end
  return list
end

local function full()
  local list = sweep(5, { { 100, 60 }, { 100, 60, 42 }, { 100, 60, 42, 30 }, { 100, 60, 42, 30 }, { 60 } })
  for _, t in ipairs { { points = 512, shortest = 3.2 }, { points = 512, shortest = 3.2, range = 60 },
    { points = 256, shortest = 3.2, range = 60, steps = 20 }, { points = 256, shortest = 3.2, seed = 2 },
    { points = 256, shortest = 3.2, range = 60, seed = 2 }, { points = 256, shortest = 3.2, seed = 3 },
    { points = 256, shortest = 3.2, range = 60, seed = 3 } } do
    list[#list + 1] = case_of(t)
  end
  return list
end

local function case_id(p)
  return ("waves%g_n%d_%s_seed%d_s%d"):format(p.shortest.si * 1e6, p.points, sticky(p) and ("range%g"):format(p.range.si * 1e9) or "dry",
    p.seed, p.steps)
end

local function find(cases, t)
  local id = case_id(case_of(t))
  for _, case in ipairs(cases) do
    if case.id == id then
      return case
    end
  end
end

--- The same case without adhesion.
local function dry_of(cases, case)
  local p = case.p
  return find(cases, { points = p.points, shortest = p.shortest.si * 1e6, seed = p.seed })
end

--- Part in contact over that without adhesion.
local function gain(cases, case) return case and case.results.part / dry_of(cases, case).results.part end

--- Of one surface, eight points a wave: those that adhere, the longest range first.
local function over_range(cases, grid)
  local list = {}
  for _, case in ipairs(cases) do
    local p = case.p
    if sticky(p) and p.points == grid.points and p.shortest.si == grid.shortest * um.si and p.seed == 1 and p.steps == 5 then
      list[#list + 1] = case
    end
  end
  table.sort(list, function(a, b) return a.p.range.si > b.p.range.si end)
  return list
end

--- Adhesion is no more than a load as large as its pull: it pulls at the rims, where surfaces touch anyway.
local function check_case(cases, case, check)
  local kappa, pull = case.results.kappa, case.results.pull
  check.within(case.id .. ": kappa under the load and the pull, between Persson's and Bush's", kappa / (1 + pull), persson, bush)
  if sticky(case.p) then
    local dry = dry_of(cases, case).results
    check.holds(case.id .. ": adhesion brings contact, no more than its pull as a load",
      case.results.part > dry.part and kappa / (1 + pull) < dry.kappa)
  end
end

local function check_ranges(cases, check)
  for _, grid in ipairs(grids) do
    local list = over_range(cases, grid)
    for i = 2, #list do
      check.holds(list[i].id .. ": a shorter range pulls more, and brings more contact",
        list[i].results.pull > list[i - 1].results.pull and list[i].results.part > list[i - 1].results.part)
    end
  end
  for k = 2, #grids do
    local here = find(cases, { points = grids[k].points, shortest = grids[k].shortest, range = 60 })
    local before = find(cases, { points = grids[k - 1].points, shortest = grids[k - 1].shortest, range = 60 })
    if here and before then
      check.holds(here.id .. ": finer waves take adhesion", gain(cases, here) < gain(cases, before))
    end
  end
end

--- Where there is a finer grid, shorter steps or another surface.
local function check_resolution(cases, check)
  local one, fine = find(cases, { points = 256, shortest = 3.2, range = 60 }), find(cases, { points = 512, shortest = 3.2, range = 60 })
  if not fine then
    return
  end
  check.within("gain of 16 points a wave over that of 8", gain(cases, fine) / gain(cases, one), 0.99, 1.01)
  check.within("part of 16 points a wave over that of 8", fine.results.part / one.results.part, 0.93, 1)
  local short = find(cases, { points = 256, shortest = 3.2, range = 60, steps = 20 })
  check.equal("part in 20 steps over that in 5", short.results.part / one.results.part, 1, 1e-6)
  for seed = 2, 3 do
    local other = find(cases, { points = 256, shortest = 3.2, range = 60, seed = seed })
    check.within(("gain of surface %d over that of the first"):format(seed), gain(cases, other) / gain(cases, one), 0.95, 1.05)
  end
end

local function gains(cases)
  local curves = {}
  for _, grid in ipairs(grids) do
    local x, y = {}, {}
    for i, case in ipairs(over_range(cases, grid)) do
      x[i], y[i] = case.p.range.si, gain(cases, case)
    end
    if #x > 1 then
      curves[#curves + 1] = { label = ("waves down to %g µm"):format(grid.shortest), x = x, y = y }
    end
  end
  return stiction.figure.lines { name = "gain", title = "What adhesion brings",
    x = { label = "range of attraction", unit = "nm", log = true }, y = { label = "contact over that without adhesion" }, curves = curves }
end

local function parts(cases)
  local curves = {}
  for _, kind in ipairs { { "without adhesion" }, { "range 100 nm", 100 }, { "range 60 nm", 60 } } do
    local x, y = {}, {}
    for _, grid in ipairs(grids) do
      local case = find(cases, { points = grid.points, shortest = grid.shortest, range = kind[2] })
      if case then
        x[#x + 1], y[#y + 1] = grid.shortest * um.si, case.results.part
      end
    end
    curves[#curves + 1] = { label = kind[1], x = x, y = y }
  end
  return stiction.figure.lines { name = "part", title = "The finer the waves, the less touches", x = { label = "shortest wave", unit = "um",
    log = true }, y = { label = "part in contact", log = true }, curves = curves }
end

return stiction.study {
  title = "The contact mechanics challenge",
  question = "How much of it touches, and how far does adhesion bring that?",
  given = { modulus = { 25*MPa, "E*" }, pressure = { 0.25*MPa, "" }, length = { 100*um, "" },
    roll_off = { 20*um, "" }, last = { 0.1*um, "where the challenge's waves end" }, slope = { 1, "rms, of all its waves" },
    hurst = { 0.8, "" } },
  chosen = {},
  sweep = full(),
  quick = { sweep = sweep(2, { { 100, 60 }, { 100, 60 } }) },
  case_id = case_id,
  scene = scene,
  results = {
    { name = "part", unit = "1", meaning = "that touches", function(run, p) return run:max("touch", "closed_area") / area(p) end },
    { name = "kappa", unit = "1", meaning = "part over load / (E* rms slope)",
      function(run, p) return run:max("touch", "closed_area") / area(p) * p.modulus.si * slope(p) / p.pressure.si end },
    { name = "pull", unit = "1", meaning = "attraction over load",
      function(run, p) return -run:min("touch", "adhesion_n") / (p.pressure.si * area(p)) end },
    { name = "gap", unit = "m", meaning = "mean gap", function(run) local gap = run:series("touch", "gap_mean"); return gap[#gap] end },
  },
  check = function(cases, check)
    for _, case in ipairs(cases) do
      check_case(cases, case, check)
    end
    check_ranges(cases, check)
    check_resolution(cases, check)
  end,
  figures = function(cases)
    local grid = find(cases, { points = 512, shortest = 1.6, range = 30 }) and grids[3] or grids[1]
    local list = over_range(cases, grid)
    return { gains(cases), parts(cases),
      stiction.figure.field { name = "pressure", title = "Pressure where it touches", array = "contact_pressure", unit = "MPa",
        case = list[#list], time = 1*s } }
  end,
}
