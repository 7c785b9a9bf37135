-- Balls of quadratic cells pressed on a plane and on each other: the node on the axis reads Hertz's peak pressure.
--
--            ._____.
--             `-.-'        half balls, axisymmetric, flats brought together, contact radius a << R
--      ________ ________   on a rigid plane, or on the mirror image
local stiction = require "stiction"
local hertz = stiction.reference.point_contact
local units = stiction.units
local mm, s, kg, m, MPa = units.mm, units.s, units.kg, units.m, units.MPa

local function modulus(p)
  return hertz.combined_modulus(p.young.si, p.poisson, p.pair and p.young.si or nil, p.poisson)
end
local function radius(p) return p.pair and p.radius / 2 or p.radius end -- 1/R = 1/R1 + 1/R2
local function sinking(p) return p.a * p.a / radius(p) end

--- Node to segment wants matching meshes.
local function cell(p, standing)
  return p.a / p.cells * (standing and p.method == "mortar" and 0.8 or 1)
end

local function ball(p, standing)
  return stiction.body {
    mesh = stiction.mesh.quarter_disc {
      centre = { 0*mm, standing and -p.radius or p.radius }, radius = p.radius, standing = standing, kind = p.kind,
      fine = { 1.5 * p.a, p.a }, fine_size = cell(p, standing), coarse_size = p.radius / 6, growth = 1.4,
    },
    material = stiction.material.linear_elastic { young = p.young, poisson = p.poisson }, density = 1000*kg/m^3,
  }
end

return stiction.study {
  title = "Pressure at the pole of balls of quadratic cells",
  question = "Do the points on the axis of revolution read Hertz's peak?",
  given = { radius = { 10*mm, "" }, young = { 100*MPa, "" }, poisson = { 0.3, "" } },
  chosen = { a = { 0.5*mm, "contact radius, R/20" }, cells = { 5, "to a" } },
  sweep = { pair = { false, true }, kind = { "quad8", "tri6" }, method = { "node_to_segment", "mortar" } },
  scene = function(p)
    local fix, path = stiction.motion.fix, { 0*mm, -sinking(p) }
    local motions = { fix { set = "ball.axis", y = false },
      stiction.motion.drive { set = "ball.flat", times = { 0*s, 1*s }, y = path } }
    local bodies, obstacles = { ball = ball(p, false) }, nil
    if p.pair then
      bodies.under = ball(p, true)
      motions[3], motions[4] = fix { set = "under.axis", y = false }, fix { set = "under.flat" }
    else
      obstacles = { under = stiction.obstacle { shape = stiction.rigid.plane {} } }
    end
    return stiction.scene {
      kinematics = "axisymmetric", bodies = bodies, obstacles = obstacles, motions = motions,
      pairs = { touch = stiction.pair {
        secondary = "ball.arc", primary = p.pair and "under.arc" or "under", discretisation = p.method } },
      scheme = stiction.scheme.quasi_static {},
      schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = 4 } } },
      output = stiction.output { frames = 0 },
      probes = {
        touch = stiction.probe.contact { pair = "touch" },
        pole = stiction.probe.contact_point { pair = "touch", near = { 0*mm, 0*mm } },
      },
    }
  end,
  results = {
    { name = "force", unit = "N", meaning = "force between the bodies",
      function(run) return run:max("touch", "force_y") end },
    { name = "pole", unit = "Pa", meaning = "pressure on the axis",
      function(run) return run:max("pole", "pressure") end },
    { name = "largest", unit = "Pa", meaning = "largest pressure",
      function(run) return run:max("touch", "pressure_max") end },
    { name = "hertz", unit = "Pa", meaning = "3 P/(2 pi a^2) for that force", function(run, p)
      return hertz.peak_pressure(run:max("touch", "force_y"), radius(p).si, modulus(p))
    end },
  },
  check = function(cases, check)
    for _, case in ipairs(cases) do
      check.close(case.id .. ": pressure at the pole", case.results.pole, case.results.hertz, 0.03)
      check.close(case.id .. ": largest pressure", case.results.largest, case.results.hertz, 0.03)
      check.close(case.id .. ": force", case.results.force,
        hertz.force(sinking(case.p).si, radius(case.p).si, modulus(case.p)), 0.05)
    end
  end,
}
