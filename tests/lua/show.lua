-- What show and compare make of outputs: filters, orders, columns, matches, differences; and csv read back.
local test, equal, fails = ...
local comparison = require "stiction.comparison"
local csv = require "stiction.csv"
local report = require "stiction.report"
local selection = require "stiction.selection"

local kinds = { { "case", "word" }, { "verdict", "word" }, { "mu", "parameter" }, { "law", "parameter" },
  { "steps", "parameter" }, { "force", "result" }, { "force_error", "error" } }

--- An output as outcomes.read gives it; rows: list of values in the order of `kinds`, false for none.
local function outcome_of(rows)
  local outcome = { folder = "out/x", columns = {}, by_name = {}, by_key = {}, cases = {} }
  for i, entry in ipairs(kinds) do
    local column = { name = entry[1], of = entry[1], kind = entry[2], unit = entry[2] == "result" and "mN" or "",
      numeric = entry[1] ~= "law" and entry[2] ~= "word" }
    outcome.columns[i], outcome.by_name[entry[1]], outcome.by_key[entry[2] .. " " .. entry[1]] = column, column, column
  end
  for i, row in ipairs(rows) do
    local values = {}
    for k, entry in ipairs(kinds) do
      values[entry[1]] = row[k] ~= false and row[k] or nil
    end
    outcome.cases[i] = { name = row[1], folder = "nowhere", values = values }
  end
  return outcome
end

local three = outcome_of {
  { "a", "finished", 0, "rcc", 10, 2e-3, 1e-5 }, { "b", "finished", 0.5, "rcc", 10, 1e-3, false },
  { "c", "failed", 0.2, "czm", 10, false, false },
}

local function names(list)
  local words = {}
  for i, entry in ipairs(list) do
    words[i] = entry.name
  end
  return table.concat(words, " ")
end

test("a filter sees parameters, results and the verdict; what a case does not have is no number", function()
  local function kept(text)
    return names(selection.filter(three, text))
  end
  equal(kept(nil), "a b c")
  equal(kept("mu > 0.1"), "b c")
  equal(kept("force < 1"), "a b")
  equal(kept("not (force < 1) and math.abs(mu - 0.2) < 1e-9"), "c")
  equal(kept("verdict ~= 'finished' or law == \"czm, mu\""), "c")
  equal(kept("mu == 0 and 1e3 > 2 --"), "a")
end)

test("a filter that cannot be is one message", function()
  fails("no parameter or result 'forc'; did you mean 'force'?; there are: case, verdict, mu", selection.filter, three,
    "mu > 9 and forc > 1")
  fails("near '='", selection.filter, three, "mu = 0.3")
  fails("not true or false", selection.filter, three, "mu")
  fails("attempt to compare", selection.filter, three, "mu < law")
  fails("no parameter or result 'string'", selection.filter, three, "string.rep('x', 9) == law")
  fails("--where", selection.filter, three, "true) or (function() while true do end end)(")
end)

test("the order: by number or word, from either end, those without a value last", function()
  equal(names(selection.sort(three, three.cases, "mu")), "a c b")
  equal(names(selection.sort(three, three.cases, "-mu")), "b c a")
  equal(names(selection.sort(three, three.cases, "force")), "b a c")
  equal(names(selection.sort(three, three.cases, "-force")), "a b c")
  equal(names(selection.sort(three, three.cases, "law")), "c a b")
  fails("no parameter or result 'lwa'; did you mean 'law'?", selection.sort, three, three.cases, "lwa")
end)

test("columns: those that tell cases apart and results, or those named", function()
  equal(names(selection.columns(three)), "case verdict mu law force force_error")
  equal(names(selection.columns(three, "force, steps")), "force steps")
  fails("did you mean 'steps'?", selection.columns, three, "step")
  fails("--columns names nothing", selection.columns, three, ",")
end)

test("values are shown in their units", function()
  equal(report.head { name = "force", unit = "mN" }, "force/(mN)")
  equal(report.in_unit({ unit = "mN" }, 0.0123456789), "12.346")
  equal(report.in_unit({ unit = "mN" }, nil), "-")
  equal(report.in_unit({ unit = "" }, "rcc"), "rcc")
end)

test("csv reads back what it wrote, and nothing that is cut off or ragged", function()
  local words = { "a,b", 'say "yes"', "two\nlines", "", "0.1" }
  local line = {}
  for i, word in ipairs(words) do
    line[i] = csv.word(word)
  end
  local text = "1,2,3,4,5\r\n" .. table.concat(line, ",") .. "\n"
  equal(table.concat(csv.read(text)[2], ";"), table.concat(words, ";"))
  equal(tonumber(csv.word(0.1 + 0.2)), 0.1 + 0.2)
  equal(select(2, csv.read("a,b\n1,2\n3\n")), "line 3 has 1 entries, its head 2")
  equal(select(2, csv.read("a,b\n1,2\n3,4")), "line 3 is cut off")
  equal(select(2, csv.read("a,b\n1,\"2\n")), "line 2 is cut off")
  equal(select(2, csv.read("")), "line 1 is cut off")
end)

test("cases are matched by parameters before names", function()
  local other = outcome_of { { "c", "finished", 0, "rcc", 10, 2e-3, false },
    { "b", "finished", 0.5, "rcc", 8, 1e-3, false }, { "d", "finished", 9, "rcc", 10, 1, false } }
  local matched, only_a, only_b = comparison.match(three, other)
  equal(#matched, 2)
  equal(matched[1].a.name .. matched[1].b.name .. " " .. matched[1].by, "ac parameters")
  equal(matched[2].a.name .. matched[2].b.name .. " " .. matched[2].by, "bb name")
  equal(names(only_a) .. " " .. names(only_b), "c d")
  local differing = comparison.settings(three, other, matched)
  equal(#differing, 1)
  local one = differing[1]
  equal(table.concat({ one.kind, one.name, one.a, one.b }, " "), "parameter steps 10 8")
end)

test("results: the furthest first, beside what they may be off by; missing ones and verdicts differ", function()
  local other = outcome_of { { "a", "finished", 0, "rcc", 10.0, 2e-3 * (1 + 1e-9), 2e-5 },
    { "b", "finished", 0.5, "rcc", 10, 1.5e-3, false }, { "c", "finished", 0.2, "czm", 10, 1, false } }
  local matched = comparison.match(three, other)
  local list, same = comparison.results(three, other, matched, 0)
  equal(#list, 4)
  equal(same, 2)
  equal(list[1].case .. " " .. list[2].case .. " " .. list[3].case .. " " .. list[4].case, "c c b a")
  equal(math.abs(list[3].relative - 1 / 3) < 1e-12 and math.abs(list[3].absolute - 5e-4) < 1e-15, true)
  equal(list[4].bound_a, 1e-5)
  equal(list[4].bound_b, 2e-5)
  equal(#comparison.results(three, other, matched, 1e-8), 3)
  list, same = comparison.results(three, three, comparison.match(three, three), 0)
  equal(#list, 0)
  equal(same, 5)
end)
