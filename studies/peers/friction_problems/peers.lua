-- The friction problems in Siconos: how it is run, and what the best of its solvers gave on two cores that were busy, with one
-- thread. Seconds of processor time of the solver alone.
local siconos = { peer = "Siconos", package = "python3-siconos python3-h5py", script = "siconos_solvers.py",
  needs = "/usr/bin/python3 -c 'import numpy, h5py, siconos.numerics'" }

--- mu; the best solver, its seconds and iterations; slip, energy; unknowns. answers: "several" where
--- solvers that all get there do not agree.
local function pair(size, problem, mu, best, results, unknowns, answers)
  return { program = siconos, peer = siconos.peer, size = size, set = { problem = problem }, mu = mu, allowed = 1e-6,
    words = { "problems/" .. problem .. ".h5" }, kept = size ~= "largest", answers = answers,
    note = best[1], seconds = best[2], iterations = best[3], unknowns = unknowns,
    results = { slip = results[1], energy = results[2] } }
end

--- Of Stiction's default solver: iterations, and work in products W p.
local function counts(problem, iterations, work)
  return { set = { problem = problem }, counts = { iterations = iterations, work = work } }
end

return {
  solver_seconds = "default_seconds", solver_iterations = "default_iterations",
  quantities = { { name = "error", own = "default_error", unit = 1, symbol = "1", most = 1e-8 },
    { name = "slip", unit = 1, symbol = "1", scale = 1 }, { name = "energy", unit = 1, symbol = "1" } },
  pairs = {
    pair("small", "p01_flat_nc49", 0.3, { "NSN_AC_HYB", 0.00035, 1 }, { 0.0514038988, 0.8907435737 }, 147),
    pair("small", "p02_wavy_nc100", 0.2, { "VI_EG", 0.00116, 40 }, { 0.2626797405, 0.6432125428 }, 300),
    pair("small", "p09_rigidbox_nc144", 0.5, { "VI_EG", 0.00245, 30 }, { 1.57e-10, 0.0166355433 }, 432),
    pair("medium", "p03_twist_nc196", 0.5, { "NSN_NM", 0.005, 1 }, { 0, 0.3329552071 }, 588),
    pair("medium", "p04_rough_nc324", 0.8, { "NSGS", 0.0277, 41 }, { 0.4747257277, 0.2740464458 }, 972),
    pair("medium", "p10_rigidwall", 0.6, { "PROX_NSN", 2.09, 30 }, { 0.114, 5.58 }, 732, "several"),
    pair("largest", "p05_nearincomp_nc400", 0.6, { "NSN_AC_HYB", 0.137, 3 }, { 0.1773219634, 0.4333943782 }, 1200),
    pair("largest", "p06_shear_nc625", 0.4, { "ADMM", 0.396, 65 }, { 0.0074527936, 0.1427790520 }, 1875),
    pair("largest", "p07_rough_nc961", 0.3, { "NSN_AC_HYB", 2.08, 2 }, { 0.3941536749, 0.1622370995 }, 2883),
  },
  counts = {
    counts("p01_flat_nc49", 29, 34), counts("p02_wavy_nc100", 21, 26), counts("p09_rigidbox_nc144", 15, 19),
    counts("p03_twist_nc196", 49, 58), counts("p04_rough_nc324", 37, 42), counts("p10_rigidwall", 10652, 17600),
  },
}
