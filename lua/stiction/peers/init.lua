-- stiction peers: the pairs of studies/peers, each side in a process of its own and in turns, results compared, costs listed.
local engine = require "stiction.engine"
local fault = require "stiction.fault"
local hold = require "stiction.hold"
local loader = require "stiction.loader"
local ordered = require "stiction.ordered"
local record = require "stiction.peers.record"
local report = require "stiction.report"
local side = require "stiction.peers.side"

local cases = { "block3d", "slide2d", "friction_problems" }
local sizes = { "small", "medium", "large", "largest" }

local function index(list, word)
  for i, entry in ipairs(list) do
    if entry == word then
      return i
    end
  end
end

local function check_word(what, word, known)
  return index(known, word) or fault.input("peers: there is no %s '%s'%s; there are %s", what, word, fault.meant(word, known),
    table.concat(known, ", "))
end

--- What a case's folder says of its peers; the file stands with the program and is trusted with nothing all the same.
local function known_of(case)
  return (loader.load(loader.own_study("peers/" .. case) .. "/peers.lua"))
end

--- "cells=8 mu=0.5", the case's parameters in words, sorted by name.
local function words_of(set)
  local words = {}
  for i, name in ipairs(ordered.keys(set)) do
    words[i] = ("%s=%s"):format(name, tostring(set[name]))
  end
  return table.concat(words, " ")
end

--- The pair of a problem whose file lies in that folder.
local function elsewhere(pair, folder)
  pair.set.folder = engine.absolute(folder)
  pair.words = { ("%s/%s.h5"):format(pair.set.folder, pair.set.problem) }
  return pair
end

--- The pairs that were asked for: those of the file, with the case's name, the place of its study and their name.
local function chosen(options)
  local most = check_word("size", options.quick and "small" or options.size or "medium", sizes)
  local names, list = options.cases or cases, {}
  for _, case in ipairs(names) do
    check_word("case", case, cases)
  end
  for _, case in ipairs(names) do
    local known = known_of(case)
    for _, pair in ipairs(known.pairs) do
      if index(sizes, pair.size) <= most and (pair.kept ~= false or options.problems) then
        pair.case, pair.folder, pair.known = case, loader.own_study("peers/" .. case), known
        pair.name = case .. " " .. words_of(pair.set)
        list[#list + 1] = pair.set.problem and options.problems and elsewhere(pair, options.problems) or pair
      end
    end
  end
  return list
end

--- |ours - theirs| over theirs, or over the quantity's scale; of a quantity with a bound, ours.
local function difference(quantity, ours, theirs)
  return quantity.most and ours or theirs and math.abs(ours - theirs) / (quantity.scale or math.abs(theirs))
end

--- What the difference may be; nil where there are several answers.
local function allowed(pair, quantity)
  return quantity.most or pair.answers ~= "several" and pair.allowed or nil
end

--- Fills in what the two sides differ by, what is allowed, and whether they agree.
local function compare(row)
  row.differences, row.allowed, row.agrees = {}, {}, not row.ours.failed
  for _, quantity in ipairs(row.pair.known.quantities) do
    local name = quantity.name
    local ours = (row.ours.results or {})[name]
    row.differences[name] = ours and difference(quantity, ours, row.theirs.results[name])
    row.allowed[name] = allowed(row.pair, quantity)
    row.agrees = row.agrees and (not row.allowed[name] or (row.differences[name] or math.huge) <= row.allowed[name])
  end
  if row.agrees and not row.theirs.stored then
    row.ratio = row.theirs.seconds / row.ours.seconds
  end
end

local function run_pair(pair, folder, options, presence)
  local absent = options.stored and "not asked for" or presence(pair.program)
  report.line("%s, %s%s", pair.name, pair.peer, absent and ": its stored results" or "")
  local ours, theirs = {}, {}
  for turn = 1, options.turns or 1 do
    ours[turn] = side.ours(pair, folder)
    theirs[turn] = not absent and side.theirs(pair) or nil
  end
  local row = { pair = pair, ours = side.median(ours), theirs = absent and side.stored(pair) or side.median(theirs) }
  if row.theirs.failed then
    report.line("  %s: %s; its stored results in place of its own", pair.peer, row.theirs.failed)
    row.theirs = side.stored(pair)
  end
  compare(row)
  return row
end

--- presence(program) -> nil or what is missing, told once.
local function asker()
  local answers = {}
  return function(program)
    local key = program.peer
    if answers[key] == nil then
      answers[key] = not side.is_there(program) and program.package
      if answers[key] then
        report.line("%s is missing: apt-get install %s", key, program.package)
      end
    end
    return answers[key] or nil
  end
end

local function run(options, folder)
  local presence, rows, good = asker(), {}, true
  for i, pair in ipairs(chosen(options)) do
    rows[i] = run_pair(pair, folder, options, presence)
    good = good and rows[i].agrees
    record.write(folder, rows)
  end
  record.show(rows)
  report.line("output: %s", folder)
  return good and 0 or 1
end

return function(options)
  chosen(options) -- words on the command line are judged before anything is made
  local folder = options.out or "out/peers"
  local owner = { source = { file = engine.absolute(loader.own_study("peers")) } }
  return hold.folder(folder, owner, "peers", run, options, folder)
end
