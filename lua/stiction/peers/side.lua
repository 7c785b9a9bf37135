-- One side of a pair: this program on the study's case, the peer by its script, or what the peer once gave.
local engine = require "stiction.engine"
local jobs = require "stiction.jobs"
local output = require "stiction.output"
local ordered = require "stiction.ordered"

local side = {}

local one_thread = { "OMP_NUM_THREADS=1", "OPENBLAS_NUM_THREADS=1" }
local mebibyte = 1048576

--- Whether all that a peer needs is there.
function side.is_there(program)
  return jobs.program { "sh", "-c", ("{ %s; } >/dev/null 2>&1"):format(program.needs) } == 0
end

--- The folder of a pair's own run.
local function place(pair, folder)
  return folder .. "/" .. pair.name:gsub("[^%w.]+", "_")
end

local function result_in(folder)
  for _, file in ipairs(engine.list(folder, true)) do
    if file:find("/manifest%.json$") then
      return (output.read_result_in(file:match("^(.*)/")))
    end
  end
end

--- Results in the units of the pair's quantities.
local function in_units(pair, results)
  local own = {}
  for _, quantity in ipairs(pair.known.quantities) do
    local value = results[quantity.own or quantity.name]
    own[quantity.name] = value and value / quantity.unit
  end
  return own
end

--- What a finished case gave; time and memory of the whole command, or of the solver alone where the peer tells no more.
local function read_ours(pair, result, seconds, memory)
  local solver = pair.known.solver_seconds
  return { seconds = solver and result.results[solver] or seconds, memory = not solver and memory / mebibyte or nil,
    unknowns = result.counters.unknowns, results = in_units(pair, result.results),
    iterations = solver and result.results[pair.known.solver_iterations] or result.iterations }
end

--- Runs the study's case as a user would: {seconds =, memory = MiB, unknowns =, iterations =, results =} or {failed = why}.
function side.ours(pair, folder)
  local out = place(pair, folder)
  local words = { engine.program(), "run", pair.folder, "--out", out, "--no-figures", "--force", "--jobs", "1",
    "--threads", "1" }
  for _, name in ipairs(ordered.keys(pair.set)) do
    words[#words + 1], words[#words + 2] = "--set", ("%s=%s"):format(name, pair.set[name])
  end
  engine.remove(out)
  local code, printed, seconds, memory = jobs.program(words, one_thread)
  local result = result_in(out)
  if type(result) ~= "table" or result.verdict ~= "finished" then
    return { failed = ("exit code %d: %s"):format(code, printed:gsub("%s+$", ""):match("[^\n]*$")) }
  end
  return read_ours(pair, result, seconds, memory)
end

--- Runs the peer's script: the same, or {failed = why}.
function side.theirs(pair)
  local words = { "/usr/bin/python3", pair.program.script }
  for _, word in ipairs(pair.words) do
    words[#words + 1] = tostring(word)
  end
  words = { "sh", "-c", 'cd "$0" && exec "$@"', pair.folder, table.unpack(words) }
  local code, printed, seconds, memory = jobs.program(words, one_thread)
  local found = engine.decode_json(printed:match("RESULT ([^\n]*)") or "")
  if type(found) ~= "table" then
    return { failed = ("exit code %d: %s"):format(code, printed:gsub("%s+$", ""):match("[^\n]*$")) }
  end
  local results = {}
  for _, quantity in ipairs(pair.known.quantities) do
    results[quantity.name] = found[quantity.name]
  end
  return { seconds = found.seconds or seconds, memory = not found.seconds and memory / mebibyte or nil, unknowns = found.unknowns,
    iterations = found.iterations, results = results, note = found.solver }
end

--- What the peer gave when the pair was written down, elsewhere.
function side.stored(pair)
  return { seconds = pair.seconds, memory = pair.memory, unknowns = pair.unknowns, iterations = pair.iterations,
    results = pair.results, note = pair.note, stored = true }
end

local function median(values)
  table.sort(values)
  return values[(#values + 1) // 2]
end

--- The last of some runs of a side, with the median of their times; the first that failed, if one did.
function side.median(runs)
  local times = {}
  for i, run in ipairs(runs) do
    if run.failed then
      return run
    end
    times[i] = run.seconds
  end
  runs[#runs].seconds = median(times)
  return runs[#runs]
end

return side
