-- stiction fit: parameters from measured curves, with errors that hold what the data and the simulation do not know.
local advice = require "stiction.fit.advice"
local copy = require "stiction.copy"
local correlated = require "stiction.fit.correlated"
local drawing = require "stiction.drawing"
local fault = require "stiction.fault"
local finer = require "stiction.fit.finer"
local hold = require "stiction.hold"
local judge = require "stiction.fit.judge"
local model_module = require "stiction.fit.model"
local numeric = require "stiction.numeric"
local ordered = require "stiction.ordered"
local output = require "stiction.output"
local pictures = require "stiction.fit.pictures"
local profile = require "stiction.fit.profile"
local provenance = require "stiction.provenance"
local record = require "stiction.fit.record"
local report = require "stiction.report"
local search = require "stiction.fit.search"
local starts_module = require "stiction.fit.starts"
local spec = require "stiction.fit.spec"
local study_module = require "stiction.study"
local verdict = require "stiction.fit.verdict"

local enough = 0.04 -- of the squares of standard errors: the search ends within a tenth of one
local most_starts, most_restarts = 3, 2 -- of the best points from which it is looked for a minimum; where a profile met a lower one

local told = { start = true, step = true }

--- Tells how an evaluation went.
local function teller(fit)
  return function(entry, number)
    if entry.failed then
      report.line("%3d  %-10s failed, taken as too far: %s", number, entry.word, entry.failed:match("^[^\n]*"))
    elseif told[entry.word] and entry.cost then
      local words = {}
      for k, own in ipairs(fit.parameters) do
        words[k] = ("%s = %s"):format(own.name, verdict.words(own, entry.values[k]))
      end
      report.line("%3d  %-10s squares %.6g  %s", number, entry.word, entry.cost, table.concat(words, ", "))
    end
  end
end

