-- The block in other programs: how each is run, and what it gave on two cores that were busy, with one thread. Seconds of
-- processor time, MiB, N.
local getfem = { peer = "GetFEM", package = "python3-getfem", needs = "/usr/bin/python3 -c 'import numpy, getfem'",
  script = "getfem_block.py" }
local calculix = { peer = "CalculiX", package = "calculix-ccx", script = "calculix_block.py",
  needs = "/usr/bin/python3 -c 'import numpy' && command -v ccx" }

--- seconds, MiB, unknowns, iterations; press, drag, normal; the largest relative difference that is allowed.
local function pair(program, size, cells, cost, results, allowed)
  return { program = program, peer = program.peer, size = size, set = { cells = cells }, words = { cells }, allowed = allowed,
    seconds = cost[1], memory = cost[2], unknowns = cost[3], iterations = cost[4],
    results = { press = results[1], drag = results[2], normal = results[3] } }
end

return {
  quantities = { { name = "press", unit = 1, symbol = "N" }, { name = "drag", unit = 1, symbol = "N" },
    { name = "normal", unit = 1, symbol = "N" } },
  pairs = {
    pair(getfem, "small", 8, { 1.08, 74.8, 1458, 47 }, { 183.579502, 31.912250, 181.846162 }, 6e-4),
    pair(calculix, "small", 8, { 1.54, 44.4, 1215, 44 }, { 183.4145, 31.8779, 181.6967 }, 1.5e-3),
    pair(getfem, "medium", 16, { 18.4, 170.3, 8670, 48 }, { 182.264085, 31.409044, 180.815517 }, 2e-4),
    pair(calculix, "medium", 16, { 22.1, 90.9, 7803, 47 }, { 182.0566, 31.39045, 180.6199 }, 1.5e-3),
    pair(getfem, "large", 24, { 85.7, 491.9, 26250, 50 }, { 181.921356, 31.286557, 180.541944 }, 1e-4),
    pair(calculix, "large", 24, { 131.6, 301.5, 24375, 47 }, { 181.7134, 31.26474, 180.3408 }, 1.5e-3),
    pair(getfem, "largest", 32, { 290, 1291.5, 58806, 49 }, { 181.773956, 31.235582, 180.423175 }, 1e-4),
  },
  counts = {
    { set = { cells = 8 }, counts = { iterations = 11, factorizations = 1, solves = 11, contact_iterations = 380, work = 1.399e8 } },
    { set = { cells = 16 }, counts = { iterations = 11, factorizations = 1, solves = 11, contact_iterations = 553, work = 4.531e9 } },
    { set = { cells = 24 }, counts = { iterations = 11, factorizations = 1, solves = 11, contact_iterations = 69, work = 6.287e9 } },
  },
}
