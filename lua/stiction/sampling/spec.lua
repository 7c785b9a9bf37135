-- What a study declares as its sample: uncertain parameters with distributions, or a fit's, or a list; how many points, of which design.
local copy = require "stiction.copy"
local csv_module = require "stiction.measured"
local declared = require "stiction.declared"
local engine = require "stiction.engine"
local fault = require "stiction.fault"
local fitted = require "stiction.sampling.fitted"
local numeric = require "stiction.numeric"
local ordered = require "stiction.ordered"
local sample = require "stiction.sample"
local sweep = require "stiction.sweep"
local units = require "stiction.units"

local spec = {}

local keys = { of = "table", fit = true, list = true, design = "string", count = "number", seed = "number", results = "table",
  set = "table", quick = "table" }
local designs = { sobol = true, latin_hypercube = true, saltelli = true }
local most_points = 100000 -- each is a case with a folder of its own
local tail = 1e-9 -- coordinates keep away so far from 0 and 1, where normal ones are infinite

--- By name: {needs = words, kind = of its coordinate in polynomials, check(a, b), value(a, b, u)} in SI.
local distributions = {
  uniform = { needs = "{ low, high }, low below high", kind = "uniform", check = function(a, b) return a < b end,
    value = function(a, b, u) return a + (b - a) * u end },
  log_uniform = { needs = "{ low, high }, both above 0", kind = "uniform", check = function(a, b) return a > 0 and a < b end,
    value = function(a, b, u) return a * (b / a) ^ u end },
  normal = { needs = "{ mean, standard deviation }", kind = "normal", check = function(_, b) return b > 0 end,
    value = function(a, b, u) return a + b * engine.quantile(u) end },
  log_normal = { needs = "{ median, standard deviation of the logarithm, a pure number }", kind = "normal", pure = true,
    check = function(a, b) return a > 0 and b > 0 end, value = function(a, b, u) return a * math.exp(b * engine.quantile(u)) end },
}

local function si_pair(entry)
  local a, b = type(entry) == "table" and entry[1], type(entry) == "table" and entry[2]
  return units.si(a), units.si(b), a, b
end

--- {name =, like =, kind =, value = function(u)} of one entry of study.sample.of.
local function axis(name, entry, standing)
  local what = "study.sample.of." .. name
  local word = type(entry) == "table" and not units.is_quantity(entry) and ordered.keys(entry)[1]
  local own = type(word) == "string" and distributions[word]
  if not own or #ordered.keys(entry) ~= 1 then
    fault.script("%s must be one of { uniform = { low, high } }, { log_uniform = ... }, { normal = ... }, { log_normal = ... }%s", what,
      fault.meant(tostring(word), ordered.keys(distributions)))
  end
  local a, b, first, second = si_pair(entry[word])
  local like = own.pure and not units.is_quantity(second)
    or not own.pure and (units.same_dimension(first, second) or not units.is_quantity(first) and not units.is_quantity(second))
  if type(a) ~= "number" or type(b) ~= "number" or not like or not own.check(a, b) then
    fault.script("%s: %s takes %s%s, not { %s, %s }", what, word, own.needs, own.pure and "" or ", both of one dimension", tostring(first),
      tostring(second))
  elseif standing == nil then
    fault.script("%s: the study has no such parameter", what)
  elseif units.is_quantity(standing) ~= units.is_quantity(first)
    or units.is_quantity(first) and not units.same_dimension(standing, first) then
    fault.script("%s is in %s, but the study's own value is %s", what, tostring(first), tostring(standing))
  end
  return { name = name, like = first, kind = own.kind, value = function(u) return own.value(a, b, u) end }
end

--- The rows of a file of points, as values by name.
local function rows_of(file, folder)
  local rows = {}
  for name, values in pairs(csv_module.read(file, folder)) do
    for i, value in ipairs(values) do
      rows[i] = rows[i] or {}
      rows[i][name] = value
    end
  end
  return rows
end

