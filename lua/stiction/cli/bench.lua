-- stiction bench: cases timed phase by phase: one of a study, or those that the workbench is judged by.
local engine = require "stiction.engine"
local fault = require "stiction.fault"
local hold = require "stiction.hold"
local jobs = require "stiction.jobs"
local loader = require "stiction.loader"
local ordered = require "stiction.ordered"
local output = require "stiction.output"
local report = require "stiction.report"
local study_module = require "stiction.study"
local sweep = require "stiction.sweep"

-- Sliding in the plane, indentation in a section, and a quarter in space with 50 000 unknowns, a few steps of it.
local standard = {
  { study = "paper/plate_on_cylinder" },
  { study = "paper/sphere_indentation", case = "A_rigid" },
  { study = "paper/sphere_indentation", case = "A_space",
    set = { "mesh_size_3d=0.213 mm", "steps_down=3" } },
}

local function measure(options, study, case, folder)
  local found
  local settings = { study = options.study, folder = folder, quick = options.quick, set = options.set,
    trust = options.trust, jobs = 1, threads = options.threads or 1, quiet = true, alone = true,
    force = true, patience = 0 } -- a measurement that is broken off leaves nothing to close
  hold.note(folder, study)
  output.settle(folder, { case })
  local stopped = jobs.run({ case }, settings, function(_, result)
    found = result
  end)
  if stopped then
    fault.run("stopped by the user")
  elseif found.bad_input then
    fault.input("%s", found.reason)
  elseif found.verdict ~= "finished" then
    fault.run("%s: %s: %s", case.id, found.verdict, found.reason)
  end
  return found
end

--- Processor time of the case's process; other: its start and reading the study as well.
local function show_phases(result)
  local rows, known, all = { { "phase", "s", "%" } }, 0, result.counters.cpu_seconds
  local function add(name, seconds)
    rows[#rows + 1] = { name, ("%.3f"):format(seconds), ("%.1f"):format(100 * seconds / all) }
  end
  for _, name in ipairs(ordered.keys(result.phases)) do
    known = known + result.phases[name]
    add(name, result.phases[name])
  end
  add("other", all - known)
  add("all", all)
  report.table(rows)
end

local function show_counters(result)
  local rows = {}
  for _, name in ipairs { "steps", "iterations", "factorizations", "cuts" } do
    rows[#rows + 1] = { name, ("%d"):format(result[name]) }
  end
  for _, name in ipairs(ordered.keys(result.counters)) do
    rows[#rows + 1] = { name, ("%.6g"):format(result.counters[name]) }
  end
  report.line()
  report.table(rows)
end

--- {needed, times: what was needed of each, s alone, s for all of them}, and the sum over all. Of a formula there is nothing.
local function limit(result)
  local counters, parts, sum = result.counters, {}, 0
  local function add(name, times)
    local each = counters["alone_" .. name]
    if not each then
      return
    end
    parts[#parts + 1] = { name, times, each, times * each }
    sum = sum + times * each
  end
  add("force_pass", counters.force_passes)
  add("stiffness_pass", counters.stiffness_passes)
  add("factorization", result.factorizations)
  add("solve", counters.solves)
  add("product", counters.products)
  add("preconditioning", counters.preconditionings)
  return parts, sum
end

--- What the case took beside passes, factorizations and solves that could not be done without.
local function show_limit(result)
  local rows, parts, sum = { { "needed", "times", "ms alone", "s" } }, limit(result)
  if #parts == 0 then
    return
  end
  for _, part in ipairs(parts) do
    rows[#rows + 1] = { part[1], ("%d"):format(part[2]), ("%.3g"):format(1e3 * part[3]), ("%.3f"):format(part[4]) }
  end
  rows[#rows + 1] = { "all", "", "", ("%.3f"):format(sum) }
  report.line()
  report.table(rows)
  report.line()
  report.line("%.2f times what it cannot do without; %.3g ms per iteration; peak memory %.0f MB",
    result.counters.cpu_seconds / sum, 1e3 * result.counters.cpu_seconds / result.iterations,
    result.counters.peak_memory / 1e6)
end

local function bench(options)
  local study = study_module.load(options.study, options.trust)
  local cases = sweep.cases(study, options)
  local case = options.case and sweep.find(cases, options.case) or cases[1]
  local folder = "out/bench/" .. study.name
  local result = hold.folder(folder, study, "bench", measure, options, study, case, folder)
  if options.json then
    return {
      study = study.name, case = case.id, seconds = result.seconds, steps = result.steps,
      iterations = result.iterations, factorizations = result.factorizations, cuts = result.cuts,
      phases = result.phases, counters = result.counters, limit = select(2, limit(result)),
    }
  end
  report.line("%s, case %s", study.title, case.id)
  show_phases(result)
  show_counters(result)
  show_limit(result)
end

return function(options)
  local found = {}
  if options.study then
    found = bench(options)
  else
    for i, entry in ipairs(standard) do
      if i > 1 and not options.json then report.line() end
      found[i] = bench { study = loader.own_study(entry.study), case = entry.case, set = entry.set or {}, quick = options.quick,
        threads = options.threads, trust = options.trust, json = options.json }
    end
  end
  if options.json then
    engine.write(engine.encode_json(found, 2) .. "\n")
  end
  return 0
end
