-- Saved contact problems against the three solvers: each answers with a small residual or says that it did not.
--
--     x = free + W p,   pbar = p - A rtilde(x),   |pbar - Proj(pbar - rho (x_n + mu |x_t|, x_t))| <= 1e-8 of the largest
--
-- The problems stand in tests/contact/problems, where README.md tells what each is. All start from no force. Which solver is
-- how fast is told as a performance profile (Dolan and More 2002): the part of the problems that a solver has answered within
-- a multiple of the least cost of all solvers on each, cost being iterations (Newton iterations or sweeps) or work (multiply-
-- adds with W and in factorizations, over those of one product W p: a sweep is 1, a Newton iteration up to a third of the
-- number of unknowns).
--
--     ./stiction run studies/proofs/solver_agreement
local stiction = require "stiction"

local folder = "../../../tests/contact/problems/"
local solvers = { "newton", "uzawa", "gauss_seidel" }
local tolerance = 1e-8

-- What the newton solver, which runs take, must answer; then problems of W indefinite or rank deficient, and two steps at
-- which runs ended, where it need not.
local problems = {
  "plate_mu00_descent", "plate_mu00_slide", "plate_mu04_descent", "plate_mu04_slide", "plate_mu04_end",
  "plate_mu08_descent", "plate_mu08_slide", "block_3d_flat", "sphere_3d_bonded", "sphere_axisymmetric_bonded",
  "greco_mu15", "greco_quadratic", "greco_fine", "hertz_frictionless", "jkr_softening", "jkr_stiff", "bar_snaps",
  "rod_slides_mu16", "rod_jams_mu16", "cube_pushed_3d", "nearly_incompressible",
  "belt_90", "belt_180_indefinite", "plate_mu08_indefinite", "peel_cohesive_first_step",
}
local open = {
  "plate_mu08_indefinite_late", "coarse_primary_rank_deficient", "rigid_plate_rank_3",
  "rigid_plate_rank_3_late", "jkr_stiff_unanswered",
}

local slow = { greco_fine = true, jkr_stiff = true, peel_cohesive_first_step = true, jkr_stiff_unanswered = true }

local names, quick_names = {}, {}
for _, list in ipairs { problems, open } do
  for _, name in ipairs(list) do
    names[#names + 1] = name
    quick_names[#quick_names + 1] = not slow[name] and name or nil
  end
end

--- Largest difference of the displacements of two solvers' answers, over what the forces have moved.
local function disagreement(run)
  local first, worst = nil, 0
  for _, name in ipairs(solvers) do
    local answer = run[name]
    if answer.converged and first then
      local difference, moved = 0, 0
      for i, x in ipairs(answer.displacement) do
        difference = difference + (x - first.displacement[i]) ^ 2
        moved = moved + (first.displacement[i] - run.free[i]) ^ 2
      end
      worst = math.max(worst, moved > 0 and math.sqrt(difference / moved) or 0)
    end
    first = first or answer.converged and answer or nil
  end
  return worst
end

local results = {
  { name = "contacts", unit = "1", meaning = "contact points", function(run) return run.contacts end },
  { name = "components", unit = "1", meaning = "force components of a point", function(run) return run.components end },
  { name = "doubts", unit = "1", meaning = "reasons why theory promises no single answer",
    function(run) return #run.doubts end },
  { name = "disagreement", unit = "1", meaning = "largest relative difference of displacements between solvers", disagreement },
}

local profile = require "../../peers/common/profile.lua".of { solvers = solvers, tolerance = tolerance,
  lines = stiction.figure.lines }
local solved = profile.solved
profile.add_results(results)

return stiction.study {
  title = "Contact solvers on saved problems",
  question = "Does every solver answer, or say that it did not, do the answers agree, and which is how fast?",
  sweep = { problem = names },
  quick = { sweep = { problem = quick_names } },
  case_id = function(p) return p.problem end,
  problem = function(p) return { file = folder .. p.problem .. ".h5", tolerance = tolerance } end,
  results = results,
  check = function(cases, check)
    local worst, differ, single = 0, 0, 0
    for _, case in ipairs(cases) do
      for _, solver in ipairs(solvers) do
        if solved(case, solver) then
          worst = math.max(worst, case.results[solver .. "_relative"])
        end
      end
    end
    check.proof { case = "saved contact problems", quantity = "worst residual of an answer", kind = "exact", source = "(27)-(29)",
      reference = 0, scale = 1, values = { { #cases, worst } }, resolution = "problems", tolerance = tolerance,
      note = "natural-map residual over the largest traction, judged apart from the solvers" }
    local wanted, answered = 0, 0
    for _, name in ipairs(problems) do
      local case = cases:find { problem = name }
      if case then
        wanted, answered = wanted + 1, answered + (solved(case, "newton") and 1 or 0)
        check.holds("newton answers " .. name, solved(case, "newton"))
        if case.results.doubts == 0 then
          single, differ = single + 1, math.max(differ, case.results.disagreement)
        end
      end
    end
    check.proof { case = "saved contact problems", quantity = "worst disagreement of solvers", kind = "exact",
      source = "uniqueness, physics.md 3", reference = 0, scale = 1, values = { { single, differ } },
      resolution = "problems of one answer", tolerance = 1e-5, note = "displacements over what the forces have moved" }
    check.proof { case = "saved contact problems", quantity = "answered by newton", kind = "exact",
      source = "all that are known to have an answer", reference = wanted, values = { { #cases, answered } },
      resolution = "problems", tolerance = 0 }
  end,
  figures = function(cases)
    return { stiction.figure.panel { name = "profile", columns = 2, figures = {
      profile.figure(cases, "iterations", "by iterations"), profile.figure(cases, "work", "by work") } } }
  end,
}
