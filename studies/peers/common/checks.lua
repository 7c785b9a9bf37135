-- What the studies of this folder hold a case to: the results of the peers, and counts in place of seconds.
local checks = {}

--- Whether a case has these parameters.
function checks.same(case, set)
  for name, value in pairs(set) do
    if rawget(case.p, name) ~= value then
      return false
    end
  end
  return true
end

--- Entries of a list whose `set` is that of the case.
function checks.of(list, case)
  local found = {}
  for _, entry in ipairs(list) do
    found[#found + 1] = checks.same(case, entry.set) and entry or nil
  end
  return found
end

--- The quantities that are the same in all programs.
function checks.compared(known)
  local found = {}
  for _, quantity in ipairs(known.quantities) do
    found[#found + 1] = not quantity.most and quantity or nil
  end
  return found
end

--- The results of each pair against the peer's stored ones: relative, or absolute where a quantity has a `scale`.
function checks.results(known, case, check)
  for _, pair in ipairs(checks.of(known.pairs, case)) do
    for _, quantity in ipairs(checks.compared(known)) do
      local name, wanted = quantity.name, pair.results[quantity.name] * quantity.unit
      check.equal(("%s: %s as in %s"):format(case.id, name, pair.peer), case.results[name], wanted,
        pair.allowed * (quantity.scale and quantity.scale * quantity.unit or wanted))
    end
  end
end

--- No count is over a tenth above what it was; `taken` holds them by name.
function checks.counts(known, case, taken, check)
  for _, stored in ipairs(checks.of(known.counts, case)) do
    for name, count in pairs(stored.counts) do
      check.within(("%s: %s"):format(case.id, name), taken[name], 0, math.floor(1.1 * count))
    end
  end
end

--- The result that a component of a probe's force has at this time.
function checks.force(probe, component, time, sign)
  return function(run) return sign * run:at(time, probe, "force_" .. component) end
end

--- The check of a study whose cases' own costs are counted.
function checks.of_cases(known)
  return function(cases, check)
    for _, case in ipairs(cases) do
      checks.results(known, case, check)
      checks.counts(known, case, case.cost, check)
    end
  end
end

return checks
