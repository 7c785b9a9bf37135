-- The same contact with the bodies' matrix factored and with multigrid: one answer. Sliding, bonded, dynamic, of large
-- strain, nearly incompressible, without friction, and pressed by a ball. Bonds that snap have more than one answer: of those it
-- is asked that multigrid finds one in every step.
local stiction = require "stiction"
local units = stiction.units
local m, mm, um, s, ms = units.m, units.mm, units.um, units.s, units.ms
local MPa, kg, N, J = units.MPa, units.kg, units.N, units.J

local kinds = {
  sliding = {},
  bonded = { bonded = true, shear = 0.1*mm },
  lifted = { bonded = true, press = -2*um, bonds = 0.03 },
  snapping = { bonded = true, press = -2*um },
  large = { material = "neo_hookean", press = 1*mm, shear = 1*mm },
  soft = { poisson = 0.49 },
  free = { mu = 0 },
  dynamic = { dynamic = true, press = 0.2*mm },
  pole = { pole = true, press = 0.5*mm },
}
local order = { "sliding", "bonded", "lifted", "large", "soft", "free", "dynamic", "pole" }

local function scene(p)
  local kind = kinds[p.kind]
  local bonds, press, shear, zero = kind.bonds or 1, kind.press or 0.4*mm, kind.shear or 0.25*mm, 0*mm
  local reach = kind.dynamic and 20*ms or 2*s
  local shape = kind.pole and stiction.rigid.sphere { radius = 30*mm, centre = { 18*mm, 22*mm, -30*mm } } or stiction.rigid.plane {}
  return stiction.scene {
    kinematics = "three_dimensional",
    bodies = { block = stiction.body {
      mesh = stiction.mesh.box { size = { 40*mm, 40*mm, 20*mm }, cells = { p.cells, p.cells, p.cells / 2 } },
      material = stiction.material[kind.material or "linear_elastic"] { young = 5*MPa, poisson = kind.poisson or 0.3 },
      density = 1000*kg/m^3 } },
    obstacles = { floor = stiction.obstacle { shape = shape } },
    pairs = { sole = stiction.pair { secondary = "block.bottom", primary = "floor",
      friction = stiction.friction.coulomb { mu = kind.mu or 0.3 },
      adhesion = kind.bonded and stiction.adhesion.rcc { w = bonds*J/m^2, C_n = bonds*1e9*N/m^3,
        C_t = bonds*1e9*N/m^3, b = bonds*1e-4*N*s/m, beta0 = 1 } or nil } },
    motions = { stiction.motion.drive { set = "block.top", times = { 0*s, reach / 2, reach },
      x = { zero, zero, shear }, y = { zero, zero, zero }, z = { zero, -press, -press } } },
    scheme = kind.dynamic and stiction.scheme.theta_xi {} or stiction.scheme.quasi_static {},
    control = stiction.control { bulk = p.bulk },
    schedule = stiction.schedule { stages = { stiction.stage { to = reach, steps = 10 } } },
    output = stiction.output { frames = 0 },
    probes = { sole = stiction.probe.contact { pair = "sole" } },
  }
end

local cases = {}
for _, kind in ipairs(order) do
  for _, bulk in ipairs { "direct", "multigrid" } do cases[#cases + 1] = { kind = kind, bulk = bulk } end
end
cases[#cases + 1] = { kind = "snapping", bulk = "multigrid" }

local function last(column)
  return function(run)
    local values = run:series("sole", column)
    return values[#values]
  end
end

return stiction.study {
  title = "Contact by a factor and by multigrid", question = "Is it the same answer?",
  given = { cells = { 8, "along each side" } },
  sweep = cases,
  case_id = function(p) return p.kind .. "_" .. p.bulk end,
  scene = scene,
  results = {
    { name = "normal", unit = "N", meaning = "normal force at the end", last "force_z" },
    { name = "drag", unit = "N", meaning = "friction at the end", last "force_x" },
  },
  check = function(runs, check)
    for k = 1, #runs - 1, 2 do
      local direct, multigrid = runs[k].results, runs[k + 1].results
      local scale = math.abs(direct.normal) + math.abs(direct.drag)
      for _, name in ipairs { "normal", "drag" } do
        check.within(name .. " of both, " .. runs[k].p.kind, multigrid[name] - direct[name], -1e-6 * scale, 1e-6 * scale)
      end
      check.within("something bears, " .. runs[k].p.kind, scale, 1e-3, 1e6)
    end
    check.equal("steps, snapping", #runs[#runs]:series("sole", "force_z") - 1, 10, 0)
  end,
}
