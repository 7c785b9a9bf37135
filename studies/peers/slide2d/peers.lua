-- The slide in other programs: how each is run, and what it gave on two cores that were busy, with one thread. Seconds of
-- processor time, MiB, N/mm.
local getfem = { peer = "GetFEM", package = "python3-getfem", needs = "/usr/bin/python3 -c 'import numpy, getfem'",
  script = "getfem_slide.py" }
local calculix = { peer = "CalculiX", package = "calculix-ccx", script = "calculix_slide.py",
  needs = "/usr/bin/python3 -c 'import numpy' && command -v ccx" }

--- seconds, MiB, unknowns, iterations; press, drag, normal; the largest relative difference that is allowed.
local function pair(program, size, set, cost, results, allowed)
  return { program = program, peer = program.peer, size = size, set = set, words = { set.cells, set.mu, set.material },
    allowed = allowed, seconds = cost[1], memory = cost[2], unknowns = cost[3], iterations = cost[4],
    results = { press = results[1], drag = results[2], normal = results[3] } }
end

local function blatz_ko(mu, cells) return { material = "blatz_ko", mu = mu, cells = cells } end
local function neo_hookean(mu, cells) return { material = "neo_hookean", mu = mu, cells = cells } end

--- Of Stiction with the default settings, every iteration of which is a solve; no step is cut.
local function counts(set, iterations, factorizations, contact_iterations, work)
  set.secondary, set.discretisation = "plate.bottom", "node_to_segment"
  return { set = set, counts = { iterations = iterations, solves = iterations, factorizations = factorizations,
    contact_iterations = contact_iterations, work = work, cuts = 0 } }
end

return {
  quantities = { { name = "press", unit = 1e3, symbol = "N/mm" }, { name = "drag", unit = 1e3, symbol = "N/mm" },
    { name = "normal", unit = 1e3, symbol = "N/mm" } },
  pairs = {
    pair(getfem, "small", blatz_ko(0.5, 8), { 5.26, 57.6, 2338, 257 }, { 23.964984, 12.702442, 25.510931 }, 4e-3),
    pair(getfem, "medium", blatz_ko(0.2, 8), { 5.81, 57.2, 2338, 267 }, { 23.931951, 4.781372, 23.822145 }, 4e-3),
    pair(calculix, "medium", neo_hookean(0.5, 8), { 21.9, 33.9, 2292, 214 }, { 19.93589, 10.03389, 19.77799 }, 2e-2),
    pair(getfem, "medium", blatz_ko(0.5, 16), { 26.3, 79.6, 8770, 281 }, { 24.072377, 12.767984, 25.612220 }, 1e-3),
    pair(getfem, "medium", blatz_ko(0.2, 16), { 28.3, 78.6, 8770, 290 }, { 24.051326, 4.776070, 23.907666 }, 1e-3),
    pair(getfem, "medium", neo_hookean(0.5, 16), { 28.7, 79.5, 8770, 275 }, { 20.146991, 9.952695, 20.051418 }, 2e-3),
    pair(calculix, "large", neo_hookean(0.5, 16), { 81.8, 90.0, 8676, 185 }, { 19.96495, 10.06001, 19.84255 }, 2e-2),
    pair(getfem, "large", blatz_ko(0.2, 24), { 85.1, 104.0, 19298, 340 }, { 24.058511, 4.774351, 23.920859 }, 2e-3),
    pair(getfem, "large", blatz_ko(0.5, 24), { 73.0, 104.9, 19298, 295 }, { 24.079140, 12.781169, 25.627561 }, 2e-3),
  },
  counts = {
    counts(blatz_ko(0.2, 8), 285, 17, 353, 9.725e8), counts(blatz_ko(0.5, 8), 303, 21, 380, 1.099e9),
    counts(blatz_ko(0.2, 16), 302, 22, 8824, 7.107e9), counts(blatz_ko(0.5, 16), 298, 25, 11653, 7.723e9),
    counts(neo_hookean(0.5, 8), 288, 12, 354, 8.615e8), counts(neo_hookean(0.5, 16), 308, 16, 10870, 6.001e9),
  },
}
