-- Steps chosen from their error against ladders of equal steps, on both examples of the paper.
--
-- Every problem runs with equal steps of several sizes, the finest being the reference, and with error control at
-- several tolerances. Meshes stay, so the error is that of time alone.
--
--     ./stiction run studies/trade/error_control            34 cases
--     ./stiction run studies/trade/error_control --quick    8 cases of two problems
local stiction = require "stiction"
local plate = require "../../paper/plate_on_cylinder"
local sphere = require "../../paper/sphere_indentation"
local units = stiction.units
local mm, um, s, ms, us = units.mm, units.um, units.s, 1e-3 * units.s, 1e-6 * units.s

-- What a problem changes in its paper's study, its own step as a function of the refinement, and what is measured.
local problems = {
  plate = {
    paper = plate, events = 1*us, quantities = { "beta_peak", "adhesion_t_peak" },
    set = { v = 1000*mm/s, mu = 0.4, travel = 2*mm, frames = 0 },
    refined = function(r) return { descent_steps = math.floor(100 * r + 0.5), sliding_step = 10*um / r } end,
  },
  rigid = {
    paper = sphere, events = 1*ms, quantities = { "beta_A", "traction_A", "pull_off" },
    set = { model = "rigid", set = "A", frames = 0 },
    refined = function(r) return { steps_down = math.floor(150 * r + 0.5) } end,
  },
  fast_bonds = {
    paper = sphere, events = 1*ms, quantities = { "beta_A", "traction_A", "pull_off" },
    set = { model = "fast_bonds", set = "A", frames = 0 },
    refined = function(r) return { steps_down = math.floor(150 * r + 0.5) } end,
  },
}

-- The parameters of a paper's study: its own, then those of the problem, of the refinement and of the mesh.
local function parameters(p)
  local problem, q = problems[p.problem], {}
  for _, part in ipairs { "given", "chosen" } do
    for name, entry in pairs(problem.paper.definition[part]) do q[name] = entry[1] end
  end
  for _, changes in ipairs { problem.set, problem.refined(p.refinement) } do
    for name, value in pairs(changes) do q[name] = value end
  end
  q.mesh_size = q.mesh_size * p.coarser
  return q
end

local function scene(p)
  local made = problems[p.problem].paper.scene(parameters(p))
  if p.tolerance > 0 then
    made.schedule.accuracy = stiction.accuracy {
      tolerance = p.tolerance, beta_change = p.beta_change, events = problems[p.problem].events,
      factors = 6, -- the plate's steps visit six sizes; without inertia it does not matter
    }
  end
  return made
end

local function value(run, p, name)
  if name == "beta_A" then return (run:max("A", "beta")) end
  for _, entry in ipairs(problems[p.problem].paper.results) do
    if entry.name == name then return entry.compute(run, parameters(p)) end
  end
end

local function measure(index)
  return function(run, p)
    local name = problems[p.problem].quantities[index]
    return name and value(run, p, name) or 0
  end
end

local wanted = 0.01 -- relative error of both quantities

-- With inertia a step of another size wants another factor, and equal steps keep theirs: there the count grows.
local most_factors = { plate = 3.5, fast_bonds = 1 }

-- Costs that are counted; attempts are steps taken and steps cut, work the floating-point operations of all phases.
local counts = { "attempts", "factorizations", "solves", "cells_evaluated", "contact_iterations", "work" }
local function count(case, name)
  if name == "attempts" then return case.cost.steps + case.cost.cuts end
  return case.cost[name]
end

