-- What would notice a wrong answer, per scene: balance, complementarity, ledger, closed forms, other units.
local measure = require "measure"

local checks = {}

--- Largest magnitude in a list.
local function largest(values)
  local most = 0
  for _, value in ipairs(values) do
    most = value ~= value and value or math.max(most, math.abs(value))
    if most ~= most then
      return most
    end
  end
  return most
end

local function contact_forces(case, q)
  local names, forces = q.solid and { "z" } or { "x", "y" }, {}
  for i, name in ipairs(names) do
    forces[i] = { name = name, contact = case:series("contact", "force_" .. name), drive = case:series("drive", "force_" .. name) }
  end
  return forces
end

--- The motions carry what the contact carries, at every step. Walls of a channel are no motions that are probed.
local function balance(case, q, say)
  local off, most = 0, 0
  for _, one in ipairs(contact_forces(case, q)) do
    for i = 2, #one.contact do
      off = math.max(off, math.abs(one.contact[i] + one.drive[i]))
    end
    most = math.max(most, largest(one.contact), largest(one.drive))
  end
  local rounding = 1e-12 * measure.scales(q).force * (1 + (q.pull or q.press) / q.size)
  say("contact force against motion, over the largest", off / (most + 1e5 * rounding), 1e-5)
end

--- Signorini and Coulomb at every point and step, over the body's size and the largest pressure.
local function complementarity(case, q, say, group)
  local deepest, tensile, both, outside = 0, 0, 0, 0
  local top, length = 0, measure.scales(q).length
  for _, point in ipairs(measure.points(case, group or "line", q)) do
    top = math.max(top, largest(point.pressure))
    for i = 2, #point.gap do
      local gap, pressure = point.gap[i], point.pressure[i]
      deepest, tensile = math.max(deepest, -gap), math.max(tensile, -pressure)
      both = math.max(both, math.abs(gap) * pressure)
      outside = math.max(outside, math.sqrt(point.friction[i] ^ 2 + point.friction_2[i] ^ 2) - (q.mu or 0) * pressure)
    end
  end
  local where = group and " at " .. group or ""
  local travel = (q.g or 0) * (q.pace * (q.last or 0) / q.steps) ^ 2 / q.size -- in a step, if nothing stopped it
  say("penetration over size" .. where, deepest / length, 1e-6 + 1e-12 * travel)
  if top > 0 then
    say("tensile dry pressure over the largest" .. where, tensile / top, 1e-6)
    say("gap times pressure" .. where, both / (top * length), 1e-6 + 1e-12 * travel)
    say("friction outside the cone" .. where, outside / top, 1e-6)
  end
end

--- The ledger makes no energy beyond the error of works taken at the ends of the steps, sum of |dF| |du|. A bond
--- that a step opens at once is let go without its work: then w and its viscous loss, b beta^2/dt at most, are missing.
local function closed_ledger(case, q, say)
  local loss, work = case:series("energy", "scheme_loss"), case:series("energy", "motion_work")
  local bound, moves = 0, measure.moves(case, q)
  for _, one in ipairs(contact_forces(case, q)) do
    local u = moves[one.name]
    for i = 2, #u do
      bound = bound + math.abs(one.drive[i] - one.drive[i - 1]) * math.abs(u[i] - u[i - 1])
    end
  end
  if q.C and q.pull / q.steps > 0.25 * math.sqrt(q.w / q.C) then
    local quickest = math.huge
    for i, dt in ipairs((case:series("step", "dt"))) do
      quickest = i > 1 and math.min(quickest, dt / q.T) or quickest
    end
    bound = bound + (q.w + q.b / quickest) * q.M / q.T ^ 2 * measure.scales(q).length
  end
  local rounding = 1e-12 + (1e-13 * (q.pull or q.press) / q.size) ^ 2
  local lowest, scale = 0, math.max(bound, largest(work), rounding * measure.scales(q).energy)
  for _, value in ipairs(loss) do
    lowest = math.min(lowest, value)
  end
  say("energy out of nothing, beyond the error of the steps", math.max(0, -lowest - bound) / scale, 1e-6)
end

