-- A flat punch with a sharp rim, drawn off a gel that it is bonded to. Bonds that reach from beyond the rim to its corner pull
-- towards that, wherever they are: their direction leapt, and no step converged. And where bonds are short and stiff, all of
-- them let go at once, one front after the other: the contact problem was given up on the way. Kendall's force is the answer.
local stiction = require "stiction"
local units = stiction.units
local m, mm, um, s, MPa, J, kg = units.m, units.mm, units.um, units.s, units.MPa, units.J, units.kg
local a, w, size = 100*um, 0.1*J/m^2, 2*mm

local function law_of(p)
  local strength = w / p.range
  if p.law == "exponential" then
    return stiction.adhesion.exponential { phi_n = w, sigma_max = strength, delta_t = p.range }
  end
  return stiction.adhesion.bilinear { K = 20 * strength / p.range, sigma_n = strength, sigma_t = strength, G_I = w, G_II = w }
end

local function scene(p)
  return stiction.scene {
    kinematics = "axisymmetric",
    bodies = { gel = stiction.body { interpolation = "mean_dilatation", density = 1000*kg/m^3,
      mesh = stiction.mesh.graded_block { origin = { 0*mm, -size }, size = { size, size }, growth = 1.2, fine = { 120*um, 6 * p.cell },
        fine_size = p.cell, coarse_size = size / 10 },
      material = stiction.material.linear_elastic { young = 3*MPa, poisson = 0.49 } } },
    obstacles = { punch = stiction.obstacle { times = { 0*s, 1*s, 2*s }, y = { 0*um, -1*um, 4*um },
      shape = stiction.rigid.polyline { smoothing = "polyline", points = { -1 * a, 0.1*mm, -1 * a, 0*um, a, 0*um, a, 0.1*mm } } } },
    pairs = { touch = stiction.pair { secondary = "gel.top", primary = "punch", adhesion = law_of(p) } },
    motions = { stiction.motion.fix { set = "gel.bottom" }, stiction.motion.fix { set = "gel.left", y = false } },
    scheme = stiction.scheme.quasi_static {},
    schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = 2 }, stiction.stage { to = 2*s, steps = p.steps } } },
    output = stiction.output { frames = 0 },
    probes = { touch = stiction.probe.contact { pair = "touch" } },
  }
end

return stiction.study {
  title = "Stiff bonds under a punch with a rim", question = "Is it drawn off at Kendall's force?",
  sweep = { { law = "bilinear", range = 0.4*um, cell = 1.5*um, steps = 40 },
    { law = "exponential", range = 0.4*um, cell = 1.5*um, steps = 40 },
    { law = "bilinear", range = 0.2*um, cell = 1*um, steps = 20 } },
  case_id = function(p) return ("%s_%g"):format(p.law, p.range / um) end,
  scene = scene,
  results = { { name = "pull_off", unit = "N", meaning = "largest pull", function(run) return run:max("touch", "force_y") end } },
  check = function(runs, check)
    local stiffness = 3e6 / (1 - 0.49 ^ 2)
    local kendall = math.sqrt(8 * math.pi * stiffness * w.si * a.si ^ 3)
    for _, run in ipairs(runs) do
      -- less by the bonds' reach: 0.94 at 0.4 um with cells and steps three and eight times finer, too
      check.within("pull over Kendall's force, " .. run.id, run.results.pull_off / kendall, 0.9, 1)
    end
  end,
}
