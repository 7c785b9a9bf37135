-- A rigid sphere on the points of a half space: Hertz's contact without a volume mesh.
--
--          .-'''-.       down by d = a^2 / R, or pressed by the force that belongs to it
--         |   R   |
--     _____'-._.-'_____   n x n points of a half space, free around them
--
--     ./stiction run studies/proofs/half_space_hertz
local stiction = require "stiction"
local units = stiction.units
local mm, s, MPa, N = units.mm, units.s, units.MPa, units.N
local hertz = stiction.reference.point_contact

local function radius(p) return p.a / p.slope end
local function modulus(p) return hertz.combined_modulus(p.young.si, p.poisson) end
local function exact_force(p) return hertz.force(p.a.si * p.slope, radius(p).si, modulus(p)) end

--- Names and distances of the points whose pressures are drawn.
local function radial(p)
  local list, step = {}, p.size * p.a / p.points
  for k = 1, 40 do
    list[k] = { name = ("at_%02d"):format(k), x = math.floor((k - 0.5) / 40 * 1.2 * p.points / p.size) + 0.5 }
    list[k].r = list[k].x * step
  end
  return list
end

local function scene(p)
  local probes = {
    touch = stiction.probe.contact { pair = "touch" },
    sphere = stiction.probe.rigid { obstacle = "sphere" },
    energy = stiction.probe.energy {},
  }
  for _, point in ipairs(radial(p)) do
    probes[point.name] = stiction.probe.contact_point { pair = "touch", near = { point.r, 0*mm, 0*mm } }
  end
  local by_force = p.drive == "force"
  return stiction.scene {
    kinematics = "three_dimensional",
    bodies = { base = stiction.body.half_space { young = p.young, poisson = p.poisson,
      size = { p.size * p.a, p.size * p.a }, points = { p.points, p.points }, boundary = "free" } },
    obstacles = { sphere = stiction.obstacle.height_map {
      surface = stiction.surface.sphere { radius = radius(p) }, times = { 0*s, 1*s },
      z = not by_force and { 0*mm, -p.a * p.slope } or nil, force = by_force and { 0*N, exact_force(p)*N } or nil } },
    pairs = { touch = stiction.pair { secondary = "base.surface", primary = "sphere" } },
    scheme = stiction.scheme.quasi_static {},
    schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = p.steps } } },
    probes = probes,
  }
end

return stiction.study {
  title = "Sphere on a half space (Hertz)",
  question = "Force, contact radius and pressure of Hertz's contact on the points of a half space.",
  given = { a = { 1*mm, "contact radius at the end" }, slope = { 0.05, "a / R" }, young = { 3*MPa, "" },
    poisson = { 0.4, "" } },
  chosen = { size = { 3, "extent of the points over a" }, steps = { 4, "the answer does not depend on them" } },
  sweep = { { points = 64, drive = "displacement" }, { points = 128, drive = "displacement" },
    { points = 256, drive = "displacement" }, { points = 512, drive = "displacement" },
    { points = 1024, drive = "displacement" }, { points = 256, drive = "force" } },
  quick = { sweep = { { points = 64, drive = "displacement" }, { points = 128, drive = "displacement" },
    { points = 256, drive = "displacement" }, { points = 128, drive = "force" } } },
  case_id = function(p) return ("%s_%d"):format(p.drive, p.points) end,
  scene = scene,
  results = {
    { name = "force", unit = "N", meaning = "force", function(run) return run:last("sphere", "force_z") end },
    { name = "depth", unit = "m", meaning = "approach", function(run) return -run:last("sphere", "u_z") end },
    { name = "radius", unit = "m", meaning = "contact radius, of the closed area",
      function(run) return math.sqrt(run:last("touch", "closed_area") / math.pi) end },
    { name = "peak", unit = "Pa", meaning = "largest pressure", function(run) return run:last("touch", "pressure_max") end },
    { name = "products", unit = "1", meaning = "products with W", function(run) return run.cost.products end },
  },
  check = function(cases, check)
    local driven = cases:where { drive = "displacement" }
    local p, fine = driven[1].p, driven[#driven]
    local function row(quantity, unit, name, reference, tolerance)
      local values = {}
      for k, case in ipairs(driven) do
        values[k] = { p.size * p.a / case.p.points, case.results[name] }
      end
      check.proof { case = "Sphere on a half space", quantity = quantity, unit = unit, kind = "exact",
        source = "Hertz; Johnson 1985, 4.2", reference = reference, values = values, resolution = "m spacing",
        tolerance = tolerance, run = fine }
    end
    row("force P", "N", "force", exact_force(p), 2e-4)
    row("contact radius a", "mm", "radius", p.a.si, 0.01)
    row("largest pressure p0", "MPa", "peak", hertz.peak_pressure(exact_force(p), radius(p).si, modulus(p)), 2e-3)
    local forced = cases:where { drive = "force" }[1]
    check.close("by force: the force", forced.results.force, exact_force(p), 1e-9)
    local twin = cases:find { drive = "displacement", points = forced.p.points }
    check.close("by force: the approach", forced.results.depth,
      twin.results.depth * (forced.results.force / twin.results.force) ^ (2 / 3), 1e-3)
  end,
  figures = function(cases)
    local fine = cases:where { drive = "displacement" }
    local case = fine[#fine]
    local p, r, pressure = case.p, {}, {}
    for k, point in ipairs(radial(p)) do
      r[k], pressure[k] = point.r.si, case:last(point.name, "pressure")
    end
    local x, y, peak = {}, {}, hertz.peak_pressure(exact_force(p), radius(p).si, modulus(p))
    for i = 0, 120 do
      x[i + 1] = 1.2 * p.a.si * i / 120
      y[i + 1] = hertz.pressure(x[i + 1], p.a.si, peak)
    end
    return {
      stiction.figure.lines { name = "pressure", title = "Pressure under the sphere", x = { label = "r", unit = "mm" },
        y = { label = "pressure", unit = "MPa" },
        curves = { { label = ("%d^2 points"):format(p.points), x = r, y = pressure, style = "points" },
          { label = "Hertz", x = x, y = y } } },
      stiction.figure.field { name = "map", title = "Contact pressure", case = cases:find { drive = "displacement", points = 128 },
        array = "contact_pressure", unit = "MPa" },
    }
  end,
}
