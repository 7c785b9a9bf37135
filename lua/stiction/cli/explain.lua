-- stiction explain: what a study asks, assumes and runs, without running it.
local engine = require "stiction.engine"
local ordered = require "stiction.ordered"
local report = require "stiction.report"
local study_module = require "stiction.study"
local sweep = require "stiction.sweep"
local units = require "stiction.units"

local function show_parameters(title, section, p)
  local rows = {}
  for _, name in ipairs(ordered.keys(section)) do
    rows[#rows + 1] = { "  " .. name, report.value(p[name]), section[name].note or "" }
  end
  if #rows > 0 then
    report.line("\n%s", title)
    report.table(rows)
  end
end

local function show_cases(cases, names)
  report.line("\nCases (%d)", #cases)
  for _, case in ipairs(cases) do
    local words = {}
    for i, name in ipairs(names) do
      words[i] = ("%s = %s"):format(name, report.value(case.p[name]))
    end
    report.line("  %s  %s", case.id, table.concat(words, ", "))
  end
end

local function show_results(results)
  if #results > 0 then
    report.line("\nResults")
  end
  for _, entry in ipairs(results) do
    report.line("  %s [%s]  %s", entry.name, entry.unit, entry.meaning)
  end
end

local show_value

local function show_table(name, value, indent)
  local meta = getmetatable(value) == "part" and engine.part(value) or ""
  report.line("%s%s%s", indent, name, meta ~= "" and " = " .. meta or "")
  for _, key in ipairs(ordered.keys(value)) do
    show_value(type(key) == "number" and ("[%d]"):format(key) or key, value[key], indent .. "  ")
  end
end

function show_value(name, value, indent)
  if type(value) == "table" and not units.is_quantity(value) then
    show_table(name, value, indent)
  else
    report.line("%s%s = %s", indent, name, report.value(value))
  end
end

return function(options)
  local study = study_module.load(options.study, options.trust)
  local cases, names = sweep.cases(study, options)
  local case = options.case and sweep.find(cases, options.case) or cases[1]
  report.line("%s", study.title)
  if study.question ~= "" then
    report.line("%s", report.wrapped(study.question, ""))
  end
  show_parameters("Given", study.given, case.p)
  show_parameters("Chosen", study.chosen, case.p)
  show_cases(cases, names)
  show_results(study.results)
  local scene = study.scene(case.p)
  engine.validate(scene)
  report.line("\nScene of case %s", case.id)
  show_table("scene", scene, "  ")
  return 0
end
