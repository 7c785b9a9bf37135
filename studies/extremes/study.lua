-- Where it stops: small scenes driven to extremes, one value at a time. Every cell must end converged and checked,
-- refused with a clear reason, or stopped with a verdict.
--
--     scene        law punch slide slide_mortar bar stack stack_mortar stack_tied drop crowd fold
--                  tie tube cup top dent dent_space (scenes.lua, dent.lua)
--     x axis       C w b beta mu nu contrast density dt speed overlap shape place units ...  (axes.lua)
--     -> cell      "punch-nu-0.4999": its checks are in checks.lua
--
--     ./stiction extremes --quick
local stiction = require "stiction"
local axes = require "axes"
local checks = require "checks"
local measure = require "measure"
local scenes = require "scenes"

local cells, by_id = axes.all()

local function values(p)
  return scenes.values_of(p.scene, by_id[("%s-%s-%s"):format(p.scene, p.axis, p.level)].changes)
end

local function sweep(slow)
  local list = {}
  for _, cell in ipairs(cells) do
    if slow or not cell.slow then
      list[#list + 1] = { scene = cell.scene, axis = cell.axis, meaning = cell.meaning, level = cell.level,
        want = cell.want or "any" }
    end
  end
  return list
end

local results = {}
for i, name in ipairs(measure.names) do
  results[i] = { name = name, unit = "1", meaning = name .. " of largest magnitude over E and size",
    function(run, p) return measure.results[name](run, values(p)) end }
end

return stiction.study {
  title = "Where it stops",
  question = "Does every extreme end converged and checked, refused with a reason, or stopped with a verdict?",
  sweep = sweep(true),
  quick = { sweep = sweep(false) },
  case_id = function(p) return ("%s-%s-%s"):format(p.scene, p.axis, p.level) end,
  scene = function(p) return scenes.make(p.scene, values(p)) end,
  results = results,
  check = function(cases, check)
    for _, case in ipairs(cases) do
      local base = cases:find { scene = case.p.scene, axis = "base" }
      local ran, why = pcall(checks.run, case, values(case.p), by_id[case.id], base, function(what, value, tolerance)
        check.equal(("%s: %s"):format(case.id, what), value, 0, tolerance)
      end)
      if not ran then
        check.holds(("%s: its checks ran, but %s"):format(case.id, tostring(why)), false)
      end
    end
  end,
}
