-- Claims of workers on other machines, whose processes cannot be seen and whose clocks may tell anything.
local test, equal, fails = ...
local claims = require "stiction.claims"
local engine = require "stiction.engine"
local hold = require "stiction.hold"
local standing = require "stiction.standing"

local folder = ("/tmp/stiction_claims.%s"):format((engine.read_file "/proc/self/stat"):match "^%d+")
local elsewhere = "worker+elsewhere+00000000+17+99"

--- f() in a folder where a worker of another machine has case "a" and has told of it.
local function with_other(f)
  local patience, between = claims.patience, claims.between_beats
  claims.patience, claims.between_beats = 0.4, 0.1
  engine.make_folder(folder .. "/.claims")
  local own = folder .. "/.claims/" .. elsewhere
  local heart = engine.heart(own, elsewhere, 0.05)
  engine.tell_heart(heart, '{"done": 3, "seconds": 60, "cases": [{"case": "a", "seconds": 5, "time": 1, "end_time": 2}]}')
  engine.link(own, folder .. "/.claims/a")
  engine.await({}, 0.2)
  local held, value = engine.call(f, heart, own)
  engine.stop_heart(heart)
  engine.remove(folder)
  claims.patience, claims.between_beats = patience, between
  if not held then
    error(value, 0)
  end
end

--- The office's answer to `take` after so many seconds of trying.
local function try(office, name, seconds)
  local over = engine.clock() + seconds
  while engine.clock() < over do
    if office:take(name) then
      return true
    end
    engine.await({}, 0.02)
  end
  return false
end

test("a claim holds as long as its worker elsewhere gives signs of life, and is taken over afterwards", function()
  with_other(function(heart)
    local office = claims.open(folder, "worker")
    equal(try(office, "a", 1), false)
    engine.stop_heart(heart)
    equal(office:take("a"), nil) -- not at once: only time can tell
    equal(try(office, "a", 5), true)
    equal(office:inherits("a"), true)
    equal(office:inherits("a"), false)
    equal(claims.may_write(folder, "a", elsewhere), false)
    office:close(true)
    equal(#engine.list(folder .. "/.claims", false), 0)
  end)
end)

test("clocks that differ decide nothing, neither for the living nor for the dead", function()
  for _, day in ipairs { "2001-01-01", "2101-01-01" } do
    with_other(function(heart, own)
      local function set_clock()
        require("stiction.jobs").program { "touch", "-d", day, own }
      end
      set_clock()
      equal(standing.read(folder).workers[1].life, "lives")
      engine.stop_heart(heart)
      set_clock()
      equal(standing.read(folder).workers[1].life, day < "2026" and "dead" or "silent")
      local office = claims.open(folder, "worker")
      equal(office:take("a"), nil)
      equal(try(office, "a", 5), true)
      office:close(true)
    end)
  end
end)

test("status tells what a worker elsewhere does, as old as that is", function()
  with_other(function()
    local known = standing.read(folder)
    local entry = known.cases.a
    equal(entry.life, "lives")
    equal(entry.worker.words, "process 17 on elsewhere")
    equal(entry.own.seconds >= 5, true)
    equal(standing.words(entry):match("^it runs: process 17 on elsewhere, for .* s, t 1 of 2 s$") ~= nil, true)
  end)
end)

test("a worker's file that is damaged is nobody's word", function()
  with_other(function(heart, own)
    engine.stop_heart(heart)
    engine.remove(folder .. "/.claims/a")
    for _, text in ipairs { "", "x", elsewhere .. "\n1\n[1, 2", elsewhere .. '\n1\n{"cases": 7, "done": "x", "seconds": []}' } do
      engine.write_file(own, text)
      local worker = standing.read(folder).workers[1]
      equal(#worker.told.cases, 0)
      equal(worker.told.done, 0)
    end
  end)
end)

test("who shares the folder with nobody is kept out by a worker elsewhere that lives, and waits for one that does not", function()
  local study = { source = { file = folder .. "/study.lua", folder = folder } }
  with_other(function(heart)
    fails("is in use by process 17 on elsewhere; wait until that ends", hold.folder, folder, study, "clean", function() end)
    engine.stop_heart(heart)
    local entered = false
    hold.folder(folder, study, "clean", function() entered = true end)
    equal(entered, true)
  end)
  with_other(function(heart, own)
    engine.rename(own, folder .. "/.claims/=alone")
    engine.link(folder .. "/.claims/=alone", own)
    fails("is in use by process 17 on elsewhere", hold.shared, folder, study, "run", function() end)
    engine.stop_heart(heart)
  end)
end)
