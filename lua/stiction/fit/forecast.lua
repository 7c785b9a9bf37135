-- What explain says of a study's fit before it runs: the data that it reads, its parameters, how many cases it takes and what they cost.
local advice = require "stiction.fit.advice"
local engine = require "stiction.engine"
local exact = require "stiction.fit.exact"
local finer = require "stiction.fit.finer"
local spec = require "stiction.fit.spec"
local units = require "stiction.units"
local verdict = require "stiction.fit.verdict"

local forecast = {}

-- As the fits of studies/fit took them, each within a half; more where a profile meets a lower point and the search goes on from there.
local steps, renewals = 6, 2 -- of the search for a minimum: evaluations of trial points, batches of derivatives
local steps_with_slopes = 3 -- where derivatives come with the cases
local each_side = 3 -- evaluations of a profile on either side
local most_starts, noise_runs = 3, 4

local function count_of(curve)
  return curve.each and #curve.y or 1
end

--- How many cases the derivative over a parameter takes.
local function cases_of(fit, own)
  local sum = 0
  for _, curve in ipairs(fit.curves) do
    sum = sum + (own.setting and (not own.curve or own.curve == curve.name) and count_of(curve) or 0)
  end
  return sum
end

local function count_further(fit)
  local count = 0
  for key, entry in pairs(fit.further or {}) do
    count = count + (type(key) ~= "number" and type(entry) == "table" and not units.is_quantity(entry) and #entry or 1)
  end
  return count
end

--- About how many cases a fit takes, by what for: {starts =, noise =, steps =, derivatives =, profiles =, finer =, further =, sum =}.
local function count_cases(study, fit, variants)
  local evaluation, derivatives, all = 0, 0, exact.all(study, fit)
  for _, curve in ipairs(fit.curves) do
    evaluation = evaluation + count_of(curve)
  end
  for _, own in ipairs(fit.parameters) do
    derivatives = derivatives + (exact.is_known(study, own) and 0 or cases_of(fit, own))
  end
  local first, minima, p = count_of(fit.curves[1]), math.min(fit.starts, most_starts), #fit.parameters
  local list = { starts = fit.starts * evaluation, noise = (fit.noise or all) and 0 or noise_runs * first,
    steps = minima * (all and steps_with_slopes or steps) * evaluation,
    derivatives = minima * renewals * derivatives, profiles = fit.profiles and 2 * p * each_side * evaluation or 0,
    finer = variants * evaluation, further = count_further(fit) * (1 + p) * first }
  local sum = 0
  for _, count in pairs(list) do
    sum = sum + count
  end
  list.sum = sum
  return list
end

local function range_of(list, unit)
  local low, high = math.huge, -math.huge
  for _, value in ipairs(list) do
    low, high = math.min(low, value), math.max(high, value)
  end
  local factor = unit == "1" and 1 or engine.parse_unit(unit)
  if low == high then
    return ("%.4g%s"):format(low / factor, unit == "1" and "" or " " .. unit)
  end
  return ("%.4g to %.4g%s"):format(low / factor, high / factor, unit == "1" and "" or " " .. unit)
end

local function error_words(curve)
  local words = not curve.told and "errors as the residuals show" or "standard errors " .. range_of(curve.sigma, curve.y_word)
  if curve.covariance then
    return words .. ", correlated as " .. curve.covariance .. " says"
  elseif curve.estimated then
    return words .. ", correlated as the residuals tell"
  end
  return words .. (curve.length and ", correlated over " .. curve:along_x(curve.length) or "")
end

local function parameters_of(fit, study, options, warnings)
  local list = {}
  for k, own in ipairs(fit.parameters) do
    local used = own.setting and spec.is_used(fit, study, options, k)
    local from, to = verdict.words(own, own.from), verdict.words(own, own.to)
    list[k] = { name = own.name, from = own.from, to = own.to, start = own.start, log = own.log, curve = own.curve, setting = own.setting,
      used = used, words = ("%s to %s%s, from %s"):format(from, to, own.log and ", logarithmic" or "",
        verdict.words(own, own.start)) }
    if own.setting and used == false then
      warnings[#warnings + 1] = { text = ("study.fit: the scene is the same from %s = %s to %s: runs do not depend on it"):format(own.name,
        from, to), change = "let the scene use it, or leave it out of the fit; if only `against` reads it, take it out of given and "
        .. "chosen: its derivatives cost no cases then" }
    end
  end
  return list
