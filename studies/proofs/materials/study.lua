-- One cell of Blatz-Ko foam, stretched: force and shape against the closed form.
--
--      ____ z = l     sides free, area 1 m^2
--     |    |    P = G (l^-1/2 - l^-3), lateral l^-1/4, J = l^1/2
--     |____|
--
--     ./stiction run studies/proofs/materials
local stiction = require "stiction"
local units = stiction.units
local m, s, kg, Pa = units.m, units.s, units.kg, units.Pa

local function motions(p)
  local fix, drive = stiction.motion.fix, stiction.motion.drive
  local times, rest = { 0*s, 1*s }, 0*m
  return {
      fix { set = "cube.left", y = false, z = false }, fix { set = "cube.front", x = false, z = false },
      fix { set = "cube.bottom", x = false, y = false },
      drive { set = "cube.top", times = times, z = { rest, (p.stretch - 1) * m } },
  }
end

local function scene(p)
  return stiction.scene {
    kinematics = "three_dimensional",
    bodies = { cube = stiction.body {
      mesh = stiction.mesh.box { size = { 1*m, 1*m, 1*m }, cells = { 1, 1, 1 } },
      material = stiction.material.blatz_ko { shear_modulus = p.shear_modulus }, density = 1*kg/m^3,
    } },
    motions = motions(p), scheme = stiction.scheme.quasi_static {},
    control = stiction.control { force_tolerance = 1e-12 },
    schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = p.steps } } },
    output = stiction.output { frames = 0 },
    probes = {
      top = stiction.probe.force { set = "cube.top" },
      corner = stiction.probe.node { set = "cube.all", near = { 1*m, 1*m, 1*m } },
    },
  }
end

local function last(run, group, name, component)
  local list = run:series(group, name, component)
  return list[#list]
end

return stiction.study {
  title = "Blatz-Ko foam in stretch", question = "Does one cell give the closed forms?",
  given = { shear_modulus = { 10*Pa, "" } },
  chosen = { steps = { 10, "Newton's method converges in each" } },
  sweep = {
    stretch = { 0.6, 1.5, 2 },
  },
  scene = scene,
  results = {
    { name = "lateral", unit = "1", meaning = "stretch of the free sides",
      function(run) return 1 + last(run, "corner", "u_x") end },
    { name = "force_z", unit = "N", meaning = "force on the top along z",
      function(run) return last(run, "top", "force_z") end },
  },
  check = function(cases, check)
    for _, c in ipairs(cases) do
      local G, l = c.p.shear_modulus.si, c.p.stretch
      local function row(quantity, unit, value, reference)
        check.proof {
          case = "Blatz-Ko, stretch " .. l, quantity = quantity, unit = unit, kind = "exact", source = "Blatz and Ko 1962",
          values = { { 1, value } }, reference = reference, tolerance = 1e-10, run = c,
        }
      end
      row("force per area", "N/m^2", c.results.force_z, G * (l ^ -0.5 - l ^ -3))
      row("lateral stretch", "1", c.results.lateral, l ^ -0.25)
      row("volume ratio", "1", c.results.lateral ^ 2 * l, l ^ 0.5)
    end
  end,
  figures = function(cases)
    local exact_x, exact_y, curves = {}, {}, {}
    for i, c in ipairs(cases) do
      curves[i] = {
        label = "one cell, to " .. c.p.stretch, y = c:series("top", "force_z"), colour = i + 1, style = "dot",
        x = stiction.numeric.map(c.time, function(t) return 1 + (c.p.stretch - 1) * t end),
      }
    end
    local G = cases[1].p.shear_modulus.si
    for i = 0, 60 do
      local l = 0.55 + i * 0.025
      exact_x[i + 1], exact_y[i + 1] = l, G * (l ^ -0.5 - l ^ -3)
    end
    table.insert(curves, 1, { label = "closed form", x = exact_x, y = exact_y, colour = 1 })
    return { stiction.figure.lines {
      name = "stretch", title = "Blatz-Ko foam, uniaxial", x = { label = "stretch", unit = "1" },
      y = { label = "force per area", unit = "Pa" }, legend = "below",
      curves = curves,
    } }
  end,
}
