-- The changed scenes: study, name, what is set beside the trade's own scene (settings of the ladder among it).
local units = require("stiction").units
local mm, um, m, s, kg, J = units.mm, units.um, units.m, units.s, units.kg, units.J
local N, MPa, GPa, Pa = units.N, units.MPa, units.GPa, units.Pa

local coarse = {
  sphere = { mesh_size = 1*mm, steps_down = 40 },
  plate = { mesh_size = 1*mm, descent_steps = 25, sliding_step = 40*um, tolerance = 1e-8 },
  hertz = { cell = 2*mm, coarse = 16*mm, depth = 3.2*mm },
  bar = { cells = 25, courant = 2 },
}

local list, count = {}, {}
local function add(study, words, set, quick)
  count[study] = (count[study] or 0) + 1
  local all = {}
  for _, part in ipairs { coarse[study], set } do
    for name, value in pairs(part) do all[name] = value end
  end
  list[#list + 1] = { study = study, name = study .. count[study], words = words, set = all, quick = quick }
end

add("sphere", "E = 1 MPa", { block_young = 1*MPa })
add("sphere", "E = 20 MPa", { block_young = 20*MPa })
add("sphere", "b = 1 N s/m", { b = 1*N*s/m })
add("sphere", "b = 40 N s/m", { b = 40*N*s/m })
add("sphere", "depth 1 mm, set B", { depth = 1*mm, set = "B" })
add("sphere", "set C", { set = "C" })
add("sphere", "set B, 3 mm/s", { set = "B", speed = 3*mm/s })
add("sphere", "0.2 mm/s", { speed = 0.2*mm/s })
add("sphere", "R = 20 mm", { sphere_radius = 20*mm })
add("sphere", "nu = 0.4", { block_poisson = 0.4 })
add("sphere", "height 5 mm", { block_height = 5*mm })
add("sphere", "depth 0.75 mm, b = 2 N s/m", { depth = 0.75*mm, b = 2*N*s/m })
add("sphere", "plain cells, E = 2 MPa", { model = "plain", block_young = 2*MPa })
add("sphere", "E = 2 MPa, set C, b = 5 N s/m", { block_young = 2*MPa, set = "C", b = 5*N*s/m })

local rough = N/m^3
add("plate", "mu = 0", { mu = 0 })
add("plate", "mu = 0.8", { mu = 0.8 })
add("plate", "500 mm/s", { v = 500*mm/s })
add("plate", "250 mm/s, mu = 0.2", { v = 250*mm/s, mu = 0.2 })
add("plate", "G = 3 MPa", { shear_modulus = 3*MPa })
add("plate", "G = 30 MPa", { shear_modulus = 30*MPa })
add("plate", "w = 5 J/m^2", { w = 5*J/m^2 })
add("plate", "C = 5e8 N/m^3", { C_n = 5e8*rough, C_t = 5e8*rough })
add("plate", "C = 6e9 N/m^3", { C_n = 6e9*rough, C_t = 6e9*rough })
add("plate", "b = 0.05 N s/m", { b = 0.05*N*s/m })
add("plate", "b = 0.5 N s/m", { b = 0.5*N*s/m })
add("plate", "sliding at 0.3 m/s", { sliding_speed = 0.3*m/s })
add("plate", "depth 0.5 mm", { depth = 0.5*mm })
add("plate", "mu = 0.2, quasi-static", { mu = 0.2, scheme = "quasi_static" })

add("hertz", "E2 = 30 GPa", { young_2 = 30*GPa, depth = 5.2*mm }, true)
add("hertz", "E2 = 210 GPa", { young_2 = 210*GPa }, true)
add("hertz", "half of the force", { force = 8.75e6*N/m })
add("hertz", "R = 100 mm", { radius = 100*mm }, true)
add("hertz", "nu = 0.45", { poisson = 0.45 })
add("hertz", "height 100 mm", { height = 100*mm }, true)
add("hertz", "width 60 mm", { width = 60*mm })
add("hertz", "mortar, nu = 0.1", { poisson = 0.1, discretisation = "mortar" })
add("hertz", "cells 1 mm, E1 = 70 GPa", { cell = 1*mm, coarse = 8*mm, young_1 = 70*GPa })
add("hertz", "cells 1 mm, half of the force", { cell = 1*mm, coarse = 8*mm, force = 8.75e6*N/m })

add("bar", "twice the speed", { speed = 20*m/s }, true)
add("bar", "E times 4", { young = 3600*Pa, duration = 2*s }, true)
add("bar", "half of the length", { length = 5*m }, true)
add("bar", "gap 2 m", { gap = 2*m })
add("bar", "contact nodes without mass, E / 2", { scheme = "massless", young = 450*Pa })
add("bar", "backward Euler, E times 2", { scheme = "backward_euler", young = 1800*Pa })
add("bar", "50 cells, density times 2", { cells = 50, courant = 1, density = 2*kg/m^3 })
add("bar", "theta = 0.55, half of the speed", { scheme = "paper_055", speed = 5*m/s, duration = 2.4*s })

return list
