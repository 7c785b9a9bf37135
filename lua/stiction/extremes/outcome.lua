-- How a cell of the map ended: one letter, its word, and whether that is a failure.
local outcome = {}

-- C, R and S are right ends of a cell; the others are defects of the program.
local words = {
  C = "converged", R = "refused", S = "stopped", X = "crashed", H = "hung", N = "not a number", W = "wrong",
  U = "unexpected",
}
outcome.order = { "C", "R", "S", "X", "H", "N", "W", "U" }
local good = { C = true, R = true, S = true }
local letter_of = { finished = "C", crashed = "X", failed = "X", ["result failed"] = "X",
  hung = "H", ["bad input"] = "R" }

function outcome.word(letter)
  return words[letter]
end

--- Outcome of what a case's process told: {letter =, verdict =, reason =, results =, steps =, seconds =}.
function outcome.of(result)
  local letter = letter_of[result.verdict] or "S"
  if letter == "R" and result.kind ~= "input" then
    letter = "X" -- a fault of the script, not of the values
  elseif (letter == "R" or letter == "S") and (result.reason or "") == "" then
    letter = "X" -- an end without a word
  end
  return { letter = letter, verdict = result.verdict, reason = result.reason, results = result.results,
    remarks = result.remarks or {}, steps = result.steps, cuts = result.cuts, iterations = result.iterations,
    seconds = result.seconds }
end

--- How many entries of a case's histories are not finite.
function outcome.holes(case)
  local holes = 0
  for _, name in ipairs(case:columns()) do
    local group, column = name:match("^(.-)/(.+)$")
    for k = 1, math.maxinteger do
      local held, values = pcall(case.series, case, group, column, k)
      if not held then
        break
      end
      for _, value in ipairs(values) do
        holes = holes + ((value - value ~= 0) and 1 or 0)
      end
    end
  end
  return holes
end

--- Sets the letter from a cell's checks {count =, failed = {text}} and from the outcome it must have; "any" is to
--- converge or to stop: only values that are out of range may be refused.
function outcome.judge(row, checks)
  local own, want = row.outcome, row.case.p.want
  own.checks = checks.count
  if own.letter == "C" and checks.count == 0 then
    own.letter, own.reason = "W", "nothing checks it"
  elseif own.letter == "C" and #checks.failed > 0 then
    own.letter, own.reason = "W", table.concat(checks.failed, "; ")
  elseif good[own.letter] and words[own.letter] ~= want and (want ~= "any" or own.letter == "R") then
    own.letter, own.reason = "U", ("%s, but must be %s: %s"):format(words[own.letter],
      want == "any" and "converged or stopped" or want, own.reason or "")
  end
end

--- How many rows ended with each letter.
function outcome.letters(rows)
  local count = {}
  for _, row in ipairs(rows) do
    count[row.outcome.letter] = (count[row.outcome.letter] or 0) + 1
  end
  return count
end

--- "12 converged, 3 refused" and the rows that are failures.
function outcome.count(rows)
  local count, failures, parts = outcome.letters(rows), {}, {}
  for _, row in ipairs(rows) do
    failures[#failures + 1] = not good[row.outcome.letter] and row or nil
  end
  for _, letter in ipairs(outcome.order) do
    if count[letter] then
      parts[#parts + 1] = ("%d %s"):format(count[letter], words[letter])
    end
  end
  return table.concat(parts, ", "), failures
end

return outcome
