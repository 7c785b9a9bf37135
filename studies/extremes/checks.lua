-- What would notice a wrong answer, per scene: balance, complementarity, ledger, closed forms, other units.
local dent = require "dent"
local measure = require "measure"
local impulses = require "impulses"

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
    local contact, drive = case:series("contact", "force_" .. name), case:series("drive", "force_" .. name)
    forces[i] = { name = name, contact = contact, drive = drive }
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

--- What draws the block along the floor is the spring, what presses it the motion.
local function tied(case, _, say)
  local fx, fy = case:series("contact", "force_x"), case:series("contact", "force_y")
  local tie, drive, off = case:series("tie", "force_x"), case:series("drive", "force_y"), 0
  for i = 2, #fx do
    off = math.max(off, math.abs(fx[i] + tie[i]), math.abs(fy[i] + drive[i]))
  end
  local most = math.max(largest(fx), largest(fy), largest(tie))
  say("contact force against spring and motion, over the largest", off / most, 1e-5)
end

--- The cavity is as wide as its wall says, has the volume that was asked for, and an amount of gas keeps p V.
local function gas_law(case, q, say)
  if q.by == "pressure" then
    return
  end
  local pressure, volume, u = case:series("gas", "pressure"), case:series("gas", "volume"), case:series("wall", "u_x")
  local wrong, off, stress = 0, 0, measure.scales(q).stress
  for i, t in ipairs(case.time) do
    local asked = (q.by == "volume" and q.fill - 1 or q.fill * stress) * t / (q.pace * q.T)
    local got, outside = volume[i] / volume[1] - 1, (q.outside or 0) * stress
    if q.by ~= "volume" then
      got = (pressure[i] + outside) * volume[i] / volume[1] - outside
    end
    off = math.max(off, math.abs(got - asked) / (q.by == "volume" and 1 or math.max(math.abs(q.fill), 1e-30) * stress))
    wrong = math.max(wrong, math.abs(volume[i] / volume[1] / (1 + u[i] / (q.size * q.L)) ^ 2 - 1))
  end
  say("volume of the cavity against its wall's way", wrong, 1e-9)
  say("volume or p V against what was asked for", off, q.by == "volume" and 1e-6 * math.max(1, largest(pressure) / stress) or 1e-9)
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

--- Energy that rounding alone may put into the ledger: of forces K u over the way that bodies are carried.
local function rounding(q)
  local way, spread = (q.pull or q.press or 0) / q.size + (q.slip or 0) / q.size, 2e-15 * (q.contrast or 1)
  if q.rho and not (q.pull or q.press) then
    way, spread = q.pace * (q.last or 1) * math.max(q.speed, (q.g or 0) * (q.last or 0)) / q.size, 1e-16
  end
  return (1e-12 + spread * way ^ 2) * measure.scales(q).energy
end

--- Every energy and work adds up with what the scheme's own formulas say that it loses: a term of a wrong size or
--- sign is left open.
local function account(case, q, say)
  local open, scale = largest(case:series("energy", "unaccounted")), measure.energy_scale(case)
  local floor = rounding(q)
  -- the audit's rule of four points along a step's way: a rubber cup that lets go leaps, 6e-6 (3e-12 if linear)
  local leaps = q.leaks_at and q.material ~= "linear_elastic"
  say("energy left open over the largest", open / math.max(scale, 1e6 * floor), leaps and 2e-5 or 1e-6)
end

--- Error of the work of a driven side's moment, taken at the ends of steps, sum of |dM| |da|.
local function turning_bound(case, q)
  local moment, bound = case:series("drive", "moment"), 0
  for i = 2, #moment do
    local turned = measure.turned(case, q, i) - measure.turned(case, q, i - 1)
    bound = bound + math.abs(moment[i] - moment[i - 1]) * math.abs(turned)
  end
  return bound
end

