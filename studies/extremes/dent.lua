-- A half space, dented: the scene, and what would notice a wrong answer of it.
local measure = require "measure"
local stiction = require "stiction"

local dent = {}

--- Heights over a half space: a paraboloid, a wave, as rough as points can tell, or a map from a file.
local function heights_of(parts, q, u)
  if q.form == "wave" then
    local lengths = q.solid and { q.size, q.size } or { q.size }
    return stiction.surface.wave { amplitude = q.height * u.m, wavelengths = parts.unit_list(lengths, u.m) }
  elseif q.form == "rough" then
    local state = 1
    return stiction.surface.map { scale = q.height * u.m, heights = function()
      state = state * 48271 % 2147483647 -- Park and Miller's
      return state / 2147483647
    end }
  elseif q.map then
    return stiction.surface.measured { file = ("maps/%s_%s.csv"):format(q.map, q.solid and "plane" or "line"), unit = q.map_unit,
      size = parts.unit_list(q.solid and { q.map_size, q.map_size } or { q.map_size }, u.m), interpolation = q.between }
  end
  return stiction.surface[q.solid and "sphere" or "cylinder"] { radius = q.radius * u.m }
end

local function bonds_of(parts, q, u)
  if q.range then
    return stiction.adhesion.dugdale { sigma0 = q.w / q.range * u.J_m2 / u.m, h0 = q.range * u.m }
  end
  return parts.adhesion_of(q, u)
end

--- A half space under a ball (in the plane a roller) that is pressed on, moved along and drawn off.
local values = { size = 0.01, points = { 12 }, radius = 0.05, mu = 0.3, C = 1e9, w = 1, b = 0.5, press = 1e-4, slip = 2e-5,
  pull = 1e-3, steps = 20, nu = 0.5, boundary = "free", form = "ball", height = 5e-5, depth = 0,
  map_unit = "um", map_size = 0.01 }

local function made(parts, q, u)
  local sides = q.solid and { q.size, q.width or q.size } or { q.size }
  local d, normal = q.slip, q.solid and "z" or "y"
  local ball = { surface = heights_of(parts, q, u), x = parts.unit_list({ 0, 0, d, d }, u.m),
    times = parts.unit_list({ 0, q.pace, 2 * q.pace, 3 * q.pace }, u.s),
    young = q.hard and q.hard * q.E * u.Pa or nil, poisson = q.hard and 0.3 or nil }
  if q.force then
    ball.force = parts.unit_list({ 0, q.force, q.force, 0 }, u.N)
  else
    ball[normal] = parts.unit_list({ 0, -q.press, -q.press, q.pull }, u.m)
  end
  local probes = { contact = stiction.probe.contact { pair = "touch" }, ball = stiction.probe.rigid { obstacle = "ball" },
    energy = stiction.probe.energy {}, line = not q.solid and stiction.probe.contact_line { pair = "touch" } or nil }
  for k = 1, q.solid and q.points[1] * q.points[2] or 0 do
    local x, y = (k - 1) % q.points[1] + 0.5, (k - 1) // q.points[1] + 0.5
    probes["point_" .. k] = stiction.probe.contact_point { pair = "touch",
      near = parts.unit_list({ (x / q.points[1] - 0.5) * q.size, (y / q.points[2] - 0.5) * sides[2], 0 }, u.m) }
  end
  return {
    kinematics = q.solid and "three_dimensional" or nil,
    bodies = { base = stiction.body.half_space { young = q.E * u.Pa, poisson = q.nu, size = parts.unit_list(sides, u.m), points = q.points,
      boundary = q.boundary, depth = q.depth > 0 and q.depth * u.m or nil } },
    obstacles = { ball = stiction.obstacle.height_map(ball) },
    pairs = { touch = stiction.pair { secondary = "base.surface", primary = "ball", adhesion = bonds_of(parts, q, u),
      friction = q.mu and stiction.friction.coulomb { mu = q.mu } or nil } },
    scheme = stiction.scheme.quasi_static {}, schedule = parts.schedule_of(q, u, { 1, 2, 3 }), probes = probes,
  }
end

--- In space: { values that differ }.
dent.in_space = { solid = true, points = { 6, 6 } }

--- The scene, made of these functions of the others.
function dent.scene(parts)
  return { values = values, make = function(q, u) return made(parts, q, u) end }
end

