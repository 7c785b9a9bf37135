-- What a sample leaves: sample.json (all that is told of results, in SI), sample.csv (a row per point).
local csv = require "stiction.csv"
local engine = require "stiction.engine"
local identity = require "stiction.identity"
local numeric = require "stiction.numeric"
local units = require "stiction.units"

local record = {}

--- Lists by place of the axes, as tables by their names.
local function named(own, list)
  local result = setmetatable({}, { json = "object" })
  for k, axis in ipairs(own.axes) do
    result[axis.name] = list[k]
  end
  return result
end

local function indices_of(own, its)
  return its and its.first and { first = named(own, its.first), total = named(own, its.total),
    first_error = its.first_error and named(own, its.first_error), total_error = its.total_error and named(own, its.total_error) } or nil
end

local function result_table(own, result)
  local polynomial = result.chaos
  return { name = result.name, unit = result.unit, meaning = result.meaning, failed = result.failed, moments = result.moments,
    quantiles = result.quantiles, indices = indices_of(own, result.indices),
    polynomial = polynomial and { degree = polynomial.degree, terms = polynomial.terms, error = polynomial.error, mean = polynomial.mean,
      deviation = polynomial.deviation, indices = indices_of(own, polynomial) } }
end

--- What is drawn as a fit has it, and whose it is.
local function drawn(own)
  local list = {}
  for _, axis in ipairs(own.axes) do
    list[#list + 1] = axis.joint and { name = axis.name, curve = axis.curve, best = axis.best, relative_error = axis.relative_error } or nil
  end
  for _, entry in ipairs(own.fit.held) do
    list[#list + 1] = { name = entry.name, curve = entry.curve, best = units.si(entry.value), held = true }
  end
  return list
end

--- All of it as a table for JSON.
function record.table(own, study, options, found)
  return { study = study.source.file, name = study.name, title = study.title, version = engine.version, quick = options.quick or false,
    set = options.set or {}, design = own.design, count = own.count, seed = own.seed, points = found.count,
    fit = own.fit and own.fit.source, parameters = numeric.map(own.axes, function(axis) return axis.name end),
    drawn = own.fit and drawn(own) or nil,
    results = numeric.map(found.results, function(result) return result_table(own, result) end),
    failed = numeric.map(found.failures, function(entry)
      return { case = entry.case, reason = entry.reason, values = identity.plain(entry.values) }
    end),
    failed_lie = numeric.map(found.where, function(place)
      return { parameter = own.axes[place.axis].name, side = place.side, from = place.from, to = place.to, chance = place.chance }
    end) }
end

local function write_points(found)
  local names = found.names
  local head = table.move(names, 1, #names, 2, { "case" })
  for _, result in ipairs(found.results) do
    head[#head + 1] = result.name
  end
  head[#head + 1] = "verdict"
  local lines = { table.concat(numeric.map(head, csv.word), ",") }
  for i, row in ipairs(found.rows) do
    local words = { row.case.id }
    for _, name in ipairs(names) do
      words[#words + 1] = csv.word(row.case.p[name])
    end
    for _, result in ipairs(found.results) do
      words[#words + 1] = result.values[i] and csv.word(result.values[i]) or "nan"
    end
    words[#words + 1] = csv.word((row.result or {}).verdict)
    lines[#lines + 1] = table.concat(words, ",")
  end
  engine.write_file(found.folder .. "/sample.csv", table.concat(lines, "\n") .. "\n")
end

--- Writes the files of a sample into its folder.
function record.write(own, study, options, found)
  engine.write_file(found.folder .. "/sample.json", engine.encode_json(record.table(own, study, options, found), 2) .. "\n")
  write_points(found)
end

return record