--- The user's own list of points, as values by name; bad input where one is none of the study.
local function listed(study, t, options)
  local file = type(t.list) == "string" and t.list
  local list = file and rows_of(file, study.source.folder) or t.list
  if type(list) ~= "table" or #list < 2 then
    fault.script("study.sample.list must be a list of two points or more, each { name = value, ... }, or the name of a .csv file%s",
      file and (" with as many rows; %s has %d"):format(file, #list) or "")
  end
  for i, point in ipairs(list) do
    local what = "study.sample.list" .. (file and (": %s: row %d"):format(file, i) or ("[%d]"):format(i))
    if type(point) ~= "table" or units.is_quantity(point) or #ordered.keys(point) == 0 or #point > 0 then
      fault.script("%s is %s; { name = value, ... } is wanted", what, type(point) == "table" and not units.is_quantity(point)
        and "a table that lacks names" or tostring(point))
    end
    local values = copy(t.set or {})
    for name, value in pairs(point) do
      values[name] = value
    end
    sweep.values_at(study, options, values, what, file and function(name)
      return point[name] and ("%s, column '%s'"):format(what, name) or "study.sample.set"
    end)
  end
  return list
end

local function read_results(study, t)
  local list = {}
  for _, name in ipairs(t.results or numeric.map(study.results, function(entry) return entry.name end)) do
    local at = numeric.first_where(study.results, function(entry) return entry.name == name end)
    list[#list + 1] = at and study.results[at] or fault.input("study.sample: the study has no result '%s'%s", tostring(name),
      fault.meant(tostring(name), numeric.map(study.results, function(entry) return entry.name end)))
  end
  if #list == 0 then
    fault.input("study.sample: the study has no results to tell the spread of")
  end
  return list
end

local function check(t, asked)
  local what = asked and "--count %s" or "study.sample: count = %s"
  local ways = (t.of and 1 or 0) + (t.fit and 1 or 0)
  if t.list and ways > 0 or not t.list and ways == 0 then
    fault.script("study.sample needs of = { name = { uniform = { low, high } }, ... } or fit = true or \"fit.json\", or, alone, list = "
      .. "{ ... }; see 'stiction help sample'")
  elseif not designs[t.design] then
    fault.script("study.sample: design = '%s'%s; it is one of %s", tostring(t.design), fault.meant(tostring(t.design),
      ordered.keys(designs)), table.concat(ordered.keys(designs), ", "))
  elseif not t.list and (math.type(t.count) ~= "integer" or t.count < 2) then
    fault.script(what .. "; a whole number of points, 2 or more, is wanted", tostring(t.count))
  elseif not t.list and t.count > most_points then
    fault.script(what .. "; it is 2 to %d, each a case of its own: take fewer points", t.count, most_points)
  elseif math.type(t.seed) ~= "integer" or t.seed < 0 then
    fault.script("study.sample: seed = %s; a whole number, which is written down, is wanted", tostring(t.seed))
  end
end

local function within(x)
  return math.min(math.max(x, tail), 1 - tail)
end

--- Points in 0 to 1, lists by axis; of saltelli's design twice as many axes, scrambled, as few points of Sobol's sequence itself lie
--- along few lines of two axes, which no resampling of them can tell.
local function drawn(own)
  if own.design == "saltelli" then
    local points = sample.scrambled_points(2 * #own.axes, own.count, own.seed)
    return numeric.map(points, function(point) return numeric.map(point, within) end)
  end
  local axes, of, list = #own.axes, {}, {}
  for k = 1, axes do
    of[("x%02d"):format(k)] = { 0, 1 }
  end
  local draw = own.design == "latin_hypercube" and sample.latin_hypercube or sample.sobol
  for i, case in ipairs(draw { count = own.count, seed = own.seed, of = of }) do
    list[i] = {}
    for k = 1, axes do
      list[i][k] = within(case[("x%02d"):format(k)])
    end
  end
  return list
end

--- The coordinates of all points of a sample, in 0 to 1, in their order; of saltelli's design A, B and each of A with one of B, in turn.
function spec.coordinates(own)
  local list, points = {}, drawn(own)
  local n = #own.axes
  for i, point in ipairs(points) do
    if own.design ~= "saltelli" then
      list[i] = point
    else
      local A, B = table.move(point, 1, n, 1, {}), table.move(point, n + 1, 2 * n, 1, {})
      list[#list + 1], list[#list + 2] = A, B
      for k = 1, n do
        local mixed = table.move(A, 1, n, 1, {})
        mixed[k] = B[k]
        list[#list + 1] = mixed
      end
    end
  end
  return list
end

--- Values in SI by place of the axes at coordinates in 0 to 1.
function spec.values(own, u)
  local xi = numeric.map(u, function(x) return engine.quantile(x) end)
  local values = {}
  for k, axis_of in ipairs(own.axes) do
    values[k] = axis_of.together and axis_of.together(xi) or axis_of.value(u[k])
  end
  return values
end

--- The sample of a study: {axes =, list = (of the user's own points), design =, count =, seed =, results =, set =, joint =, fit = (as of
--- fitted.read)}.
function spec.read(study, options)
  local t = declared(study, options, "sample", keys, "{ of = { ... } }")
  t.design, t.seed, t.count = t.design or "sobol", t.seed or 1, options.count or t.count or 64
  t.count = math.tointeger(t.count) or t.count
  check(t, options.count)
  local own = { design = t.design, count = t.count, seed = t.seed, results = read_results(study, t), set = copy(t.set or {}), axes = {} }
  if t.list then
    own.list, own.design = listed(study, t, options), "list"
    return own
  end
  if t.fit then
    local others = copy(t.of or {})
    for name, value in pairs(own.set) do
      others[name] = value
    end
    own.fit = fitted.read(study, t.fit, options, others)
    own.axes, own.joint = own.fit.axes, true
    for _, entry in ipairs(own.fit.held) do
      own.set[entry.name] = entry.value
    end
  end
  local probe = copy(own.set)
  for _, name in ipairs(ordered.keys(t.of or {})) do
    local entry = t.of[name]
    if own.set[name] ~= nil then
      fault.script("study.sample: '%s' stands in both of and set (%s); leave it in one of them", name, tostring(own.set[name]))
    end
    local word = type(entry) == "table" and not units.is_quantity(entry) and ordered.keys(entry)[1]
    probe[name] = type(word) == "string" and type(entry[word]) == "table" and not units.is_quantity(entry[word]) and entry[word][1]
      or type(word) == "number" and entry[1] or nil
  end
  for _, own_axis in ipairs(own.axes) do
    probe[own_axis.name] = own_axis.like
  end
  local standing = sweep.values_at(study, options, probe, "study.sample")
  local told = sweep.settings_of(study, options)
  for _, name in ipairs(ordered.keys(t.of or {})) do
    if told[name] ~= nil then
      fault.input("--set %s: '%s' is what study.sample draws, and has no single value", name, name)
    end
    own.axes[#own.axes + 1] = axis(name, t.of[name], standing[name])
  end
  local cases = own.design == "saltelli" and own.count * (#own.axes + 2) or own.count
  if cases > most_points then
    fault.script("study.sample: count = %d of saltelli's design are %d cases, at most %d: take fewer points", own.count, cases, most_points)
  end
  return own
end

return spec
