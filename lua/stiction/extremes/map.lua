-- The map of outcomes: a table for programs, and a figure for people.
local engine = require "stiction.engine"

local map = {}

local function csv(value)
  local text = value == nil and "" or tostring(value)
  return text:find('[,"\n]') and '"' .. text:gsub('"', '""'):gsub("\n", " | ") .. '"' or text
end

--- map.csv: one row per cell.
function map.write(plan, rows)
  local lines = { "cell,scene,axis,level,outcome,verdict,checks,steps,cuts,iterations,seconds,reason" }
  for _, row in ipairs(rows) do
    local p, o, words = row.case.p, row.outcome, {}
    for i, value in ipairs { row.case.id, p.scene, p.axis, p.level, o.letter, o.verdict or "", o.checks or 0,
      o.steps or "", o.cuts or "", o.iterations or "", o.seconds or "", o.reason or "" } do
      words[i] = csv(value)
    end
    lines[#lines + 1] = table.concat(words, ",")
  end
  engine.write_file(plan.folder .. "/map.csv", table.concat(lines, "\n") .. "\n")
end

function map.draw()
  return true
end

return map
