-- Derivatives of results with respect to parameters: of each that a study names a run beside the case's own, in which it is a little
-- smaller and whose steps are corrected with the case's own factor.
local engine = require "stiction.engine"
local fault = require "stiction.fault"
local units = require "stiction.units"

local derivatives = {}

local relative = -1e-5 -- of the parameter: towards 0, where what has an upper bound still may be

--- The values p with one of them a little different, and by how much, SI; nil where it is 0, from which no such step leads away.
function derivatives.shifted(p, name)
  local value = p[name]
  local si = units.si(value)
  if type(si) ~= "number" then
    fault.input("study.derivatives: '%s' is %s; only of a number there are derivatives", name, tostring(value))
  elseif si == 0 then
    return nil
  end
  local other = {}
  for key, own in next, p do
    other[key] = own
  end
  other[name] = value * (1 + relative)
  return setmetatable(other, getmetatable(p)), units.si(other[name]) - si
end

local made = setmetatable({}, { __mode = "k" }) -- by the scene of a case, as long as that is kept

--- The scenes to run beside that of a case: list of {name =, scene =}; empty where the study names no parameters.
function derivatives.of(study, case)
  if #study.derivatives == 0 then
    return {}
  end
  local scene = study:scene_of(case)
  if not made[scene] then
    local list = {}
    for _, name in ipairs(study.derivatives) do
      local p = derivatives.shifted(case.p, name)
      list[#list + 1] = p and { name = name, scene = study:scene_of { id = case.id, p = p } }
    end
    made[scene] = list
  end
  return made[scene]
end

--- Text that changes when one of those scenes does.
function derivatives.text(study, case)
  local texts = {}
  for i, one in ipairs(derivatives.of(study, case)) do
    texts[i] = one.name .. engine.scene_text(one.scene)
  end
  return table.concat(texts)
end

--- Notes in the result of a case how its derivatives were made, of what the engine tells, and remarks on those that are not there.
function derivatives.note(study, case, result)
  result.remarks = #study.derivatives > 0 and (result.remarks or {}) or result.remarks
  for _, name in ipairs(study.derivatives) do
    if not derivatives.shifted(case.p, name) then
      table.insert(result.remarks, ("no derivatives with respect to %s, which is 0: no relative step leads away"):format(name))
    end
  end
  for _, own in ipairs(result.beside or {}) do
    own.step = select(2, derivatives.shifted(case.p, own.name))
    if own.rough > 0 then
      table.insert(result.remarks, ("derivatives with respect to %s are rough in %d of %d steps, which the case leaves out of balance by "
        .. "more than 1e-9 of the largest force"):format(own.name, own.rough, own.steps))
    end
    if own.ended ~= "" then
      table.insert(result.remarks, ("no derivatives with respect to %s after %d steps: %s"):format(own.name, own.steps, own.ended))
    end
  end
end

--- Of each result its derivatives by parameter, of those that can be had: {parameter = {result = number}}.
function derivatives.of_results(study, run, beside)
  local all = {}
  for _, own in ipairs(beside or {}) do
    all[own.name] = {}
    for _, entry in ipairs(study.results) do
      local held, value = engine.call(run.derivative, run, own.name, function(other) return entry.compute(other, other.p) end)
      if held then
        all[own.name][entry.name] = value
      elseif value.kind == "stopped" then
        error(value, 0)
      end
    end
  end
  return all
end

return derivatives
