-- A measured curve of a fit: its values with their errors, the cases that it is compared with, and the residuals of these.
local correlation = require "stiction.fit.correlation"
local engine = require "stiction.engine"
local fault = require "stiction.fault"
local measured = require "stiction.measured"
local noise_module = require "stiction.fit.noise"
local numeric = require "stiction.numeric"
local ordered = require "stiction.ordered"
local units = require "stiction.units"

local curve = {}

local keys = { file = "string", x = "string", y = "string", units = "table", against = true, case = "table", each = "table",
  own = "table", sigma = true, relative = "number", weight = "number", correlation = true, white = true, covariance = "table" }
local covariance_keys = { file = "string", unit = "string" }
local against_keys = { x = "string", y = "string", x_sign = "number", y_sign = "number", after = true, before = true }
local guess = 0.01 -- of the largest value: a noise that nothing tells, as all residuals count alike then
local least_points = 8 -- of which the noise can be told
local of_third_differences = 20 -- (1, 3, 3, 1) squared, summed
local most_points = 2000 -- with a table of covariances
local lopsided = 1e-6 -- of the standard errors of two points, by which their covariance may be written twice
local slack = 1e-9 -- of the range, by which data may go beyond a run

local Curve = {}
curve.methods = Curve -- of what curve.read gives
Curve.__index = Curve

local function check_keys(t, what, allowed)
  for _, key in ipairs(ordered.keys(t)) do
    local kind = allowed[key]
    if not kind then
      fault.script("%s: unknown key '%s'%s; keys: %s", what, tostring(key), fault.meant(tostring(key), ordered.keys(allowed)),
        table.concat(ordered.keys(allowed), ", "))
    elseif kind ~= true and type(t[key]) ~= kind then
      fault.script("%s: %s must be a %s, not a %s", what, key, kind, type(t[key]))
    end
  end
end

local function check(name, t)
  local what = "study.fit.data." .. name
  if type(t) ~= "table" then
    fault.script("%s must be a table: { file =, x =, y =, against = function(run, p) ... end }", what)
  end
  check_keys(t, what, keys)
  for _, key in ipairs { "file", "x", "y", "against" } do
    if t[key] == nil then
      fault.script("%s: %s is missing", what, key)
    end
  end
  if type(t.against) == "table" then
    check_keys(t.against, what .. ".against", against_keys)
    for _, key in ipairs { "x", "y" } do
      local _ = t.against[key] or fault.script("%s.against: %s is missing: \"probe/column\" or \"time\"", what, key)
    end
  elseif type(t.against) ~= "function" then
    fault.script("%s: against must be function(run, p) that gives xs and ys, or { x = \"probe/column\", y = \"probe/column\" }", what)
  end
  if t.covariance then
    check_keys(t.covariance, what .. ".covariance", covariance_keys)
    for _, key in ipairs { "sigma", "relative", "correlation", "white" } do
      local _ = t[key] == nil or fault.script("%s: covariance says all of the noise; leave out %s", what, key)
    end
  elseif t.white ~= nil and (t.correlation == nil or not (t.sigma or t.relative)) then
    fault.script("%s: white is what each point has for itself beside noise that goes on: say sigma of that, and correlation", what)
  end
  if t.weight and t.weight <= 0 then
    fault.script("%s: weight = %g; it must be above 0", what, t.weight)
  end
  return what
end

--- Values of a column in SI, and its unit as a quantity, or 1; bad input if no unit is named.
local function column(t, key, columns, words, what)
  local list, word = columns[t[key]], words[t[key]]
  if not word then
    fault.input("%s: %s: column '%s' names no unit; write \"%s [mm]\" in its head, or units = { %s = \"mm\" } (\"1\" for a pure number)",
      what, t.file, t[key], t[key], t[key])
  end
  return numeric.map(list, units.si), list[1], word
end

local function like(value, unit)
  if units.is_quantity(unit) then
    return units.is_quantity(value) and units.same_dimension(value, unit)
  end
  return type(value) == "number"
end

--- Standard errors of the values as they are told; nil if they are not.
local function told_errors(t, columns, y, unit, what)
  local sigma, list = t.sigma, nil
  if type(sigma) == "string" then
    list = columns[sigma]
  elseif sigma ~= nil then
    list = numeric.map(y, function() return sigma end)
  end
  for i, value in ipairs(list or {}) do
    if not like(value, unit) then
      fault.input("%s: sigma is %s; it must be like %s: %s", what, tostring(value), t.y, tostring(unit))
    elseif units.si(value) <= 0 then
      fault.input("%s: sigma[%d] is %g; a standard error is above 0", what, i, units.si(value))
    end
  end
  if not list and not t.relative then
    return nil
  end
  local own, largest = {}, math.abs((numeric.extreme(y)))
  for i, value in ipairs(y) do
    local share = (t.relative or 0) * math.max(math.abs(value), guess * largest)
    own[i] = math.sqrt((list and units.si(list[i]) or 0) ^ 2 + share ^ 2)
  end
  return own
