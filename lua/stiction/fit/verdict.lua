-- What a fit says in words: of each parameter, of combinations, of the model; and what it claims.
local combination = require "stiction.fit.combination"
local correlated = require "stiction.fit.correlated"
local engine = require "stiction.engine"
local judge = require "stiction.fit.judge"
local numeric = require "stiction.numeric"
local units = require "stiction.units"

local verdict = {}

local stuck = 1 -- gain that derivatives promise, in squares of standard errors, where a search that found none is told
local blur = 0.3 -- standard errors by which a finer level changes curves, where runs of signs may be of its making

--- A value in SI in the unit that the study wrote the parameter's bounds in, and that unit.
function verdict.shown(own, value)
  if not units.is_quantity(own.like) then
    return value, ""
  end
  local _, unit = own.like:display()
  return value / engine.parse_unit(unit), unit
end

--- "0.981 J/m^2"
function verdict.words(own, value, digits)
  local number, unit = verdict.shown(own, value)
  return ("%%.%dg%%s"):format(digits or 4):format(number, unit ~= "" and " " .. unit or "")
end

--- The ends of an interval with what the simulation may be off by on either side: a relative share, or of a linear parameter a half width;
--- open beyond the bounds, as there nothing was looked for.
local function with_simulation(own, result, share, half)
  local function moved(x, way)
    x = x and (own.log and x * math.exp(way * share) or x + way * half)
    return x and x > own.from and x < own.to and x or nil
  end
  result.low, result.high = moved(result.statistical.low, -1), moved(result.statistical.high, 1)
end

--- {low =, high = (SI; nil: open), statistical = {low =, high =}, simulation = (half width, SI; nil: not known), by = "profile" or
--- "covariance", bound = "low" | "high" (that it is at: the interval is of the other side alone)}: what is claimed of the k-th parameter:
--- never less than the simulation's own error on either side. nil of one at its bound that has no profile.
function verdict.interval(fit, judged, intervals, own_error, k)
  local own, value = fit.parameters[k], judged.values[k]
  local profiled = intervals and intervals[k]
  if not judged.errors[k] and not profiled then
    return nil
  end
  local result = { by = profiled and "profile" or "covariance", bound = profiled and profiled.bound, stretch = judged.stretch }
  local low, high
  if profiled then
    low, high = profiled.low, profiled.high
  else
    local half = judged.t * judged.relative[k]
    low = own.log and value * math.exp(-math.min(half, 700)) or value - judged.t * judged.errors[k]
    high = own.log and value * math.exp(math.min(half, 700)) or value + judged.t * judged.errors[k]
  end
  result.statistical = { low = low and low > own.from and low or nil, high = high and high < own.to and high or nil }
  local share = own_error.known and own_error.relative[k]
  result.simulation = share and share * judged.sizes[k] or nil
  with_simulation(own, result, share or 0, result.simulation or 0)
  return result
end

local function list_words(words)
  return #words > 1 and table.concat(words, ", ", 1, #words - 1) .. " and " .. words[#words] or words[1]
end

--- What is said of the k-th parameter, in a word or two: data may determine what the simulation is too rough to claim.
function verdict.word(judged, own_error, k)
  local fate = judged.fates[k]
  if fate == "determined" and own_error.known and own_error.relative[k] > judge.settled then
    return "not claimed"
  end
  return fate or "at its bound"
end

