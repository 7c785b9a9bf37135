-- stiction explain: what a study asks, assumes and models, what it will cost and what to change, without running it.
local derivatives = require "stiction.derivatives"
local engine = require "stiction.engine"
local fault = require "stiction.fault"
local forecast = require "stiction.fit.forecast"
local ordered = require "stiction.ordered"
local output = require "stiction.output"
local report = require "stiction.report"
local study_module = require "stiction.study"
local sweep = require "stiction.sweep"

local width, name_width, words_width = 110, 26, 14

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

local function show_results(study)
  if #study.results > 0 then
    report.line("\nResults")
  end
  for _, entry in ipairs(study.results) do
    report.line("  %s [%s]  %s", entry.name, entry.unit, entry.meaning)
  end
  if #study.derivatives > 0 then
    report.line("  and their derivatives with respect to %s, of a run beside the case each", table.concat(study.derivatives, ", "))
  end
end

--- `head`, then `text` beside it, wrapped.
local function beside(head, text)
  local indent = (" "):rep(#head)
  local lines = report.wrapped(text, indent, width)
  report.line("%s", head .. lines:sub(#indent + 1))
end

local function show_line(line)
  local head = ("  %-" .. name_width .. "s"):format(line.name)
  if line.meaning == "" then
    beside(head, line.words)
  else
    beside(head .. ("%-" .. words_width .. "s"):format(line.words) .. "  ", line.meaning)
  end
end

local function show_warnings(warnings)
  if #warnings == 0 then
    return report.line("\nNothing to change")
  end
  report.line("\nWhat to change")
  for i, warning in ipairs(warnings) do
    beside(("  %d. "):format(i), warning.text)
    beside("     -> ", warning.change)
  end
end

local function show(study, cases, names, case, explanation)
  report.line("%s", study.title)
  if study.question ~= "" then
    report.line("%s", report.wrapped(study.question, ""))
  end
  show_parameters("Given", study.given, case.p)
  show_parameters("Chosen", study.chosen, case.p)
  show_cases(cases, names)
  show_results(study)
  report.line("\nCase %s", case.id)
  for _, section in ipairs(explanation.sections) do
    report.line("\n%s", section.title)
    for _, line in ipairs(section.lines) do
      show_line(line)
    end
  end
  if explanation.fit then
    report.line("\nFit")
  end
  for _, line in ipairs(explanation.fit and forecast.lines(explanation.fit) or {}) do
    show_line(line)
  end
  show_warnings(explanation.warnings)
end

return function(options)
  local study = study_module.load(options.study, options.trust)
  if study.problem then
    fault.input("%s solves saved contact problems; there is no scene to explain", study.name)
  end
  sweep.tell_quick(study, options)
  sweep.tell_twice(study)
  local cases, names = sweep.cases(study, options)
  local case = options.case and sweep.find(cases, options.case) or cases[1]
  local explanation = engine.explain(study:scene_of(case))
  if #study.derivatives > 0 then
    engine.check_beside(study:scene_of(case), derivatives.of(study, case))
  end
  local warnings
  explanation.fit, warnings = forecast.of(study, options)
  table.move(warnings, 1, #warnings, #explanation.warnings + 1, explanation.warnings)
  if options.json then
    explanation.study, explanation.case, explanation.parameters = study.name, case.id, output.plain(case.p)
    engine.write(engine.encode_json(explanation, 2) .. "\n")
  else
    show(study, cases, names, case, explanation)
  end
  return 0
end