--- Nothing may make energy: the scheme's loss is never below what it was at the start.
local function ledger(case, q, say)
  if q.pace > 1 then
    return
  end
  local loss, scale, lowest = case:series("energy", "scheme_loss"), measure.energy_scale(case), 0
  for _, value in ipairs(loss) do
    lowest = math.min(lowest, value)
  end
  say("energy out of nothing, over the largest energy", scale > 0 and -lowest / scale or -lowest, 1e-6)
end

--- Bond and traction of a driven point, step by step from (13) and (21) with the opening it is driven to.
local function law(case, q, say)
  local dt, pull, beta = case:series("step", "dt"), q.pull * q.L, q.C and q.beta0 or 0
  local got, traction, off, wrong, top = case:series("point", "beta"), case:series("point", "adhesion_n"), 0, 0, 0
  local C, w, b = (q.C or 0) * q.M / q.L ^ 2 / q.T ^ 2, q.w * q.M / q.T ^ 2, q.b * q.M / q.T
  for i = 2, #dt do
    local opening = pull * math.max(0, case.time[i] / (q.pace * q.T) - q.until_pull) / (2 - q.until_pull)
    local energy, old = C * opening ^ 2, beta
    local top_of, below = b * old + dt[i] * w, b + dt[i] * energy
    beta = below > 0 and math.min(1, top_of / below) or (w > 0 and 1 or old)
    beta = opening > 0 and math.min(beta, old) or beta
    off = math.max(off, math.abs(got[i] - beta))
    local right = -C * opening * beta ^ 2
    wrong, top = math.max(wrong, math.abs(traction[i] - right)), math.max(top, math.abs(right))
  end
  if q.C and q.C > 0 then
    say("bond intensity against its formula", off, 1e-9)
    say("adhesion against its formula", wrong / math.max(top, 1e-300), 1e-9)
  end
end

