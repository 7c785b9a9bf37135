-- A case that is a saved contact problem, solved again in place of a scene.
local engine = require "stiction.engine"
local fault = require "stiction.fault"
local ordered = require "stiction.ordered"

local problem = {}

local kinds = { file = "string", solver = "string", tolerance = "number" }

--- What study.problem(p) asks: {file = an absolute path, solver =, tolerance =}. The file stands relative to the
--- study.
function problem.read(study, p)
  local t = study.problem(p)
  if type(t) ~= "table" then
    fault.script("study.problem must return a table: { file = ..., solver = ..., tolerance = ... }")
  end
  for _, key in ipairs(ordered.keys(t)) do
    if type(t[key]) ~= kinds[key] then
      fault.script("study.problem: %s", kinds[key] and ("%s must be a %s"):format(key, kinds[key])
        or ("unknown key '%s'%s"):format(tostring(key), fault.meant(key, ordered.keys(kinds))))
    end
  end
  local file = t.file and (t.file:sub(1, 1) == "/" and t.file or study.source.folder .. "/" .. t.file)
  if not file or engine.kind_of_path(file) ~= "file" then
    fault.input("study.problem: there is no file '%s'", tostring(file))
  end
  return { file = file, solver = t.solver or "all", tolerance = t.tolerance or 1e-8 }
end

--- Text that changes when the file does.
function problem.identity(study, p)
  return engine.hash(engine.read_file(problem.read(study, p).file) or "")
end

--- The result of a case as that of a run, and the answers: contacts, components, doubts, free, and by the solver's name
--- converged, method, iterations, work, residual, relative, cone_error (or nil), seconds, force, displacement.
function problem.solve(study, case)
  local asked, before = problem.read(study, case.p), engine.clock()
  local report = engine.solve(asked.file, asked.solver, asked.tolerance)
  local run = { id = case.id, p = case.p, contacts = report.contacts, components = report.components,
    doubts = report.doubts, free = report.free }
  local iterations = 0
  for name, answer in pairs(report.answers) do
    run[name], iterations = answer, iterations + answer.iterations
  end
  return {
    verdict = "finished", reason = "", remarks = report.doubts, steps = 0, iterations = iterations,
    factorizations = 0, cuts = 0, seconds = engine.clock() - before, phases = { contact = engine.clock() - before },
    counters = { unknowns = report.contacts * report.components, cells_evaluated = 0 },
  }, run
end

return problem
