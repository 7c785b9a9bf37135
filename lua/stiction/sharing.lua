-- A sweep that several runs share: each case is run by the one that claims it, the others take over what it leaves.
local claims = require "stiction.claims"
local engine = require "stiction.engine"
local evaluation = require "stiction.evaluation"
local fault = require "stiction.fault"
local jobs = require "stiction.jobs"
local output = require "stiction.output"
local report = require "stiction.report"

local sharing = {}

local looks = { first = 0.5, last = 5 } -- s, between looks at what others do
local standby = "=standby" -- the claim of the worker that waits for the last cases, and judges them
local room = 1 << 20 -- bytes that must fit where a case did not end well

--- Takes over what another run has made of a row's case since this one looked; true if there is something but a case that
--- was stopped.
local function look_again(plan, row)
  local new = evaluation.row(plan.study, plan.folder, row.case, true)
  local ended = new.mark ~= row.mark and new.result and new.result.verdict ~= "stopped"
  if not ended or new.result.fingerprint ~= row.fingerprint then
    return false
  end
  row.result, row.mark, row.computed, row.done, row.stale = new.result, new.mark, new.computed, new.done, new.stale
  row.place = new.place
  row.fresh, row.elsewhere = false, true
  return true
end

--- Takes over whatever others have made of the rows that this run has not.
function sharing.refresh(plan, rows)
  for _, row in ipairs(rows) do
    if not row.fresh and not (row.computed and plan.options.worker) then
      look_again(plan, row)
    end
  end
end

--- A worker that slept so long elsewhere that it was taken for dead may still write: into files that are no longer these.
local function detach(folder)
  for _, path in ipairs(engine.list(folder, true)) do
    engine.write_file(path, engine.read_file(path))
  end
end

--- Whether this run may begin the case of a row now; what others have claimed lands in `taken`.
local function take(plan, row, taken)
  if row.elsewhere or look_again(plan, row) then
    return false
  end
  local mine, worker = plan.office:take(row.case.id)
  if mine and plan.office:inherits(row.case.id) then
    detach(plan.folder .. "/" .. row.case.id)
  end
  if mine and look_again(plan, row) then
    plan.office:release(row.case.id)
    return false
  elseif not mine and not plan.options.join then
    fault.input("case %s is being run by %s; wait until that ends, or share the sweep with --join", row.case.id,
      claims.words(worker))
  elseif not mine then
    taken[#taken + 1] = row.case
  end
  return mine
end

--- Gives up cases that others have taken while this process slept.
local function give_up(plan, running)
  local now = engine.clock()
  if now - (plan.looked or -math.huge) >= claims.between_beats then
    plan.looked = now
    for _, job in ipairs(running) do
      job.lost = not plan.office:owns(job.case.id)
    end
  end
end

--- A fault if a case did not end well where nothing can be written: that is not the case's, which is left to others.
local function check_disk(plan, case, result)
  if result.verdict == "finished" or result.verdict == "result failed" or result.verdict == "stopped" then
    return
  end
  local trial = ("%s/.claims/trial.%s"):format(plan.folder, plan.office.worker)
  local held, reason = engine.call(engine.write_file, trial, (" "):rep(room))
  engine.remove(trial)
  if not held then
    output.forget_result(plan.folder .. "/" .. case.id)
    fault.run("%s: this run ends, and leaves case %s and all others to those that can write", tostring(reason), case.id)
  end
end

--- Whether a worker is to wait for what others do: one does, which also judges the sweep, the others may go.
local function may_go(plan)
  local mine, other = plan.office:take(standby)
  if not mine then
    report.line("no case is left to begin; %s waits for the last ones", claims.words(other))
  end
  return not mine
end

--- Waits a while for other runs, a longer one each time.
local function wait(plan, taken, pause)
  if pause == looks.first then
    report.line("waiting for %d case%s that other runs do", #taken, #taken == 1 and "" or "s")
  end
  engine.await({}, pause)
  return plan.options.worker and math.min(1.3 * pause, looks.last) or pause + 1e-9
end

--- As jobs.run, with the cases shared: what others run is waited for, and taken over if they end before it does. Of
--- workers one waits; "left" of the others.
function sharing.run(plan, row_of, cases, settings, on_end)
  local bad, pause, tell = false, looks.first, settings.tick
  local function ended(case, result)
    if plan.options.join then
      check_disk(plan, case, result)
    end
    bad = bad or result.bad_input
    on_end(case, result)
    plan.office:release(case.id)
  end
  settings.tick = function(running)
    give_up(plan, running)
    tell(running)
  end
  while #cases > 0 and not bad do
    local taken = {}
    settings.take = function(case) return take(plan, row_of[case.id], taken) end
    if jobs.run(cases, settings, ended) == "stopped" then
      return "stopped"
    elseif plan.options.worker and not bad and may_go(plan) then
      return "left"
    end
    pause = #taken > 0 and wait(plan, taken, pause) or pause
    if engine.stopped() then
      return "stopped"
    end
    cases = taken
  end
end

--- The cases in an order of this worker's own, so that many do not all try the same.
function sharing.spread(cases, worker)
  local task = tonumber(select(2, claims.batch_job()) or "")
  local share = task and task * 0.6180339887498949 % 1 or tonumber(engine.hash(worker):sub(1, 8), 16) / 2^32
  local first, list = math.floor(share * #cases), {}
  for i = 1, #cases do
    list[i] = cases[(first + i - 1) % #cases + 1]
  end
  return list
end

--- f(plan, ...) in a folder that is shared.
function sharing.with(plan, f, ...)
  plan.office = claims.of(plan.folder)
  return f(plan, ...)
end

return sharing