--- Histories of all points, {x =, y = place, gap = {...}, pressure =, adhesion_n =, friction =, slip =, ...}.
local function points_of(case, q)
  local points, nx = {}, q.points[1]
  for k = 1, q.solid and nx * q.points[2] or nx do
    local x, y = (k - 1) % nx + 0.5, q.solid and (k - 1) // nx + 0.5 or 0
    local point = { x = (x / nx - 0.5) * q.size * q.L, y = q.solid and (y / q.points[2] - 0.5) * (q.width or q.size) * q.L or 0 }
    for _, name in ipairs { "gap", "pressure", "adhesion_n", "adhesion_t", "friction", "slip", "friction_2", "slip_2" } do
      if q.solid then
        point[name] = case:series("point_" .. k, name)
      elseif not name:find "_2" then
        point[name] = case:series("line", name, k)
      end
    end
    points[k] = point
  end
  return points
end

local function largest(list)
  local most = 0
  for _, value in ipairs(list) do
    most = (value ~= value or math.abs(value) > most) and math.abs(value) or most
  end
  return most
end

local function top_of(points, name)
  local top = 0
  for _, point in ipairs(points) do
    top = math.max(top, largest(point[name]))
  end
  return top
end

--- Signorini and Coulomb at every point and step; the force is the sum of the points' tractions.
local function complementarity(_, q, say, points)
  local top, deepest, tensile, both, outside = top_of(points, "pressure"), 0, 0, 0, 0
  for _, point in ipairs(points) do
    for i = 2, #point.gap do
      local gap, pressure = point.gap[i], point.pressure[i]
      deepest, tensile, both = math.max(deepest, -gap), math.max(tensile, -pressure), math.max(both, math.abs(gap) * pressure)
      outside = math.max(outside, math.sqrt(point.friction[i] ^ 2 + (q.solid and point.friction_2[i] or 0) ^ 2) - (q.mu or 0) * pressure)
    end
  end
  local length = measure.scales(q).length
  say("penetration over size", deepest / length, 1e-6)
  top = math.max(top, top_of(points, "adhesion_n"), top_of(points, "adhesion_t")) -- what the answer's tolerance is of
  if top > 0 then
    say("tensile dry pressure over the largest", tensile / top, 1e-6)
    say("gap times pressure", both / (top * length), 1e-6)
    say("friction outside the cone", outside / top, 1e-6)
  end
end

local function part_of(q)
  return (q.size * q.L / q.points[1]) * (q.solid and (q.width or q.size) * q.L / q.points[2] or 1)
end

local function sum_of_tractions(case, q, say, points)
  if q.unchecked then
    return -- too many points to ask each
  end
  local force, off = case:series("contact", q.solid and "force_z" or "force_y"), 0
  local most = math.max(largest(force), part_of(q) * math.max(top_of(points, "pressure"), top_of(points, "adhesion_n")))
  for i = 2, #force do
    local sum = 0
    for _, point in ipairs(points) do
      sum = sum + (point.pressure[i] + point.adhesion_n[i]) * part_of(q)
    end
    off = math.max(off, math.abs(math.abs(force[i]) - math.abs(sum)))
  end
  say("force against tractions, over the largest", off / math.max(most, 1e-300), 1e-9)
end

--- Displacement at u, v from the middle of a rectangle a by b under unit pressure, over (1 - nu)/G (Love 1929); in
--- the plane (b = nil) but for a constant (Johnson 1985, 2.13).
local function love(u, v, a, b)
  local sum = 0
  if not b then
    for _, x in ipairs { u - a / 2, u + a / 2 } do
      sum = (x == 0 and 0 or x * math.log(math.abs(x) / a)) - sum
    end
    return -sum / math.pi
  end
  local function asinh(x) return x < 0 and -math.log(-x + math.sqrt(x * x + 1)) or math.log(x + math.sqrt(x * x + 1)) end
  for _, sx in ipairs { -0.5, 0.5 } do
    for _, sy in ipairs { -0.5, 0.5 } do
      local x, y = u + sx * a, v + sy * b
      sum = sum + sx * sy * 4 * (x * asinh(y / math.abs(x)) + y * asinh(x / math.abs(y)))
    end
  end
  return sum / (2 * math.pi)
end

