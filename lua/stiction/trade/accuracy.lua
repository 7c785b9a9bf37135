-- The cheapest measured settings of a study that are near enough: `stiction run --accuracy`.
local copy = require "stiction.copy"
local fault = require "stiction.fault"
local ladder = require "stiction.trade.ladder"
local numeric = require "stiction.numeric"
local ordered = require "stiction.ordered"
local record = require "stiction.trade.record"
local report = require "stiction.report"
local sweep = require "stiction.sweep"

local accuracy = {}

local rounding = 1e-9

--- 0.02 of "2%" or "0.02"; bad input else.
function accuracy.share(text)
  local number, percent = text:match("^%s*([%d.]+[eE]?[-+]?%d*)%s*(%%?)%s*$")
  local share = tonumber(number)
  if not share or share <= 0 then
    fault.input("--accuracy %s: write a share above 0, as 2%% or 0.02", text)
  end
  return percent == "%" and share / 100 or share
end

--- The run of least work whose bound is within `share`, nil and the best bound there is if none is.
function accuracy.cheapest(runs, share)
  local best, nearest = nil, math.huge
  for _, run in ipairs(runs) do
    local bound = run.bound or math.huge
    nearest = math.min(nearest, bound)
    if bound <= share and (not best or run.work < best.work) then
      best = run
    end
  end
  return best, nearest
end

--- Options of the run with the settings of its accuracy, and what was measured of them: {p = of the measured scene,
--- values =, errors = {by quantity, SI; of a curve relative to its norm}}. What the user sets by hand stays set.
function accuracy.apply(study, options)
  local share = accuracy.share(options.accuracy)
  local kept = record.read(study, options.study)
  local run, nearest = accuracy.cheapest(kept.runs, share)
  if not run then
    fault.input("--accuracy %s: the best that was measured is %.2g%%; give 'trade' finer levels and measure them: "
      .. "./stiction trade %s", options.accuracy, 100 * nearest, options.study)
  end
  local settings, words = {}, {}
  for _, name in ipairs(ordered.keys(run.settings)) do
    settings[#settings + 1] = name .. "=" .. run.settings[name]
    words[#words + 1] = ("%s = %s"):format(name, run.settings[name])
  end
  report.line("--accuracy %s: %s (measured: off by at most %.2g%%, %.2g of the default's work)", options.accuracy,
    table.concat(words, ", "), 100 * run.bound, run.work / accuracy.default_work(kept.runs))
  local own = copy(options)
  own.set = table.move(options.set or {}, 1, #(options.set or {}), #settings + 1, settings)
  local measured = { p = sweep.find(sweep.trade(study, {}), run.case).p, values = run.values, errors = {} }
  for name, error in pairs(run.errors) do
    local reference = kept.references[name]
    measured.errors[name] = error * reference.scale + reference.uncertainty
  end
  return own, measured
end

--- Checks that the measured scene, where it is among the cases, still gives what was measured: what the program has
--- changed since by more than the error it promises makes that promise void.
function accuracy.check(measured, cases, check)
  local function differs(p, name)
    return not ladder.same(p[name], measured.p[name])
  end
  for _, case in ipairs(cases) do
    if not numeric.first_where(ordered.keys(measured.p), function(name) return differs(case.p, name) end) then
      for _, name in ipairs(ordered.keys(measured.values)) do
        local was, error = measured.values[name], measured.errors[name]
        if error then
          check.equal(("%s: %s within its error of what its trade measured"):format(case.id, name), case.results[name],
            was, math.max(error, rounding * math.abs(was)))
        end
      end
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
