-- A suction cup pressed onto a plane and pulled off: what the air under it holds, and what its bonds hold.
--
--        | | stem, driven       p V stays: the cup holds by the pressure outside as long as its rim seals,
--      .-' '-.                  and lets go at once when the rim is off by `leak`
--    _/_______\_  rim
--
-- While it is pressed, air goes out under the rim; then p V stays. Whatever the cup does, what is pulled is the pressure that is
-- missing, times the area within the rim, less what the floor does to the cup.
--
--     ./stiction run studies/proofs/suction_cup
local stiction = require "stiction"
local u = stiction.units
local mm, s, m, N, MPa, kPa = u.mm, u.s, u.m, u.N, u.MPa, 1e3 * u.Pa

local function cup(p) -- right half: a cone of one wall with a flat rim below and a stem above
  local function at(x, y, name) return stiction.edge { to = { x, y }, name = name } end
  local O, h, t, R, r = 0*mm, p.height, p.wall, p.radius, p.stem
  return stiction.mesh.gmsh { size = t / 3, start = { R, O }, kind = "quad8", edges = {
    at(R + 1.5 * t, O, "rim"), at(r, h + 1.2 * t, "out"), at(r, h + 6 * t, "out"), at(O, h + 6 * t, "top"), at(O, h, "axis"),
    at(r, h, "under"), at(R, O, "under") } }
end

local function touch(p, set)
  return stiction.pair { secondary = set, primary = "floor", friction = stiction.friction.coulomb { mu = p.mu },
    adhesion = p.bonds and stiction.adhesion.rcc { w = p.w, C_n = p.C, C_t = p.C, b = 0.01 * p.w * s } or nil }
end

return stiction.study {
  title = "A suction cup", question = "How much does the air under a cup hold, and how much its bonds?",
  given = { radius = 10*mm, height = 4*mm, wall = 1.5*mm, stem = 2*mm, young = 3*MPa, outside = 101.325*kPa,
    w = { 5*u.J/m^2, "tacky" }, mu = 0.5 },
  chosen = { down = { 2.5*mm, "most of the air is driven out before the rim seals" }, up = { 8*mm, "bonds let go" },
    leak = { 0.02*mm, "of the rim" }, C = { 1e9*N/m^3, "bonds" }, steps = { 60, "each way" },
    drag = { 1e-5, "stabilisation: it lets go at once" } },
  sweep = { { air = false, bonds = true }, { air = true, bonds = false }, { air = true, bonds = true } },
  quick = { set = { steps = 40 } },
  case_id = function(p) return (p.air and "air" or "") .. (p.bonds and "bonds" or "") end,
  scene = function(p)
    return stiction.scene { kinematics = "axisymmetric",
      bodies = { cup = stiction.body { density = 1000*u.kg/m^3, mesh = cup(p),
        material = stiction.material.neo_hookean { young = p.young, poisson = 0.45 } } },
      obstacles = { floor = stiction.obstacle { shape = stiction.rigid.plane {} } },
      pairs = { rim = touch(p, "cup.rim"), under = touch(p, "cup.under") },
      motions = { stiction.motion.drive { set = "cup.top", times = { 0*s, 1*s, 2*s }, x = { 0*mm, 0*mm, 0*mm },
        y = { 0*mm, -p.down, p.up } } },
      loads = p.air and { stiction.load.gas { set = "cup.under", outside = p.outside, times = { 0*s, 2*s },
        pressure = { 0*kPa, 0*kPa },
        seal = { 0, 1 }, leaks_at = p.leak } } or nil,
      scheme = stiction.scheme.quasi_static { stabilisation = p.drag }, schedule = stiction.schedule { stages = {
        stiction.stage { to = 1*s, steps = p.steps }, stiction.stage { to = 2*s, steps = p.steps } } },
      probes = { lip = stiction.probe.node { set = "cup.under", near = { p.radius, 0*mm } },
        under = stiction.probe.contact { pair = "under" }, top = stiction.probe.force { set = "cup.top" },
        energy = stiction.probe.energy { audit = true },
        air = p.air and stiction.probe.gas { set = "cup.under" } or nil, rim = stiction.probe.contact { pair = "rim" } } }
  end,
  results = { { name = "held", unit = "N", meaning = "largest pull up to there", function(run) return run:max("top", "force_y") end } },
  check = function(cases, check)
    local bonds, air, both = table.unpack(cases:values "held")
    check.holds("the air holds more than the bonds", air > 3 * bonds and both > 3 * bonds)
    for _, c in ipairs(cases:where { air = true }) do
      local pull, t = c:max("top", "force_y")
      local r = c.p.radius.si + c:at(t, "lip", "u_x")
      local floor = c:at(t, "rim", "force_y") + c:at(t, "under", "force_y")
      check.close("what is pulled is what air and floor hold, " .. c.id, pull, -c:at(t, "air", "pressure") * math.pi * r ^ 2 - floor, 1e-4)
    end
  end,
  figures = function(cases)
    local function field(name, case, time, title)
      return stiction.figure.field { name = name, case = case, time = time, array = "von_mises", label = "von Mises stress", unit = "kPa",
        deformed = true, scale_bar = 5*mm, title = title }
    end
    return { stiction.figure.lines { name = "force", title = "A suction cup pressed on and pulled off", x = { label = "time", unit = "s" },
        y = { label = "pull", unit = "N" }, curves = stiction.numeric.map(cases, function(c)
          return { label = c.id, case = c, y = "top/force_y" }
        end) },
      field("pressed", cases[2], 1*s, "pressed on"), field("pulled", cases[2], 2*s, "drawn up by 8 mm, held by air alone") }
  end,
}
