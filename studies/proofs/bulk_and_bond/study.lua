-- What makes an adhesive joint tougher at speed: the bulk that relaxes, the bond that is viscous, or both; over six decades.
--
--      M (<--+==================+|   strip: its end is turned at a constant rate, so that it cleaves at a constant speed v;
--            |  open  | bonded   |          fracture energy by its moment and its stiffness at rest, M^2 / (2 E' I)
--     -------+--------+-------------
--      sphere: drawn off a block that has relaxed under it; fracture energy by JKR, pull-off / (3/2 pi R)
--
-- The bond that knows no rate (b = 0) breaks at w. With E0 the modulus of what is loaded at once, both fracture energies rise
-- from w to w E0/E: at the front all is loaded at once, far from it relaxed. A viscous bond alone can be made to tell the same
-- at one speed; who then gives the body its measured relaxation too has counted the same loss twice.
--
--     ./stiction run studies/proofs/bulk_and_bond
local stiction = require "stiction"
local jkr = stiction.reference.jkr
local units, numeric = stiction.units, stiction.numeric
local mm, um, s, kg, m, J, N, MPa = units.mm, units.um, units.s, units.kg, units.m, units.J, units.N, units.MPa

local function relaxes(p) return p.kind == "bulk" or p.kind == "both" end
local function viscosity(p) return (p.kind == "bond" or p.kind == "both") and p.lag * p.time * p.w or 0*N*s/m end

--- E / (1 - nu^2) at rest, and of what is loaded at once, Pa: the bulk modulus stays.
local function modulus(p, at_once)
  local K, G = p.young.si / (3 * (1 - 2 * p.poisson)), p.young.si / (2 * (1 + p.poisson)) * (at_once and 1 + p.share or 1)
  return 4 * G * (3 * K + G) / (3 * K + 4 * G)
end

local function body(p, mesh, interpolation)
  return stiction.body { density = 1000*kg/m^3, mesh = mesh, interpolation = interpolation,
    material = stiction.material.linear_elastic { young = p.young, poisson = p.poisson },
    relaxing = relaxes(p) and { { share = p.share, time = p.time } } or nil }
end

-- The strip. Its bonds act over the length `reach`, as those of a beam on springs of stiffness C = 4 E' I / reach^4 do.
local function second_moment(p) return p.height.si ^ 3 / 12 end
local function curvature(p) return math.sqrt(2 * p.w.si / (modulus(p) * second_moment(p))) end -- of the strip at rest, 1/m
local function strip(p)
  local h, r, C = p.height, p.reach, 4 * modulus(p) * second_moment(p) / p.reach.si ^ 4
  local reaches = p.turned * ((p.kind == "bond" or p.kind == "both") and p.pace >= 1 and 2 or 1)
  local over = reaches * p.time / p.pace -- at rest the front goes a reach in time / pace
  local x, edge = curvature(p) * reaches * r.si / 2 * h, stiction.edge
  return stiction.scene {
    bodies = { strip = body(p, stiction.mesh.gmsh { size = p.cell * r, kind = "quad8", start = { 0*mm, 0*mm }, edges = {
      edge { to = { p.open * r, 0*mm }, name = "open" }, edge { to = { (p.length - 1) * r, 0*mm }, name = "bonded" },
      edge { to = { p.length * r, 0*mm }, name = "rest" }, edge { to = { p.length * r, h }, name = "far" },
      edge { to = { 0*mm, h }, name = "top" }, edge { to = { 0*mm, 0*mm }, name = "near" } } }) },
    obstacles = { plane = stiction.obstacle { shape = stiction.rigid.plane {} } },
    pairs = { bond = stiction.pair { secondary = "strip.bonded", primary = "plane", adhesion = stiction.adhesion.rcc {
      w = p.w, C_n = C*N/m^3, C_t = 0*N/m^3, b = viscosity(p), beta0 = 1, bonding = "never" } } },
    motions = { stiction.motion.fix { set = "strip.far" },
      stiction.motion.drive { set = "strip.near", near = { 0*mm, h }, times = { 0*s, over }, x = { 0*mm, x } },
      stiction.motion.drive { set = "strip.near", near = { 0*mm, 0*mm }, times = { 0*s, over }, x = { 0*mm, -x } } },
    scheme = stiction.scheme.quasi_static {}, output = stiction.output { frames = 0 },
    schedule = stiction.schedule { stages = { stiction.stage { to = over, steps = p.steps } } },
    probes = { force = stiction.probe.force { set = "strip.near", near = { 0*mm, h } },
      line = stiction.probe.contact_line { pair = "bond" }, energy = stiction.probe.energy {} },
  }
end

-- The sphere. Its bonds act over the length `zone` = E*/C.
local function sphere(p)
  local h, C, Z = p.zone * p.fine, modulus(p) / p.zone.si, 0*mm
  local off = p.held + (p.depth + p.above) * p.time / (p.pace * p.zone)
  return stiction.scene {
    kinematics = "axisymmetric",
    bodies = { block = body(p, stiction.mesh.graded_block { origin = { Z, -p.radius }, size = { p.radius, p.radius }, growth = 1.25,
      fine = { p.touched, 6 * h }, fine_size = h, coarse_size = p.radius / 12 }, "mean_dilatation") },
    obstacles = { ball = stiction.obstacle { shape = stiction.rigid.sphere { centre = { Z, p.radius }, radius = p.radius },
      times = { 0*s, p.held / 2, p.held, off }, y = { Z, -p.depth, -p.depth, p.above } } },
    pairs = { bond = stiction.pair { secondary = "block.top", primary = "ball", adhesion = stiction.adhesion.rcc {
      w = p.w, C_n = C*N/m^3, C_t = 0*N/m^3, b = viscosity(p) } } },
    motions = { stiction.motion.fix { set = "block.bottom" }, stiction.motion.fix { set = "block.left", y = false } },
    scheme = stiction.scheme.quasi_static {}, output = stiction.output { frames = 0 },
    schedule = stiction.schedule { stages = { stiction.stage { to = p.held, steps = 20 }, stiction.stage { to = off, steps = p.steps } } },
    probes = { bond = stiction.probe.contact { pair = "bond" }, energy = stiction.probe.energy {} },
  }
end

--- Where the bond begins at every time: X of the first point with beta > 1/2, m.
local function fronts(run)
  local X, beta, front = {}, {}, {}
  for k = 1, math.floor(run:series("line", "count")[1]) do
    X[k], beta[k] = run:series("line", "X", k)[1], run:series("line", "beta", k)
  end
  for i in ipairs(run.time) do
    front[i] = math.huge
    for k, x in ipairs(X) do
      if beta[k][i] > 0.5 and x < front[i] then front[i] = x end
    end
  end
  return front
end

--- First and last step in which the strip's front is within the window.
local function window(run, p)
  local first, last
  for i, x in ipairs(fronts(run)) do
    local grown = x / p.reach.si - p.open
    if grown > p.from and not first then first = i end
    if grown < p.to then last = i end
  end
  return first, last
end

--- What was lost per area of the strip's front in the window, over w.
local function lost(name)
  return function(run, p)
    if p.shape ~= "strip" or name == "relaxation_loss" and not relaxes(p) then return 0 end
    local i, k = window(run, p)
    local loss, front = run:series("energy", name), fronts(run)
    return (loss[k] - loss[i]) / (front[k] - front[i]) / p.w.si
  end
end

local function energy(run, p)
  if p.shape == "sphere" then
    return run:max("bond", "force_y") / jkr.sphere.pull_off(p.radius.si, p.w.si)
  end
  local i, k = window(run, p)
  local moment = numeric.mean(table.move(run:series("force", "force_x"), i, k, 1, {})) * p.height.si
  return moment ^ 2 / (2 * modulus(p) * second_moment(p) * p.w.si)
end

local function pace(run, p)
  if p.shape == "sphere" then return p.pace end
  local i, k = window(run, p)
  local front = fronts(run)
  return (front[k] - front[i]) / (run.time[k] - run.time[i]) * p.time.si / p.reach.si
end

local function sweep(paces)
  local list = {}
  for _, shape in ipairs { "strip", "sphere" } do
    list[#list + 1] = { shape = shape, kind = "neither", pace = 1 }
    for _, kind in ipairs { "bulk", "bond", "both" } do
      for _, pace_of in ipairs(paces) do
        if kind == "bulk" or pace_of <= 1 then list[#list + 1] = { shape = shape, kind = kind, pace = pace_of } end
      end
    end
  end
  return list
end

return stiction.study {
  title = "Bulk and bond over six decades of speed",
  question = "What makes a joint tougher at speed: the bulk that relaxes, the viscous bond, or both?",
  given = { young = { 5*MPa, "at rest" }, poisson = { 0.48, "at rest" }, w = { 1*J/m^2, "of the bond" }, time = { 1*s, "it relaxes in" },
    share = { 3, "of the shear modulus more at once" } },
  chosen = { lag = { 1.7, "b / (w time): at one speed the bond alone tells what the bulk alone does" },
    height = { 5*mm, "of the strip" }, reach = { 10*mm, "of its bonds" }, length = { 34, "reaches" },
    open = { 3, "reaches, at first" },
    turned = { 17, "reaches that the front goes at rest; twice as many where viscous bonds hold it back" },
    cell = { 0.25, "of the reach" }, from = { 3, "reaches grown" }, to = { 5.5, "reaches grown" },
    steps = { 140, "front moves less than a cell a step" },
    radius = { 5*mm, "of the sphere" }, zone = { 20*um, "of its bonds" }, fine = { 0.3, "of the zone" },
    touched = { 0.6*mm, "finest cells" },
    depth = { 40*um, "pressed" }, above = { 40*um, "beyond the largest force" }, held = { 1e4*s, "until all has relaxed" } },
  sweep = sweep { 1e-3, 1e-2, 0.1, 1, 10, 100, 1000 },
  quick = { set = { turned = 11, length = 25, steps = 90 }, sweep = { { shape = "strip", kind = "neither", pace = 1 },
    { shape = "strip", kind = "bulk", pace = 0.1 }, { shape = "strip", kind = "bulk", pace = 1000 },
    { shape = "strip", kind = "bond", pace = 1e-3 }, { shape = "sphere", kind = "neither", pace = 1 },
    { shape = "sphere", kind = "bulk", pace = 1e-3 }, { shape = "sphere", kind = "bulk", pace = 1000 },
    { shape = "sphere", kind = "bond", pace = 1e-3 } } },
  case_id = function(p) return ("%s_%s_%g"):format(p.shape, p.kind, p.pace) end,
  scene = function(p) return p.shape == "strip" and strip(p) or sphere(p) end,
  results = {
    { name = "energy", unit = "1", meaning = "fracture energy over w", energy },
    { name = "speed", unit = "1", meaning = "of the front, times the time to relax over the length of the bonds", pace },
    { name = "bulk", unit = "1", meaning = "lost in the bulk per area of the front over w", lost "relaxation_loss" },
    { name = "bond", unit = "1", meaning = "lost in the viscous bond per area of the front over w", lost "bonding_loss" },
  },
  check = function(cases, check)
    local at_once = modulus(cases[1].p, true) / modulus(cases[1].p)
    for _, shape in ipairs { "strip", "sphere" } do
      local elastic = cases:find { shape = shape, kind = "neither" }.results.energy
      local bulk = cases:where { shape = shape, kind = "bulk" }:values "energy"
      local slow = cases:find { shape = shape, kind = "bulk", pace = 1e-3 }
      if slow then check.close(shape .. ": slowly the bulk does nothing", slow.results.energy / elastic, 1, 0.03) end
      check.non_decreasing(shape .. ": the quicker the tougher", bulk, 0.02) -- steps meet the largest force within 0.5 %
      check.within(shape .. ": at most by E0/E", bulk[#bulk] / elastic / at_once, 0.85, 1.02)
      check.close(shape .. ": slowly the bond's viscosity does nothing either",
        cases:find { shape = shape, kind = "bond", pace = 1e-3 }.results.energy / elastic, 1, 0.03)
    end
    check.proof { case = "Bulk and bond", quantity = "fracture energy of the strip, loaded at once, over w", unit = "1", kind = "exact",
      source = "front at once, far from it at rest: w E0/E", reference = at_once,
      values = { { 1, cases:find { shape = "strip", kind = "bulk", pace = 1000 }.results.energy } }, resolution = "mesh", tolerance = 0.03,
      run = cases:find { shape = "strip", kind = "bulk", pace = 1000 } }
    for _, c in ipairs(cases:where { shape = "strip" }) do
      if c.p.pace <= 0.1 then -- quicker, the strip behind the front has not relaxed yet
        check.close("what it takes is w and what is lost, " .. c.id, c.results.energy, 1 + c.results.bulk + c.results.bond, 0.04)
      end
    end
    local function strip_at(kind) return cases:find { shape = "strip", kind = kind, pace = 1 } end
    if strip_at "bond" then
      local bulk, bond, both = strip_at("bulk").results.energy, strip_at("bond").results.energy, strip_at("both").results.energy
      check.close("the bond alone can tell what the bulk does, at one speed", bond, bulk, 0.1)
      check.holds("who takes both counts twice", both > 1.5 * bulk)
    end
  end,
  figures = function(cases)
    local kinds, ratio = { "bulk", "bond", "both" }, modulus(cases[1].p, true) / modulus(cases[1].p)
    local speed = { label = "speed * time / reach", log = true }
    --- A line with points at the cases of a kind.
    local function add(list, shape, kind, result, how)
      local of = cases:where { shape = shape, kind = kind }
      local x, y = of:values "speed", of:values(result)
      list[#list + 1] = { label = how.label or kind, x = x, y = y, colour = how.colour, style = how.style }
      list[#list + 1] = { x = x, y = y, colour = how.colour, style = "points" }
    end
    local function energies(shape)
      local list = {}
      for i, kind in ipairs(kinds) do add(list, shape, kind, "energy", { colour = i }) end
      local elastic = cases:find { shape = shape, kind = "neither" }.results.energy
      list[#list + 1] = { label = "E0 / E", x = { 1e-3, 1e3 }, y = { ratio * elastic, ratio * elastic }, style = "dash", colour = 0 }
      return list
    end
    local losses, lines = {}, stiction.figure.lines
    add(losses, "strip", "bulk", "bulk", { label = "bulk alone", colour = 1 })
    add(losses, "strip", "bond", "bond", { label = "bond alone", colour = 2 })
    add(losses, "strip", "both", "bulk", { label = "both: the bulk", colour = 3, style = "dash" })
    add(losses, "strip", "both", "bond", { label = "both: the bond", colour = 3, style = "dot" })
    return { stiction.figure.panel { name = "rates", width = "double", columns = 3, figures = {
      lines { name = "strip", title = "strip", x = speed, y = { label = "fracture energy / w" }, curves = energies "strip",
        legend = "below" },
      lines { name = "losses", title = "strip: lost where", x = speed, y = { label = "loss per area / w" }, curves = losses,
        legend = "below" },
      lines { name = "sphere", title = "sphere", x = speed, y = { label = "pull-off / JKR's" }, curves = energies "sphere",
        legend = "below" },
    } } }
  end,
}
