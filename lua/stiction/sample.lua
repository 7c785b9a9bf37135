-- Lists of cases for study.sweep that are no grid: values side by side, Latin hypercubes and Sobol points.
local calls = require "stiction.calls"
local engine = require "stiction.engine"
local fault = require "stiction.fault"
local ordered = require "stiction.ordered"
local units = require "stiction.units"

local sample = {}

local most_axes = 16 -- of Sobol points: the dimensions in the table below
local bits = 52 -- of a Sobol point's coordinate

-- Primitive polynomials and initial direction numbers by dimension from the second on: degree, coefficients, numbers.
-- S. Joe, F. Y. Kuo, SIAM J. Sci. Comput. 30 (2008) 2635, new-joe-kuo-6.
local directions = {
  { 1, 0, { 1 } }, { 2, 1, { 1, 3 } }, { 3, 1, { 1, 3, 1 } }, { 3, 2, { 1, 1, 1 } }, { 4, 1, { 1, 1, 3, 3 } },
  { 4, 4, { 1, 3, 5, 13 } }, { 5, 2, { 1, 1, 5, 5, 17 } }, { 5, 4, { 1, 1, 5, 5, 5 } }, { 5, 7, { 1, 1, 7, 11, 19 } },
  { 5, 11, { 1, 1, 5, 1, 1 } }, { 5, 13, { 1, 1, 1, 3, 11 } }, { 5, 14, { 1, 3, 5, 5, 31 } },
  { 6, 1, { 1, 3, 3, 9, 7, 49 } }, { 6, 13, { 1, 1, 1, 15, 21, 21 } }, { 6, 16, { 1, 3, 1, 13, 27, 49 } },
}

--- Random numbers that a seed decides, in [0, 1): splitmix64.
local function generator(seed)
  local state = seed
  local function whole()
    state = state + 0x9e3779b97f4a7c15
    local z = state
    z = (z ~ (z >> 30)) * 0xbf58476d1ce4e5b9
    z = (z ~ (z >> 27)) * 0x94d049bb133111eb
    return z ~ (z >> 31)
  end
  return function() return (whole() >> 11) * 2.0 ^ -53 end, whole
end

local function shuffled(list, random)
  for i = #list, 2, -1 do
    local k = 1 + math.floor(random() * i)
    list[i], list[k] = list[k], list[i]
  end
  return list
end