--- A quasi-static run makes no energy beyond the error of works taken at the ends of its steps, sum of |dF| |du|. A
--- bond that a step opens at once is let go without its work: then w and its viscous loss, b beta^2/dt at most, are
--- missing.
local function closed_ledger(case, q, say)
  local loss, work = case:series("energy", "scheme_loss"), case:series("energy", "motion_work")
  local bound, moves = 0, measure.moves(case, q)
  for _, one in ipairs(contact_forces(case, q)) do
    local u = moves[one.name]
    for i = 2, #u do
      bound = bound + math.abs(one.drive[i] - one.drive[i - 1]) * math.abs(u[i] - u[i - 1])
    end
  end
  bound = bound + (q.turn and turning_bound(case, q) or 0)
  if q.C and q.pull / q.steps > 0.25 * math.sqrt(q.w / q.C) then
    local quickest = math.huge
    for i, dt in ipairs((case:series("step", "dt"))) do
      quickest = i > 1 and math.min(quickest, dt / q.T) or quickest
    end
    bound = bound + (q.w + q.b / quickest) * q.M / q.T ^ 2 * measure.scales(q).length
  end
  local lowest, scale = 0, math.max(bound, largest(work), 1e6 * rounding(q))
  for _, value in ipairs(loss) do
    lowest = math.min(lowest, value)
  end
  say("energy out of nothing, beyond the error of the steps", math.max(0, -lowest - bound) / scale, 1e-6)
end

--- Whether the run itself says so.
local function told(case, words)
  for _, remark in ipairs(case.remarks) do
    if remark:find(words, 1, true) then
      return true
    end
  end
  return false
end

