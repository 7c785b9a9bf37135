-- Tables in the report: read, printed and joined by their first column; the list of time schemes.
local test, equal, fails = ...
local check = require "stiction.check"
local stiction = require "stiction"
local tables = require "stiction.tables"

local function part(t)
  local recorder, list = check.recorder()
  recorder.table(t)
  return { checks = list }
end

test("tables of one title are joined, missing places marked", function()
  local joined = tables.join {
    part { title = "all", columns = { "scheme", "order" }, rows = { { "a", 2 }, { "b", 1 } } },
    part { title = "all", columns = { "scheme", "energy", "note" }, rows = { { "c", 0.5 }, { "a", 1, "kept" } } },
    part { title = "other", columns = { "x" }, rows = { { "1" } } },
  }
  equal(#joined, 2)
  equal(table.concat(joined[1].columns, " "), "scheme order energy note")
  local lines = {}
  for i, words in ipairs(tables.words(joined[1])) do
    lines[i] = table.concat(words, " ")
  end
  equal(table.concat(lines, "; "), "scheme order energy note; a 2 1 kept; b 1 - -; c - 0.5 -")
end)

test("quantities are SI, mistakes are told", function()
  local units = stiction.units
  local list = part { title = "t", columns = { "a", "b" }, rows = { { "x", 2*units.mm } } }
  equal(list.checks[1].table.rows[1][2], 0.002)
  fails("takes { title", part, { title = "t", rows = {} })
  fails("begins with a text", part, { title = "t", columns = { "a" }, rows = { { 1 } } })
end)

test("the list of schemes: every name makes a part, every kind of scheme with dynamics is there", function()
  local kinds = {}
  for _, name in ipairs(stiction.schemes.names()) do
    local about = stiction.schemes.about(name)
    stiction.schemes.make(name)
    equal(about.order == 1 or about.order == 2, true)
    kinds[about.kind] = true
  end
  for _, category in ipairs(require("stiction.engine").catalog()) do
    for _, kind in ipairs(category.name == "scheme" and category.kinds or {}) do
      equal(kinds[kind.name] or false, kind.name ~= "quasi_static")
    end
  end
  fails("did you mean 'massless'?", stiction.schemes.make, "masless")
end)
