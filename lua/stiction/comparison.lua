-- What differs between two outputs: cases, parameters, settings, results.
local engine = require "stiction.engine"
local manifests = require "stiction.manifest"
local ordered = require "stiction.ordered"

local comparison = {}

--- Text of a value, so that 8 and 8.0 are the same.
local function text_of(value)
  return type(value) == "number" and engine.number_text(value) or tostring(value)
end

--- Text that cases of the same parameters share.
local function key_of(outcome, case)
  local words = {}
  for _, column in ipairs(outcome.columns) do
    local value = case.values[column.name]
    words[#words + 1] = column.kind == "parameter" and value ~= nil and column.of .. "=" .. text_of(value) or nil
  end
  table.sort(words)
  return table.concat(words, "\n")
end

local ways = {
  { "parameters", function(outcome, case) return key_of(outcome, case) .. "\n\n" .. case.name end },
  { "parameters", key_of },
  { "name", function(_, case) return case.name end },
}

--- Cases matched by their parameters, else by their names: list of {a =, b =, by = "parameters" | "name"} in the order
--- of a's; then the cases that are in a alone, and in b alone.
function comparison.match(a, b)
  local by_case, taken, list, only_a, only_b = {}, {}, {}, {}, {}
  for _, way in ipairs(ways) do
    local found = {}
    for _, case in ipairs(b.cases) do
      found[way[2](b, case)] = not taken[case] and case or nil
    end
    for _, case in ipairs(a.cases) do
      local other = not by_case[case] and found[way[2](a, case)]
      if other and not taken[other] then
        by_case[case], taken[other] = { a = case, b = other, by = way[1] }, true
      end
    end
  end
  for _, case in ipairs(a.cases) do
    local to = by_case[case] and list or only_a
    to[#to + 1] = by_case[case] or case
  end
  for _, case in ipairs(b.cases) do
    only_b[#only_b + 1] = not taken[case] and case or nil
  end
  return list, only_a, only_b
end

--- Adds the values of nested tables to `found`, as texts under their paths: "bodies.block.material.young".
local function flatten(value, path, found)
  if type(value) ~= "table" then
    found[path] = text_of(value)
  elseif value.meaning and value.unit then -- as the manifest describes a value
    flatten(value.value == nil and "none" or value.value, path, found)
  elseif type(value[1]) == "number" then
    local words = {}
    for i, x in ipairs(value) do
      words[i] = text_of(x)
    end
    found[path] = "{" .. table.concat(words, ", ") .. "}"
  else
    for _, name in ipairs(ordered.keys(value)) do
      flatten(value[name], path == "" and tostring(name) or path .. "." .. tostring(name), found)
    end
  end
end

--- What a case was run with: by kind of setting, texts by their paths.
local function settings_of(outcome, case)
  local manifest = manifests.read(case.folder)
  local parameters, settings, files, program = {}, {}, {}, {}
  for _, column in ipairs(outcome.columns) do
    local value = case.values[column.name]
    if column.kind == "parameter" and value ~= nil then
      parameters[column.of] = text_of(value) .. (#column.unit > 1 and " " .. column.unit or "")
    end
  end
  for _, file in ipairs(type(manifest.files) == "table" and manifest.files or {}) do
    if type(file) == "table" then
      files[tostring(file.path)] = tostring(file.hash)
    end
  end
  flatten(manifest.parts or {}, "", settings)
  flatten(manifest.build or {}, "", program)
  return { { "parameter", parameters }, { "setting", settings }, { "file", files }, { "program", program } }
end

--- What the matched cases were run with that differs: list of {kind =, name =, a =, b = (texts), cases = names}, what
--- is alike in several cases once.
function comparison.settings(a, b, pairs_matched)
  local list, known = {}, {}
  local function note(pair, kind, name, left, right)
    local key = table.concat({ kind, name, left, right }, "\n")
    if not known[key] then
      known[key] = { kind = kind, name = name, a = left, b = right, cases = {} }
      list[#list + 1] = known[key]
    end
    table.insert(known[key].cases, pair.a.name)
  end
  for _, pair in ipairs(pairs_matched) do
    local one, other = settings_of(a, pair.a), settings_of(b, pair.b)
    for k, section in ipairs(one) do
      for _, name in ipairs(ordered.keys_of(section[2], other[k][2])) do
        local left, right = section[2][name] or "none", other[k][2][name] or "none"
        if left ~= right then
          note(pair, section[1], name, left, right)
        end
      end
    end
  end
  return list
end

--- The difference of two values: absolute, and relative to the larger one; infinite where they cannot be subtracted.
local function distance(left, right)
  if left == right or left ~= left and right ~= right then
    return 0, 0
  elseif left ~= left or right ~= right then
    return nil, math.huge
  elseif type(left) ~= "number" or type(right) ~= "number" then
    return nil, math.huge
  end
  local absolute = math.abs(left - right)
  return absolute, absolute / math.max(math.abs(left), math.abs(right))
end

local function bound(outcome, case, name)
  local column = outcome.by_key["error " .. name .. "_error"]
  return column and case.values[column.name]
end

--- Results and verdicts of the matched cases: list of {case =, name =, unit =, a =, b =, absolute =, relative =,
--- bound_a =, bound_b =} of those further apart than the tolerance, the furthest first, and the number of the others.
function comparison.results(a, b, pairs_matched, tolerance)
  local list, equal = {}, 0
  local function compare(pair, key, column, other)
    local left, right = column and pair.a.values[column.name], other and pair.b.values[other.name]
    local absolute, relative = distance(left, right)
    if relative > tolerance then
      local name = (column or other).of
      list[#list + 1] = { case = pair.a.name, name = name, unit = (column or other).unit, a = left, b = right,
        at = #list, absolute = absolute, relative = relative, bound_a = bound(a, pair.a, name),
        bound_b = bound(b, pair.b, name) }
    elseif left ~= nil or key == "word verdict" then
      equal = equal + 1
    end
  end
  for _, pair in ipairs(pairs_matched) do
    for _, key in ipairs(ordered.keys_of(a.by_key, b.by_key)) do
      if key == "word verdict" or key:find("^result ") then
        compare(pair, key, a.by_key[key], b.by_key[key])
      end
    end
  end
  table.sort(list, function(one, other)
    if one.relative ~= other.relative then
      return one.relative > other.relative
    end
    return one.at < other.at
  end)
  return list, equal
end

return comparison
