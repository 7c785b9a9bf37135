-- The residuals of a fit at points of its parameters: batches of cases, compared with the measured curves.
local engine = require "stiction.engine"
local exact = require "stiction.fit.exact"
local loss_module = require "stiction.fit.loss"
local numeric = require "stiction.numeric"
local points_module = require "stiction.points"
local space = require "stiction.fit.space"
local spec = require "stiction.fit.spec"

local model = {}

local near, differences = 5e-3, 3 -- relative distance of runs whose differences tell how rough they are; how often these are taken
local of_third = 1 / 20 -- mean square of noise to that of its third differences, (k!)^2 / (2 k)! (Wild 2011)
local least_noise, least_share, most_share = 1e-12, 1e-6, 0.05

local Model = {}
Model.__index = Model

local function rms(list)
  local sum = 0
  for _, x in ipairs(list) do
    sum = sum + x * x
  end
  return math.sqrt(sum / #list)
end

--- The cases of a curve at values of the fit's parameters, other settings in `extra`; and what the comparison takes besides.
local function cases_of(self, curve, values, extra)
  local settings, others = spec.values_for(self.fit, curve, values)
  local cases = curve:cases(settings)
  for _, case in ipairs(cases) do
    for name, value in pairs(extra or {}) do
      case[name] = value
    end
  end
  return cases, others
end

--- What the rows of a curve's cases give at its points, and their runs; nil and the reason.
local function modelled(self, part)
  local curve, runs = part.curve, {}
  for i, row in ipairs(part.rows) do
    if not row.computed then
      return nil, ("%s: %s"):format(row.case.id, points_module.reason(row))
    end
    runs[i] = self.points:run_of(row)
  end
  local held, list, reason = engine.call(curve.model, curve, runs, part.others)
  if not held then
    if list.kind == "stopped" then
      error(list, 0)
    end
    return nil, tostring(list) .. (list.trace or "")
  end
  return list, list and runs or ("%s: %s"):format(curve.what, reason)
end

--- An answer at one point: {r =, J = {derivatives by place of parameter, of those that no other case tells}, curves = {model values by
--- place}, results = {of each run} | failed =, cases = {ids}}; values: of the parameters.
local function answer_of(self, parts, values)
  local answer = { r = {}, curves = {}, results = {}, cases = {} }
  for i, part in ipairs(parts) do
    for _, row in ipairs(part.rows) do
      answer.cases[#answer.cases + 1] = row.case.id
    end
    local list, runs = modelled(self, part)
    if not list then
      return { failed = runs, cases = answer.cases }
    end
    answer.curves[i], part.list, part.runs = list, list, runs
    for _, run in ipairs(runs) do
      answer.results[#answer.results + 1] = run.results
    end
    for _, r in ipairs(part.curve:residuals(list)) do
      answer.r[#answer.r + 1] = r
    end
  end
  answer.J = exact.columns(self.points.study, self.fit.parameters, values, parts)
  return answer
end

--- Answers at points, each a list of coordinates, by one batch of cases. word: what for. extra: settings in place of the study's;
--- curves: these alone.
function Model:evaluate(list, word, extra, curves)
  local wanted, parts, points = {}, {}, {}
  for n, z in ipairs(list) do
    local values = space.values(self.fit.parameters, z)
    parts[n], points[n] = {}, values
    for i, curve in ipairs(curves or self.fit.curves) do
      local cases, others = cases_of(self, curve, values, extra)
      parts[n][i] = { curve = curve, others = others, first = #wanted + 1, count = #cases }
      table.move(cases, 1, #cases, #wanted + 1, wanted)
    end
  end
  local rows, answers = self.points:run(wanted), {}
  for n, own in ipairs(parts) do
    for _, part in ipairs(own) do
      part.rows = table.move(rows, part.first, part.first + part.count - 1, 1, {})
    end
    answers[n] = answer_of(self, own, points[n])
    self:note(list[n], word, answers[n])
  end
  return answers
end

--- The range of a curve's x that its run at a point covers, SI; nil if that has failed.
function Model:range(curve, z)
  local cases, others = cases_of(self, curve, space.values(self.fit.parameters, z))
  local row = self.points:run(cases)[1]
  if not row.computed or curve.each then
    return nil
  end
  local p = row.case.p
  for name, value in pairs(others) do
    p[name] = value
  end
  local held, low, high = engine.call(curve.range, curve, self.points:run_of(row), p)
  if held then
    return low, high
  end
end

--- Notes and tells an answer.
function Model:note(z, word, answer)
  local values, cost = space.values(self.fit.parameters, z), nil
  if answer.r and #answer.r == self.fit.count then
    cost = select(3, loss_module.of(self.fit.loss, answer.r))
  end
  self.log[#self.log + 1] = { word = word, values = values, z = z, cost = cost, failed = answer.failed, cases = answer.cases }
  self.tell(self.log[#self.log], #self.log)
end

--- Third differences along a line through a point of what runs are at the points of the first curve, SI, as they tell how rough runs are;
--- nil and the reason if a run fails.
local function third_differences(self, z)
  local curve, line = self.fit.curves[1], {}
  for i = 0, differences do
    local values = space.values(self.fit.parameters, z)
    local other = {}
    for k, own in ipairs(self.fit.parameters) do
      local step = space.step(own, values[k], near * i)
      other[k] = z[k] + (z[k] > 0.5 and -step or step)
    end
    line[i + 1] = other
  end
  local answers, list = self:evaluate(line, "noise", nil, { curve }), {}
  for _, answer in ipairs(answers) do
    if answer.failed then
      return nil, answer.failed
    end
  end
  local own = numeric.map(answers, function(answer) return answer.curves[1] end)
  for n = 1, #own[1] do
    list[n] = own[4][n] - 3 * own[3][n] + 3 * own[2][n] - own[1][n]
  end
  return list
end

--- Root mean square of a list of the first curve, SI, as it counts in residuals.
local function size_of(curve, list)
  local own = {}
  for i, value in ipairs(list) do
    own[i] = math.sqrt(curve.weight) * value / curve.sigma[i]
  end
  return rms(curve:whitened(own)), rms(own)
end

--- Sets the noise of residuals, self.noise, by the errors and correlations that the curve has now; what a residual is in all.
function Model:weigh_noise()
  local curve = self.fit.curves[1]
  local size, plain = size_of(curve, curve.y)
  if self.third then
    self.noise = math.sqrt(of_third) * size_of(curve, self.third)
  else
    self.noise = (self.fit.noise or 1e-6) * plain * curve:roughened()
  end
  self.noise = math.max(self.noise, least_noise * size)
  return size
end

--- Measures the noise of runs near a point and sets the size of differences by it: self.noise of a residual, self.share relative.
function Model:set_steps(z)
  local reason
  if not self.fit.noise and not self.exact then
    self.third, reason = third_differences(self, z)
  end
  local size = self:weigh_noise()
  self.share = math.min(math.max(2 * math.sqrt(self.noise / size), least_share), most_share)
  return reason
end

--- The fit as search.run wants it.
function Model:problem(enough)
  local parameters = self.fit.parameters
  return { parameters = parameters, loss = self.fit.loss, known = self.fit.known, most = self.fit.most, enough = enough, refusals = 1,
    step = function(k, z) return space.step(parameters[k], space.values(parameters, z)[k], self.share) end,
    evaluate = function(list, word) return self:evaluate(list, word) end }
end

--- Names of all parameters that differ among the cases of a fit.
local function names_of(fit)
  local names, list = {}, {}
  for _, own in ipairs(fit.parameters) do
    names[own.key] = own.setting or nil
  end
  for _, curve in ipairs(fit.curves) do
    for _, source in ipairs { curve.case, curve.each or {} } do
      for name in pairs(source) do
        names[name] = true
      end
    end
  end
  for name in pairs(names) do
    list[#list + 1] = name
  end
  table.sort(list)
  return list
end

--- tell(entry, number): called with every answer, {word =, values =, cost =, failed =}.
function model.open(fit, study, options, folder, tell)
  return setmetatable({ fit = fit, points = points_module.open(study, options, folder, names_of(fit)), log = {}, tell = tell,
    noise = 0, share = least_share, exact = exact.all(study, fit) }, Model)
end

return model
