-- Which scenes: the map, row by row, and others by dice, from which nothing was made.
local design = { lambdas = { 0.2, 0.5, 1 } }

local thicks = { 0.0025, 0.005, 0.01, 0.02, 0.04, 0.08, 0.2, 0.5 } -- a/h

local function row(t)
  local p = { kind = "sphere", poisson = 0.49, law = "neo_hookean", base = "stuck", slope = 0.01, squat = 4, lambda = 0 }
  for key, value in pairs(t) do p[key] = value end
  return p
end

--- Rows of the map: {group, label, parameters}; squat is L/h.
local function rows()
  local list = {}
  local function add(group, label, t) list[#list + 1] = { number = #list + 1, group = group, label = label, p = row(t) } end
  for _, law in ipairs { "linear_elastic", "neo_hookean" } do
    for _, poisson in ipairs { 0.3, 0.49 } do
      for _, slope in ipairs { 0.01, 0.1, 0.3, 0.6 } do
        add(("sphere, ν = %g, %s strains"):format(poisson, law == "neo_hookean" and "large" or "small"), ("a/R = %g"):format(slope),
          { law = law, poisson = poisson, slope = slope })
      end
    end
  end
  for _, poisson in ipairs { 0.3, 0.49 } do
    for _, squat in ipairs { 1, 0.5, 0.25 } do
      add(("narrow block, a/R = 0.01, ν = %g"):format(poisson), ("L/h = %g"):format(squat), { squat = squat, poisson = poisson })
    end
  end
  for _, poisson in ipairs { 0.3, 0.49 } do
    add("sliding base, a/R = 0.01", ("ν = %g"):format(poisson), { base = "smooth", poisson = poisson })
  end
  for _, poisson in ipairs { 0.3, 0.49 } do
    for _, slope in ipairs { 0.003, 0.03, 0.1 } do
      add(("punch, ν = %g"):format(poisson), ("depth/a = %g"):format(slope), { kind = "punch", poisson = poisson, slope = slope })
    end
  end
  for _, lambda in ipairs(design.lambdas) do
    for _, slope in ipairs { 0.01, 0.1 } do
      add(("sphere pulled off, λ = %g"):format(lambda), ("a/R = %g"):format(slope), { kind = "pull", lambda = lambda, slope = slope })
    end
  end
  return list
end

design.rows = rows()
design.thicks = thicks

--- Numbers between 0 and 1 that any machine repeats (Park and Miller 1988).
local function dice(seed)
  local state = seed
  return function()
    state = state * 48271 % 2147483647
    return state / 2147483647
  end
end

local function thrown(count, seed)
  local list, throw = {}, dice(seed)
  local function between(low, high) return low * (high / low) ^ throw() end
  for k = 1, count do
    local kind = k % 5 == 0 and "pull" or k % 5 == 1 and "punch" or "sphere"
    local p = row { kind = kind, poisson = 0.495 * throw(), law = throw() < 0.3 and "linear_elastic" or "neo_hookean",
      base = throw() < 0.3 and "smooth" or "stuck", slope = between(0.002, kind == "sphere" and 0.6 or 0.1), squat = between(0.25, 8) }
    p.thick = between(0.0015, 0.6)
    p.lambda = kind == "pull" and design.lambdas[1 + math.floor(#design.lambdas * throw())] or 0
    list[k] = p
  end
  return list
end

local function add(list, group, number, p, levels)
  for level = levels[1], levels[2] do
    local case = { set = group, number = number, level = level }
    for key, value in pairs(p) do case[key] = value end
    case.wide, case.squat = case.thick / p.squat, nil
    list[#list + 1] = case
  end
end

--- Each at two levels of mesh, every `finer`th of the map at three; of the map every `every`th; for pulls also blocks as good
--- as half spaces.
function design.sweep(t)
  local list, pulled = {}, {}
  local function keep(group, number, p, last)
    add(list, group, number, p, { 0, last })
    pulled[p.lambda] = p.kind == "pull" or nil
  end
  for i, entry in ipairs(design.rows) do
    for j, thick in ipairs(thicks) do
      local number = #thicks * (i - 1) + j
      if (i + 3 * j) % t.every == 0 then
        entry.p.thick = thick
        keep("map", number, entry.p, entry.p.kind ~= "pull" and number % t.finer == 0 and 2 or 1)
      end
    end
  end
  for k, p in ipairs(thrown(t.dice, 20261126)) do
    keep("dice", k, p, 1)
  end
  for k, lambda in ipairs(design.lambdas) do
    local p = row { kind = "pull", law = "linear_elastic", slope = 1e-3, squat = 1, thick = 5e-3, lambda = lambda }
    if pulled[lambda] then
      add(list, "endless", k, p, { 0, 1 })
    end
  end
  return list
end

return design
