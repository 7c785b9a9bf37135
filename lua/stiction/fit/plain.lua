-- A fit of a function in place of cases: the same search, judgement and profiles, for proofs of them.
local correlated = require "stiction.fit.correlated"
local judge = require "stiction.fit.judge"
local noise = require "stiction.fit.noise"
local numeric = require "stiction.numeric"
local profile = require "stiction.fit.profile"
local search = require "stiction.fit.search"
local space = require "stiction.fit.space"
local starts = require "stiction.fit.starts"

local plain = {}

--- The curve of such a fit, as far as its noise is concerned: t.correlation is a length or "estimated", t.shares as noise.along has them.
local function curve_of(t)
  local length = type(t.correlation) == "number" and t.correlation or nil
  local own = { first = 1, last = #t.x, x = t.x, name = "data", estimated = t.correlation == "estimated", shares = t.shares,
    weights = t.weights,
    correlate = function(self, told)
      self.length, self.common = told, told and noise.along(self.x, told, self.shares)
    end }
  own:correlate(length)
  own.common = t.common or own.common
  return own
end

--- A problem as search.run has it, of t = {parameters =, x =, y =, sigma = (one for all; nil: not known), sigmas, weights = (one each), f =
--- function(values, x), correlation =, shares =, common = (as of noise), loss =, share = (of differences), enough =, ...}; where f gives no
--- number the point fails.
function plain.problem(t)
  local count, curve = { evaluations = 0 }, curve_of(t)
  local function residuals(z)
    local values, r = space.values(t.parameters, z), {}
    for i, x in ipairs(t.x) do
      r[i] = (t.f(values, x) - t.y[i]) / (t.sigmas and t.sigmas[i] or t.sigma or 1)
      if not numeric.is_finite(r[i]) or math.abs(r[i]) > 1e150 then
        return { failed = "no number" }
      end
      r[i] = t.weights and math.sqrt(t.weights[i]) * r[i] or r[i]
    end
    return { r = curve.common and curve.common:whitened(r) or r }
  end
  return { parameters = t.parameters, loss = t.loss or "squares", known = t.sigma ~= nil, enough = t.enough or 1e-6,
    most = t.most or 1000, refusals = t.refusals or 1, always = t.always, central = t.central, count = count, curves = { curve },
    step = function(k, z) return space.step(t.parameters[k], space.values(t.parameters, z)[k], t.share or 1e-6) end,
    evaluate = function(points)
      count.evaluations = count.evaluations + #points
      return numeric.map(points, residuals)
    end }
end

--- The best minimum from `count` starts, its judgement, and its profiles if wanted; the problem.
function plain.fit(t, count, profiled)
  local problem = plain.problem(t)
  local minima = search.run(problem, starts.of(t.parameters, count or 1), 3)
  if not minima then
    return nil
  end
  minima = correlated.settle(problem, minima, problem.curves, function() end)
  local judged = judge.of(problem, minima[1], { curves = problem.curves })
  return minima[1], judged, profiled and profile.of(problem, minima[1], judged), problem
end

return plain
