-- A sweep that several runs share: each case is run by the one that claims it, the others take over what it leaves.
local claims = require "stiction.claims"
local engine = require "stiction.engine"
local evaluation = require "stiction.evaluation"
local fault = require "stiction.fault"
local jobs = require "stiction.jobs"
local report = require "stiction.report"

local sharing = {}

local between_looks = 0.5 -- s

--- Takes over what another run has made of a row's case since this one looked; true if there is something but a case that
--- was stopped.
local function look_again(plan, row)
  local new = evaluation.row(plan.study, plan.folder, row.case, true)
  local ended = new.mark ~= row.mark and new.result and new.result.verdict ~= "stopped"
  if not ended or new.result.fingerprint ~= row.fingerprint then
    return false
  end
  row.result, row.mark, row.computed, row.done, row.stale = new.result, new.mark, new.computed, new.done, new.stale
  row.fresh, row.elsewhere = false, true
  return true
end

--- Takes over whatever others have made of the rows that this run has not.
function sharing.refresh(plan, rows)
  for _, row in ipairs(rows) do
    if not row.fresh then
      look_again(plan, row)
    end
  end
end

--- Whether this run may begin the case of a row now; what others have claimed lands in `taken`.
local function take(plan, row, taken)
  if row.elsewhere or look_again(plan, row) then
    return false
  end
  local mine, worker = plan.office:take(row.case.id)
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

--- Lives on, and gives up cases that others have taken while this process slept.
local function tick(plan, running)
  if plan.office:beat() then
    for _, job in ipairs(running) do
      job.lost = not plan.office:owns(job.case.id)
    end
  end
end

--- As jobs.run, with the cases shared: what others run is waited for, and taken over if they end before it does.
function sharing.run(plan, row_of, cases, settings, on_end)
  local bad, told = false, false
  local function ended(case, result)
    bad = bad or result.bad_input
    on_end(case, result)
    plan.office:release(case.id)
  end
  while #cases > 0 and not bad do
    local taken = {}
    settings.take = function(case) return take(plan, row_of[case.id], taken) end
    settings.tick = function(running) tick(plan, running) end
    if jobs.run(cases, settings, ended) == "stopped" then
      return "stopped"
    elseif #taken > 0 and not told then
      report.line("waiting for %d case%s that other runs do", #taken, #taken == 1 and "" or "s")
      told = true
    end
    engine.await({}, #taken > 0 and between_looks or 0)
    if engine.stopped() then
      return "stopped"
    end
    cases = taken
  end
end

--- f(plan, ...) with plan.office open: the folder is shared.
function sharing.with(plan, f, ...)
  plan.office = claims.open(plan.folder)
  local answers = table.pack(engine.call(f, plan, ...))
  plan.office:close()
  if not answers[1] then
    error(answers[2], 0)
  end
  return table.unpack(answers, 2, answers.n)
end

return sharing
