-- What a fit leaves: fit.json (everything in SI), fit.csv (its evaluations), curves.csv (data, model, residuals).
local combination = require "stiction.fit.combination"
local csv = require "stiction.csv"
local engine = require "stiction.engine"
local judge = require "stiction.fit.judge"
local numeric = require "stiction.numeric"
local space = require "stiction.fit.space"
local units = require "stiction.units"
local verdict = require "stiction.fit.verdict"

local record = {}

local function unit_of(own)
  return units.is_quantity(own.like) and engine.dimension_text(own.like.metre, own.like.kilogram, own.like.second) or "1"
end

local function named(fit, powers)
  local list = setmetatable({}, { json = "object" })
  for k, x in pairs(powers) do
    list[fit.parameters[k].name] = x
  end
  return list
end

local function parameters_of(fit, result)
  local list, judged = {}, result.judged
  for k, own in ipairs(fit.parameters) do
    local interval, profile = result.intervals[k], result.profiles and result.profiles[k]
    list[k] = { name = own.name, key = own.key, curve = own.curve, unit = unit_of(own), from = own.from, to = own.to, log = own.log,
      start = own.start, best = judged.values[k], shown = verdict.words(own, judged.values[k], 6), error = judged.errors[k],
      relative_error = judged.relative[k], verdict = verdict.word(judged, result.own_error, k), interval = interval,
      simulation_error = interval and interval.simulation, profile = profile and profile.points }
  end
  return list
end

local function advice_of(fit, result)
  return numeric.map(result.advice, function(own)
    return { measurement = own.words, bits = own.bits, error_becomes = own.shrinks, of = own.parameter
      and fit.parameters[own.parameter].name, reason = own.reason }
  end)
end

local function runs_of(fit, judged)
  local list = {}
  for i, chance in ipairs(judged.runs) do
    list[i] = { curve = fit.curves[i].name, chance = chance or nil }
  end
  return list
end

local function curves_of(fit, judged)
  local list = {}
  for i, curve in ipairs(fit.curves) do
    local told = judged.correlated[i]
    list[i] = { name = curve.name, points = #curve.x, worth = curve:effective(), correlation = curve.length, covariance = curve.covariance,
      correlation_estimated = curve.estimated, residuals_tell = told and { correlation = told.length, chance = told.chance } or nil }
  end
  return list
end

--- All of it as a table for JSON.
function record.table(fit, study, options, result)
  local judged = result.judged
  return { study = study.source.file, name = study.name, title = study.title, question = study.question, version = engine.version,
    quick = options.quick or false, set = options.set or {}, files = fit.files, level = judge.level,
    parameters = parameters_of(fit, result),
    squares = judged.squares, degrees_of_freedom = judged.degrees, errors_known = fit.known, loss = fit.loss,
    chance_of_squares = judged.chance, widened_by = judged.stretch, runs = runs_of(fit, judged), rejected = judged.rejected,
    curves = curves_of(fit, judged),
    misfit_of_the_simulation = judged.coarse,
    free = numeric.map(judged.free, function(k) return fit.parameters[k].name end),
    covariance = judged.covariance, correlations = judged.correlations, eigenvalues = judged.eigenvalues,
    directions = judged.directions,
    combinations = numeric.map(judged.combinations, function(own)
      return { powers = named(fit, own.powers), words = combination.words(fit.parameters, own.powers, judged), relative_error = own.error }
    end),
    simulation = { known = result.own_error.known or false, reason = result.own_error.reason,
      finer = result.own_error.variants },
    further = advice_of(fit, result), says = result.lines, noise = result.noise, difference = result.share,
    minima = numeric.map(result.minima, function(own)
      return { squares = own.at.cost, values = space.values(fit.parameters, own.z), ended = own.ended, gain_promised = own.promised }
    end),
    cases = result.cases, cases_of_search = result.search_cases, cases_of_best = result.best_cases, evaluations = #result.log }
end

local function write_log(fit, result)
  local head = { "number", "for" }
  for _, own in ipairs(fit.parameters) do
    head[#head + 1] = own.name
  end
  local lines = { table.concat(numeric.map(head, csv.word), ",") .. ",squares,failed,cases" }
  for i, entry in ipairs(result.log) do
    local words = { tostring(i), entry.word }
    for k in ipairs(fit.parameters) do
      words[#words + 1] = csv.word(entry.values[k])
    end
    words[#words + 1], words[#words + 2] = csv.word(entry.cost), csv.word(entry.failed and entry.failed:match("^[^\n]*"))
    words[#words + 1] = table.concat(entry.cases, " ")
    lines[#lines + 1] = table.concat(words, ",")
  end
  engine.write_file(result.folder .. "/fit.csv", table.concat(lines, "\n") .. "\n")
end

local function write_curves(fit, result)
  local lines = { "curve,x,y,sigma,model,residual,whitened" }
  for i, curve in ipairs(fit.curves) do
    local whitened = curve:residuals(result.found.at.curves[i])
    for n, x in ipairs(curve.x) do
      local model = result.found.at.curves[i][n]
      lines[#lines + 1] = table.concat({ csv.word(curve.name), csv.word(x), csv.word(curve.y[n]), csv.word(curve.sigma[n]), csv.word(model),
        csv.word((model - curve.y[n]) / curve.sigma[n]), csv.word(whitened[n] / math.sqrt(curve.weight)) }, ",")
    end
  end
  engine.write_file(result.folder .. "/curves.csv", table.concat(lines, "\n") .. "\n")
end

--- Writes the files of a fit into its folder.
function record.write(fit, study, options, result)
  engine.write_file(result.folder .. "/fit.json", engine.encode_json(record.table(fit, study, options, result), 2) .. "\n")
  write_log(fit, result)
  write_curves(fit, result)
end

return record