end

--- How many times as long a case takes with runs beside it: measured 1.4 to 2.3 for the factors of where its steps end, 0.2 to 0.37 a run.
local function longer(study)
  return #study.derivatives > 0 and 1.7 + 0.3 * #study.derivatives or 1
end

--- Seconds that explain forecasts for the run of a case alone; nil where it forecasts none.
local function seconds_of(explanation)
  for _, section in ipairs(explanation.sections) do
    for _, line in ipairs(section.title == "Cost" and section.lines or {}) do
      if line.name == "time" then
        return line.value
      end
    end
  end
end

local function made(study, options, warnings)
  local fit = spec.read(study, options)
  advice.check(fit)
  local variants = #(finer.variants(fit, study, options) or {})
  local case = spec.case_at(fit, study, options)
  local result = { points = fit.count, cases = count_cases(study, fit, variants), most = fit.most, starts = fit.starts, curves = {},
    loss = fit.loss, parameters = parameters_of(fit, study, options, warnings), finer = variants,
    seconds = seconds_of(engine.explain(study:scene_of(case))) }
  result.seconds = result.seconds and longer(study) * result.seconds
  for i, curve in ipairs(fit.curves) do
    result.curves[i] = { name = curve.name, file = curve.file, points = #curve.y, cases = count_of(curve), correlation = curve.length,
      words = ("%d points of %s: %s %s, %s %s; %s"):format(#curve.y, curve.file, curve.x_name, range_of(curve.x, curve.x_word),
        curve.y_name, range_of(curve.y, curve.y_word), error_words(curve)) }
  end
  if variants == 0 then
    warnings[#warnings + 1] = { text = "study.fit has neither `finer` nor a trade: what cells and steps may be off by will not be known",
      change = "finer = { a setting of the study, a level finer }" }
  end
  return result
end

--- {points =, cases = (by what for), most = (evaluations of a search), curves = {{name =, words =, ...}}, parameters = {{name =, words =,
--- used =}}, seconds = (of one case; nil: not forecast)} or {refused = why}; and warnings as explain has them. nil without a fit.
function forecast.of(study, options)
  if not study.fit then
    return nil, {}
  end
  local warnings = {}
  local held, result = engine.call(made, study, options, warnings)
  if held then
    return result, warnings
  elseif result.kind == "stopped" then
    error(result, 0)
  end
  local words = tostring(result):match("^[^\n]*")
  return { refused = words }, { { text = "stiction fit would be refused: " .. words, change = "see 'stiction help fit'" } }
end

local function duration(seconds)
  local value, unit = seconds, "s"
  if seconds >= 100 then
    value, unit = seconds / (seconds < 6000 and 60 or 3600), seconds < 6000 and "min" or "h"
  end
  return (value < 10 and "%.2g %s" or "%.0f %s"):format(value, unit)
end

local kinds = { "starts", "noise", "steps", "derivatives", "profiles", "finer", "further" }

--- The same as lines of explain: {name =, words =, meaning =}.
function forecast.lines(result)
  local lines = {}
  local function add(name, words, meaning)
    lines[#lines + 1] = { name = name, words = words, meaning = meaning or "" }
  end
  if result.refused then
    add("refused", result.refused)
    return lines
  end
  for _, curve in ipairs(result.curves) do
    add(curve.name, curve.words .. (curve.cases > 1 and ("; %d cases an evaluation, one a point"):format(curve.cases) or ""))
  end
  for _, own in ipairs(result.parameters) do
    add(own.name, own.words .. (not own.setting and "; no cases: `against` has to read it"
      or own.used == false and "; NOT USED by the scene" or ""))
  end
  local words = {}
  for _, kind in ipairs(kinds) do
    local count = result.cases[kind]
    words[#words + 1] = count > 0 and ("%s %d"):format(kind, count) or nil
  end
  add("cases", ("about %d"):format(result.cases.sum), table.concat(words, ", ")
    .. ("; a search is ended after %d evaluations"):format(result.most))
  if result.seconds then
    add("time", "about " .. duration(result.cases.sum * result.seconds), ("of %s a case, one at a time%s; --jobs runs several"):format(
      duration(result.seconds), result.finer > 0 and ", finer ones more" or ""))
  else
    add("time", "not forecast", "as that of a case on a half space is not")
  end
  return lines
end

return forecast