--- Bad input if nobody asks for a parameter: neither the study has it, nor does a comparison read it.
local function check_read(fit, study)
  for _, own in ipairs(fit.parameters) do
    local read = own.setting
    for _, curve in ipairs(fit.curves) do
      read = read or curve.read[own.key] and (not own.curve or own.curve == curve.name)
    end
    if not read then
      local known = numeric.map(fit.parameters, function(other) return other ~= own and other.key or "" end)
      table.move(ordered.keys(study.given), 1, #ordered.keys(study.given), #known + 1, known)
      table.move(ordered.keys(study.chosen), 1, #ordered.keys(study.chosen), #known + 1, known)
      fault.input("study.fit: the study has no parameter '%s'%s, and no `against` reads it", own.key, fault.meant(own.key, known))
    end
  end
end

--- The first batch: starts, with the runs that tell the noise. Bad input where the study's own start fails and no other does.
local function begin(fit, model, study)
  local starts = starts_module.of(fit.parameters, math.tointeger(fit.starts))
  local answers = model:evaluate(starts, "start")
  local good = numeric.first_where(answers, function(answer) return answer.r ~= nil end)
  if not good then
    fault.input("study.fit: %s fails: %s", #starts > 1 and ("each of the %d starts"):format(#starts) or "the start", answers[1].failed)
  elseif answers[1].failed then
    report.line("the study's own start fails; the others go on")
  end
  check_read(fit, study)
  local reason = model:set_steps(starts[good])
  if reason then
    report.line("the noise of the runs could not be measured (%s); a millionth is taken", reason:match("^[^\n]*"))
  end
  return starts, answers
end

local function about(fit, model)
  return { curves = fit.curves, noise = model.noise, share = model.share }
end

--- The lowest minimum with its judgement and profiles; all minima; the cases of the search alone.
local function look(fit, model, study, options)
  local problem = model:problem(enough)
  local starts, answers = begin(fit, model, study)
  local minima = search.run(problem, starts, most_starts, answers)
  minima = correlated.settle(problem, minima, fit.curves, function(i, length)
    report.line("the noise of %s is correlated over %s", fit.curves[i].name, fit.curves[i]:along_x(length))
    model:weigh_noise()
  end)
  local cases = #model.points.rows
  local found, judged, intervals = minima[1], nil, nil
  for round = 0, most_restarts do
    judged = judge.of(problem, found, about(fit, model))
    if not fit.profiles or options.no_profiles then
      break
    end
    local lower
    intervals, lower = profile.of(problem, found, judged)
    judged.undercut = lower ~= nil
    if not lower or round == most_restarts then
      break
    end
    report.line("a profile met a lower point; the search goes on from there")
    minima = correlated.settle(problem, search.run(problem, { lower, found.z }, 1), fit.curves, function() model:weigh_noise() end)
    found = minima[1]
  end
  return found, judged, intervals, minima, cases
end

local function interval_words(own, interval)
  local function end_of(value, open)
    return value and ("%.4g"):format((verdict.shown(own, value))) or open
  end
  if not interval then
    return "at its bound"
  end
  local function word(side)
    return end_of(interval[side], interval.bound == side and "at its bound" or "open")
  end
  return ("%s .. %s"):format(word("low"), word("high"))
end

local function percent(value)
  return value and ("%.2g"):format(100 * value) or "-"
end

local function show(fit, result)
  local judged, rows = result.judged, { { "parameter", "best", "unit", "95 % from .. to", "data/%", "simulation/%", "" } }
  for k, own in ipairs(fit.parameters) do
    local number, unit = verdict.shown(own, judged.values[k])
    rows[#rows + 1] = { own.name, ("%.5g"):format(number), unit, interval_words(own, result.intervals[k]), percent(judged.relative[k]),
      result.own_error.known and percent(result.own_error.relative[k]) or "?",
      verdict.word(judged, result.own_error, k) }
  end
  report.line()
  report.table(rows)
  for _, line in ipairs(result.lines) do
    report.line("%s", line)
  end
  for i = 1, math.min(3, #result.advice) do
    local words = advice.said(fit, result.advice[i])
    if words then
      report.line("%s %s", i == 1 and "further measurements:" or "  or", words)
    end
  end
  for i = 2, #result.minima do
    if result.minima[i].ended == "there" then
      report.line("another minimum has squares %.4g", result.minima[i].at.cost)
    end
  end
end

local function show_cost(result)
  report.line("%d cases (%d of the search), %d of them run now, %d kept", result.cases, result.search_cases, result.ran, result.kept)
end

local function run(fit, model, study, options, folder)
  report.line("%d points of %d curve%s, %d parameter%s", fit.count, #fit.curves, #fit.curves == 1 and "" or "s", #fit.parameters,
    #fit.parameters == 1 and "" or "s")
  provenance.keep(folder, study, fit.files)
  local result = { folder = folder }
  local found, judged, intervals, minima, cases = look(fit, model, study, options)
  result.found, result.judged, result.profiles, result.minima, result.search_cases = found, judged, intervals, minima, cases
  result.own_error = finer.of(model, study, options, found, judged)
  verdict.settle(judged, result.own_error, found)
  judge.stretch(fit, judged, intervals)
  judge.decide(judged, intervals and judge.by_profiles(fit.parameters, judged, intervals) or judged.relative)
  result.advice = advice.of(model, found, judged)
  result.intervals = {}
  for k in ipairs(fit.parameters) do
    result.intervals[k] = verdict.interval(fit, judged, intervals, result.own_error, k)
  end
  result.lines = verdict.lines(fit, judged, result.own_error, found, intervals)
  result.cases, result.ran, result.kept = #model.points.rows, model.points.ran, model.points.known
  result.log, result.noise, result.share = model.log, model.noise, model.share
  result.best_cases = found.at.cases
  record.write(fit, study, options, result)
  show(fit, result)
  show_cost(result)
  local drawn = options.no_figures
    or drawing.draw({ figures = function() return pictures.of(fit, result) end }, {}, folder)
  report.line("output: %s", folder)
  return drawn and not judged.rejected and 0 or 1
end

--- Fits a study's parameters; the exit code: 1 if the model is rejected.
return function(options)
  options = copy(options)
  local study = study_module.load(options.study, options.trust)
  local fit = spec.read(study, options)
  advice.check(fit)
  finer.variants(fit, study, options)
  local folder = options.out or output.folder(study, options) .. "/fit"
  local model = model_module.open(fit, study, options, folder, teller(fit))
  return hold.folder(folder, study, "fit", run, fit, model, study, options, folder)
end