end

--- Standard errors by a file of covariances [points, points], and the noise that goes with them; bad input where there can be none.
local function by_covariance(self, t, folder, note)
  local rows, unit = measured.matrix(t, folder, note, self.what .. ".covariance")
  if not like(unit, self.y_unit * self.y_unit) then
    fault.input("%s.covariance: unit = \"%s\"; it must be like the square of %s, in %s", self.what, t.unit, self.y_name, self.y_word)
  elseif #rows ~= #self.y or #rows > most_points then
    fault.input("%s.covariance: %s has %d rows for %d points; one for each, at most %d", self.what, t.file, #rows, #self.y, most_points)
  end
  local sigma = {}
  for i, row in ipairs(rows) do
    if row[i] <= 0 then
      fault.input("%s.covariance: %s: variance %d is %g; it is above 0", self.what, t.file, i, row[i])
    end
    sigma[i] = math.sqrt(row[i])
  end
  for i, row in ipairs(rows) do
    for k = 1, #row do
      row[k] = row[k] / (sigma[i] * sigma[k])
      if k < i and math.abs(row[k] - rows[k][i]) > lopsided then
        fault.input("%s.covariance: %s: entries (%d, %d) and (%d, %d) differ; a covariance is symmetric", self.what, t.file, i, k, k, i)
      end
    end
  end
  local common, least = noise_module.of_correlations(rows)
  if not common then
    fault.input("%s.covariance: %s is not positive definite: the least eigenvalue of its correlations is %.2g; was it rounded? Add the "
      .. "variance of what each point has for itself to the diagonal", self.what, t.file, least)
  end
  return sigma, common
end

--- The share of each standard error that goes on along the curve, where `white` is what each point has for itself; sigma: of both.
local function with_white(self, white)
  if not like(white, self.y_unit) or units.si(white) <= 0 or units.si(white) ~= units.si(white) then
    fault.input("%s: white is %s; it must be above 0 and like %s: %s", self.what, tostring(white), self.y_name, tostring(self.y_unit))
  end
  self.shares = {}
  for i, sigma in ipairs(self.sigma) do
    self.sigma[i] = math.sqrt(sigma ^ 2 + units.si(white) ^ 2)
    self.shares[i] = sigma / self.sigma[i]
  end
end

--- The noise of values along a smooth curve, from their third differences: by the median, which jumps do not change. Of noise that is
--- correlated along x over a length where there is one.
function curve.noise(y, x, length)
  local sizes = {}
  for i = 4, #y do
    local share = length and math.sqrt(correlation.third_difference(x, length, i) / of_third_differences) or 1
    sizes[#sizes + 1] = math.abs(y[i] - 3 * y[i - 1] + 3 * y[i - 2] - y[i - 3]) / share
  end
  table.sort(sizes)
  local median = #y >= least_points and sizes[(#sizes + 1) // 2] or 0
  local noise = 1.4826 * median / math.sqrt(of_third_differences)
  return noise > 0 and noise or guess * math.max(math.abs((numeric.extreme(y))), 1e-300)
end

local function check_rising(self)
  for i = 2, #self.x do
    if self.x[i] <= self.x[i - 1] then
      fault.input("%s: %s: %s does not increase from row %d (%.6g) to row %d (%.6g), in SI; sort the rows, and give the ways there "
        .. "and back as two curves", self.what, self.file, self.x_name, i - 1, self.x[i - 1], i, self.x[i])
    end
  end
end

--- The length of the noise's correlation as it is told, SI, nil where none is; whether it is to be estimated.
local function told_length(self, told)
  if told == nil then
    return nil, false
  elseif told == "estimated" then
    if #self.x < correlation.least_points then
      fault.input("%s: correlation = \"estimated\" takes %d points, there are %d; give a length, or leave it out", self.what,
        correlation.least_points, #self.x)
    end
    return nil, true
  elseif not like(told, self.x_unit) then
    fault.input("%s: correlation is %s; it must be a length along %s, like %s, or \"estimated\"", self.what, tostring(told), self.x_name,
      units.is_quantity(self.x_unit) and "1 " .. self.x_word or "0.1")
  end
  local length, span = units.si(told), self.x[#self.x] - self.x[1]
  if length <= 0 or length ~= length then
    fault.input("%s: correlation is %s; a length is above 0 (leave it out where each point's noise is its own)", self.what, tostring(told))
  elseif length > span then
    fault.input("%s: correlation is %s, longer than the curve, %.6g in SI: such noise moves the curve as a whole; let a parameter of its "
      .. "own do so (own = { zero = { from, to } }, which `against` adds)", self.what, tostring(told), span)
  end
  return length, false
end

--- The curve of that name in study.fit.data. note(path, text): told of the file that is read.
function curve.read(name, t, folder, note)
  local what = check(name, t)
  local columns, words = measured.read({ file = t.file, units = t.units }, folder, note)
  local self = setmetatable({ name = name, what = what, file = t.file, case = t.case or {}, each = t.each, own = t.own or {},
    against = t.against, weight = t.weight or 1, read = {}, x_name = t.x, y_name = t.y }, Curve)
  self.x, self.x_unit, self.x_word = column(t, "x", columns, words, what)
  self.y, self.y_unit, self.y_word = column(t, "y", columns, words, what)
  self.rows = {}
  for parameter, head in pairs(t.each or {}) do
    self.rows[parameter] = columns[head]
  end
  if not t.each or t.correlation ~= nil then
    check_rising(self)
  end
  if t.covariance then
    self.sigma, self.common = by_covariance(self, t.covariance, folder, note)
  else
    self.sigma = told_errors(t, columns, self.y, self.y_unit, what)
  end
  self.told, self.covariance = self.sigma ~= nil, t.covariance and t.covariance.file
  if t.white ~= nil then
    with_white(self, t.white)
  end
  local length
  length, self.estimated = told_length(self, t.correlation)
  if not t.covariance then
    self:correlate(length)
  end
  return self
end

--- Takes the noise for correlated along x over this length, SI (nil: not at all).
function Curve:correlate(length)
  self.length = length
  self.common = length and noise_module.along(self.x, length, self.shares)
  if not self.told then
    local noise = self.each and guess * math.abs((numeric.extreme(self.y))) or curve.noise(self.y, self.x, length)
    self.sigma = numeric.map(self.y, function() return noise end)
  end
end

--- How many independent points the curve's are worth.
function Curve:effective()
  return self.common and noise_module.effective(self.common, #self.x) or #self.x
end

--- The cases that the curve takes, each a table of values by name: `values` are those of the fit's parameters.
function Curve:cases(values)
  local list = {}
  for i = 1, self.each and #self.y or 1 do
    local own = {}
    for _, source in ipairs { self.case, values } do
      for name, value in pairs(source) do
        own[name] = value
      end
    end
    for name, column_of in pairs(self.rows) do
      own[name] = column_of[i]
    end
    list[i] = own
  end
  return list
end

local function in_si(self, list, unit, axis)
  if type(list) ~= "table" or units.is_quantity(list) then
    fault.script("%s: against must give two lists, xs and ys; its %s is %s", self.what, axis, tostring(list))
  end
  local own = {}
  for i, value in ipairs(list) do
    if units.is_quantity(value) and not like(value, unit) then
      fault.script("%s: against gives %s for %s, which is in %s in the file", self.what, tostring(value), axis, tostring(unit))
    end
    own[i] = units.si(value)
    if type(own[i]) ~= "number" or own[i] ~= own[i] then
      fault.script("%s: against gives no number: %s[%d] is %s", self.what, axis, i, tostring(value))
    end
  end
  return own
end

local function series_of(self, run, name, unit, axis)
  local values, word = run.time, "s"
  if name ~= "time" then
    local group, own = name:match("^([^/]+)/(.+)$")
    values, word = run:series(group or name, own or "")
  end
  local _, metre, kilogram, second = engine.parse_unit(word)
  if units.is_quantity(unit) and (unit.metre ~= metre or unit.kilogram ~= kilogram or unit.second ~= second) then
    fault.input("%s: %s of the run is in %s, %s of the file in %s", self.what, name, word, self[axis .. "_name"], self[axis .. "_word"])
  end
  return values
end

--- Points of the run that the curve is compared with.
local function points_of(self, run, p)
  local t = self.against
  if type(t) == "function" then
    return t(run, p)
  end
  local x, y = series_of(self, run, t.x, self.x_unit, "x"), series_of(self, run, t.y, self.y_unit, "y")
  local after, before, xs, ys = units.si(t.after) or -math.huge, units.si(t.before) or math.huge, {}, {}
  for i, time in ipairs(run.time) do
    if time >= after and time <= before then
      xs[#xs + 1], ys[#ys + 1] = (t.x_sign or 1) * x[i], (t.y_sign or 1) * y[i]
    end
  end
  return xs, ys
end

--- The same with rising x; what goes back is bad input.
local function rising(self, xs, ys)
  if #xs ~= #ys or #xs < 2 then
    fault.script("%s: against gives %d xs and %d ys; two lists of one length are wanted", self.what, #xs, #ys)
  end
  local sign, x, y = xs[#xs] > xs[1] and 1 or -1, {}, {}
  for i = 1, #xs do
    local k = sign > 0 and i or #xs + 1 - i
    if #x > 0 and xs[k] < x[#x] then
      fault.script("%s: the run's %s goes back and forth (%.6g after %.6g, in SI); let against give one way of it", self.what,
        self.x_name, xs[k], x[#x])
    elseif #x == 0 or xs[k] > x[#x] then
      x[#x + 1], y[#y + 1] = xs[k], ys[k]
    end
  end
  return x, y
end

--- What a run is at the curve's own x, in SI, by straight lines between its points; nil and why if it does not go so far.
local function along(self, run, p)
  local xs, ys = points_of(self, run, p)
  xs, ys = rising(self, in_si(self, xs, self.x_unit, "x"), in_si(self, ys, self.y_unit, "y"))
  local room, list = slack * (self.x[#self.x] - self.x[1]), {}
  if self.x[1] < xs[1] - room or self.x[#self.x] > xs[#xs] + room then
    return nil, ("the data go from %.6g to %.6g in %s (SI), the run from %.6g to %.6g"):format(self.x[1], self.x[#self.x], self.x_name,
      xs[1], xs[#xs])
  end
  local k = 1
  for i, x in ipairs(self.x) do
    while k < #xs - 1 and xs[k + 1] < x do
      k = k + 1
    end
    list[i] = ys[k] + (ys[k + 1] - ys[k]) * (x - xs[k]) / (xs[k + 1] - xs[k])
  end
  return list
end

--- The range of x, SI, that a run covers.
function Curve:range(run, p)
  local xs, ys = points_of(self, run, p)
  xs = rising(self, in_si(self, xs, self.x_unit, "x"), in_si(self, ys, self.y_unit, "y"))
  return xs[1], xs[#xs]
end

--- What the runs are at the curve's points, in SI; p: values that `against` is given with those of each run's own. nil and why
--- if a run does not go so far.
function Curve:model(runs, p)
  local function seen_by(run)
    local own = {}
    for name, value in pairs(run.p) do
      own[name] = value
    end
    for name, value in pairs(p) do
      own[name] = value
    end
    return setmetatable({}, { __index = function(_, name)
      self.read[name] = true
      return own[name]
    end, __pairs = function() return pairs(own) end })
  end
  if not self.each then
    return along(self, runs[1], seen_by(runs[1]))
  end
  local list = {}
  for i, run in ipairs(runs) do
    list[i] = in_si(self, { (self.against(run, seen_by(run))) }, self.y_unit, "y")[1]
      or fault.script("%s: against gives no number", self.what)
  end
  return list
end

--- A length along x, SI, in the unit of the file: "0.03 s"; as a study would write it: "0.03*s".
function Curve:along_x(length, written)
  local value = ("%.2g"):format(length / (self.x_word == "1" and 1 or engine.parse_unit(self.x_word)))
  if self.x_word == "1" then
    return value
  end
  local plain = self.x_word:find("^%a+$")
  return value .. (written and "*" or " ") .. (written and not plain and ('units("%s")'):format(self.x_word) or self.x_word)
end

--- By how much whitening makes noise grow that each point has for itself.
function Curve:roughened()
  return self.common and noise_module.roughened(self.common, #self.x) or 1
end

--- A list in standard errors without what its entries have in common by the correlation of the noise.
function Curve:whitened(list)
  return self.common and self.common:whitened(list) or list
end

--- The inverse of Curve:whitened.
function Curve:coloured(list)
  return self.common and self.common:coloured(list) or list
end

--- Residuals in standard errors, weighted, independent of each other, of what Curve:model gives.
function Curve:residuals(model)
  local list, weight = {}, math.sqrt(self.weight)
  for i, value in ipairs(model) do
    list[i] = weight * (value - self.y[i]) / self.sigma[i]
  end
  return self:whitened(list)
end

return curve
