-- Friction problems u = W r + q in space, solved alone: the contact solvers against Siconos', in Siconos' measure.
--
--     |r - P(r - (u + mu |u_t| n))| <= 1e-8 |q|,   P: the projection on the cones |r_t| <= mu r_n
--
-- problems/ holds /W_upper_packed (row by row, from the diagonal on), /q and /mu; mean diagonal of W and largest q are 1.
-- `seconds` is processor time of the solver alone, from no forces.
--
--     ./stiction run studies/peers/friction_problems
--     ./stiction peers friction_problems
local stiction = require "stiction"
local checks = require "../common/checks.lua"
local known = require "peers"
local measure = require "measure"

local default = "newton" -- what runs take unless told otherwise
local accuracy = 1e-8 -- in Siconos' measure

local names, quick_names = {}, {}
for _, pair in ipairs(known.pairs) do
  names[#names + 1] = pair.kept and pair.set.problem or nil
  quick_names[#quick_names + 1] = (pair.size == "small" or pair.answers) and pair.set.problem or nil
end

local function friction_of(p)
  return checks.of(known.pairs, { p = p })[1].mu
end

--- Results of one solver; their names begin with `mark`.
local function results_of(solver, mark)
  return {
    { name = mark .. "error", unit = "1", meaning = "Siconos' measure of the error, " .. solver, function(run, p)
      return measure.error(run[solver].force, run[solver].displacement, run.free, friction_of(p))
    end },
    { name = mark .. "told", unit = "1", meaning = "the same as 'stiction solve' tells it, " .. solver,
      function(run) return run[solver].cone_error end },
    { name = mark .. "iterations", unit = "1", meaning = "iterations or sweeps, " .. solver,
      function(run) return run[solver].iterations end },
    { name = mark .. "work", unit = "1", meaning = "work in products W p, " .. solver, function(run) return run[solver].work end },
    { name = mark .. "seconds", unit = "s", meaning = "processor time, " .. solver,
      function(run) return run[solver].seconds end },
  }
end

local results = results_of(default, "default_")
for _, solver in ipairs { "uzawa", "gauss_seidel" } do
  table.move(results_of(solver, solver .. "_"), 1, 5, #results + 1, results)
end
table.move({
  { name = "slip", unit = "1", meaning = "|u| / |q|", function(run) return measure.slip(run[default].displacement, run.free) end },
  { name = "energy", unit = "1", meaning = "r . W r / |q|^2",
    function(run) return measure.energy(run[default].force, run[default].displacement, run.free) end },
}, 1, 2, #results + 1, results)

return stiction.study {
  title = "Friction problems alone",
  question = "Does the default solver answer what Siconos answers, as it answers, at no more work than before?",
  chosen = { folder = { "problems", "beside the study; larger ones are not part of it" },
    tolerance = { 5e-10, "of the largest force; below 1e-8 of |q| on all of them" } },
  sweep = { problem = names },
  quick = { sweep = { problem = quick_names } },
  case_id = function(p) return p.problem end,
  problem = function(p) return { file = p.folder .. "/" .. p.problem .. ".h5", tolerance = p.tolerance } end,
  results = results,
  check = function(cases, check)
    for _, case in ipairs(cases) do
      local pair = checks.of(known.pairs, case)[1]
      check.within(case.id .. ": error", case.results.default_error, 0, accuracy)
      check.equal(case.id .. ": error as told", case.results.default_told, case.results.default_error, 1e-12)
      checks.counts(known, case, { iterations = case.results.default_iterations, work = case.results.default_work }, check)
      if not pair.answers then
        checks.results(known, case, check)
      end
    end
  end,
}
