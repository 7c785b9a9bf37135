-- What a run's results may be off by: `stiction run --accuracy`, the cheapest measured settings that are near enough, and
-- `--check-accuracy`. A claim is made of the scene that was measured, or of what is measured now.
local claim = require "stiction.trade.claim"
local copy = require "stiction.copy"
local fault = require "stiction.fault"
local ladder = require "stiction.ladder"
local numeric = require "stiction.numeric"
local ordered = require "stiction.ordered"
local output = require "stiction.output"
local quantity_module = require "stiction.trade.quantity"
local recheck = require "stiction.trade.recheck"
local record = require "stiction.trade.record"
local report = require "stiction.report"
local sweep = require "stiction.sweep"

local accuracy = {}

local rounding = 1e-9
local told = 3 -- cases without a claim that are named
local of_cells = { "cells lock", "are too stiff", "depend on the mesh" } -- what warnings say of them

--- 0.02 of "2%" or "0.02"; bad input else.
function accuracy.share(text)
  local number, percent = text:match("^%s*([%d.]+[eE]?[-+]?%d*)%s*(%%?)%s*$")
  local share = tonumber(number)
  if not share or share <= 0 then
    fault.input("--accuracy %s: write a share above 0, as 2%% or 0.02", text)
  elseif percent == "" and share >= 1 then
    fault.input("--accuracy %s: a share without %% is one of 1, as 0.02; did you mean %s%%?", text, number)
  end
  return percent == "%" and share / 100 or share
end

--- The run of least work whose bound is within `share`, nil and the best bound there is if none is; `bound_of(run)` is
--- its own by default.
function accuracy.cheapest(runs, share, bound_of)
  local best, nearest = nil, math.huge
  for _, run in ipairs(runs) do
    local bound = (bound_of and bound_of(run) or not bound_of and run.bound) or math.huge
    nearest = math.min(nearest, bound)
    if bound <= share and (not best or run.work < best.work) then
      best = run
    end
  end
  return best, nearest
end

--- Names of all that the trade of a study measures, and the set of those that decide by default.
local function measured_names(study)
  local names, judged = {}, {}
  for i, quantity in ipairs(quantity_module.list(study, select(2, sweep.knobs(study, {})))) do
    names[i], judged[quantity.name] = quantity.name, not quantity.watched or nil
  end
  return names, judged
end

