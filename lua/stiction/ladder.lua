-- The runs of a trade: every knob alone from the default settings, all numbers at their finest, then combinations.
local fault = require "stiction.fault"
local ordered = require "stiction.ordered"
local units = require "stiction.units"

local ladder = {}

local most = 5000 -- combinations of all levels

--- Whether two settings are one: numbers and quantities to what a text of them keeps.
function ladder.same(a, b)
  if units.is_quantity(a) or units.is_quantity(b) then
    return units.same_dimension(a, b) and ladder.same(a.si, b.si)
  elseif type(a) == "number" and type(b) == "number" then
    return math.abs(a - b) <= 1e-9 * math.max(math.abs(a), math.abs(b))
  end
  return a == b
end

--- Position of a value among the levels of a knob, nil if it is none of them.
function ladder.level_of(knob, value)
  for i, level in ipairs(knob.levels) do
    if ladder.same(level, value) then
      return i
    end
  end
end

--- Resolution of a number that is refined towards its last level: itself if it falls, its inverse if it rises.
function ladder.resolution(knob, level)
  local value = units.si(knob.levels[level])
  return knob.falls and value or 1 / value
end

local nearest, farthest = 1.5, 4 -- by which one level is finer than another
local tolerance = 10 -- levels so far apart are of a tolerance, not of a resolution

--- The next value of a number that is finer, and by what its resolution falls; nil beyond the last of a tolerance.
function ladder.finer(knob, value)
  local levels, si = knob.levels, units.si(value)
  for level = 1, #levels do
    local ratio = knob.falls and si / units.si(levels[level]) or units.si(levels[level]) / si
    local own = level > 1 and ladder.same(levels[level - 1], value)
    if own and ratio > 1 or ratio >= nearest and ratio <= farthest then
      return levels[level], ratio
    end
  end
  local last = ladder.resolution(knob, #levels - 1) / ladder.resolution(knob, #levels)
  if last >= tolerance then
    return nil
  end
  local whole = math.type(units.si(levels[1])) == "integer"
  return knob.falls and value / 2 or whole and math.ceil(2 * value) or 2 * value, 2
end

local function check_numbers(knob)
  local before
  for _, level in ipairs(knob.levels) do
    local value = units.si(level)
    if type(value) ~= "number" or value <= 0 then
      fault.input("study.trade: the levels of '%s' must all be numbers above 0, or all words or flags", knob.name)
    elseif before and (value < before) ~= knob.falls or value == before then
      fault.input("study.trade: the levels of '%s' must rise or fall, towards the finest", knob.name)
    end
    before = value
  end
end

--- {name =, label =, levels =, numeric =, falls =, default = (level)} of one entry of study.trade.knobs.
local function read_knob(entry, base)
  local name, levels = entry.name or entry[1], entry.levels or entry[2]
  if type(name) ~= "string" or type(levels) ~= "table" or #levels < 2 then
    fault.input("study.trade.knobs: each is { \"name\", { at least two levels, the finest last } }")
  end
  local label = tostring(entry.label or name)
  local knob = { name = name, label = label, levels = levels, numeric = type(units.si(levels[1])) == "number" }
  if knob.numeric then
    knob.falls = units.si(levels[2]) < units.si(levels[1])
    check_numbers(knob)
  end
  if base[name] == nil then
    fault.input("study.trade.knobs: the study has no parameter '%s'%s", name, fault.meant(name, ordered.keys(base)))
  end
  knob.default = ladder.level_of(knob, base[name])
    or fault.input("study.trade.knobs: the default %s = %s must be one of its levels", name, tostring(base[name]))
  return knob
end

--- The knobs of study.trade; `base` holds the settings in force by name.
function ladder.knobs(entries, base)
  local knobs, count = {}, 1
  for i, entry in ipairs(entries) do
    knobs[i] = read_knob(entry, base)
    count = count * #knobs[i].levels
  end
  if #knobs == 0 then
    fault.input("study.trade.knobs lists no knob")
  elseif count > most then
    fault.input("study.trade: %d combinations of levels, at most %d; give fewer", count, most)
  end
  return knobs
end

--- Levels of the default settings; `changes` by knob name replace some.
function ladder.levels(knobs, changes)
  local levels = {}
  for i, knob in ipairs(knobs) do
    levels[i] = changes and changes[knob.name] or knob.default
  end
  return levels
end

--- Levels with every number at its finest.
function ladder.corner(knobs)
  local changes = {}
  for _, knob in ipairs(knobs) do
    changes[knob.name] = knob.numeric and #knob.levels or knob.default
  end
  return ladder.levels(knobs, changes)
end

--- Levels as one word.
function ladder.key(levels)
  return table.concat(levels, " ")
end

--- Runs by the word of their levels; a run is {levels =, values = {by quantity}, work =, ...}, values nil if it did not
--- finish.
function ladder.index(runs)
  local by_levels = {}
  for _, run in ipairs(runs) do
    by_levels[ladder.key(run.levels)] = run
  end
  return by_levels
end

--- The runs of the first round: the default, each knob alone, the corner; lists of levels, without repeats.
function ladder.first_round(knobs)
  local rounds, seen = {}, {}
  local function add(levels)
    local key = ladder.key(levels)
    if not seen[key] then
      rounds[#rounds + 1], seen[key] = levels, true
    end
  end
  add(ladder.levels(knobs))
  for _, knob in ipairs(knobs) do
    for level = 1, #knob.levels do
      add(ladder.levels(knobs, { [knob.name] = level }))
    end
  end
  add(ladder.corner(knobs))
  return rounds
end

return ladder