--- In dynamics kinetic, strain and potential energy never exceed what was there at the start, the scheme and the
--- viscosity make none, and what they lose is little: or else the run must say so.
local function energy_kept(case, _, say)
  local e = {}
  for _, name in ipairs { "kinetic", "strain", "potential", "scheme_loss", "damping_loss" } do
    e[name] = case:series("energy", name)
  end
  local start, gain, made, scale = e.kinetic[1] + e.strain[1] + e.potential[1], 0, 0, measure.energy_scale(case)
  for i = 1, #e.kinetic do
    gain = math.max(gain, e.kinetic[i] + e.strain[i] + e.potential[i] - start)
    made = math.max(made, -e.scheme_loss[i], -e.damping_loss[i])
  end
  local words, lost = told(case, "made energy"), e.scheme_loss[#e.scheme_loss]
  scale = math.max(scale, 1e-300)
  say("energy above that of the start and not told", words and 0 or gain / scale, 1e-6)
  say("energy out of nothing and not told", words and 0 or made / scale, 1e-6)
  say("energy lost and not told", (words or told(case, "lost energy")) and 0 or lost / scale, 0.1001)
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

--- A punch that is symmetric must press symmetrically, unless friction leaves it several answers and the run says so.
local function symmetry(case, q, say)
  if q.turn then
    return -- it tips to one side
  end
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
    say("left against right pressure and not told", told(case, "with friction more than one answer") and 0 or off / top,
      1e-5)
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

--- The upper block stays on the lower one, told by their displacements and not by the contact. The nodes compared lie
--- up to half a cell apart on surfaces that bend: 0.17 on coarse or hard blocks, where a contact unseen shows 1.
local function above_bed(case, q, say)
  if q.edge then
    return -- part of the sole hangs over the edge and goes down beside it
  end
  local sole, bed, lowest = case:series("sole", "u_y"), case:series("bed", "u_y"), 0
  for i = 2, #sole do
    lowest = math.min(lowest, sole[i] - bed[i] - q.sink * q.L)
  end
  say("node in the other body over the way pressed", lowest / (q.press * q.L), 0.2)
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

--- Stress over strain where the sides are held.
local function uniaxial(q)
  return q.E * (1 - q.nu) / ((1 + q.nu) * (1 - 2 * q.nu))
end

--- Uniaxial strain of two layers in a row: the force of a spring of two.
local function channel(case, q, say)
  if q.shift ~= 0 or q.material ~= "linear_elastic" then
    return
  end
  local modulus = uniaxial(q)
  local spring = 1 / (q.heights[1] / modulus + (q.heights[2] + q.apart) / (q.contrast * modulus)) -- tied nodes move down
  local force = case:series("contact", "force_z")
  local wanted = spring * q.press * q.size ^ 2 * q.M * q.L / q.T ^ 2
  -- node to segment on meshes that do not match fails the patch test: 6e-3
  local unmatched = q.unmatched and q.discretisation == "node_to_segment"
  say("force over that of two layers in a row, less 1", force[#force] / wanted - 1, unmatched and 1e-2 or 1e-6)
end

--- While the first wave is under way the wall sees rho c v0.
local function wave(case, q, say)
  if q.material ~= "linear_elastic" or q.whole or q.pace ~= 1 then
    return
  end
  local c = math.sqrt(q.E / q.rho)
  local first = q.gap / q.speed
  local from, to = (first + 0.5 * q.size / c) * q.T, (first + 1.6 * q.size / c) * q.T
  local mean = measure.mean_between(case, "point", "pressure", from, to)
  -- steps a hundred times shorter let the front ring: 8e-4 then, else 5e-6
  say("pressure over rho c v0, less 1", mean / (q.rho * c * q.speed * q.M / q.L / q.T ^ 2) - 1, q.tiny and 2e-3 or 1e-4)
end

--- Momentum of a single cell: what the floor and the weight gave it. The scheme takes inner forces at the ends of steps
--- at contact nodes and in the mean elsewhere: half of them is left over wherever the step changes, and at the end.
local function momentum(case, q, say)
  if q.whole then
    return -- one step: the end force times the step is no impulse
  end
  local force, v, dt = case:series("contact", "force_y"), 0, case:series("step", "dt")
  local strain, modulus = case:series("energy", "strain"), uniaxial(q) * q.M / q.L / q.T ^ 2
  for i = 1, 4 do
    local corner = case:series("corner_" .. i, "v_y")
    v = v + 0.25 * corner[#corner] / (q.L / q.T)
  end
  local mass, impulse, over, t = q.rho * q.size ^ 2, 0, 0, case.time
  for i = 2, #t do
    impulse = impulse + force[i] * (t[i] - t[i - 1])
    over = over + math.max(force[i], math.sqrt(2 * modulus * strain[i])) * math.abs((dt[i + 1] or 0) - dt[i])
  end
  local unit, last = q.M / q.T, t[#t] / q.T
  impulse, over = impulse / unit, over / unit
  local given = impulse - mass * q.g * last - mass * (v + q.speed)
  local all = math.abs(impulse) + mass * q.g * last + mass * math.abs(q.speed)
  say("momentum over all impulses", given / all, 1e-6 + over / all)
end

--- Where the common centre of three blocks ends: their fall, and what the floor gave them. Contact nodes follow by
--- implicit Euler: what acts on them comes half a step late; changes of the step as in `momentum`.
local function centre(case, q, say)
  local t, dt, potential = case.time, case:series("step", "dt"), case:series("energy", "potential")
  local n, push, late, longest, all = #t, 0, 0, largest(dt), {}
  for i = 1, 3 do
    all[i] = case:series("floor_" .. i, "force_y")
  end
  for k = 2, n do
    local force = all[1][k] + all[2][k] + all[3][k]
    push = push + force * dt[k] * (t[n] - t[k] + 0.5 * dt[k])
    late = late + force * (dt[k] * longest + math.abs((dt[k + 1] or 0) - dt[k]) * (t[n] - t[k]))
  end
  local unit, last = q.M, t[n] / q.T -- of mass times length, for a depth of 1 m
  local mass, sunk = 3 * q.rho * q.size ^ 2, -potential[n] / (q.M * q.L / q.T ^ 2)
  local fall = mass * (q.speed * last + 0.5 * q.g * last ^ 2)
  local wanted = fall - push / unit
  local got = q.g > 0 and sunk / q.g or wanted
  say("where the common centre ends, over its free fall", (got - wanted) / fall,
    1e-6 + (late / unit + 0.5 * mass * q.g * last * longest / q.T) / fall)
end

--- The same numbers in other units give the same dimensionless results; what the scheme loses is what works and
--- energies leave, and no surer than they are.
local function other_units(case, _, say, base)
  if base then
    for _, name in ipairs(measure.names) do
      local own, wanted = case.results[name], base.results[name]
      local terms = name == "loss" and 1e-2 * math.abs(base.results.work) or 0
      say(name .. " less that in SI", own - wanted, 1e-5 * math.max(math.abs(wanted), 1e-6, terms))
    end
  end
end

--- The force of a flat floor is the pressure of its points times the part of the surface that each of them has, all
--- the same.
local function carried(say, force, pressures, part, where)
  local off = 0
  for i = 2, #force do
    local sum = 0
    for _, pressure in ipairs(pressures) do
      sum = sum + pressure[i] * part
    end
    off = math.max(off, math.abs(force[i] - sum))
  end
  off = off / math.max(largest(force), 1e-300)
  say("force of the floor against pressure, over the largest" .. (where or ""), off, 1e-6)
end

local function pressures_of(case, line, q)
  local list = {}
  for k, point in ipairs(measure.points(case, line, q)) do
    list[k] = point.pressure
  end
  return list
end

local function carried_by_bar(case, q, say)
  carried(say, case:series("contact", "force_y"), pressures_of(case, "line", q), 0.5 * q.size / q.cells * q.L)
end

local function carried_by_drop(case, q, say)
  carried(say, case:series("contact", "force_y"), pressures_of(case, "line", q), 0.5 * q.size * q.L)
end

local function carried_by_crowd(case, q, say)
  for i = 1, 3 do
    local pair = "floor_" .. i
    carried(say, case:series(pair, "force_y"), pressures_of(case, "line_" .. pair, q), 0.5 * q.size * q.L,
      " at " .. pair)
  end
end

local function lines_of_crowd(case, q, say)
  for _, name in ipairs(case:columns()) do
    local line = name:match("^(line_[%w_]+)/gap$")
    if line then
      complementarity(case, q, say, line)
    end
  end
end

--- What presses a folded strip on one side holds it on the other: its contact with itself takes and gives nothing.
local function held(case, _, say)
  local off, most = 0, 0
  for _, name in ipairs { "force_x", "force_y" } do
    local here, there = case:series("drive", name), case:series("held", name)
    most = math.max(most, largest(here))
    for i = 2, #here do
      off = math.max(off, math.abs(here[i] + there[i]))
    end
  end
  say("what is held against what presses, over the largest", off / math.max(most, 1e-300), 1e-5)
end

--- What is drawn off the floor is the pressure that is missing, times the area within the lip, less the floor's push; air that
--- leaks has no pressure.
local function suction(case, q, say)
  local pressure, r, off, wrong, most = case:series("gas", "pressure"), case:series("lip", "u_x"), 0, 0, 0
  local floor, drive, leaking = case:series("contact", "force_y"), case:series("drive", "force_y"), case:series("lip", "u_y")
  local left = false
  for i = 2, #pressure do
    local pull = pressure[i] * math.pi * (q.size * q.L + r[i]) ^ 2
    off, most = math.max(off, math.abs(floor[i] + drive[i] + pull)), math.max(most, math.abs(pull), math.abs(floor[i]))
    wrong = math.max(wrong, left and math.abs(pressure[i]) or pressure[i])
    left = left or math.abs(leaking[i]) > q.leaks_at * q.L
  end
  say("what is pulled against air and floor, over the largest", off / (most + 1e-6 * measure.scales(q).force), 1e-6)
  say("pressure of air above that outside, or once the lip is off", wrong / (q.E * q.M / q.L / q.T ^ 2), 1e-12)
end

local of_scene = {
  law = { law, driven, balance, account, closed_ledger },
  punch = { balance, complementarity, above_floor, symmetry, released, account, closed_ledger },
  slide = { balance, complementarity, above_bed, sliding, account, closed_ledger },
  tie = { tied, complementarity, above_floor, account },
  tube = { gas_law, account },
  cup = { suction, complementarity, account },
  top = { impulses, complementarity, account, energy_kept },
  bar = { above_floor, wave, carried_by_bar, account, energy_kept },
  stack = { balance, complementarity, channel, account, closed_ledger },
  drop = { complementarity, momentum, carried_by_drop, account, energy_kept },
  fold = { held, complementarity, account, closed_ledger },
  crowd = { lines_of_crowd, centre, carried_by_crowd, account, energy_kept },
}
of_scene.slide_mortar, of_scene.stack_mortar = of_scene.slide, of_scene.stack
of_scene.dent, of_scene.dent_space = { dent.checks }, { dent.checks }
of_scene.stack_tied = { balance, channel, account, closed_ledger }

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