--- Of names, those whose reference is as sure as it says; words on the others, a list.
local function sure_names(references, names)
  local sure, doubts = {}, {}
  for _, name in ipairs(names) do
    local doubt = (references[name] or {}).doubt
    sure[#sure + 1] = not doubt and name or nil
    doubts[#doubts + 1] = doubt and ("%s: how far it is off is not known: %s"):format(name, doubt) or nil
  end
  return sure, doubts
end

--- Largest error of a run in the quantities named, the reference's own included, relative; nil where it has none.
local function bound_in(run, references, names, judged)
  local bound = #names > 0 and 0 or nil
  for _, name in ipairs(names) do
    local reference, error = references[name], (run.errors or {})[name]
    local scale = reference and (judged[name] and reference.scale or math.abs(reference.value))
    if not error or scale == 0 then
      return nil
    end
    bound = math.max(bound, (error * reference.scale + reference.uncertainty) / scale)
  end
  return bound
end

--- Parameters of a kept run, read from its settings.
local function parameters_of(study, run)
  local settings = numeric.map(ordered.keys(run.settings), function(name) return name .. "=" .. run.settings[name] end)
  return select(2, sweep.knobs(study, { set = settings }))
end

--- What the trade knows of its own scene, a list by run: {p =, values =, errors = {by quantity, SI; of a curve relative
--- to its norm}}.
local function scenes_of(study, kept, wanted)
  local list = {}
  for _, run in ipairs(kept.runs) do
    local scene = { p = run.errors and parameters_of(study, run), values = run.values, errors = {} }
    for name, error in pairs(run.errors or {}) do
      local reference = kept.references[name]
      if not reference.doubt and (not wanted or numeric.first_where(wanted, function(other) return other == name end)) then
        scene.errors[name] = error * reference.scale + reference.uncertainty
      end
    end
    list[#list + 1] = scene.p and scene or nil
  end
  return list
end

--- What --set says of a parameter, nil if nothing.
local function set_by_hand(options, name)
  local at = numeric.first_where(options.set or {}, function(setting) return setting:match("^%s*([%w_]+)%s*=") == name end)
  return at and options.set[at]
end

--- The plan's options with the settings of its accuracy, and {share =, of = (names or nil), scenes =, chosen =}. What the
--- user sets by hand stays set.
function accuracy.choose(study, options)
  local names, judged = measured_names(study)
  local of = claim.names(options.of, names)
  if not options.accuracy then
    return options, { of = of, judged = judged, scenes = {} }
  end
  local share, kept = accuracy.share(options.accuracy), record.read(study, options.study)
  local sure, doubts = sure_names(kept.references, of or ordered.keys(judged))
  local function bound_of(run)
    return bound_in(run, kept.references, sure, judged)
  end
  local run, nearest = accuracy.cheapest(kept.runs, share, bound_of)
  if #sure == 0 or of and #doubts > 0 then
    fault.input("--accuracy %s: %s", options.accuracy, table.concat(doubts, "; "))
  elseif not run then
    fault.input("--accuracy %s: the best that was measured is %.2g%%; give 'trade' finer levels and measure them: "
      .. "'stiction trade %s'", options.accuracy, 100 * nearest, options.study)
  end
  local settings, words, overruled = {}, {}, nil
  for _, name in ipairs(ordered.keys(run.settings)) do
    settings[#settings + 1] = name .. "=" .. run.settings[name]
    words[#words + 1] = ("%s = %s"):format(name, run.settings[name])
    overruled = overruled or set_by_hand(options, name)
  end
  report.line("--accuracy %s%s: %s (off by at most %.2g%% in the scene that was measured, %.2g of the default's work)",
    options.accuracy, of and " of " .. table.concat(of, ", ") or "", table.concat(words, ", "), 100 * bound_of(run),
    run.work / accuracy.default_work(kept.runs))
  if overruled then
    report.line("--set %s stands instead, and that is not what these words are of", overruled)
  end
  for _, doubt in ipairs(doubts) do
    report.line("%s", doubt)
  end
  local own = copy(options)
  own.set = table.move(options.set or {}, 1, #(options.set or {}), #settings + 1, settings)
  return own, { share = share, of = of, judged = judged, scenes = scenes_of(study, kept, of),
    chosen = parameters_of(study, run) }
end

--- Names of the parameters in which p differs from q.
local function differences(p, q)
  local names = {}
  for _, name in ipairs(ordered.keys(q)) do
    names[#names + 1] = not ladder.same(p[name], q[name]) and name or nil
  end
  return names
end

--- The measured scene whose parameters a case has, all of them; nil if there is none.
function accuracy.scene_of(scenes, p)
  return scenes[numeric.first_where(scenes, function(scene) return #differences(p, scene.p) == 0 end)]
end

--- Says of which cases nothing is known.
local function tell_unknown(own, cases, options)
  local lines = {}
  for _, case in ipairs(cases) do
    local words = {}
    for i, name in ipairs(differences(case.p, own.chosen)) do
      words[i] = ("%s = %s, measured with %s"):format(name, report.value(case.p[name]), report.value(own.chosen[name]))
    end
    lines[#lines + 1] = ("%s: not the scene that was measured (%s)"):format(case.id, table.concat(words, "; "))
  end
  for i = 1, math.min(told, #lines) do
    report.line("%s", lines[i])
  end
  if #lines > told then
    report.line("and %d more", #lines - told)
  end
  if #lines > 0 and not options.check_accuracy then
    report.line("How far these results are off is not known: the settings are a guess, and no error is written. "
      .. "--check-accuracy measures it: the same cases with each setting a level finer.")
  end
end

--- What is known before anything runs: {names = (columns), of = {by case, {by name}}}.
function accuracy.known(own, cases, options)
  local claims, unknown, seen = { of = {} }, {}, {}
  for _, case in ipairs(cases) do
    local scene = accuracy.scene_of(own.scenes, case.p)
    claims.of[case.id] = scene and scene.errors
    unknown[#unknown + 1] = not scene and case or nil
    for name in pairs(scene and scene.errors or {}) do
      seen[name] = true
    end
  end
  if options.accuracy then
    tell_unknown(own, unknown, options)
  end
  claims.names = ordered.keys(seen)
  return claims
end

--- "2.5%", or what there is to say where there is no share.
local function share_words(its)
  if not its then
    return "not known"
  elseif its.unmoved then
    return ("not known: %s = %s moves others and leaves it exactly as it is; it may take steps"):format(its.unmoved.knob,
      report.value(its.unmoved.value))
  end
  return its.relative < math.huge and ("%.2g%%"):format(100 * its.relative)
    or its.absolute < math.huge and ("%.2g in SI, and it is 0 here"):format(its.absolute) or "of a curve that is 0 here"
end

--- {absolute by name} of what was found for a case, with its words, and the largest relative one that decides.
local function settle(own, id, found)
  local absolute, words, worst = {}, {}, 0
  for _, name in ipairs(own.of or ordered.keys(found)) do
    local its = found[name]
    absolute[name] = its and its.absolute
    if own.of or its.judged then
      worst = math.max(worst, its and its.relative or math.huge)
      words[#words + 1] = name .. " " .. share_words(its)
    end
  end
  local most = worst < math.huge and ("off by at most %.2g%%"):format(100 * worst) or "the share that it is off by is not known"
  report.line("%s: %s (%s)", id, most, table.concat(words, ", "))
  return absolute, worst
end

--- Measures what is not known of the rows that have finished, into plan.claims and plan.accuracy.worst; what ended it
--- early, if anything.
function accuracy.recheck(plan, rows)
  local open = {}
  for _, row in ipairs(rows) do
    local wanted = not plan.wanted or plan.wanted[row.case.id]
    open[#open + 1] = wanted and row.done and not plan.claims.of[row.case.id] and row or nil
  end
  local found, stopped = recheck.run(plan, open)
  local seen, own = {}, plan.accuracy
  own.worst = {}
  for _, name in ipairs(plan.claims.names) do
    seen[name] = true
  end
  for _, row in ipairs(stopped and {} or open) do
    local id = row.case.id
    local its = found[id]
    own.worst[id] = math.huge
    if its.reason then
      report.line("%s: how far it is off is not known: %s", id, its.reason)
    else
      plan.claims.of[id], own.worst[id] = settle(own, id, its.of)
      for name in pairs(plan.claims.of[id]) do
        seen[name] = true
      end
    end
  end
  plan.claims.names = ordered.keys(seen)
  return stopped
end

--- Says which claims stand on cells that explain warns of: they are of what settings a level finer change, or those of the trade.
local function tell_doubts(plan, rows)
  local of, texts = {}, {}
  for _, row in ipairs(rows) do
    for _, warning in ipairs(row.done and plan.claims.of[row.case.id] and row.result.warnings or {}) do
      local text = tostring(warning.text)
      if numeric.first_where(of_cells, function(words) return text:find(words, 1, true) end) then
        texts[#texts + 1] = not of[text] and text or nil
        of[text] = of[text] or {}
        table.insert(of[text], row.case.id)
      end
    end
  end
  for _, text in ipairs(texts) do
    report.line("What is claimed of %s may be too little, as finer cells than were tried may change more: %s",
      #of[text] > told and ("%d cases"):format(#of[text]) or table.concat(of[text], ", "), text)
  end
end

--- Keeps with the cases what their results may be off by.
function accuracy.keep(plan, rows)
  tell_doubts(plan, rows)
  for _, row in ipairs(rows) do
    local errors, any = {}, false
    for name, error in pairs(row.done and plan.claims.of[row.case.id] or {}) do
      if error < math.huge then
        errors[name], any = { value = row.result.results[name], error = error }, true
      end
    end
    if any then
      row.result.errors = errors
      output.write_result(plan.folder, row.case, row.result)
    end
  end
end

--- Checks that a measured scene among the cases still gives what was measured: what the program has changed since by more
--- than the error it promises makes that promise void. And that what was found now is within the share asked for.
function accuracy.check(own, cases, check)
  for _, case in ipairs(cases) do
    local scene, worst = accuracy.scene_of(own.scenes, case.p), (own.worst or {})[case.id]
    for _, name in ipairs(ordered.keys(scene and scene.values or {})) do
      local was, error = scene.values[name], scene.errors[name]
      if error then
        check.equal(("%s: %s within its error of what its trade measured"):format(case.id, name), case.results[name],
          was, math.max(error, rounding * math.abs(was)))
      end
    end
    if own.share and worst then
      check.within(("%s: off by no more than asked for"):format(case.id), worst, 0, own.share)
    end
  end
end

--- Work of the default settings; NaN where they did not finish.
function accuracy.default_work(runs)
  for _, run in ipairs(runs) do
    if run.default then
      return run.work or 0 / 0
    end
  end
  return 0 / 0
end

return accuracy
