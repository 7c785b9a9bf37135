-- A rough surface that adheres, pressed onto a soft half space and drawn off it: what is left of the pull, and what is lost.
--
--      /\  _/\    /\_/\/\        self-affine, rigid, pressed down beyond the largest pull and up until it lets go
--     ____________________       points, periodic; Dugdale's traction of work w and range h0
--
-- The law has no memory: what is lost goes where patches of contact jump in and out.
--
--     ./stiction run studies/rough/press_and_pull
local stiction = require "stiction"
local units = stiction.units
local um, s, J, m, MPa, Pa = units.um, units.s, units.J, units.m, units.MPa, units.Pa

local function scene(p)
  local L, sticky = p.length, p.w.si > 0
  local height = p.slope * p.heights
  local up = 1.2 * height + p.reach -- the same way there and back, so that the works' errors cancel where nothing jumps
  return stiction.scene {
    kinematics = "three_dimensional",
    bodies = { base = stiction.body.half_space { young = p.young, poisson = p.poisson, size = { L, L },
      points = { p.points, p.points }, boundary = "periodic" } },
    obstacles = { rough = stiction.obstacle.height_map {
      surface = stiction.surface.rough { hurst = p.hurst, longest = L / 2, shortest = L / 8, rms_slope = p.slope, seed = p.seed },
      times = { 0*s, 1*s, 2*s }, z = { up, -height - p.dive, up } } },
    pairs = { touch = stiction.pair { secondary = "base.surface", primary = "rough",
      adhesion = sticky and stiction.adhesion.dugdale { sigma0 = p.w.si / p.range.si * Pa, h0 = p.range, ramp = p.ramp } or nil } },
    scheme = stiction.scheme.quasi_static {},
    schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = p.steps },
      stiction.stage { to = 2*s, steps = p.steps } } },
    output = stiction.output { frames = 4 },
    probes = {
      touch = stiction.probe.contact { pair = "touch" },
      rough = stiction.probe.rigid { obstacle = "rough" },
      energy = stiction.probe.energy {},
    },
  }
end

local function area(p) return p.length.si ^ 2 end

local function case_of(w, slope, points, steps) return { w = w * J/m^2, slope = slope, points = points, steps = steps } end

--- Force and area of a step are those of its end: works lie within the sum of |change of force| |change of place|.
local function work_error(case)
  local force, z, sum = case:series("touch", "force_z"), case:series("rough", "u_z"), 0
  for i = 2, #force do
    sum = sum + math.abs(force[i] - force[i - 1]) * math.abs(z[i] - z[i - 1])
  end
  return sum / area(case.p)
end

