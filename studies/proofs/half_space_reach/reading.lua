-- What the cases say: errors of the half space with bars, whether promises hold, figures.
local stiction = require "stiction"
local scenes, design = require "scenes", require "design"

local reading = { shares = { 0.01, 0.03, 0.1 } }

local order = 1.7 -- of the meshes, seen where three of them were taken; growth of cells counts as their size

local function pressed(run, p)
  local series = run:series("touch", "force_y")
  return -series[p.steps + 1], series
end

function reading.force(run, p) return pressed(run, p) / scenes.force(p) end

--- By the steps before and after the turn.
function reading.stiffness(run, p)
  if p.kind ~= "pull" then
    return 0
  end
  local force, series = pressed(run, p)
  return (force + series[p.steps + 2]) / scenes.force(p) / ((p.depth + p.above) / p.up)
end

function reading.pull_off(run, p) return p.kind == "pull" and run:max("touch", "force_y") / scenes.force(p) or 0 end

local between = 5e-4 -- of the force: the contact ends between two nodes, 32 of them to a

--- Value of endless cells from two, and the bar that is left: what was added, and what no order says.
local function extrapolated(coarse, fine)
  local rest = (fine - coarse) / (2 ^ order - 1)
  return fine + rest, math.abs(rest) + between
end

--- a/h of a base's spring c / h: pi E* in these units; c by linear elasticity, for pulls' endless block alone.
local base_number = 1.74

--- Of an endless half space at these meshes: force (brought to the same approach) and pull-off.
local function half_space(endless)
  local p, r = endless.p, endless.results
  local force = scenes.force(p) / (math.pi * scenes.modulus(p)) * base_number * p.thick / scenes.depth(p)
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
        local value, bar = extrapolated(coarse[i], fine[i])
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
      local first, bar = extrapolated(e[0], e[1])
      most = math.max(most, math.abs(extrapolated(e[1], e[2]) - first) / bar)
    end
  end
  return most
end

function reading.check_leading() end
function reading.figures() return {} end

return reading
