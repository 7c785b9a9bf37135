-- Pull-off of a rigid sphere from the points of a half space under Dugdale's adhesion (Maugis 1992).
--
--          .-'''-.       down by `depth` in Maugis' units, then up until it lets go
--         |   R   |
--     _____'-._.-'_____   traction sigma0 up to the opening h0 = w / sigma0;
--                         lambda = sigma0 (9 R / (2 pi w E*^2))^(1/3): JKR is endless lambda
--
--     ./stiction run studies/proofs/half_space_adhesion
local stiction = require "stiction"
local units = stiction.units
local mm, m, s, J, MPa, Pa = units.mm, units.m, units.s, units.J, units.MPa, units.Pa
local jkr, maugis = stiction.reference.jkr, stiction.reference.maugis

local function modulus(p) return jkr.modulus(p.young.si, p.poisson) end
local function sigma0(p) return maugis.traction(modulus(p), p.radius.si, p.w.si, p.lambda) end

--- Maugis' units of contact radius, force and depth.
local function scales(p) return maugis.units(modulus(p), p.radius.si, p.w.si) end

local function scene(p)
  local a, _, d = scales(p)
  return stiction.scene {
    kinematics = "three_dimensional",
    bodies = { base = stiction.body.half_space { young = p.young, poisson = p.poisson,
      size = { p.size * a * m, p.size * a * m }, points = { p.points, p.points }, boundary = "free" } },
    obstacles = { sphere = stiction.obstacle.height_map { surface = stiction.surface.sphere { radius = p.radius },
      times = { 0*s, 1*s, 2*s }, z = { 0*mm, -p.depth * d * m, p.above * d * m } } },
    pairs = { touch = stiction.pair { secondary = "base.surface", primary = "sphere",
      adhesion = stiction.adhesion.dugdale { sigma0 = sigma0(p)*Pa, h0 = p.w.si / sigma0(p) * m, ramp = p.ramp } } },
    scheme = stiction.scheme.quasi_static {},
    schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = p.steps_down },
      stiction.stage { to = 2*s, steps = p.steps_up } } },
    probes = {
      touch = stiction.probe.contact { pair = "touch" },
      sphere = stiction.probe.rigid { obstacle = "sphere" },
      energy = stiction.probe.energy {},
    },
  }
end

--- Past its maximum what is held only falls: along the stable states to where they end, and then to none.
local function comes_back(case)
  local forces, top, least, back = case:series("touch", "force_z"), 0, math.huge, 0
  for _, force in ipairs(forces) do
    if force > top then
      top, least, back = force, force, 0
    end
    least = math.min(least, force)
    back = math.max(back, force - least)
  end
  return back / top
end

return stiction.study {
  title = "Pull-off of a sphere from a half space (Maugis)",
  question = "Does Dugdale's adhesion give the pull-off of Maugis as its ramps get steeper and are resolved by more points?",
  given = { radius = { 5*mm, "" }, young = { 5*MPa, "" }, poisson = { 0.48, "" }, w = { 1*J/m^2, "" } },
  chosen = { size = { 6, "extent of the points over the radius unit (pi w R^2 / K)^(1/3)" },
    depth = { 0.5, "over the depth unit" }, above = { 2.5, "over the depth unit, where it has let go" },
    steps_down = { 6, "the way down does not matter: the law has no memory" }, steps_up = { 60, "a twentieth of the depth unit each" } },
  -- ramp: of the range, along which the traction rises and falls
  sweep = { { lambda = 0.5, points = 64, ramp = 0.1 }, { lambda = 0.5, points = 128, ramp = 0.05 },
    { lambda = 0.5, points = 256, ramp = 0.025 }, { lambda = 1, points = 64, ramp = 0.1 }, { lambda = 1, points = 128, ramp = 0.1 },
    { lambda = 1, points = 256, ramp = 0.1 } },
  quick = { sweep = { { lambda = 0.5, points = 64, ramp = 0.1 }, { lambda = 0.5, points = 128, ramp = 0.05 } } },
  case_id = function(p) return ("lambda%g_%d"):format(p.lambda, p.points) end,
  scene = scene,
  results = {
    { name = "pull_off", unit = "N", meaning = "largest force that the sphere holds",
      function(run) return run:max("touch", "force_z") end },
    { name = "ratio", unit = "1", meaning = "that force over pi w R: 2 by DMT, 3/2 by JKR",
      function(run, p) return run:max("touch", "force_z") / (math.pi * p.w.si * p.radius.si) end },
  },
  check = function(cases, check)
    for _, lambda in ipairs { 0.5, 1 } do
      local its, values = cases:where { lambda = lambda }, {}
      for k, case in ipairs(its) do
        values[k] = { case.p.size * scales(case.p) / case.p.points, case.results.pull_off }
      end
      if #its > 0 then
        local p = its[1].p
        check.proof { case = "Sphere on a half space, Dugdale's adhesion", quantity = ("pull-off, lambda = %g"):format(lambda),
          unit = "N", kind = "exact", source = "Maugis 1992", reference = maugis.pull_off(lambda) * math.pi * p.w.si * p.radius.si,
          values = values, resolution = "m spacing",
          tolerance = lambda == 0.5 and 0.01 or 0.02, run = its[#its] } -- at lambda = 1 the ramps stay
        for _, case in ipairs(its) do
          -- coarse points let go by rings
          check.within(case.id .. ": force that comes back after the largest, over that", comes_back(case), 0, 0.02)
        end
      end
    end
  end,
  figures = function(cases)
    local curves = {}
    for _, lambda in ipairs { 0.5, 1 } do
      local its = cases:where { lambda = lambda }
      local case = its[#its]
      if case then
        local p = case.p
        local _, P, d = scales(p)
        local x, y = {}, {}
        for k, z in ipairs(case:series("sphere", "u_z")) do
          x[k], y[k] = -z / d, case:series("sphere", "force_z")[k] / P
        end
        curves[#curves + 1] = { label = ("%d^2 points, lambda = %g"):format(p.points, lambda), x = x, y = y, style = "points" }
        local depths, forces = {}, {}
        for k = 1, 200 do
          local a = 0.05 + 1.95 * k / 200
          depths[k], forces[k] = maugis.depth(lambda, a), maugis.force(lambda, a)
        end
        curves[#curves + 1] = { label = ("Maugis, lambda = %g"):format(lambda), x = depths, y = forces }
      end
    end
    return {
      stiction.figure.lines { name = "force", title = "Force over depth", x = { label = "d*", range = { -2.5, 1 } },
        y = { label = "P*", range = { -2, 1.5 } }, curves = curves },
      stiction.figure.field { name = "bonds", title = "Part of the work that is ahead", case = cases:where { points = 128 }[1],
        time = 1*s, array = "beta", unit = "1" },
    }
  end,
}