local function names_with(fit, judged, own_error, word)
  local names = {}
  for _, k in ipairs(judged.free) do
    names[#names + 1] = verdict.word(judged, own_error, k) == word and fit.parameters[k].name or nil
  end
  return names
end

--- Whether what rejects the model is no more than one finer level of the simulation changes: then nothing is rejected yet.
local function is_coarse(judged, own_error, found)
  if not own_error.known then
    return false
  end
  local chance = judge.chance_with(judged, found.at.r, own_error.changes)
  local largest = 0
  for _, variant in ipairs(own_error.variants) do
    largest = math.max(largest, variant.residual)
  end
  return chance ~= nil and chance >= judge.doubt or chance == nil and largest > blur
end

local function on_squares(fit, judged, lines)
  local each = judged.squares / math.max(1, judged.degrees)
  local words = ("chi square %.4g at %d degrees of freedom (%.3g each; chance %.2g)"):format(judged.squares, judged.degrees, each,
    judged.chance or 0)
  if judged.chance and judged.chance < judge.doubt then
    lines[#lines + 1] = (judged.coarse and "no agreement yet: " or "MODEL REJECTED by the data: ") .. words
  elseif judged.chance then
    lines[#lines + 1] = "the model agrees with the data: " .. words
      .. (judged.chance > 1 - judge.doubt and "; so little says that the errors given are too large" or "")
  elseif fit.known then
    lines[#lines + 1] = fit.loss and fit.loss ~= "squares" and ("the loss is '%s': its sum has no known distribution, and chi square tells "
      .. "nothing"):format(fit.loss) or nil
  elseif not judged.rejected then
    lines[#lines + 1] = "errors of the data were not given: they are those that the residuals show, and chi square tells nothing"
  end
end

local function on_model(fit, judged, lines)
  on_squares(fit, judged, lines)
  for i, chance in ipairs(judged.runs) do
    if chance and chance < judge.doubt / #judged.runs then
      lines[#lines + 1] = ("%sthe residuals of %s keep their sign in long runs (chance %.2g)"):format(
        judged.coarse and "no agreement yet: " or "MODEL REJECTED: ", fit.curves[i].name, chance)
    end
  end
  for _, line in ipairs(correlated.lines(fit.curves, judged, judge.doubt)) do
    lines[#lines + 1] = line
  end
  lines[#lines + 1] = judged.stretch and ("as model and data do not agree, errors, intervals and what is determined are those of "
    .. "data %.3g times less sure, the root of chi square per degree"):format(judged.stretch) or nil
  if judged.coarse then
    lines[#lines + 1] = "one finer level of the simulation changes the curves by as much as that: refine before the model is blamed"
  elseif judged.rejected and fit.starts == 1 then
    lines[#lines + 1] = "the search began in one place; whether others end lower is not known (fit.starts says how many to try)"
  end
end

--- Notes whether the misfit is of the simulation's own making; `rejected` is what is left.
function verdict.settle(judged, own_error, found)
  judged.coarse = judged.rejected and is_coarse(judged, own_error, found)
  judged.misfit, judged.rejected = judged.rejected, judged.rejected and not judged.coarse
end

--- What is said of profiles that could not be followed to their end.
local function on_profiles(fit, judged, intervals, lines)
  for k, own in ipairs(fit.parameters) do
    for _, side in ipairs(intervals and intervals[k] and intervals[k].lost or {}) do
      lines[#lines + 1] = ("the interval of %s is open %s: its profile could not be followed %s %s (%s)"):format(own.name,
        side.way < 0 and "below" or "above", side.way < 0 and "below" or "beyond", verdict.words(own, side.value),
        side.reason:match("^[^\n]*"))
    end
  end
  lines[#lines + 1] = judged.undercut and "profiles still meet lower points: this may be no minimum; the intervals are about it" or nil
end

--- What is said of the k-th parameter, which is at its bound.
local function on_bound(fit, judged, own_error, intervals, k)
  local own, interval = fit.parameters[k], verdict.interval(fit, judged, intervals, own_error, k)
  local words = ("%s is at its bound %s: the data would have it beyond"):format(own.name,
    verdict.words(own, judged.values[k], 10))
  if not interval then
    return words .. ", and no error is told"
  end
  local finish, of_data = interval.low or interval.high, interval.statistical.low or interval.statistical.high
  if not of_data and not (intervals[k].lost and intervals[k].lost[1]) then
    return ("%s is at its bound %s, and NOT DETERMINED by these data: its interval is open on the other side, too"):format(own.name,
      verdict.words(own, judged.values[k], 10))
  end
  return ("%s; on the other side its interval (95 %%) %s"):format(words, finish and "ends at " .. verdict.words(own, finish)
    or of_data and "is open by the simulation's own error, by the data it ends at " .. verdict.words(own, of_data) or "is open")
end

--- Lines on the model, the parameters and the simulation's own error; intervals: of profiles, or nil.
function verdict.lines(fit, judged, own_error, found, intervals)
  local lines = {}
  on_model(fit, judged, lines)
  local function those(word)
    return names_with(fit, judged, own_error, word)
  end
  local good, mixed, lost, open = those("determined"), those("only in combination"), those("not determined"), those("not claimed")
  if #good > 0 then
    lines[#lines + 1] = "determined: " .. list_words(good)
  end
  if #mixed > 0 then
    local words = numeric.map(judged.combinations, function(own)
      return ("%s to %s"):format(combination.words(fit.parameters, own.powers, judged),
        combination.error_words(fit.parameters, own, judged))
    end)
    lines[#lines + 1] = ("determined only in combination: %s; what these data tell is %s"):format(list_words(mixed),
      #words > 0 and list_words(words) or "no combination of them alone")
  end
  if #lost > 0 then
    lines[#lines + 1] = "NOT DETERMINED by these data: " .. list_words(lost)
  end
  local cut = those("not followed")
  lines[#lines + 1] = #cut > 0 and ("NOT FOLLOWED to the ends of their intervals, as runs fail or do not settle there, and determined by "
    .. "the covariance alone: %s"):format(list_words(cut)) or nil
  for k in ipairs(fit.parameters) do
    lines[#lines + 1] = not judged.errors[k] and on_bound(fit, judged, own_error, intervals, k) or nil
  end
  local coarse = {}
  for _, k in ipairs(judged.free) do
    local share, name = own_error.known and own_error.relative[k] or 0, fit.parameters[k].name
    coarse[#coarse + 1] = share > judged.t * judged.relative[k] and share <= judge.settled and name or nil
  end
  lines[#lines + 1] = #open > 0 and ("NOT CLAIMED, whatever the data say: %s, by which the simulation's own error is more than %d %%; "
    .. "make its settings finer"):format(list_words(open), 100 * judge.settled) or nil
  lines[#lines + 1] = #coarse > 0 and ("the simulation is less sure than the data of %s: finer settings would tell more than further "
    .. "measurements"):format(list_words(coarse)) or nil
  lines[#lines + 1] = not own_error.known and ("the simulation's own error is NOT KNOWN (%s): the intervals are of the data alone"):format(
    own_error.reason) or nil
  for _, variant in ipairs(own_error.known and own_error.variants or {}) do
    lines[#lines + 1] = variant.doubt and ("the simulation's own error may be more than is told: %s"):format(variant.doubt) or nil
  end
  on_profiles(fit, judged, intervals, lines)
  if found.lost > 0 then
    lines[#lines + 1] = ("%d derivatives could not be had, as runs beside the best point fail%s"):format(found.lost,
      found.reason and ": " .. found.reason or "")
  end
  if found.ended == "stuck" and (found.promised or 0) > stuck then
    lines[#lines + 1] = ("the search is STUCK: derivatives promise a gain of %.2g squared standard errors, no step along them gains. "
      .. "Results jump or kink there, and this may be no minimum: leave out data at a jump, or try further starts (fit.starts)"):format(
      found.promised)
  end
  if found.ended == "most" then
    lines[#lines + 1] = ("the search was ended after %d evaluations (fit.most); this may be no minimum"):format(fit.most)
  end
  return lines
end

return verdict
