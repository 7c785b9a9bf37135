-- What the runs of a trade tell: their errors, the front of work and error, combinations worth a run.
local ladder = require "stiction.ladder"
local quantity_module = require "stiction.trade.quantity"

local exchange = {}

local gain = 0.01 -- of its error that a run on the front must save over the cheaper ones

--- Adds errors = {by quantity, relative to the scale}, error (the largest) and bound (with the reference's uncertainty)
--- to finished runs. A quantity that is only watched counts for neither.
function exchange.judge(runs, references, quantities)
  for _, run in ipairs(runs) do
    if run.values then
      run.errors, run.error, run.bound = {}, 0, 0
      for _, quantity in ipairs(quantities) do
        local reference = references[quantity.name]
        local error = quantity_module.distance(quantity, run.values[quantity.name], reference.value) / reference.scale
        run.errors[quantity.name] = error
        if not quantity.watched then
          run.error = math.max(run.error, error)
          run.bound = math.max(run.bound, error + reference.uncertainty / reference.scale)
        end
      end
    end
  end
end

--- The runs that no other beats in both work and error, by rising work; less than `gain` of an error is no difference.
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
    return ladder.key(a.levels) < ladder.key(b.levels)
  end)
  local front, best = {}, math.huge
  for _, run in ipairs(finished) do
    if run.error < (1 - gain) * best then
      front[#front + 1], best = run, run.error
    end
  end
  return front
end

--- What one changed knob does to the default: {factor = of work, shift = {by quantity}}, nil where it did not finish.
local function effects(knobs, runs, quantities)
  local by_levels, table_of = ladder.index(runs), {}
  local default = by_levels[ladder.key(ladder.levels(knobs))]
  for i, knob in ipairs(knobs) do
    table_of[i] = {}
    for level = 1, #knob.levels do
      local run = by_levels[ladder.key(ladder.levels(knobs, { [knob.name] = level }))]
      if run and run.values then
        local effect = { factor = run.work / default.work, shift = {} }
        for _, quantity in ipairs(quantities) do
          effect.shift[quantity.name] = quantity_module.minus(run.values[quantity.name], default.values[quantity.name])
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
      run.values[quantity.name] = quantity_module.plus(run.values[quantity.name], effect.shift[quantity.name])
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

--- At most `count` of a list, from its first to its last.
local function spread(list, count)
  local chosen, n = {}, math.min(count, #list)
  for i = 1, n do
    chosen[i] = list[n == 1 and 1 or 1 + math.floor((i - 1) * (#list - 1) / (n - 1) + 0.5)]
  end
  return chosen
end

--- At most `count` combinations not yet run that the single knobs promise to lie on the front, spread over its work;
--- none dearer than the finest run.
function exchange.promising(knobs, runs, references, quantities, count)
  local by_levels, all = ladder.index(runs), {}
  local table_of, default = effects(knobs, runs, quantities)
  local dearest = by_levels[ladder.key(ladder.corner(knobs))].work
  each_combination(knobs, function(levels)
    local run = by_levels[ladder.key(levels)] or guess(levels, table_of, default, references, quantities)
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
  return spread(fresh, count)
end

--- At most `count` combinations not yet run, each a run of the front with one number a level coarser: where choices and
--- numbers work on each other, the front goes on from them to less work.
function exchange.neighbours(knobs, runs, count)
  local known, fresh = ladder.index(runs), {}
  for _, run in ipairs(exchange.front(runs)) do
    for i, knob in ipairs(knobs) do
      local levels = table.move(run.levels, 1, #knobs, 1, {})
      levels[i] = levels[i] - 1
      local key = ladder.key(levels)
      if knob.numeric and levels[i] >= 1 and not known[key] then
        fresh[#fresh + 1], known[key] = levels, true
      end
    end
  end
  return spread(fresh, count)
end

return exchange