--- Every node of a driven cell is where it was sent, however many steps it took.
local function driven(case, q, say)
  local gap = case:series("point", "gap")
  local sent = q.pull * q.L
  say("where it ends over where it was sent, less 1", gap[#gap] / sent - 1, 1e-9)
end

--- A punch that is symmetric must press symmetrically.
local function symmetry(case, q, say)
  local points, off, top = measure.points(case, "line", q), 0, 0
  table.sort(points, function(a, b) return a.X < b.X end)
  for k, point in ipairs(points) do
    local twin = points[#points + 1 - k]
    top = math.max(top, largest(point.pressure))
    for i, pressure in ipairs(point.pressure) do
      off = math.max(off, math.abs(pressure - twin.pressure[i]))
    end
  end
  if top > 0 then
    say("left against right pressure", off / top, 1e-5)
  end
end

--- The sole stays above the floor, told by its own displacement and not by the contact.
local function above_floor(case, q, say)
  local u, lowest = case:series("sole", "u_y"), 0
  for i = 2, #u do
    lowest = math.min(lowest, u[i] + (q.gap or -(q.sink or 0)) * q.L)
  end
  say("node below the floor over size", lowest / measure.scales(q).length, 1e-6)
end

--- The upper block stays on the lower one, told by their displacements and not by the contact.
local function above_bed(case, q, say)
  local sole, bed, lowest = case:series("sole", "u_y"), case:series("bed", "u_y"), 0
  for i = 2, #sole do
    lowest = math.min(lowest, sole[i] - bed[i] - q.sink * q.L)
  end
  say("node in the other body over its height", lowest / (q.height * q.L), 0.05)
end

--- Once nothing touches and no bond is left there is no force and no strain.
local function released(case, _, say)
  local touching, bond = case:series("contact", "stick"), case:series("contact", "beta_max")
  local slipping, force = case:series("contact", "slip"), case:series("contact", "force_y")
  local n = #touching
  if touching[n] + slipping[n] == 0 and bond[n] == 0 then
    say("force left after the last bond", largest { force[n] } / math.max(largest(force), 1e-300), 1e-9)
  end
end

--- Where all points slide, the forces are on the cone; the surface is not quite flat.
local function sliding(case, q, say)
  local slip, stick = case:series("contact", "slip"), case:series("contact", "stick")
  local fx, fy, n = case:series("contact", "force_x"), case:series("contact", "force_y"), #case.time
  if slip[n] > 0 and stick[n] == 0 and q.mu >= 0.1 and not q.tilts then
    say("sliding: force ratio over mu, less 1", math.abs(fx[n] / fy[n]) / q.mu - 1, 0.02)
  end
end

--- Uniaxial strain of two layers in a row: the force of a spring of two.
local function channel(case, q, say)
  if q.shift ~= 0 or q.material ~= "linear_elastic" then
    return
  end
  local modulus = q.E * (1 - q.nu) / ((1 + q.nu) * (1 - 2 * q.nu))
  local spring = 1 / (q.heights[1] / modulus + q.heights[2] / (q.contrast * modulus))
  local force = case:series("contact", "force_z")
  local wanted = spring * q.press * q.size ^ 2 * q.M * q.L / q.T ^ 2
  say("force over that of two layers in a row, less 1", force[#force] / wanted - 1, q.uniform_tolerance or 1e-6)
end

--- While the first wave is under way the wall sees rho c v0.
local function wave(case, q, say)
  if q.material ~= "linear_elastic" or q.whole or q.pace ~= 1 then
    return
  end
  local c = math.sqrt(q.E / q.rho)
  local first = q.gap / q.speed
  local mean = measure.mean_between(case, "point", "pressure", (first + 0.5 * q.size / c) * q.T, (first + 1.6 * q.size / c) * q.T)
  say("pressure over rho c v0, less 1", mean / (q.rho * c * q.speed * q.M / q.L / q.T ^ 2) - 1, 0.02)
end

--- Kinetic and strain energy never exceed what was there at the start (with gravity's share and no motion).
local function no_gain(case, q, say)
  if q.pace > 1 then
    return -- steps far above every period of the body: the ledger tells what the scheme makes of it
  end
  local kinetic, strain, potential = case:series("energy", "kinetic"), case:series("energy", "strain"),
    case:series("energy", "potential")
  local start, most = kinetic[1] + strain[1] + potential[1], 0
  local scale = measure.energy_scale(case)
  for i in ipairs(kinetic) do
    most = math.max(most, kinetic[i] + strain[i] + potential[i] - start)
  end
  say("energy above that of the start", most / math.max(scale, 1e-300), 1e-6)
end

--- Momentum of a single cell: what the floor and the weight gave it.
local function momentum(case, q, say)
  if q.whole then
    return -- one step: the end force times the step is no impulse
  end
  local force, v = case:series("contact", "force_y"), 0
  for i = 1, 4 do
    local corner = case:series("corner_" .. i, "v_y")
    v = v + 0.25 * corner[#corner] / (q.L / q.T)
  end
  local mass, impulse, t = q.rho * q.size ^ 2, 0, case.time
  for i = 2, #t do
    impulse = impulse + force[i] * (t[i] - t[i - 1])
  end
  impulse = impulse / (q.M / q.T)
  local last = t[#t] / q.T
  local given = impulse - mass * q.g * last - mass * (v + q.speed)
  say("momentum over all impulses", given / (math.abs(impulse) + mass * q.g * last + mass * math.abs(q.speed)), 0.01)
end

--- The same numbers in other units give the same dimensionless results.
local function other_units(case, _, say, base)
  if base then
    for _, name in ipairs(measure.names) do
      local own, wanted = case.results[name], base.results[name]
      say(name .. " less that in SI", own - wanted, 1e-5 * math.max(math.abs(wanted), 1e-6))
    end
  end
end

local function lines_of_crowd(case, q, say)
  for i = 1, 3 do
    complementarity(case, q, say, "line_floor_" .. i)
  end
end

local of_scene = {
  law = { law, driven, balance, closed_ledger },
  punch = { balance, complementarity, above_floor, symmetry, released, closed_ledger },
  slide = { balance, complementarity, above_bed, sliding, closed_ledger },
  slide_mortar = { balance, complementarity, above_bed, sliding, closed_ledger },
  bar = { above_floor, wave, no_gain, ledger },
  stack = { balance, complementarity, channel, closed_ledger }, stack_mortar = { balance, complementarity, channel, closed_ledger },
  drop = { complementarity, momentum, no_gain, ledger }, crowd = { lines_of_crowd, no_gain, ledger },
}

--- Runs the checks of one cell; say(what, value, tolerance) records each.
function checks.run(case, q, cell, base, say)
  for _, check in ipairs(of_scene[cell.scene]) do
    check(case, q, say)
  end
  if cell.axis == "units" then
    other_units(case, q, say, base)
  end
end

return checks
