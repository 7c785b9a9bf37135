-- stiction peers: missing peers, answers that differ, and the counts that its studies hold.
local test, equal = ...
local engine = require "stiction.engine"
local loader = require "stiction.loader"
local peers = require "stiction.peers"
local report = require "stiction.report"
local side = require "stiction.peers.side"

--- Exit code, what was printed, and peers.json, where these stand in for the sides.
local function run(sides, options)
  local kept, line, shown, lines = {}, report.line, report.table, {}
  for name, f in pairs(sides) do
    kept[name], side[name] = side[name], f
  end
  report.line = function(format, ...)
    lines[#lines + 1] = (format or ""):format(...)
  end
  report.table = function() end
  options.out, options.quick = "peers_out", true
  local held, code = pcall(peers, options)
  report.line, report.table = line, shown
  for name, f in pairs(kept) do
    side[name] = f
  end
  local found = engine.decode_json(engine.read_file("peers_out/peers.json") or "")
  engine.remove("peers_out")
  assert(held, tostring(code))
  return code, table.concat(lines, "\n"), found
end

local function none() return false end
local function all() return true end

--- The stored results times a factor, as if they came from a run.
local function scaled(factor)
  return function(pair)
    local own = { seconds = 2, memory = 10, unknowns = 7, iterations = 3, results = {} }
    for name, value in pairs(pair.results) do
      own.results[name] = factor * value
    end
    return own
  end
end

test("a missing peer is named with its package, and its stored results stand for it without its time", function()
  local code, text, found = run({ is_there = none, ours = scaled(1 + 1e-4) }, { cases = { "block3d" } })
  equal(code, 0)
  assert(text:find("GetFEM is missing: apt-get install python3-getfem", 1, true), text)
  assert(text:find("CalculiX is missing: apt-get install calculix-ccx", 1, true), text)
  equal(found[1]["peer's"].stored, true)
  equal(found[1].ratio, nil)
  equal(found[1].agrees, true)
end)

test("a peer that is there is run in turns, its time over ours", function()
  local turns = {}
  local function noting(name, seconds, f)
    return function(pair)
      turns[#turns + 1] = name
      local own = f(pair)
      own.seconds = seconds[#turns]
      return own
    end
  end
  local ours, theirs = scaled(1), scaled(1)
  local code, _, found = run({ is_there = all, ours = noting("o", { 1, 0, 3, 0, 2, 0 }, ours),
    theirs = noting("t", { 0, 10, 0, 30, 0, 20 }, theirs) }, { cases = { "slide2d" }, turns = 3 })
  equal(code, 0)
  equal(table.concat(turns), "ototot")
  equal(found[1].ratio, 10)
  equal(found[1]["peer's"].stored, nil)
end)

test("results that differ by more than is allowed end with 1", function()
  local code, text, found = run({ is_there = all, ours = scaled(1.01), theirs = scaled(1) }, { cases = { "slide2d" } })
  equal(code, 1)
  equal(found[1].ratio, nil)
  assert(text:find("differ by more than is allowed", 1, true), text)
  equal(found[1].agrees, false)
  assert(math.abs(found[1].differences.drag - 0.01) < 1e-9)
end)

test("a run of ours without an answer ends with 1, a peer's is replaced by what is stored", function()
  local function dead() return { failed = "exit code 3: broken" } end
  local code, text = run({ is_there = none, ours = dead }, { cases = { "slide2d" } })
  equal(code, 1)
  assert(text:find("no answer: exit code 3: broken", 1, true), text)
  local second, words, found = run({ is_there = all, ours = scaled(1), theirs = dead }, { cases = { "slide2d" } })
  equal(second, 0)
  assert(words:find("GetFEM: exit code 3: broken; its stored results", 1, true), words)
  equal(found[1]["peer's"].stored, true)
end)

test("an error above the bound of a friction problem is none that agrees", function()
  local function off(pair)
    local own = scaled(1)(pair)
    own.results.error = 2e-8
    return own
  end
  equal(run({ is_there = none, ours = off }, { cases = { "friction_problems" } }), 1)
end)

test("counts may grow by a tenth and no more, and only those of the case's own parameters", function()
  local checks = loader.load(loader.own_study "peers/common/checks.lua")
  local known = { counts = { { set = { cells = 8 }, counts = { solves = 20 } }, { set = { cells = 9 }, counts = { solves = 1 } } } }
  local function held(solves)
    local found = {}
    local recorder = { within = function(_, value, low, high) found[#found + 1] = low <= value and value <= high end }
    checks.counts(known, { id = "a", p = { cells = 8 } }, { solves = solves }, recorder)
    equal(#found, 1)
    return found[1]
  end
  equal(held(22), true)
  equal(held(23), false)
end)
