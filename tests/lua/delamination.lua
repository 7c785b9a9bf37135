-- Layered specimens whose slender arms bonds hold, stiff ones: each step takes as few iterations as the law is smooth for.
local test, _, _, shared = ...
local stiction = require "stiction"
local u = stiction.units
local mm, s = u.mm, u.s

local run = shared("runs").quasi_static "delamination_runs"
local length, free = 40, 26 -- half the specimen and its crack, mm

local function arms(thickness, cell)
  local e, t = stiction.edge, thickness*mm
  local lower = stiction.mesh.gmsh { size = cell*mm, kind = "quad8", start = { 0*mm, 0*mm }, edges = {
    e { to = { 2*length*mm, 0*mm }, name = "bottom" }, e { to = { 2*length*mm, t }, name = "right" },
    e { to = { free*mm, t }, name = "bond" }, e { to = { (free - cell)*mm, t }, name = "free" },
    e { to = { 0*mm, t }, name = "crack" }, e { to = { 0*mm, 0*mm }, name = "left" } } }
  local upper = stiction.mesh.block { origin = { 0*mm, t }, size = { 2*length*mm, t }, cells = { 2*length // cell, 2 }, kind = "quad8" }
  local bodies = {}
  for name, mesh in pairs { lo = lower, up = upper } do
    bodies[name] = stiction.body { mesh = mesh, density = 1600*u.kg/u.m^3,
      material = stiction.material.linear_elastic { young = 120*u.GPa, poisson = 0.2 } }
  end
  return bodies
end

--- fixture: "dcb" opens the crack, "enf" shears it, "slb" does both; stiffness of the bonds, N/m^3.
local function specimen(fixture, stiffness, steps)
  local thickness, motion = 1.2, stiction.motion
  local bodies = arms(thickness, 2)
  local bond = stiction.adhesion.bilinear { K = stiffness*u.N/u.m^3, sigma_n = 40*u.MPa, sigma_t = 60*u.MPa,
    G_I = 300*u.J/u.m^2, G_II = 900*u.J/u.m^2, mix = "linear" }
  local pairs = { bond = stiction.pair { secondary = "lo.bond", primary = "up.bottom", adhesion = bond } }
  local held = motion.fix { set = "lo.bottom", near = { 2*length*mm, 0*mm }, x = true, y = true }
  local at = fixture == "dcb" and 0 or length
  local drive = motion.drive { set = "up.top", near = { at*mm, 2*thickness*mm }, times = { 0*s, 1*s },
    y = { 0*mm, (fixture == "dcb" and 5 or -5)*mm } }
  local other = fixture == "slb" and motion.fix { set = "up.bottom", near = { 0*mm, thickness*mm }, x = false }
    or motion.fix { set = "lo.bottom", near = { 0*mm, 0*mm }, x = false }
  if fixture == "enf" then
    pairs.crack = stiction.pair { secondary = "lo.crack", primary = "up.bottom" }
  end
  return stiction.scene { bodies = bodies, pairs = pairs, motions = { held, other, drive }, scheme = stiction.scheme.quasi_static {},
    schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = steps } } },
    probes = { load = stiction.probe.force { set = "up.top", near = { at*mm, 2*thickness*mm } } } }
end

for _, own in ipairs { { "dcb", 2e14 }, { "enf", 2e14 }, { "slb", 2e13 } } do
  test(("%s with bonds of %g N/m^3 takes few iterations a step, and its steps are not cut"):format(own[1], own[2]), function()
    local result = run(specimen(own[1], own[2], 25)).result
    assert(result.iterations <= 4 * 25, result.iterations)
    assert(result.cuts <= 1, result.cuts)
  end)
end