-- Cases of one problem: the finest equal steps, the other equal steps, those under error control.
local function sorted(cases, problem)
  local equal, controlled = {}, {}
  for _, case in ipairs(cases) do
    if case.p.problem == problem then
      local list = case.p.tolerance > 0 and controlled or equal
      list[#list + 1] = case
    end
  end
  table.sort(equal, function(a, b) return a.p.refinement < b.p.refinement end)
  local reference = table.remove(equal)
  return reference, equal, controlled
end

-- Largest relative error of the quantities that count.
local function error_of(case, reference)
  local worst = 0
  for _, name in ipairs { "peak_beta", "peak_adhesion" } do
    worst = math.max(worst, math.abs(case.results[name] / reference.results[name] - 1))
  end
  return worst
end

local function cheapest(list, reference)
  local best
  for _, case in ipairs(list) do
    if error_of(case, reference) <= wanted and (not best or case.cost.work < best.cost.work) then
      best = case
    end
  end
  return best
end

-- A row for each cheapest run, and their ratio.
local function rows_of(name, reference, even, paced)
  local rows, ratio = {}, { name .. ", ratio", "" }
  for i, case in ipairs { even, paced } do
    rows[i] = { case.id, error_of(case, reference) }
    for k, each in ipairs(counts) do
      rows[i][k + 2] = count(case, each)
      ratio[k + 2] = ("%.2f"):format(count(paced, each) / count(even, each))
    end
  end
  return { rows[1], rows[2], ratio }
end

local titles = { plate = "plate (4.2)", rigid = "sphere (4.1)", fast_bonds = "sphere, fast bonds" }
local names = { "plate", "rigid", "fast_bonds" }

-- Error against cost, both of counts, for all runs.
local function cost_figure(cases)
  local curves = {}
  for i, name in ipairs(names) do
    local reference, equal, controlled = sorted(cases, name)
    for k, list in ipairs(reference and { equal, controlled } or {}) do
      local x, y = {}, {}
      table.sort(list, function(a, b) return a.cost.work < b.cost.work end)
      for n, case in ipairs(list) do x[n], y[n] = case.cost.work, math.max(error_of(case, reference), 1e-5) end
      curves[#curves + 1] = { label = titles[name] .. (k == 1 and ", equal steps" or ", error control"), x = x, y = y,
        colour = i, style = k == 1 and "dash" or "solid" }
    end
  end
  return stiction.figure.lines { name = "error_cost", title = "Error of the peaks against cost", legend = "below",
    x = { label = "work, floating-point operations", unit = "1", log = true },
    y = { label = "larger error of peak β and adhesion", unit = "1", log = true }, curves = curves }
end

-- Sizes of the steps over time, and the steps in which something happened.
local function step_figure(name, controlled, even)
  local at, dt, happened = {}, {}, (controlled:series("step", "events"))
  local sizes = controlled:series("step", "dt")
  for k, events in ipairs(happened) do
    if events > 0 then at[#at + 1], dt[#dt + 1] = controlled.time[k], sizes[k] end
  end
  local time, size, equal = {}, {}, (even:series("step", "dt"))
  for k = 2, #sizes do time[k - 1], size[k - 1] = controlled.time[k], sizes[k] end
  return stiction.figure.lines { name = "steps_" .. name, title = titles[name], legend = "below",
    x = { label = "time", unit = "s" }, y = { label = "step", unit = "s", log = true },
    curves = {
      { label = "error control, tolerance " .. controlled.p.tolerance, x = time, y = size, colour = 1 },
      { label = "with touch, separation or an end of β", x = at, y = dt, colour = 2, style = "points" },
      { label = "equal steps within 1 %", x = { even.time[2], even.time[#even.time] }, y = { equal[2], equal[#equal] },
        colour = 3, style = "dash" },
    } }
end

local function list(problem, refinements, tolerances)
  local cases = {}
  for _, r in ipairs(refinements) do cases[#cases + 1] = { problem = problem, refinement = r, tolerance = 0 } end
  for _, t in ipairs(tolerances) do cases[#cases + 1] = { problem = problem, refinement = 1, tolerance = t } end
  return cases
end

local function joined(lists)
  local cases = {}
  for _, each in ipairs(lists) do
    for _, case in ipairs(each) do cases[#cases + 1] = case end
  end
  return cases
end

-- The last refinement is the reference.
local everything = joined {
  list("plate", { 0.5, 1, 1.5, 2, 3, 4, 16 }, { 1e-3, 5e-4, 3e-4, 2e-4, 1e-4 }),
  list("rigid", { 0.5, 1, 1.5, 2, 3, 4, 16 }, { 1e-2, 3e-3, 2e-3, 1e-3, 5e-4 }),
  list("fast_bonds", { 0.125, 0.25, 0.5, 1, 8 }, { 0.3, 0.1, 0.03, 0.01, 1e-3 }),
}
local few = joined {
  list("plate", { 1, 2, 8 }, { 3e-4 }),
  list("rigid", { 1, 1.5, 4 }, { 2e-3 }),
}

return stiction.study {
  title = "Error control while running against ladders of equal steps",
  question = "What do peaks within 1 % cost on both examples, with equal steps and with error control?",
  chosen = {
    beta_change = { 1, "no bound: a bond at rest grows without error, however fast" },
    coarser = { 2, "times the cells of the paper's studies: the error of time is what counts" },
  },
  sweep = everything, quick = { sweep = few },
  case_id = function(p)
    return p.problem .. (p.tolerance > 0 and "_tolerance_" .. p.tolerance or "_equal_" .. p.refinement)
  end,
  scene = scene,
  results = {
    { name = "peak_beta", unit = "1", meaning = "largest bond intensity of the crown or of node A", measure(1) },
    { name = "peak_adhesion", unit = "Pa", meaning = "largest adhesion there", measure(2) },
    { name = "pull_off", unit = "N", meaning = "largest force that the bonds of the sphere hold; 0 of the plate",
      measure(3) },
  },

  check = function(cases, check)
    local rows = {}
    for _, name in ipairs(names) do
      local reference, equal, controlled = sorted(cases, name)
      local even, paced
      if reference then even, paced = cheapest(equal, reference), cheapest(controlled, reference) end
      if reference then
        check.holds(name .. ": equal steps reach 1 %", even ~= nil)
        check.holds(name .. ": error control reaches 1 %", paced ~= nil)
      end
      if even and paced then
        for _, row in ipairs(rows_of(name, reference, even, paced)) do rows[#rows + 1] = row end
        for _, each in ipairs(counts) do
          local bound = each == "factorizations" and most_factors[name] or 0.75
          local ratio = count(paced, each) / count(even, each)
          check.within(("%s: %s over those of equal steps"):format(name, each), ratio, 0, bound)
        end
      end
    end
    local columns = { "run", "error", table.unpack(counts) }
    check.table { title = "The cheapest runs within 1 %", columns = columns, rows = rows }
  end,

  figures = function(cases)
    local figures = { cost_figure(cases) }
    for _, name in ipairs(names) do
      local reference, equal, controlled = sorted(cases, name)
      local even, paced
      if reference then even, paced = cheapest(equal, reference), cheapest(controlled, reference) end
      if even and paced then figures[#figures + 1] = step_figure(name, paced, even) end
    end
    return figures
  end,
}
