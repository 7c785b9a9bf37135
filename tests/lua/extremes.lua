-- Outcomes of the cells of a map: what is a right end, and what is a defect.
local test, equal = ...
local outcome = require "stiction.extremes.outcome"

local function letter(result)
  return outcome.of(result).letter
end

local function judged(result, want, checks)
  local row = { case = { id = "a", p = { want = want } }, outcome = outcome.of(result) }
  outcome.judge(row, checks)
  return row.outcome.letter, row.outcome.reason
end

local finished = { verdict = "finished", reason = "" }
local refused = { verdict = "bad input", reason = "is 0; it must be > 0", kind = "input" }

test("ends of a case", function()
  equal(letter(finished), "C")
  equal(letter(refused), "R")
  equal(letter { verdict = "not converged", reason = "at t = 0 s" }, "S")
  equal(letter { verdict = "crashed", reason = "by signal 11" }, "X")
  equal(letter { verdict = "failed", reason = "cannot write" }, "X")
  equal(letter { verdict = "hung", reason = "" }, "H")
end)

test("an end without a reason and a fault of the script are defects", function()
  equal(letter { verdict = "not converged", reason = "" }, "X")
  equal(letter { verdict = "bad input", reason = "attempt to index nil", kind = "script" }, "X")
end)

test("a converged cell needs checks, and all of them must hold", function()
  equal(judged(finished, "any", { count = 2, failed = {} }), "C")
  equal(judged(finished, "any", { count = 0, failed = {} }), "W")
  equal(judged(finished, "any", { count = 2, failed = { "energy is 2, within 1" } }), "W")
end)

test("an outcome that is not the wanted one", function()
  equal(judged(refused, "refused", { count = 0, failed = {} }), "R")
  equal(judged(refused, "any", { count = 0, failed = {} }), "U")
  equal(judged(refused, "converged", { count = 0, failed = {} }), "U")
  equal(judged(finished, "refused", { count = 1, failed = {} }), "U")
end)

test("counts and failures", function()
  local rows = {}
  for i, result in ipairs { finished, finished, refused, { verdict = "hung", reason = "" } } do
    rows[i] = { outcome = outcome.of(result) }
  end
  local words, failures = outcome.count(rows)
  equal(words, "2 converged, 1 refused, 1 hung")
  equal(#failures, 1)
end)
