-- A rough surface pressed onto a soft half space, left there to bond, then moved along or drawn off: does waiting make it stronger?
--
--      /\  _/\    /\_/\/\   -> or up     self-affine, rigid, pressed down at once and kept there
--     ____________________               points, periodic; bonds grow as w t / b where surfaces touch, and slip has friction
--
-- A bond of this law grows and breaks by the same viscosity b. Two pure numbers decide: the time of rest over that of a bond,
-- t w / b, and the speed at which it is parted over that of breaking, V b / (w u0) with the range u0 = sqrt(w / C).
--
--     ./stiction run studies/rough/rest_and_part
local stiction = require "stiction"
local units = stiction.units
local numeric = stiction.numeric
local um, s, J, m, MPa = units.um, units.s, units.J, units.m, units.MPa

--- Time of a bond b/w, s; stiffness of bonds C = w / u0^2.
local function bond_time(p) return p.b / p.w.si end
local function adhesion(p)
  local stiffness = p.w / p.range ^ 2
  return stiction.adhesion.rcc { w = p.w, C_n = stiffness, C_t = stiffness, b = p.b * units.N * s / m, bonding = "contact" }
end

--- Ends of pressing, rest and parting, s.
local function times(p)
  local pressed = 1e-3 * bond_time(p)
  local rested = pressed + p.rest * bond_time(p)
  return pressed, rested, rested + p.way * bond_time(p) / p.speed
end

local function scene(p)
  local L, height = p.length, p.slope * p.heights
  local pressed, rested, parted = times(p)
  local along = p.part == "slide"
  local z = { height, -height, -height, along and -height or -height + p.way * p.range }
  return stiction.scene {
    kinematics = "three_dimensional",
    bodies = { base = stiction.body.half_space { young = p.young, poisson = 0.5, size = { L, L }, points = { p.points, p.points },
      boundary = "periodic" } },
    obstacles = { rough = stiction.obstacle.height_map {
      surface = stiction.surface.rough { hurst = 0.8, longest = L / 2, shortest = L / 8, rms_slope = p.slope, seed = p.seed },
      times = { 0*s, pressed * s, rested * s, parted * s }, z = z, x = { 0*um, 0*um, 0*um, along and p.way * p.range or 0*um } } },
    pairs = { touch = stiction.pair { secondary = "base.surface", primary = "rough", adhesion = adhesion(p),
      friction = stiction.friction.coulomb { mu = p.mu } } },
    scheme = stiction.scheme.quasi_static {},
    schedule = stiction.schedule { stages = { stiction.stage { to = pressed * s, steps = p.down },
      stiction.stage { to = rested * s, steps = p.hold }, stiction.stage { to = parted * s, steps = p.steps } } },
    output = stiction.output { frames = 4 },
    probes = { touch = stiction.probe.contact { pair = "touch" }, rough = stiction.probe.rigid { obstacle = "rough" } },
  }
end

local function mu_pressed(run, p) return -p.mu * run:min("touch", "force_z") end

--- Largest traction of one bond that has rested and is then led off by itself, over sqrt(w C). In units of b/w and u0:
--- d beta/dt = 1 - beta u^2 up to a whole bond, growing only where it stays in contact; implicit in beta, traction beta^2 u.
local function alone(p, rest, speed)
  local beta, peak, n, last = math.min(1, 1e-3 + rest), 0, 4000, p.way / speed
  for k = 1, n do
    local u = p.way * k / n
    beta = math.min(p.part == "slide" and 1 or beta, (beta + last / n) / (1 + last / n * u ^ 2))
    peak = math.max(peak, beta ^ 2 * u)
  end
  return peak
end

--- Of a part and speed, by time of rest.
local function over_rest(cases, part, speed)
  local its = cases:where { part = part, speed = speed }
  table.sort(its, function(a, b) return a.p.rest < b.p.rest end)
  return its
end