local function check_energy(case, check)
  local lost, error = case.results.lost, work_error(case)
  if case.p.w.si == 0 then
    check.within(case.id .. ": lost without adhesion, over what was stored", lost * area(case.p) / case:max("energy", "strain"),
      -1e-9, 1e-9)
  else
    check.within(case.id .. ": lost over what bonds hold where they were, but for the works' error",
      lost / (case.p.w.si * case.results.bonded), -error / (case.p.w.si * case.results.bonded), 1)
  end
  local force = case:series("touch", "force_z")
  check.equal(case.id .. ": force at the end over the largest", force[#force] / math.max(case:max("touch", "force_z"), 1e-12), 0, 1e-9)
end

--- Where a finer grid or shorter steps were computed of the same surface.
local function check_resolution(cases, check)
  local function find(points, steps) return cases:find { slope = 0.1, w = 0.05*J/m^2, points = points, steps = steps } end
  local one, fine, short = find(64, 50), find(128, 50), find(64, 100)
  if one and fine and short then
    check.within("pull-off of 64 points over that of 128", one.results.pull_off / fine.results.pull_off, 0.97, 1.03)
    check.within("pull-off in 50 steps over that in 100", one.results.pull_off / short.results.pull_off, 0.97, 1.03)
  end
end

--- One surface of each slope, as coarse as the others.
local function over_slope(cases)
  local list = {}
  for _, case in ipairs(cases) do
    if case.p.points == 64 and case.p.steps == 50 and case.p.w.si > 0 then
      list[#list + 1] = case
    end
  end
  table.sort(list, function(a, b) return a.p.slope < b.p.slope end)
  return list
end

local function cycle(cases)
  local curves = {}
  for _, case in ipairs(cases) do
    local x, y, force = {}, {}, case:series("touch", "force_z")
    for k, z in ipairs(case:series("rough", "u_z")) do
      x[k], y[k] = -z, -force[k] / area(case.p)
    end
    curves[#curves + 1] = { label = ("h' = %g"):format(case.p.slope), x = x, y = y }
  end
  return stiction.figure.lines { name = "cycle", title = "Pressed on and drawn off", x = { label = "approach", unit = "um" },
    y = { label = "mean pressure", unit = "kPa" }, curves = curves }
end

local function pull_off(cases)
  local x, y, lost = {}, {}, {}
  for i, case in ipairs(cases) do
    x[i], y[i] = case.p.slope, case.results.pull_off * case.p.range.si / case.p.w.si
    lost[i] = case.results.lost / case.p.w.si
  end
  return stiction.figure.lines { name = "pull_off", title = "What roughness leaves of adhesion", x = { label = "rms slope", log = true },
    y = { label = "over that of flat surfaces", log = true },
    curves = { { label = "pull-off / sigma0", x = x, y = y, style = "points" },
      { label = "lost in the cycle / w", x = x, y = lost, style = "points" } } }
end

return stiction.study {
  title = "Pressing and drawing off a rough adhesive surface",
  question = "How does roughness take adhesion, and how much does a cycle lose by jumps alone?",
  given = { young = { 3*MPa, "" }, poisson = { 0.5, "" }, length = { 100*um, "of a period" }, hurst = { 0.8, "" }, seed = { 1, "" },
    range = { 0.3*um, "of the traction" } },
  chosen = { ramp = { 0.5, "of the range; with less, single points snap" },
    heights = { 8*um, "pressed, over the slope" },
    dive = { 0.3*um, "and as much more, beyond the largest pull" },
    reach = { 0.5*um, "that patches are drawn out before they let go" } },
  sweep = { case_of(0, 0.1, 64, 50), case_of(0.05, 0.07, 64, 50), case_of(0.05, 0.1, 64, 50),
    case_of(0.05, 0.14, 64, 50), case_of(0.05, 0.2, 64, 50), case_of(0.05, 0.28, 64, 50),
    case_of(0.05, 0.1, 64, 100), case_of(0.05, 0.1, 128, 50), case_of(0.05, 0.2, 128, 50) },
  quick = { sweep = { case_of(0, 0.1, 64, 50), case_of(0.05, 0.14, 64, 50), case_of(0.05, 0.2, 64, 50) } },
  case_id = function(p) return ("w%g_slope%g_n%d_s%d"):format(1000 * p.w.si, p.slope, p.points, p.steps) end,
  scene = scene,
  results = {
    { name = "pull_off", unit = "Pa", meaning = "largest pull over the area",
      function(run, p) return run:max("touch", "force_z") / area(p) end },
    { name = "lost", unit = "J/m^2", meaning = "work of the cycle over the area",
      function(run, p) local work = run:series("energy", "motion_work"); return work[#work] / area(p) end },
    { name = "touching", unit = "1", meaning = "largest part in contact",
      function(run, p) return run:max("touch", "closed_area") / area(p) end },
    { name = "bonded", unit = "1", meaning = "largest part within the range of attraction",
      function(run, p) return run:max("touch", "bonds") / p.points ^ 2 end },
  },
  check = function(cases, check)
    for _, case in ipairs(cases) do
      check_energy(case, check)
    end
    local rough = over_slope(cases)
    for i = 2, #rough do
      check.holds(("steeper roughness pulls less: %s"):format(rough[i].id), rough[i].results.pull_off < rough[i - 1].results.pull_off)
    end
    check_resolution(cases, check)
  end,
  figures = function(cases)
    local rough = over_slope(cases)
    return { cycle(rough), pull_off(rough),
      stiction.figure.field { name = "bonds", title = "Adhesion at the deepest", array = "normal_adhesion", unit = "MPa",
        case = rough[1], time = 1*s } }
  end,
}
