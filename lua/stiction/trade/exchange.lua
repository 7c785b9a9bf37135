-- What the runs of a trade tell: the reference with its uncertainty, errors, the front, combinations worth a run.
local extrapolation = require "stiction.trade.extrapolation"
local ladder = require "stiction.trade.ladder"

local exchange = {}

local function key_of(levels)
  return table.concat(levels, " ")
end

--- Runs by their levels; a run is {levels =, values = {by quantity}, work =, ...}, values nil if it did not finish.
local function index(runs)
  local by_levels = {}
  for _, run in ipairs(runs) do
    by_levels[key_of(run.levels)] = run
  end
  return by_levels
end

--- {h =, value =, work =} of the finished runs along one numeric knob through the default, the finest last.
function exchange.line(knobs, runs, knob, quantity)
  local by_levels, line = index(runs), {}
  for level = 1, #knob.levels do
    local run = by_levels[key_of(ladder.levels(knobs, { [knob.name] = level }))]
    if run and run.values then
      line[#line + 1] = { h = ladder.resolution(knob, level), value = run.values[quantity], work = run.work, run = run }
    end
  end
  return line
end

--- {value =, uncertainty =} of one quantity: the corner and, knob by knob, the correction to its limit. The corrections
--- are those of the lines through the default; how far the corner is from the sum of these lines tells how much less
--- they hold there, and adds to the uncertainty.
local function reference_of(knobs, runs, quantity)
  local by_levels = index(runs)
  local default, corner = by_levels[key_of(ladder.levels(knobs))], by_levels[key_of(ladder.corner(knobs))]
  if not (default and default.values and corner and corner.values) then
    return nil
  end
  local sum, correction, squares = default.values[quantity], 0, 0
  for _, knob in ipairs(knobs) do
    if knob.numeric then
      local line = exchange.line(knobs, runs, knob, quantity)
      local limit = extrapolation.limit(line)
      sum = sum + line[#line].value - default.values[quantity]
      correction, squares = correction + limit.correction, squares + limit.uncertainty ^ 2
    end
  end
  local interaction = 0.5 * math.abs(corner.values[quantity] - sum)
  return {
    value = corner.values[quantity] + correction,
    uncertainty = math.sqrt(squares + math.min(interaction, math.abs(correction)) ^ 2),
  }
end

--- References of all quantities {name =, scale = nil | number}: by name {value =, uncertainty =, scale =}, the last two
--- in the quantity's unit; nil and the reason if the default or the finest run did not finish.
function exchange.references(knobs, runs, quantities)
  local references = {}
  for _, quantity in ipairs(quantities) do
    local reference = reference_of(knobs, runs, quantity.name)
    if not reference then
      return nil, "the default run or the finest one did not finish: there is nothing to compare with"
    end
    reference.scale = quantity.scale or math.abs(reference.value)
    if reference.scale == 0 then
      return nil, ("'%s' tends to 0: give it a scale in study.trade.quantities"):format(quantity.name)
    end
    references[quantity.name] = reference
  end
  return references
end

--- Adds errors = {by quantity, relative to the scale}, error (the largest) and band (of that error) to finished runs.
function exchange.judge(runs, references, quantities)
  for _, run in ipairs(runs) do
    if run.values then
      run.errors, run.error, run.bound = {}, 0, 0
      for _, quantity in ipairs(quantities) do
        local reference = references[quantity.name]
        local error = math.abs(run.values[quantity.name] - reference.value) / reference.scale
        run.errors[quantity.name] = error
        run.error = math.max(run.error, error)
        run.bound = math.max(run.bound, error + reference.uncertainty / reference.scale)
      end
    end
  end
end

--- The runs that no other beats in both work and error, by rising work.
function exchange.front(runs)
  local finished = {}
  for _, run in ipairs(runs) do
    if run.error then
      finished[#finished + 1] = run
    end
  end
  table.sort(finished, function(a, b)
    if a.work ~= b.work then
      return a.work < b.work
    elseif a.error ~= b.error then
      return a.error < b.error
    end
    return key_of(a.levels) < key_of(b.levels)
  end)
  local front, best = {}, math.huge
  for _, run in ipairs(finished) do
    if run.error < best then
      front[#front + 1], best = run, run.error
    end
  end
  return front
end

--- What one changed knob does to the default: {factor = of work, shift = {by quantity}}, nil where it did not finish.
local function effects(knobs, runs, quantities)
  local by_levels, table_of = index(runs), {}
  local default = by_levels[key_of(ladder.levels(knobs))]
  for i, knob in ipairs(knobs) do
    table_of[i] = {}
    for level = 1, #knob.levels do
      local run = by_levels[key_of(ladder.levels(knobs, { [knob.name] = level }))]
      if run and run.values then
        local effect = { factor = run.work / default.work, shift = {} }
        for _, quantity in ipairs(quantities) do
          effect.shift[quantity.name] = run.values[quantity.name] - default.values[quantity.name]
        end
        table_of[i][level] = effect
      end
    end
  end
  return table_of, default
end

--- Guess of a combination: shifts add up, factors of work multiply.
local function guess(levels, table_of, default, references, quantities)
  local run = { levels = levels, work = default.work, values = {}, guessed = true }
  for _, quantity in ipairs(quantities) do
    run.values[quantity.name] = default.values[quantity.name]
  end
  for i, level in ipairs(levels) do
    local effect = table_of[i][level]
    if not effect then
      return nil
    end
    run.work = run.work * effect.factor
    for _, quantity in ipairs(quantities) do
      run.values[quantity.name] = run.values[quantity.name] + effect.shift[quantity.name]
    end
  end
  exchange.judge({ run }, references, quantities)
  return run
end

--- Calls use(levels) for every combination of levels.
local function each_combination(knobs, use)
  local levels = {}
  local function descend(i)
    if i > #knobs then
      return use(table.move(levels, 1, #levels, 1, {}))
    end
    for level = 1, #knobs[i].levels do
      levels[i] = level
      descend(i + 1)
    end
  end
  descend(1)
end

--- At most `count` combinations not yet run that the single knobs promise to lie on the front, spread over its work;
--- none dearer than the finest run.
function exchange.promising(knobs, runs, references, quantities, count)
  local by_levels, all = index(runs), {}
  local table_of, default = effects(knobs, runs, quantities)
  local dearest = by_levels[key_of(ladder.corner(knobs))].work
  each_combination(knobs, function(levels)
    local run = by_levels[key_of(levels)] or guess(levels, table_of, default, references, quantities)
    if run and run.work <= dearest then
      all[#all + 1] = run
    end
  end)
  local fresh = {}
  for _, run in ipairs(exchange.front(all)) do
    if run.guessed then
      fresh[#fresh + 1] = run.levels
    end
  end
  local chosen, n = {}, math.min(count, #fresh)
  for i = 1, n do
    chosen[i] = fresh[n == 1 and 1 or 1 + math.floor((i - 1) * (#fresh - 1) / (n - 1) + 0.5)]
  end
  return chosen
end

return exchange