local function sweep(rests, speeds, points)
  local list = {}
  for _, part in ipairs { "slide", "pull" } do
    for _, at in ipairs(speeds) do
      for _, rest in ipairs(rests) do
        list[#list + 1] = { part = part, rest = rest, speed = at.speed, way = at.way, points = points }
      end
    end
  end
  return list
end
local slow, even, fast = { speed = 0.1, way = 4 }, { speed = 1, way = 6 }, { speed = 10, way = 10 }

local function figure(cases, part, title)
  local curves, colour = {}, 0
  for _, speed in ipairs { 0.1, 1, 10 } do
    local x, y, bond = {}, {}, {}
    for k, case in ipairs(over_rest(cases, part, speed)) do
      x[k], y[k] = case.p.rest, case.results.strength
      bond[k] = alone(case.p, case.p.rest, speed)
    end
    if #x > 0 then
      colour = colour + 1
      curves[#curves + 1] = { label = ("V b / (w u0) = %g"):format(speed), x = x, y = y, style = "points", colour = colour }
      curves[#curves + 1] = { label = "one bond", x = x, y = bond, style = "dash", colour = colour }
    end
  end
  return stiction.figure.lines { name = part, title = title, x = { label = "time of rest over b/w", log = true },
    y = { label = "bonds' force over A sqrt(w C)", log = true }, curves = curves, legend = "below" }
end

return stiction.study {
  title = "A rough bonded contact that rests, then slides or is drawn off",
  question = "Does waiting make it stronger, and does it grow with the logarithm of time?",
  given = { young = { 3*MPa, "" }, length = { 100*um, "of a period" }, seed = { 1, "" }, slope = { 0.1, "rms" },
    w = { 0.05 * J/m^2, "" }, b = { 0.5, "N s/m for a square metre: a bond takes 10 s" }, range = { 0.3*um, "u0 of the bonds" },
    mu = { 0.3, "" } },
  chosen = { heights = { 8*um, "pressed, over the slope: 8 % touches" }, down = { 8, "nothing but the area depends on them" },
    hold = { 4, "bonds grow evenly: exact in any number" }, steps = { 100, "twice as many change the strength by less than 5 %" } },
  sweep = sweep({ 0.01, 0.03, 0.1, 0.3, 1, 3, 10 }, { slow, even, fast }, 64),
  quick = { sweep = sweep({ 0.1, 1, 10 }, { slow, fast }, 64) },
  case_id = function(p) return ("%s_rest%g_speed%g"):format(p.part, p.rest, p.speed) end,
  scene = scene,
  results = {
    { name = "force", unit = "N", meaning = "largest force of parting, along or upwards",
      function(run, p) return run:max("touch", p.part == "slide" and "force_x" or "force_z") end },
    { name = "strength", unit = "1", meaning = "that force, less friction mu P, over area that rested in contact and sqrt(w C)",
      function(run, p)
        local area, peak = run:max("touch", "closed_area"), p.w.si / p.range.si
        local force = p.part == "slide" and run:max("touch", "force_x") - mu_pressed(run, p) or run:max("touch", "force_z")
        return force / (area * peak)
      end },
    { name = "beta", unit = "1", meaning = "largest bond intensity at the end of rest",
      function(run, p)
        local _, rested = times(p)
        return run:at(rested, "touch", "beta_max")
      end },
    { name = "touching", unit = "1", meaning = "part of the area that touches",
      function(run, p) return run:max("touch", "closed_area") / p.length.si ^ 2 end },
  },
  check = function(cases, check)
    for _, case in ipairs(cases) do
      local p = case.p
      check.within(case.id .. ": largest bond after rest, w t / b but for the time of pressing", case.results.beta,
        math.min(1, p.rest), math.min(1, p.rest + 1e-3) + 1e-9)
    end
    for _, part in ipairs { "slide", "pull" } do
      local lazy, quick = over_rest(cases, part, 0.1), over_rest(cases, part, 10)
      for i = 2, #lazy do
        check.holds(("%s: longer rest before fast parting makes stronger"):format(quick[i].id),
          quick[i].results.force > quick[i - 1].results.force or quick[i - 1].p.rest >= 1)
      end
      local whole = numeric.first_where(quick, function(case) return case.p.rest >= 1 end)
      check.close(part .. ", fast: after ten times b/w no stronger than after once", quick[#quick].results.force,
        quick[whole].results.force, 1e-3)
      if part == "slide" then
        check.close("slide, slow: force after the longest over that after the shortest rest",
          lazy[#lazy].results.force / lazy[1].results.force, 1, 1e-2)
      end
    end
  end,
  figures = function(cases)
    return { figure(cases, "slide", "Static friction after rest"), figure(cases, "pull", "Pull-off after rest") }
  end,
}
