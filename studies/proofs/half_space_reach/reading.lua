-- What the cases say: errors of the half space with bars, whether promises hold, figures.
local stiction = require "stiction"
local scenes, design = require "scenes", require "design"

local reading = { shares = { 0.01, 0.03, 0.1 } }

local order = 1.7 -- of the meshes, seen where three of them were taken; growth of cells counts as their size

--- Force at the largest approach, all forces, and the number of that one: steps may have been halved.
local function pressed(run)
  local series = run:series("touch", "force_y")
  local at = stiction.numeric.first_where(run.time, function(time) return time > 1 - 1e-9 end)
  return -series[at], series, at
end

function reading.force(run, p) return pressed(run) / scenes.force(p) end

--- By the step that follows the turn.
function reading.stiffness(run, p)
  if p.kind ~= "pull" then
    return 0
  end
  local force, series, at = pressed(run)
  local way = (run.time[at + 1] - run.time[at]) * (p.depth + p.above)
  return (force + series[at + 1]) / scenes.force(p) / way
end

function reading.pull_off(run, p) return p.kind == "pull" and run:max("touch", "force_y") / scenes.force(p) or 0 end

-- Of the force: where the contact ends between two nodes no order says; the most that a third mesh changed where the others agreed.
local between = { sphere = 6e-4, pull = 6e-4, punch = 1.5e-3 }

--- Value of endless cells from two, and the bar that is left: what was added, and what no order says.
local function extrapolated(coarse, fine, kind)
  local rest = (fine - coarse) / (2 ^ order - 1)
  return fine + rest, math.abs(rest) + between[kind]
end

--- int_0^inf 1 - M dt of linear elasticity (engine/scene/explain/reach.hpp), by base and Poisson's ratio.
local springs = { stuck = { [0.3] = 1.37685, [0.49] = 1.73745 }, smooth = { [0.3] = 1.16758, [0.49] = 1.16758 } }

--- Of an endless half space at these meshes: force (brought to the same approach) and pull-off.
local function half_space(endless)
  local p, r = endless.p, endless.results
  local force = scenes.force(p) / (math.pi * scenes.modulus(p)) * springs.stuck[0.49] * p.thick / scenes.depth(p)
  return { force = r.force * (1 - force * r.stiffness), pull_off = r.pull_off }
end

--- The largest error of a scene at one mesh.
local function errors(case, endless)
  local p, r = case.p, case.results
  if p.kind ~= "pull" then
    return { r.force - 1 }
  end
  local known = half_space(endless[p.lambda .. "_" .. math.min(p.level, 1)])
  local over = math.max(math.abs(known.force), known.pull_off)
  return { (r.force - known.force) / over, (r.pull_off - known.pull_off) / known.pull_off }
end

local function sorted(cases)
  local by, endless = {}, {}
  for _, case in ipairs(cases) do
    local p = case.p
    if p.set == "endless" then
      endless[p.lambda .. "_" .. p.level] = case
    else
      local key = p.set .. p.number
      by[key] = by[key] or { set = p.set, number = p.number, p = p, levels = {} }
      by[key].levels[p.level] = case
    end
  end
  return by, endless
end

