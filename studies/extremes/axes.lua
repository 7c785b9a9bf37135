-- What is driven to extremes: per axis its levels and the scenes they are tried on.
-- A level is { name, changes of the scene's values, want = the only right outcome, slow = true: full form only }.
local axes = {}

local function axis(name, meaning, scenes, levels)
  axes[#axes + 1] = { name = name, meaning = meaning, scenes = scenes, levels = levels }
end

--- Levels that set one value, named by it.
local function of(key, values)
  local levels = {}
  for i, value in ipairs(values) do
    levels[i] = { ("%g"):format(value), { [key] = value } }
  end
  return levels
end

local everything = { "law", "punch", "slide", "slide_mortar", "bar", "stack", "stack_mortar", "stack_tied", "drop", "crowd", "fold", "tie",
  "tube", "cup", "top", "dent", "dent_space" }

axis("base", "ordinary values", everything, { { "all", {}, want = "converged" } })

axis("C", "bond stiffness C [N/m^3]", { "law", "punch", "dent" }, of("C", { 0, 1e3, 1e6, 1e8, 1e11, 1e13, 1e16 }))
axis("w", "decohesion energy w [J/m^2]", { "law", "punch", "dent" }, of("w", { 0, 1e-9, 1e-3, 1e3, 1e6 }))
axis("b", "bond viscosity b [N s/m]", { "law", "punch", "dent" }, of("b", { 0, 1e-9, 1e-3, 1e3, 1e6 }))
axis("beta", "bond intensity at the start", { "law", "punch", "dent" }, {
  { "0", { beta0 = 0 } }, { "1", { beta0 = 1 } }, { "1_b0", { beta0 = 1, b = 0 } }, { "0_b0", { beta0 = 0, b = 0 } },
  { "below_0", { beta0 = -1e-9 }, want = "refused" }, { "above_1", { beta0 = 1 + 1e-9 }, want = "refused" },
})
axis("mu", "friction coefficient", { "punch", "slide", "slide_mortar", "fold", "dent", "dent_space" }, of("mu", { 0, 1e-9, 1, 3, 10 }))
axes[#axes].levels[6] = { "below_0", { mu = -0.1 }, want = "refused" }

axis("nu", "Poisson's ratio", { "punch", "stack", "slide" }, {
  { "-0.99", { nu = -0.99 } }, { "0", { nu = 0 } }, { "0.49", { nu = 0.49 } }, { "0.4999", { nu = 0.4999 } },
  { "0.4999_mean", { nu = 0.4999, interpolation = "mean_dilatation" } }, { "0.499999", { nu = 0.499999 } },
  { "0.5", { nu = 0.5 }, want = "refused" },
})
axis("nu", "Poisson's ratio", { "fold" }, {
  { "0", { nu = 0 } }, { "0.45", { nu = 0.45 } }, { "0.49_mean", { nu = 0.49, interpolation = "mean_dilatation" } },
})
axis("nu", "Poisson's ratio", { "dent", "dent_space" }, {
  { "-0.99", { nu = -0.99 } }, { "0", { nu = 0 } }, { "0_mu_3", { nu = 0, mu = 3 } }, { "0.4999", { nu = 0.4999 } },
  { "0.5001", { nu = 0.5001 }, want = "refused" },
})
axis("contrast", "upper E over lower E", { "slide", "slide_mortar", "stack", "stack_mortar", "stack_tied" },
  of("contrast", { 1e-9, 1e-6, 1e-3, 1e3, 1e6, 1e9 }))
axis("density", "mass density [kg/m^3]", { "bar", "drop", "crowd" }, {
  { "0", { rho = 0 }, want = "refused" }, { "1e-3", { rho = 1e-3 } }, { "1e5", { rho = 1e5 } },
  { "1e8", { rho = 1e8 }, slow = true },
})
axis("dt", "time step over the ordinary one", everything, {
  { "one_step", { whole = true } }, { "1e-12", { pace = 1e-12 } }, { "1e6", { pace = 1e6, halvings = 3 } },
})
axis("speed", "speed over the wave speed", { "bar" }, {
  { "1e-9", { speed = 30e-9, gap = 1e-8 } }, { "0.01", { speed = 0.3, gap = 0.05 } }, { "0.5", { speed = 15 } },
  { "1", { speed = 30 } }, { "1_rubber", { speed = 30, material = "neo_hookean" } },
  { "3", { speed = 90 } }, { "3_rubber", { speed = 90, material = "neo_hookean" } },
})
axis("speed", "speed over the wave speed", { "drop", "crowd" }, {
  { "0.01", { speed = 0.1 } }, { "1", { speed = 10, last = 4e-3, steps = 400 } },
  { "3_rubber", { speed = 30, last = 4e-3, steps = 400, material = "neo_hookean" } },
})
axis("overlap", "overlap at the start or by a step, in heights", { "punch" }, {
  { "start_1e-4", { sink = 5e-7 } }, { "start_0.01", { sink = 5e-5 } },
  { "start_0.1", { sink = 5e-4 }, want = "refused" },
  { "start_0.5", { sink = 2.5e-3 }, want = "refused" }, { "start_all", { sink = 5e-3 }, want = "refused" },
  { "start_beyond", { sink = 8e-3 }, want = "refused" },
  { "step_0.2", { press = 1e-3, steps = 1 } }, { "step_0.6", { press = 3e-3, steps = 1 } },
  { "step_2", { press = 1e-2, steps = 1 } }, { "step_2_rubber", { press = 1e-2, steps = 1, material = "neo_hookean" } },
})
axis("overlap", "overlap at the start or by a step, in heights", { "slide", "slide_mortar" }, {
  { "start_1e-4", { sink = 3e-7 } }, { "start_0.1", { sink = 3e-4 }, want = "refused" },
  { "start_0.5", { sink = 1.5e-3 }, want = "refused" }, { "start_1.5", { sink = 4.5e-3 }, want = "refused" },
  { "step_0.2", { press = 6e-4, steps = 1 } }, { "step_0.6", { press = 1.8e-3, steps = 1 } },
  { "step_2", { press = 6e-3, steps = 1 } },
})
axis("shape", "cells and aspect", { "punch" }, {
  { "one_cell", { cells = { 1, 1 } } }, { "flat_1e4", { size = 1, height = 1e-4, press = 2e-6, pull = 1e-3 } },
  { "flat_100", { size = 0.1, height = 1e-3, press = 2e-5 } },
  { "slender_100", { size = 1e-2, height = 1, press = 1e-4, pull = 1e-2, cells = { 1, 20 } } },
  { "slender_1e4", { size = 1e-4, height = 1, press = 1e-4, pull = 1e-2, cells = { 1, 20 } } },
  { "slender_1e4_smooth", { mu = 0, size = 1e-4, height = 1, press = 1e-4, pull = 1e-2, cells = { 1, 20 } } },
})
axis("shape", "cells and aspect", { "slide", "slide_mortar" }, {
  { "one_cell", { cells = { 1, 1 }, below = { 1, 1 } } },
  { "one_on_many", { cells = { 1, 1 }, below = { 40, 2 }, tilts = true, edge = true } },
  { "many_on_one", { cells = { 40, 2 }, below = { 1, 1 } } },
  { "flat_1e4", { size = 1, upper = 0.6, height = 1e-4, at = 0.13, press = 2e-6, slip = 6e-3 } },
})
axis("shape", "cells and aspect", { "stack", "stack_mortar", "stack_tied" }, {
  { "one_cell", { cells = { 1, 1, 1 }, below = { 1, 1, 1 } } },
  { "flat_1e4", { heights = { 1e-6, 1e-6 }, press = 2e-8 } },
  { "slender_1e4", { heights = { 100, 100 }, press = 1 } },
})
axis("place", "where nodes meet the other side", { "slide", "slide_mortar" }, {
  { "node_on_node", { at = 0.00125, upper = 0.005 } }, { "node_on_middle", { at = 0.001875, upper = 0.005 } },
  { "flush_corners", { at = 0, upper = 0.01, slip = 0 } }, { "flush_one_side", { at = 0 } },
  { "corner_on_corner", { at = 0.01, slip = 0, tilts = true, edge = true } },
  { "corner_nearly", { at = 0.01 - 1e-12, slip = 0, tilts = true, edge = true } },
  { "over_the_corner", { at = 0.0097, slip = 6e-4, steps = 24, tilts = true, edge = true } },
  { "past_the_corner", { at = 0.01 + 1e-9, edge = true } }, { "half_over", { at = 0.007, edge = true } },
  { "slides_off", { at = 0.003, slip = 9e-3, steps = 60, edge = true } },
})
axis("place", "where nodes meet the other side", { "stack", "stack_mortar" }, {
  { "node_on_edge", { cells = { 2, 2, 1 }, below = { 1, 1, 1 } } },
  { "node_on_face", { cells = { 3, 3, 1 }, below = { 2, 2, 1 }, unmatched = true } },
  { "edge_on_edge", { shift = 0.01 } }, { "edge_beyond", { shift = 0.01 + 1e-9 } }, { "half_over", { shift = 0.005 } },
})

axis("seam", "how tied surfaces lie on one another", { "stack_tied" }, {
  { "many_on_one", { cells = { 12, 12, 1 }, below = { 1, 1, 1 } } }, { "one_on_many", { cells = { 1, 1, 1 }, below = { 12, 12, 1 } } },
  { "3_on_2", { cells = { 3, 2, 1 }, below = { 2, 3, 1 } } }, { "nearly", { cells = { 3, 3, 1 }, shift = 1e-12 } },
  { "apart_0.05", { apart = 2.5e-4 } }, { "apart_0.2", { apart = 1e-3 }, want = "refused" },
  { "inside_0.05", { apart = -2.5e-4 } }, { "hangs_over_0.01", { shift = 5e-5 } },
  { "hangs_over_0.1", { shift = 5e-4 }, want = "refused" }, { "beyond", { shift = 0.01 }, want = "refused" },
})

local units = {}
for _, unit in ipairs { { "nm", { L = 1e-9 } }, { "um", { L = 1e-6 } }, { "km", { L = 1e3 } }, { "Mm", { L = 1e6 } },
  { "ug", { M = 1e-9 } }, { "Gg", { M = 1e9 } }, { "ns", { T = 1e-9 } }, { "Gs", { T = 1e9 } },
  { "nm_ns", { L = 1e-9, T = 1e-9, M = 1e-15 } } } do
  units[#units + 1] = unit
end
axis("units", "the same in other units", everything, units)

axis("steps", "number of tiny steps", { "law", "bar", "drop", "punch" }, { { "1e4", { tiny = 1e4 } } })
axis("steps", "number of tiny steps", { "dent" }, {
  { "1e4", { tiny = 1e4, points = { 2 } } }, { "1e6", { tiny = 1e6, points = { 2 } }, slow = true },
})
axis("steps", "number of tiny steps", { "law", "bar" }, { { "1e6", { tiny = 1e6 }, slow = true } })
axis("turn", "turn of the driven side [rad]", { "punch" }, {
  { "1e-12", { turn = 1e-12 } }, { "0.1", { turn = 0.1, press = 2e-4 } }, { "3_rubber", { turn = 3, material = "neo_hookean" } },
  { "100_in_a_step", { turn = 628, steps = 1 } },
})
axis("apart", "pulled apart, in lengths", { "law", "punch" }, {
  { "1", { pull = 1e-2 } }, { "1e3", { pull = 10 } }, { "1e9", { pull = 1e7 } },
  { "dry_1e9", { pull = 1e7, without = { "C" } } },
})
axis("support", "nothing holds the body", { "drop", "crowd" }, {
  { "static", { static = true, without = { "eta" } }, want = "refused" }, { "no_floor", { gap = 1 } },
  { "flight", { gap = 1, g = 0, speed = 0.1 } },
})
axis("sheet", "in plane stress", { "punch", "slide" }, {
  { "linear", { sheet = true } }, { "0.4999", { sheet = true, nu = 0.4999 } },
  { "rubber", { sheet = true, material = "neo_hookean" } },
  { "rubber_0.4999", { sheet = true, material = "neo_hookean", nu = 0.4999 } },
  { "venant", { sheet = true, material = "st_venant_kirchhoff" } },
  { "mean", { sheet = true, interpolation = "mean_dilatation" }, want = "refused" },
})
axis("relief", "waves of the sole, amplitude [m]", { "punch" }, {
  { "1e-15", { relief = 1e-15 } }, { "1e-9", { relief = 1e-9 } }, { "1e-5", { relief = 1e-5 } }, { "1e-3", { relief = 1e-3 } },
  { "3e-3", { relief = 3e-3 } }, { "folded", { relief = 4e-3 }, want = "refused" },
  { "rubber", { relief = 1e-3, material = "neo_hookean" } }, { "dry", { relief = 1e-3, without = { "C" } } },
})
axis("relax", "time in which the body relaxes [s]", { "punch", "slide", "slide_mortar", "drop", "crowd", "fold", "tie" }, {
  { "0", { relax = 0 }, want = "refused" }, { "1e-9", { relax = 1e-9 } }, { "1e-3", { relax = 1e-3 } }, { "1", { relax = 1 } },
  { "1e9", { relax = 1e9 } }, { "share_0", { relax = 1, share = 0 }, want = "refused" }, { "share_1e-9", { relax = 0.1, share = 1e-9 } },
  { "share_1e6", { relax = 0.1, share = 1e6, tilts = true } }, { "rubber", { relax = 0.1, material = "neo_hookean" } },
  { "sheet", { relax = 0.1, sheet = true }, want = "refused" },
  { "bulk", { relax = 0.1, bulk_share = 1 } }, { "bulk_alone", { relax = 0.1, share = 0, bulk_share = 1 } },
  { "bulk_1e6", { relax = 0.1, bulk_share = 1e6, tilts = true } },
  { "bulk_rubber", { relax = 0.1, bulk_share = 1, material = "neo_hookean" } },
})
axis("relax", "time in which the body relaxes [s]", { "punch", "slide", "slide_mortar", "drop", "crowd", "tie" }, {
  { "0.4999_mean", { relax = 0.1, nu = 0.4999, interpolation = "mean_dilatation" } },
  { "bulk_mean", { relax = 0.1, bulk_share = 1, interpolation = "mean_dilatation", material = "neo_hookean" } },
})
axis("folds", "of a strip on itself", { "fold" }, {
  { "2", { folds = 2, press = 3e-3 } }, { "4", { folds = 4, press = 5e-3 } }, { "few_steps", { steps = 4 } },
  { "flat", { press = 1.6e-3 } }, { "apart", { press = -3e-3 } }, { "bonded", { C = 1e9, w = 1, b = 0.5, pull = 3e-3 } },
  { "coarse", { cell = 1e-3 } }, { "sheet", { sheet = true } },
})
axis("pairs", "which whole outlines may touch", { "crowd" }, {
  { "one_way", { pairing = "one_way" } }, { "both_ways", { pairing = "both_ways" } },
  { "everything", { pairing = "everything" } }, { "everything_dry", { pairing = "everything", without = { "mu" } } },
})
axis("spring", "spring that draws it, stiffness [N/m]", { "tie" }, {
  { "0", { k = 0 }, want = "refused" }, { "1e-6", { k = 1e-6 }, want = "refused" }, { "1", { k = 1 } }, { "1e9", { k = 1e9 } },
  { "1e16", { k = 1e16 } }, { "line", { line = true } }, { "line_1e12", { line = true, k = 1e12 } },
  { "line_slack", { line = true, rest = 2 } }, { "spread", { spread = true } }, { "stretched", { draw = 1 } },
  { "rubber", { material = "neo_hookean", line = true } },
})
axis("fill", "gas, pressure over E or volume, that fills it; stress of its surface over E size", { "tube" }, {
  { "0", { fill = 0 } }, { "1e-9", { fill = 1e-9 } }, { "1", { fill = 1 } }, { "1000", { fill = 1e3, steps = 1000 } },
  { "sucked", { fill = -0.3, outside = 1 } }, { "vacuum", { fill = -0.1 }, want = "refused" },
  { "volume", { by = "volume", fill = 4 } }, { "volume_1e3", { by = "volume", fill = 1e3, steps = 300 } },
  { "volume_1e-3", { by = "volume", fill = 1e-3, steps = 100 } }, { "volume_0", { by = "volume", fill = 0 }, want = "refused" },
  { "pressure", { by = "pressure" } }, { "pressure_beyond", { by = "pressure", fill = 1 } },
  { "gamma_1e-9", { gamma = 1e-9 } }, { "gamma_0.2", { gamma = 0.2 } }, { "gamma_1e3", { gamma = 1e3 } },
  { "gamma_0", { gamma = 0 }, want = "refused" }, { "linear", { material = "linear_elastic", fill = 1 } },
})
axis("seal", "how far off its seal a cup may be, how far it is drawn; pressure outside over E", { "cup" }, {
  { "leaks_0", { leaks_at = 0 } }, { "leaks_1e-9", { leaks_at = 1e-9 } }, { "leaks_never", { leaks_at = 1 } },
  { "below_0", { leaks_at = -1e-6 }, want = "refused" }, { "pull_1e-9", { pull = 1e-9 } }, { "pull_0.1", { pull = 0.1 } },
  { "outside_0", { outside = 0 } }, { "outside_1e-9", { outside = 1e-9 } }, { "outside_1", { outside = 1 } },
  { "outside_1e3", { outside = 1e3 } }, { "bonds", { C = 1e9, w = 5, b = 0.05 } }, { "dry", { without = { "mu" } } },
  { "linear", { material = "linear_elastic" } }, { "0.4999_mean", { nu = 0.4999, interpolation = "mean_dilatation" } },
})
axis("inertia", "moments of inertia of a ball over 0.1 m R^2, spin [rad/s]", { "top" }, {
  { "1e-9", { moments = { 1e-9, 1.5e-9, 2e-9 } } }, { "1e-3", { moments = { 1e-3, 1.5e-3, 2e-3 } } },
  { "1e3", { moments = { 1e3, 1.5e3, 2e3 } } }, { "1e9", { moments = { 1e9, 1.5e9, 2e9 } } },
  { "needle", { slender = 1e-9, moments = { 1, 1, 1 } } }, { "equal", { moments = { 1, 1, 1 } } },
  { "disc", { moments = { 1, 1, 2 } } }, { "no_body", { moments = { 1, 1, 2.1 } }, want = "refused" },
  { "0", { moments = { 0, 0, 0 } }, want = "refused" }, { "still", { spin = { 0, 0, 0 } } },
    { "spin_1e-9", { spin = { 1e-9, 1e-9, 1e-9 } } },
  { "spin_1e4", { spin = { 1e4, 2e4, 3e4 } } }, { "spin_1e9", { spin = { 1e9, 2e9, 3e9 } } }, { "mass_1e-9", { mass = 1e-9 } },
  { "mass_1e3", { mass = 1e3 } },
})
axis("points", "of a half space, their number and sides", { "dent" }, {
  { "1", { points = { 1 } }, want = "refused" }, { "2", { points = { 2 } } }, { "3", { points = { 3 } } }, { "127", { points = { 127 } } },
  { "2048", { points = { 2048 }, steps = 4, unchecked = true } }, { "2049", { points = { 2049 } }, want = "refused" },
})
axis("points", "of a half space, their number and sides", { "dent_space" }, {
  { "1", { points = { 1, 1 } }, want = "refused" }, { "2", { points = { 2, 2 } } }, { "2_by_8", { points = { 2, 8 } } },
  { "7_by_5", { points = { 7, 5 } } }, { "1_to_1000", { width = 1e-5 } },
})
axis("load", "of a half space: from nothing to the whole of it", { "dent", "dent_space" }, {
  { "empty", { press = -1e-3 } }, { "one_point", { press = 1e-12 } }, { "whole", { press = 2e-3, slip = 0 } },
  { "whole_wave", { form = "wave", boundary = "periodic", nu = 0.3, depth = 0.01, press = 2e-3 } },
  { "wave_dry", { form = "wave", boundary = "periodic", nu = 0.3, depth = 0.01, without = { "C", "mu" } } },
  { "too_deep", { form = "wave", boundary = "periodic", press = 1e-3 }, want = "refused" },
  { "layer_0.5", { form = "wave", boundary = "periodic", depth = 0.01, press = 1e-3 }, want = "refused" },
  { "layer_0.4999", { form = "wave", boundary = "periodic", nu = 0.4999, depth = 0.01, press = 1e-3 } },
  { "force", { force = 1 } }, { "force_0", { force = 0 } }, { "force_1e-12", { force = 1e-12 } }, { "force_1e6", { force = 1e6 } },
  { "force_dry", { force = 1, without = { "C" } } }, { "pulled", { force = -1e-3 } },
  { "pulled_dry", { force = -1e-3, without = { "C" } }, want = "refused" },
})
axis("rough", "heights from point to point [m]", { "dent", "dent_space" }, {
  { "1e-12", { form = "rough", height = 1e-12 } }, { "1e-6", { form = "rough", height = 1e-6 } },
  { "1e-3", { form = "rough", height = 1e-3 } }, { "1", { form = "rough", height = 1 } },
  { "1e-5_bonded", { form = "rough", height = 1e-5, without = { "mu" } } },
  { "periodic", { form = "rough", height = 1e-5, boundary = "periodic", nu = 0.3, depth = 0.01 } },
})
axis("map", "heights from a file", { "dent", "dent_space" }, {
  { "as_many", { map = "own" } }, { "few", { map = "few" }, want = "refused" }, { "few_bilinear", { map = "few", between = "bilinear" } },
  { "few_bicubic", { map = "few", between = "bicubic" } }, { "many_bilinear", { map = "many", between = "bilinear" } },
  { "flat", { map = "flat" } }, { "spike", { map = "spike" } }, { "nanometres", { map = "own", map_unit = "nm" } },
  { "metres", { map = "own", map_unit = "m" } }, { "other_size", { map = "own", map_size = 0.02 }, want = "refused" },
  { "hole", { map = "hole" }, want = "refused" },
  { "seam", { map = "ramp", boundary = "periodic", nu = 0.3, depth = 0.01 }, want = "refused" },
})
axis("range", "of attraction [m], between points 8e-4 apart", { "dent", "dent_space" }, {
  { "1e-12", { range = 1e-12, without = { "mu" } } }, { "1e-9", { range = 1e-9, without = { "mu" } } },
  { "1e-6", { range = 1e-6, without = { "mu" } } }, { "1e-3", { range = 1e-3, without = { "mu" } } },
  { "1", { range = 1, without = { "mu" } } }, { "1e-6_mu", { range = 1e-6 } }, { "1e-3_mu", { range = 1e-3 } },
})
axis("counterpart", "E of an elastic counterpart over that of the half space", { "dent", "dent_space" }, {
  { "1e-9", { hard = 1e-9 } }, { "1", { hard = 1 } }, { "1e9", { hard = 1e9 } }, { "1_mu_3", { hard = 1, mu = 3 } },
  { "1e-3_mu_3", { hard = 1e-3, mu = 3 } },
})
axis("material", "bulk law under the same loads", { "punch", "slide", "stack", "drop" }, {
  { "rubber", { material = "neo_hookean" } }, { "venant", { material = "st_venant_kirchhoff" } },
  { "rubber_0.4999", { material = "neo_hookean", nu = 0.4999, interpolation = "mean_dilatation" } },
})

--- All levels by "scene-axis-level", and their list in order: {scene =, axis =, level =, entry =}.
function axes.all()
  local list, by_id = {}, {}
  for _, one in ipairs(axes) do
    for _, entry in ipairs(one.levels) do
      for _, scene in ipairs(one.scenes) do
        local cell = { id = ("%s-%s-%s"):format(scene, one.name, entry[1]), scene = scene, axis = one.name,
          meaning = one.meaning, level = entry[1], changes = entry[2], want = entry.want, slow = entry.slow or false }
        list[#list + 1], by_id[cell.id] = cell, cell
      end
    end
  end
  return list, by_id
end

return axes