--- Coordinates of one axis, one in each of #points + extra strata as far as those there allow.
local function extend(points, extra, random)
  local count, taken, free = #points + extra, {}, {}
  for _, x in ipairs(points) do
    taken[math.floor(x * count)] = true
  end
  for stratum = 0, count - 1 do
    free[#free + 1] = not taken[stratum] and stratum or nil
  end
  for k, stratum in ipairs(shuffled(free, random)) do
    if k <= extra then
      points[#points + 1] = (stratum + random()) / count
    end
  end
end

--- The blocks that a count consists of: those of a list; of a number its odd part and the same again until it is whole,
--- so that twice as many keep the first.
local function blocks_of(count)
  if type(count) == "table" then
    return count
  end
  local odd = count
  while odd % 2 == 0 do
    odd = odd // 2
  end
  local blocks, total = { odd }, odd
  while total < count do
    blocks[#blocks + 1], total = total, 2 * total
  end
  return blocks
end

--- Direction numbers of a dimension.
local function directions_of(dimension)
  local v = {}
  local degree, coefficients, first = table.unpack(directions[dimension - 1] or { 0, 0, {} })
  for i = 1, bits do
    if dimension == 1 then
      v[i] = 1 << (bits - i)
    elseif i <= degree then
      v[i] = first[i] << (bits - i)
    else
      v[i] = v[i - degree] ~ (v[i - degree] >> degree)
      for k = 1, degree - 1 do
        v[i] = v[i] ~ (((coefficients >> (degree - 1 - k)) & 1) * v[i - k])
      end
    end
  end
  return v
end

--- Points of one dimension, in the order of Gray's code, all shifted alike.
local function sobol_axis(dimension, count, shift)
  local v, x, points = directions_of(dimension), 0, {}
  for n = 1, count do
    points[n] = ((x ~ shift) + 0.5) * 2.0 ^ -bits
    local zero, k = 1, n - 1
    while k & 1 == 1 do
      zero, k = zero + 1, k >> 1
    end
    x = x ~ v[zero]
  end
  return points
end

--- A whole number that this one and the key decide, as if drawn at random (the last steps of splitmix64).
local function mixed(z, key)
  z = (z ~ key) * 0xbf58476d1ce4e5b9
  z = (z ~ (z >> 30)) * 0x94d049bb133111eb
  z = (z ~ (z >> 27)) * 0xbf58476d1ce4e5b9
  return z ~ (z >> 31)
end

local nested_bits = 20 -- that are each turned by those before them; the others are drawn

--- A coordinate whose every bit is turned or not as those above it decide (Owen 1995): points stay as even as they were along each
--- axis, and what two axes have in common is no longer the same at each seed.
local function scrambled(x, key)
  local whole, kept = math.floor(x * 2.0 ^ bits), 0
  for i = 1, nested_bits do
    local place = bits - i
    kept = kept | ((((whole >> place) ~ mixed((whole >> (place + 1)) + i, key)) & 1) << place)
  end
  local rest = bits - nested_bits
  return (kept + (mixed(whole >> rest, ~key) & ((1 << rest) - 1)) + 0.5) * 2.0 ^ -bits
end

local kinds = { log = true, whole = true }

--- The value at x in [0, 1) of an axis { low, high, "log" | "whole" | nil }.
local function value_at(axis, x)
  if axis[3] == "log" then
    return axis[1] * (axis[2] / axis[1]) ^ x
  elseif axis[3] == "whole" then
    return math.floor(axis[1] + (axis[2] - axis[1] + 1) * x)
  end
  return axis[1] + (axis[2] - axis[1]) * x
end

local function check_axis(word, name, axis)
  local low, high = units.si(type(axis) == "table" and axis[1]), units.si(type(axis) == "table" and axis[2])
  local numbers = not units.is_quantity(axis) and type(low) == "number" and type(high) == "number"
  local plain = numbers and not units.is_quantity(axis[1]) and not units.is_quantity(axis[2])
  local like = plain or numbers and units.same_dimension(axis[1], axis[2])
  if not like or low >= high or axis[3] and not kinds[axis[3]] or axis[3] == "whole" and not plain then
    fault.script("%s: of.%s must be { low, high }, { low, high, \"log\" } or { low, high, \"whole\" }", word, tostring(name))
  elseif axis[3] == "log" and low <= 0 then
    fault.script("%s: of.%s: a logarithmic axis begins above 0", word, tostring(name))
  end
end

local known = { count = true, seed = true, of = true }

local function whole_from(least, x)
  return math.type(x) == "integer" and x >= least
end

local function counts_hold(count)
  for _, block in ipairs(type(count) == "table" and count or { count }) do
    if not whole_from(1, block) then
      return false
    end
  end
  return type(count) == "table" and #count > 0 or type(count) == "number"
end

--- The names of the axes of { count =, seed =, of = { name = { low, high } } }.
local function read(word, t)
  for key in pairs(type(t) == "table" and t or fault.script("%s takes one table", word)) do
    if not known[key] then
      fault.script("%s: unknown key '%s'%s; it has count, seed and of", word, tostring(key), fault.meant(key, { "count", "seed", "of" }))
    end
  end
  if not counts_hold(t.count) or not whole_from(0, t.seed) then
    fault.script("%s needs count = a whole number above 0, and seed = a whole number, which is written down", word)
  elseif type(t.of) ~= "table" or #ordered.keys(t.of) == 0 then
    fault.script("%s needs of = { name = { low, high }, ... }", word)
  end
  for name, axis in pairs(t.of) do
    check_axis(word, name, axis)
  end
  return ordered.keys(t.of)
end

local function total_of(count)
  local total = 0
  for _, block in ipairs(type(count) == "table" and count or { count }) do
    total = total + block
  end
  return total
end

--- Cases called s1, s2, ..., of the coordinates by name.
local function cases_of(t, names, coordinates, word)
  local list, ids = {}, {}
  for i = 1, total_of(t.count) do
    list[i], ids[i] = {}, ("s%d"):format(i)
    for _, name in ipairs(names) do
      list[i][name] = value_at(t.of[name], coordinates[name][i])
    end
  end
  return setmetatable(list, { ids = ids, sample = { kind = word, seed = t.seed, count = t.count } })
end

--- Values side by side: zip{ mu = { 0.1, 0.2 }, speed = { v1, v2 } } are two cases.
function sample.zip(t)
  local list, length = {}, nil
  for _, name in ipairs(ordered.keys(t)) do
    local values = t[name]
    length = length or type(values) == "table" and #values
    if type(values) ~= "table" or units.is_quantity(values) or #values ~= length or length == 0 then
      fault.script("sample.zip: '%s' must be a list as long as the others", tostring(name))
    end
    for i = 1, length do
      list[i] = list[i] or {}
      list[i][name] = values[i]
    end
  end
  return list
end

--- A Latin hypercube: latin_hypercube{ count = 20, seed = 1, of = { mu = { 0.1, 0.5 }, speed = { v1, v2, "log" } } }; each of
--- count equal parts of every axis holds one case. Twice the count keeps the cases; count = { 20, 10 } adds 10 to 20.
function sample.latin_hypercube(t)
  local names, coordinates = read("sample.latin_hypercube", t), {}
  for _, name in ipairs(names) do
    local random = generator(t.seed ~ tonumber(engine.hash(name), 16))
    coordinates[name] = {}
    for _, block in ipairs(blocks_of(t.count)) do
      extend(coordinates[name], block, random)
    end
  end
  return cases_of(t, names, coordinates, "latin_hypercube")
end

--- Points of Sobol's sequence, shifted by the seed: sobol{ count = 64, seed = 1, of = { ... } } as a Latin hypercube; a
--- larger count keeps the cases. Powers of 2 fill the space most evenly; up to 16 axes.
function sample.sobol(t)
  local names, coordinates = read("sample.sobol", t), {}
  if #names > most_axes then
    fault.script("sample.sobol: %d axes, at most %d", #names, most_axes)
  end
  for k, name in ipairs(names) do
    local _, whole = generator(t.seed * 1000003 + k)
    coordinates[name] = sobol_axis(k, total_of(t.count), whole() >> (64 - bits))
  end
  return cases_of(t, names, coordinates, "sobol")
end

--- Points of Sobol's sequence in 0 to 1, {x1, ..., x_axes} each, scrambled by the seed; a larger count keeps them.
function sample.scrambled_points(axes, count, seed)
  if axes > most_axes then
    fault.script("study.sample: %d axes of points, at most %d", axes, most_axes)
  end
  local list = {}
  for k = 1, axes do
    local _, whole = generator(seed * 1000003 + k)
    local key = whole()
    for i, x in ipairs(sobol_axis(k, count, 0)) do
      list[i] = list[i] or {}
      list[i][k] = scrambled(x, key)
    end
  end
  return list
end

--- What a list of cases was drawn with: {kind =, seed =, count =}, and their names; nil of any other list.
function sample.drawn(list)
  local meta = getmetatable(list)
  if type(meta) == "table" and meta.sample then
    return meta.sample, meta.ids
  end
end

--- What scripts see.
sample.functions = setmetatable(calls.functions({ zip = sample.zip, latin_hypercube = sample.latin_hypercube,
  sobol = sample.sobol }, "sample"), {
  __index = function(_, name)
    fault.script("there is no sample.%s%s", tostring(name), fault.meant(name, { "zip", "latin_hypercube", "sobol" }))
  end,
})

return sample
