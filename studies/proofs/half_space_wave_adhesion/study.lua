-- A wavy surface that adheres to a half space, pressed on and drawn off by displacement (Johnson 1995).
--
--      \__/      \__/      \__/      heights D (1 - cos(2 pi x / L)), work w of adhesion
--     --------------------------     n points along one wave length, periodic, plane strain
--
-- q = p* sin^2(psi) - sqrt(2 E* w tan(psi) / L), psi = pi a / L, p* = pi E* D / L: a jumps to full contact at the largest q, and the
-- surfaces come apart at the least one. Johnson's adhesion has no range; Dugdale's nears it as its traction grows over p*.
--
--     ./stiction run studies/proofs/half_space_wave_adhesion
local stiction = require "stiction"
local units = stiction.units
local mm, um, s, MPa, Pa, m = units.mm, units.um, units.s, units.MPa, units.Pa, units.m
local line = stiction.reference.line_contact

local function modulus(p) return line.combined_modulus(p.young.si, p.poisson) end
local function full(p) return math.pi * modulus(p) * p.amplitude.si / p.length.si end

--- Work of adhesion, J/m^2, of Johnson's alpha = sqrt(2 E* w / L) / p*.
local function work(p) return (p.alpha * full(p)) ^ 2 * p.length.si / (2 * modulus(p)) end

local function scene(p)
  local sigma0, D = p.strength * full(p), p.amplitude
  return stiction.scene {
    bodies = { base = stiction.body.half_space { young = p.young, poisson = p.poisson, size = { p.length },
      points = { p.points }, boundary = "periodic" } },
    obstacles = { wave = stiction.obstacle.height_map {
      surface = stiction.surface.wave { amplitude = p.amplitude, wavelengths = { p.length } },
      times = { 0*s, 1*s, 2*s }, y = { p.far * D, -p.deep * D, p.far * D } } },
    pairs = { touch = stiction.pair { secondary = "base.surface", primary = "wave",
      adhesion = stiction.adhesion.dugdale { sigma0 = sigma0*Pa, h0 = work(p) / sigma0 * m, ramp = p.ramp } } },
    scheme = stiction.scheme.quasi_static {},
    schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = p.steps },
      stiction.stage { to = 2*s, steps = p.steps } } },
    probes = {
      touch = stiction.probe.contact { pair = "touch" },
      wave = stiction.probe.rigid { obstacle = "wave" },
      line = stiction.probe.contact_line { pair = "touch" },
      energy = stiction.probe.energy {},
    },
  }
end

local function johnson(alpha, part)
  local psi = math.pi * part / 2 -- 2 a / L
  return math.sin(psi) ^ 2 - alpha * math.sqrt(math.tan(psi))
end

--- Least q / p* with contact, and the part in contact where q is zero: on the way off.
local function exact(alpha)
  local least, zero = 0, nil
  for k = 1, 20000 do
    local part = 0.9 * k / 20000
    local q = johnson(alpha, part)
    least = math.min(least, q)
    if q > 0 and not zero then
      zero = part
    end
  end
  return least, zero
end

--- Length over L of the zone at an edge in which Dugdale's traction acts: pi/8 (K / sigma0)^2, K^2 = 2 E* w.
local function zone(p) return math.pi / 8 * (p.alpha / p.strength) ^ 2 end

--- Mean pressures over p*, and the part in contact to the middles of those zones, over the steps of the way off.
local function curve(run, p)
  local load, part = {}, {}
  local force, bonds = run:series("touch", "force_y"), run:series("touch", "bonds")
  for k, t in ipairs(run.time) do
    if t >= 1 then
      load[#load + 1], part[#part + 1] = -force[k] / (p.length.si * full(p)), bonds[k] / p.points - zone(p)
    end
  end
  return load, part
end

return stiction.study {
  title = "Wave that adheres to a half space (Johnson)",
  question = "Do a wavy surface's pull-off and its contact without load near Johnson's as the range of adhesion gets short?",
  given = { young = { 3*MPa, "" }, poisson = { 0.5, "" }, length = { 1*mm, "of a wave" },
    amplitude = { 10*um, "of the heights" }, alpha = { 0.3, "Johnson's, of the work of adhesion" } },
  chosen = { ramp = { 0.2, "of the law, over its range" }, deep = { 0.5, "down, over the amplitude" },
    far = { 1, "off, over the amplitude" }, steps = { 150, "each way" } },
  sweep = { { points = 512, strength = 2 }, { points = 1024, strength = 2 }, { points = 2048, strength = 2 } },
  quick = { sweep = { { points = 256, strength = 2 ^ 0.5 }, { points = 512, strength = 2 ^ 0.5 } } },
  case_id = function(p) return ("n%d"):format(p.points) end,
  scene = scene,
  results = {
    { name = "pull_off", unit = "1", meaning = "largest mean tension over p*",
      function(run, p) local load = curve(run, p) return -math.min(table.unpack(load)) end },
    { name = "without_load", unit = "1", meaning = "part in contact where no force acts, on the way off",
      function(run, p)
        local load, part = curve(run, p)
        for k = 2, #load do
          if load[k] <= 0 then
            return part[k - 1] + (part[k] - part[k - 1]) * load[k - 1] / (load[k - 1] - load[k])
          end
        end
        return 0
      end },
  },
  check = function(cases, check)
    local its = cases:where {}
    local case = its[#its]
    local p = case.p
    local least, part = exact(p.alpha)
    local values = { pull_off = {}, without_load = {} }
    for k, one in ipairs(its) do
      for name, list in pairs(values) do
        list[k] = { one.p.length.si / one.p.points, one.results[name] }
      end
    end
    local function proof(name, quantity, reference, tolerance)
      check.proof { case = "Wave that adheres to a half space", quantity = quantity, unit = "1", kind = "exact", source = "Johnson 1995",
        reference = reference, values = values[name], resolution = "m spacing", tolerance = tolerance, run = case }
    end
    -- Johnson's adhesion has no range: what is left falls as points and strength grow
    proof("pull_off", "largest mean tension over p*", -least, p.strength < 2 and 0.03 or 0.01)
    proof("without_load", "part in contact without load", part, 0.02)
  end,
  figures = function(cases)
    local curves = {}
    for _, case in ipairs(cases) do
      local load, part = curve(case, case.p)
      curves[#curves + 1] = { label = ("%d points, sigma0 = %.3g p*"):format(case.p.points, case.p.strength), x = part, y = load,
        style = "points" }
    end
    local parts, loads = {}, {}
    for k = 1, 200 do
      parts[k] = 0.6 * k / 200
      loads[k] = johnson(cases[1].p.alpha, parts[k])
    end
    curves[#curves + 1] = { label = "Johnson", x = parts, y = loads }
    return { stiction.figure.lines { name = "load", title = "A wave drawn off", x = { label = "part in contact", range = { 0, 0.6 } },
      y = { label = "mean pressure / p*", range = { -0.15, 0.4 } }, curves = curves } }
  end,
}