--- Gaps are those of the tractions, all added up: only where pressure and shear do not couple, and points are free.
local function elastic(case, q, say, points)
  if #points == 0 or q.boundary ~= "free" or (q.mu and q.nu < 0.5) or (q.hard and q.mu) then
    return
  end
  local soft = 2 * (1 - q.nu ^ 2) / q.E + (q.hard and 2 * (1 - 0.3 ^ 2) / (q.E * q.hard) or 0)
  soft = soft / (q.M / q.L / q.T ^ 2)
  local a, b = q.size * q.L / q.points[1], q.solid and (q.width or q.size) * q.L / q.points[2] or nil
  local shift, off, most = case:series("ball", q.solid and "u_z" or "u_y"), 0, 0
  for i = #shift, 2, -math.ceil((#points) ^ 2 / 2000) do
    local first
    for _, point in ipairs(points) do
      local sum = 0
      for _, other in ipairs(points) do
        sum = sum + (other.pressure[i] + other.adhesion_n[i]) * love(point.x - other.x, point.y - other.y, a, b)
      end
      local wrong = point.gap[i] - point.gap[1] - shift[i] - soft * sum
      first = first or (q.solid and 0 or wrong) -- in the plane up to a constant
      off, most = math.max(off, math.abs(wrong - first)), math.max(most, math.abs(soft * sum), math.abs(shift[i]))
    end
  end
  say("gaps against those of the tractions, over the largest", off / math.max(most, 1e-300), 1e-8)
end

--- Strain energy is half of the tractions' work where there is no shear; what is lost is not gained again.
local function energies(case, q, say, points)
  local loss, bound = case:series("energy", "scheme_loss"), 0
  local work, strain = case:series("energy", q.force and "load_work" or "motion_work"), case:series("energy", "strain")
  local scale = math.max(largest(work), largest(strain))
  local lowest = 0
  local shift, force = case:series("ball", q.solid and "u_z" or "u_y"), case:series("contact", q.solid and "force_z" or "force_y")
  local along, drag = case:series("ball", "u_x"), case:series("contact", "force_x")
  for i = 2, #loss do
    bound = bound + math.abs(force[i] - force[i - 1]) * math.abs(shift[i] - shift[i - 1])
      + math.abs(drag[i] - drag[i - 1]) * math.abs(along[i] - along[i - 1])
    for _, point in ipairs(points) do -- friction takes its means, too
      bound = bound + part_of(q) * (math.abs(point.friction[i] - point.friction[i - 1]) * math.abs(point.slip[i] - point.slip[i - 1])
        + (q.solid and math.abs(point.friction_2[i] - point.friction_2[i - 1]) * math.abs(point.slip_2[i] - point.slip_2[i - 1]) or 0))
    end
    lowest = math.min(lowest, loss[i] - loss[i - 1])
  end
  if q.C and not q.range and q.pull / q.steps > 0.25 * math.sqrt(q.w / q.C) then -- bonds that a step opens at once
    local quickest = math.huge
    for i, dt in ipairs((case:series("step", "dt"))) do
      quickest = i > 1 and math.min(quickest, dt / q.T) or quickest
    end
    bound = bound + (q.w + q.b / quickest) * q.M / q.T ^ 2 * part_of(q) * #points
  end
  say("energy out of nothing in a step, beyond the error of the steps", math.max(0, -lowest - bound) / math.max(scale, 1e-300), 1e-6)
  local off = 0
  if not q.mu and (q.range or not q.C) and q.boundary == "free" then
    for i = 2, #loss do
      local sum = 0
      for _, point in ipairs(points) do
        sum = sum + 0.5 * part_of(q) * (point.pressure[i] + point.adhesion_n[i]) * (point.gap[i] - point.gap[1] - shift[i])
      end
      off = math.max(off, math.abs(sum - strain[i]))
    end
    say("strain energy against the tractions' work, over the largest", off / math.max(scale, 1e-300), 1e-8)
  end
end

--- Whether what is drawn far off is let go.
local function released(case, q, say)
  local bonds, force = case:series("contact", "beta_max"), case:series("contact", q.solid and "force_z" or "force_y")
  local n = #force
  if not q.force and bonds[n] == 0 and case:series("contact", "stick")[n] + case:series("contact", "slip")[n] == 0 then
    say("force left after the last bond", math.abs(force[n]) / math.max(largest(force), 1e-300), 1e-9)
  end
end

--- All checks of a dent; say(what, value, tolerance) records each.
function dent.checks(case, q, say)
  local points = not q.unchecked and points_of(case, q) or {}
  for _, check in ipairs { complementarity, sum_of_tractions, elastic, energies, released } do
    check(case, q, say, points)
  end
end

return dent