--- By set: scenes with their error, its bar, the bound.
function reading.scenes(cases)
  local by, endless = sorted(cases)
  local all = { map = {}, dice = {} }
  for _, case in ipairs(cases) do
    local scene = by[case.p.set .. case.p.number]
    if case.p.level == 0 and scene then
      local coarse, fine = errors(scene.levels[0], endless), errors(scene.levels[1], endless)
      scene.error, scene.bar, scene.bound = 0, 0, case.results.bound
      for i = 1, #coarse do
        local value, bar = extrapolated(coarse[i], fine[i], scene.p.kind)
        if math.abs(value) > math.abs(scene.error) then
          scene.error, scene.bar = value, bar
        end
      end
      local list = all[scene.set]
      list[#list + 1] = scene
    end
  end
  return all
end

--- By share: how many scenes the bound promises it and the measured error less its bar is above.
function reading.wrong(list)
  local wrong = {}
  for _, share in ipairs(reading.shares) do
    wrong[share] = 0
    for _, scene in ipairs(list) do
      if scene.bound <= share and math.abs(scene.error) - scene.bar > share then
        wrong[share] = wrong[share] + 1
      end
    end
  end
  return wrong
end

--- Scenes with three meshes: what the two finer ones say against the bar of the two coarser.
function reading.change_by_third(cases)
  local by, endless = sorted(cases)
  local most = 0
  for _, case in ipairs(cases) do
    local scene = by[case.p.set .. case.p.number]
    if case.p.level == 2 and case.p.kind ~= "pull" then
      local e = {}
      for level = 0, 2 do e[level] = errors(scene.levels[level], endless)[1] end
      local first, bar = extrapolated(e[0], e[1], case.p.kind)
      most = math.max(most, math.abs(extrapolated(e[1], e[2], case.p.kind) - first) / bar)
    end
  end
  return most
end

local function row_of(map, t)
  for _, scene in ipairs(map) do
    local fits = true
    for key, value in pairs(t) do fits = fits and scene.p[key] == value end
    if fits and math.abs(scene.p.thick / scene.p.wide - 4) < 1e-9 then
      return scene
    end
  end
end

--- Leading terms that are known, where the map has the scenes: base, and strain of small-strain laws.
function reading.check_leading(map, check)
  local function base(t, inward)
    local scene = row_of(map, t)
    if not scene then
      return
    end
    local x = 2 / math.pi * springs[t.base][t.poisson] * t.thick
    local known = x + (t.kind == "punch" and 1 or 7 / 6) * x ^ 2 + inward
    check.equal(("%s, base %s, nu = %g: error at a/h = %g"):format(t.kind, t.base, t.poisson, t.thick), scene.error, known,
      scene.bar + 0.1 * x ^ 2)
  end
  for _, poisson in ipairs { 0.3, 0.49 } do
    local inward = (1 - 2 * poisson) / (1 - poisson) / math.pi
    for _, thick in ipairs { 0.01, 0.04, 0.08 } do
      base({ kind = "sphere", base = "stuck", poisson = poisson, law = "linear_elastic", slope = 0.01, thick = thick }, 0.01 * inward)
    end
    local steep = row_of(map, { kind = "sphere", base = "stuck", poisson = poisson, law = "linear_elastic", slope = 0.1, thick = 0.0025 })
    local flat = row_of(map, { kind = "sphere", base = "stuck", poisson = poisson, law = "linear_elastic", slope = 0.01, thick = 0.0025 })
    if steep and flat then
      check.equal(("sphere, nu = %g: change of the error by a/R from 0.01 to 0.1"):format(poisson), steep.error - flat.error,
        0.09 * inward - 0.3 * (0.1 ^ 2 - 0.01 ^ 2), flat.bar)
    end
  end
end

local kinds = { { letter = "1", label = "to 1 %", colour = 0 }, { letter = "3", label = "to 3 %", colour = 1 },
  { letter = "X", label = "to 10 %", colour = 2 }, { letter = "-", label = "not to 10 %", colour = 3 } }

local function letter(error)
  for k, share in ipairs(reading.shares) do
    if error <= share then
      return kinds[k].letter
    end
  end
  return "-"
end

--- Rows of a map whose letters are of value(scene).
local function rows_of(map, value)
  local by = {}
  for _, scene in ipairs(map) do by[scene.number] = scene end
  return stiction.numeric.map(design.rows, function(entry)
    local i, cells = entry.number, {}
    for j = 1, #design.thicks do
      local scene = by[#design.thicks * (i - 1) + j]
      cells[j] = scene and letter(value(scene)) or "."
    end
    return { group = entry.group, label = entry.label, cells = table.concat(cells) }
  end)
end

local function picture(name, title, map, value)
  local columns = stiction.numeric.map(design.thicks, function(thick) return ("a/h = %g"):format(thick) end)
  return stiction.figure.map { name = name, title = title, blocks = 1, columns = columns, kinds = kinds, rows = rows_of(map, value) }
end

--- Bound against error of one set; errors too small to see stand at 0.01 %.
local function against(list, label, colour)
  local x, y = {}, {}
  for i, scene in ipairs(list) do
    x[i], y[i] = math.max(math.abs(scene.error), 1e-4), scene.bound
  end
  return { label = label, x = x, y = y, style = "points", colour = colour }
end

function reading.figures(all)
  local figure = stiction.figure
  local measured = picture("measured", "measured: a half space is right", all.map, function(scene) return math.abs(scene.error) end)
  local told = picture("told", "told by explain", all.map, function(scene) return scene.bound end)
  return { figure.panel { name = "map", columns = 2, width = "double", figures = { measured, told } },
    figure.lines { name = "bound", title = "what explain tells, and what is", legend = "below",
      x = { label = "error of the half space", unit = "%", log = true, range = { 1e-4, 3 } },
      y = { label = "bound told beforehand", unit = "%", log = true, range = { 1e-4, 3 } },
      curves = { against(all.map, "the map", 0), against(all.dice, "thrown by dice", 1),
        { label = "equal", x = { 1e-4, 3 }, y = { 1e-4, 3 }, style = "dash", colour = 6 } } } }
end

return reading
