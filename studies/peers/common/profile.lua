-- Performance profiles (Dolan and More 2002): the part of the cases that a solver has answered within a multiple of the least
-- cost of all solvers on each. Cases are saved contact problems; their results hold <solver>_relative and <solver>_<measure>,
-- unless costs come from elsewhere.
local profile = {}

--- {solvers = names, tolerance = of the largest traction, lines = of figures, cost(case, solver) = if not from results: nil
--- without an answer} -> methods add_results, solved, least, ratios, figure.
function profile.of(settings)
  local solvers, own = settings.solvers, {}

  --- Appends each solver's cost and residual to the results of a study.
  function own.add_results(results)
    for _, name in ipairs(solvers) do
      for _, row in ipairs {
        { "iterations", "iterations or sweeps" }, { "work", "work in products W p" },
        { "relative", "residual over the largest traction" },
      } do
        results[#results + 1] = { name = name .. "_" .. row[1], unit = "1", meaning = row[2] .. " of " .. name,
          function(run) return run[name][row[1]] end }
      end
    end
  end

  function own.solved(case, solver)
    return case.results[solver .. "_relative"] <= settings.tolerance
  end

  --- Nil without an answer; a problem solved by its guess costs 1.
  local function cost(case, solver, measure)
    if settings.cost then
      return settings.cost(case, solver)
    end
    return own.solved(case, solver) and math.max(1, case.results[solver .. "_" .. measure]) or nil
  end

  --- Cost of the cheapest solver on a case, nil where none has an answer.
  function own.least(case, measure)
    local best
    for _, solver in ipairs(solvers) do
      local mine = cost(case, solver, measure)
      best = mine and math.min(mine, best or mine) or best
    end
    return best
  end

  --- Cost over the least, rising, of the cases that it answers.
  function own.ratios(cases, solver, measure)
    local ratios = {}
    for _, case in ipairs(cases) do
      local mine = cost(case, solver, measure)
      ratios[#ratios + 1] = mine and mine / own.least(case, measure)
    end
    table.sort(ratios)
    return ratios
  end

  --- At ratio x[i] the part rises to y[i].
  local function steps(cases, solver, measure, last)
    local x, y = { 1 }, { 0 }
    for i, ratio in ipairs(own.ratios(cases, solver, measure)) do
      table.move({ ratio, ratio }, 1, 2, #x + 1, x)
      table.move({ y[#y], i / #cases }, 1, 2, #y + 1, y)
    end
    x[#x + 1], y[#y + 1] = last, y[#y]
    return x, y
  end

  function own.figure(cases, measure, title)
    local curves, last = {}, 10
    for _, solver in ipairs(solvers) do
      local ratios = own.ratios(cases, solver, measure)
      last = math.max(last, 1.2 * (ratios[#ratios] or 1))
    end
    for i, solver in ipairs(solvers) do
      local x, y = steps(cases, solver, measure, last)
      curves[i] = { label = solver, x = x, y = y }
    end
    return settings.lines { name = measure, title = title, curves = curves, legend = "below",
      x = { label = "cost over the least of all solvers", log = true },
      y = { label = "part of problems answered", range = { 0, 1 } } }
  end

  return own
end

return profile
