-- stiction status: how far a sweep is, who works on it, and whether they live; read from its output folder, anywhere.
local engine = require "stiction.engine"
local evaluation = require "stiction.evaluation"
local fault = require "stiction.fault"
local hold = require "stiction.hold"
local outcomes = require "stiction.outcomes"
local output = require "stiction.output"
local progress = require "stiction.progress"
local report = require "stiction.report"
local standing = require "stiction.standing"
local study_module = require "stiction.study"
local sweep = require "stiction.sweep"

local most_rows, most_failed = 40, 5 -- told

--- Of one case of the study: "done", "failed", "waiting" or what standing knows of it.
local function state_of(plan, case, known)
  local entry = known.cases[case.id]
  local row = not (entry and entry.life == "lives") and evaluation.row_of_ended(plan.study, plan.folder, case)
  if row and row.computed then
    return row.done and "done" or "failed", row.result
  elseif row and not row.damaged and row.result.fingerprint == row.fingerprint then
    return "failed", row.result
  end
  return entry and (entry.life == "dead" and "lost" or "running") or "waiting", entry
end

--- The same of what a folder holds, without its study.
local function state_in(folder, name, known)
  local entry, result = known.cases[name], output.read_result_in(folder .. "/" .. name)
  if entry and entry.life ~= "dead" then
    return "running", entry
  elseif not result or result.verdict == "stopped" then
    return entry and "lost" or "waiting", entry
  end
  return result.verdict == "finished" and "done" or "failed", result
end

--- Lists of {case =, entry =} by state, and the number of all cases: those of the study, or else what the folder shows and workers tell.
local function sort_cases(plan, known)
  local states, total = { done = {}, failed = {}, running = {}, lost = {}, waiting = {} }, 0
  local function add(name, state, entry)
    total = total + 1
    table.insert(states[state], { case = name, entry = entry })
  end
  engine.watch_lines(false) -- no fault of a script is told
  for _, case in ipairs(plan.cases or {}) do
    add(case.id, state_of(plan, case, known))
  end
  for _, path in ipairs(plan.cases and {} or engine.list(plan.folder, false)) do
    if engine.kind_of_path(path .. "/manifest.json") then
      add(path:match("[^/]+$"), state_in(plan.folder, path:match("[^/]+$"), known))
    end
  end
  local seen = total
  for _, worker in ipairs(plan.cases and {} or known.workers) do
    total = math.max(total, worker.told.total)
  end
  for _ = seen + 1, total do
    table.insert(states.waiting, {})
  end
  return states, total
end

local function show_workers(known)
  local rows = { { "worker", "sign of life", "done", "failed", "case", "for", "progress", "left" } }
  for _, worker in ipairs(known.workers) do
    local cases = worker.told.cases
    for i = 1, math.max(1, #cases) do
      local own = cases[i] or {}
      rows[#rows + 1] = { i == 1 and worker.words or "", i == 1 and standing.sign_of_life(worker) or "",
        i == 1 and tostring(worker.told.done) or "", i == 1 and tostring(worker.told.failed) or "", own.case or "-",
        own.seconds and progress.duration(own.seconds) or "", standing.progress(own),
        own.left and progress.duration(own.left) or "" }
    end
  end
  local count = #rows
  if count > 1 then
    report.table(table.move(rows, 1, math.min(count, most_rows + 1), 1, {}))
    report.line(count > most_rows + 1 and ("and %d more lines\n"):format(count - most_rows - 1) or "")
  end
end

local function names(list)
  local words = {}
  for i = 1, math.min(#list, most_failed) do
    local entry = list[i].entry or {}
    words[i] = entry.verdict and ("%s (%s)"):format(list[i].case, entry.verdict) or list[i].case
  end
  return table.concat(words, ", ") .. (#list > most_failed and (" and %d more"):format(#list - most_failed) or "")
end

--- What the workers that live do in a second, all together, and how many they are.
local function rate_of(known)
  local rate, living = 0, 0
  for _, worker in ipairs(known.workers) do
    if worker.life == "lives" then
      living = living + 1
      rate = rate + (worker.told.seconds > 0 and worker.told.done / worker.told.seconds or 0)
    end
  end
  return rate, living
end

local function show(plan)
  local known = standing.read(plan.folder)
  local states, total = sort_cases(plan, known)
  show_workers(known)
  local rate, living = rate_of(known)
  local left = #states.running + #states.lost + #states.waiting
  report.line("%s: %d of %d cases done, %d failed, %d running, %d waiting%s", plan.folder, #states.done, total,
    #states.failed, #states.running, #states.waiting,
    #states.lost > 0 and (", %d lost: %s"):format(#states.lost, names(states.lost)) or "")
  if #states.failed > 0 then
    report.line("failed: %s", names(states.failed))
  end
  if not plan.cases and #known.workers == 0 then
    report.line("cases that have not begun do not show in the folder: 'stiction status STUDY' counts them")
  end
  if left > 0 and living == 0 then
    report.line("nobody works on it; 'stiction run STUDY' goes on from here")
  elseif left > 0 then
    report.line("%d worker%s: %s", living, living == 1 and "" or "s", rate > 0
      and ("%.3g cases/min, left %s"):format(60 * rate, progress.duration(left / rate)) or "no case has ended yet")
  end
  return 0
end

return function(options)
  local folder = outcomes.folder(options.study, options.out)
  local plan = { folder = folder, options = options }
  if engine.kind_of_path(options.study) == "file" or engine.kind_of_path(options.study .. "/study.lua") == "file" then
    plan.study = study_module.load(options.study, options.trust)
    plan.cases = sweep.cases(plan.study, options)
    hold.check_owner(folder, plan.study)
  elseif options.quick or options.set then
    fault.input("--quick and --set choose cases of a study; %s is none", options.study)
  end
  if not plan.study and engine.kind_of_path(folder) ~= "folder" then
    fault.input("there is no output folder %s", folder)
  end
  hold.owner(folder) -- refuses what it cannot read
  return show(plan)
end
