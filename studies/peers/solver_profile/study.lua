-- Which contact solver answers how many of the problems of our own studies, and at what cost: performance profiles.
--
-- problems.lua lists them by study, case and step; collect.sh runs the studies and leaves the files in a folder:
--
--     studies/peers/solver_profile/collect.sh /tmp/problems
--     ./stiction run studies/peers/solver_profile --set folder=/tmp/problems
--
-- All start from no force. Cost: iterations or sweeps; work in products W p, so that it repeats. The quick form takes the
-- friction problems that are kept beside. siconos.lua has the seconds that Siconos' solvers took on those that they take: dry
-- ones with friction; seconds compare only if both sides ran on one machine.
local stiction = require "stiction"
local listed = require "problems"

local solvers = { "newton", "uzawa", "gauss_seidel" }
local methods = { "none", "sweeps", "newton", "proximal", "uphill", "descent", "minimisation", "damping", "gauss_seidel",
  "uzawa", "pivoting", "enumeration" }
local tolerance = 1e-8
local profiles = require "../common/profile.lua"
local profile = profiles.of { solvers = solvers, tolerance = tolerance, lines = stiction.figure.lines }
local siconos = require "siconos" -- problem -> solver -> s, of those that answered

local names = {}
for _, group in ipairs(listed) do
  for _, step in ipairs(group.steps) do
    names[#names + 1] = group.folder .. "/" .. step
  end
end

local results = {
  { name = "rows", unit = "1", meaning = "components of all contacts", function(run) return run.contacts * run.components end },
  { name = "method", unit = "1", meaning = "what in the newton solver answered: place in the list of study.lua, less 1",
    function(run)
      for i, name in ipairs(methods) do
        if name == run.newton.method then return i - 1 end
      end
      return -1
    end },
  { name = "newton_seconds", unit = "s", meaning = "processor time of the newton solver", function(run) return run.newton.seconds end },
}
profile.add_results(results)

local function least_of(seconds)
  local least
  for _, s in pairs(seconds) do
    least = math.min(s, least or s)
  end
  return least
end

local beside = profiles.of { solvers = { "Stiction, default", "Siconos, the best for each", "Siconos, Gauss-Seidel" },
  lines = stiction.figure.lines, cost = function(case, solver)
    local theirs = siconos[case.p.problem]
    if solver == "Stiction, default" then
      return profile.solved(case, "newton") and case.results.newton_seconds or nil
    elseif solver == "Siconos, Gauss-Seidel" then
      return theirs.NSGS
    end
    return least_of(theirs)
  end }

local function those_of_siconos(cases)
  local chosen = {}
  for _, case in ipairs(cases) do
    chosen[#chosen + 1] = siconos[case.p.problem] and case or nil
  end
  return chosen
end

--- "sweeps 3 newton 1": what in the default solver answered these.
local function words_of_methods(cases)
  local counts, words = {}, {}
  for _, case in ipairs(cases) do
    counts[case.results.method + 1] = (counts[case.results.method + 1] or 0) + 1
  end
  for i, name in ipairs(methods) do
    words[#words + 1] = counts[i] and ("%s %d"):format(name, counts[i])
  end
  return table.concat(words, ", ")
end

local function row_of(key, cases)
  local row, rows = { key, #cases }, 0
  for _, case in ipairs(cases) do
    rows = math.max(rows, case.results.rows)
  end
  row[3] = rows
  for _, solver in ipairs(solvers) do
    row[#row + 1] = #profile.ratios(cases, solver, "work")
  end
  row[#row + 1] = words_of_methods(cases)
  return row
end

local function groups_of(cases)
  local order, groups = {}, {}
  for _, case in ipairs(cases) do
    local key = case.p.problem:match("^[^/]+")
    if not groups[key] then
      order[#order + 1], groups[key] = key, {}
    end
    table.insert(groups[key], case)
  end
  return order, groups
end

return stiction.study {
  title = "Contact solvers on the problems of our own studies",
  question = "How many of the contact problems of studies does each solver answer, and within how much of the least cost?",
  chosen = { folder = { "problems", "where collect.sh left them" } },
  sweep = { problem = names },
  quick = { sweep = { problem = { "p01_flat_nc49", "p02_wavy_nc100", "p09_rigidbox_nc144" } },
    set = { folder = "../friction_problems/problems" } },
  case_id = function(p) return (p.problem:gsub("/problems/", "_"):gsub("/", "_")) end,
  problem = function(p) return { file = p.folder .. "/" .. p.problem .. ".h5", tolerance = tolerance } end,
  results = results,
  check = function(cases, check)
    local rows, order, groups = {}, groups_of(cases)
    for i, key in ipairs(order) do
      rows[i] = row_of(key, groups[key])
    end
    rows[#rows + 1] = row_of("all", cases)
    check.table { title = "Contact problems answered", columns = { "study", "problems", "rows at most", "newton", "uzawa",
      "gauss_seidel", "newton's answers by" }, rows = rows }
    local answered = #profile.ratios(cases, "newton", "work")
    check.equal("answered by the default solver", answered, #cases, 0)
    local ratios = profile.ratios(cases, "newton", "work")
    check.within("median of the default's work over the least", ratios[(#ratios + 1) // 2] or math.huge, 1, 4)
  end,
  figures = function(cases)
    local drawn = { stiction.figure.panel { name = "profile", columns = 2, figures = {
      profile.figure(cases, "iterations", "by iterations"), profile.figure(cases, "work", "by work") } } }
    local shared = those_of_siconos(cases)
    drawn[2] = #shared > 0 and beside.figure(shared, "siconos", ("by processor time, %d dry problems"):format(#shared)) or nil
    return drawn
  end,
}
