-- Histories of a cell in a form that its checks can use, and results without units.
local measure = {}

--- Scales of a cell in SI: length, stress, force and energy of its numbers.
function measure.scales(q)
  local length, stress = q.size * q.L, q.E * q.M / q.L / q.T ^ 2
  local area = (q.solid or q.revolved) and length ^ 2 or length
  return { length = length, stress = stress, force = stress * area, energy = stress * area * length }
end

local function component(case, group, name, k)
  local held, values = pcall(function() return (case:series(group, name, k)) end)
  return held and values or nil
end

local function zeros(count)
  local list = {}
  for i = 1, count do
    list[i] = 0
  end
  return list
end

--- Points of a contact_line probe: {X =, gap = {...}, pressure = {...}, friction = {...}, friction_2 = {...}}.
function measure.points(case, group, q)
  local points = {}
  for k = 1, math.maxinteger do
    local gap = component(case, group, "gap", k)
    if not gap then
      return points
    end
    points[k] = { X = case:series(group, "X", k)[1], gap = gap, pressure = case:series(group, "pressure", k),
      friction = case:series(group, "friction", k),
      friction_2 = q.solid and case:series(group, "friction_2", k) or zeros(#gap) }
  end
end

--- Mean of a history over its steps between two times.
function measure.mean_between(case, group, name, from, to)
  local values, sum, count = case:series(group, name), 0, 0
  for i, t in ipairs(case.time) do
    if t > from and t < to then
      sum, count = sum + values[i], count + 1
    end
  end
  return sum / count
end

--- Displacement of the driven set at every step, by component: what its node probe says.
function measure.moves(case, q)
  local moves = {}
  for _, name in ipairs(q.solid and { "x", "y", "z" } or { "x", "y" }) do
    moves[name] = case:series("driven", "u_" .. name)
  end
  return moves
end

--- Turn of the driven side at the end of step i, rad: as scenes.lua asks for it.
function measure.turned(case, q, i)
  return q.turn * math.max(0, math.min(1, case.time[i] / (q.pace * q.T) - 1))
end

--- Largest of all energies of the ledger and works.
function measure.energy_scale(case)
  local most = 0
  for _, name in ipairs { "kinetic", "strain", "bond", "potential", "motion_work", "load_work", "spring", "surface" } do
    for _, value in ipairs(component(case, "energy", name) or {}) do
      most = math.max(most, math.abs(value))
    end
  end
  return most
end

local function extreme(case, group, name)
  local most = 0
  for _, value in ipairs(component(case, group, name) or {}) do
    most = math.abs(value) > math.abs(most) and value or most
  end
  return most
end

measure.names = { "force", "work", "loss", "strain" }

--- Results without units, by name.
measure.results = {
  force = function(case, q)
    return (extreme(case, "contact", q.solid and "force_z" or "force_y") + extreme(case, "floor_1", "force_y"))
      / measure.scales(q).force
  end,
  work = function(case, q) return extreme(case, "energy", "motion_work") / measure.scales(q).energy end,
  loss = function(case, q) return extreme(case, "energy", "scheme_loss") / measure.scales(q).energy end,
  strain = function(case, q) return extreme(case, "energy", "strain") / measure.scales(q).energy end,
}

return measure
