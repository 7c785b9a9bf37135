-- The page on a study and what its output holds: what was asked and chosen, what came out, how far to trust it.
local engine = require "stiction.engine"
local html = require "stiction.html"
local fit_page = require "stiction.fit_page"
local jobs = require "stiction.jobs"
local fault = require "stiction.fault"
local numeric = require "stiction.numeric"
local ordered = require "stiction.ordered"
local report = require "stiction.report"
local selection = require "stiction.selection"
local tables = require "stiction.tables"
local warnings = require "stiction.warnings"

local study_page = {}

local most_cases, most_values, longest = 500, 12, 200 -- rows, distinct values, bytes of a value

local own_style = [[
nav a { margin-right: 1rem } img { max-width: 100% } figure { margin: 1rem 0 } .wide { overflow-x: auto }
.bad { color: #a00000; font-weight: bold } .small td { font-size: 14px; overflow-wrap: anywhere }
]]

local function decoded(path)
  local value = engine.decode_json(engine.read_file(path) or "")
  return type(value) == "table" and value or nil
end

--- A list of tables in what was decoded, {} where there is none.
local function list_of(value)
  return type(value) == "table" and value or {}
end

local function word(value)
  if type(value) == "table" then
    return "{" .. table.concat(numeric.map(value, word), ", ") .. "}"
  end
  local text = type(value) == "number" and ("%.10g"):format(value) or tostring(value)
  return #text > longest and text:sub(1, longest) .. "..." or text
end

local function with_unit(value, unit)
  return word(value) .. (type(unit) == "string" and unit ~= "1" and unit ~= "" and " " .. unit or "")
end

local function paragraph(text)
  return text ~= "" and "<p>" .. html.plain(text) .. "</p>" or ""
end

local function section(id, title, body)
  return body ~= "" and ('<section id="%s"><h2>%s</h2>\n%s\n</section>'):format(id, title, body) or ""
end

--- The values of a parameter over the cases, the first ones where they are many.
local function values_of(outcome, name)
  local column, seen, list = outcome.by_key["parameter " .. name], {}, {}
  for _, case in ipairs(column and outcome.cases or {}) do
    local value = case.values[column.name]
    if value ~= nil and not seen[value] then
      list[#list + 1], seen[value] = value, true
    end
  end
  table.sort(list, function(a, b)
    if type(a) ~= type(b) or type(a) == "boolean" then
      return tostring(a) < tostring(b)
    end
    return a < b
  end)
  local words = numeric.map(table.move(list, 1, math.min(#list, most_values), 1, {}), word)
  return table.concat(words, ", ") .. (#list > most_values and (", ... (%d values)"):format(#list) or ""), #list
end

local function parameter_rows(outcome, entries)
  local rows = {}
  for _, name in ipairs(ordered.keys(entries)) do
    local entry, words, count = list_of(entries[name]), values_of(outcome, name)
    local value = count > 1 and words or word(entry.value)
    rows[#rows + 1] = { name, with_unit(value, entry.unit), tostring(entry.note or "") }
  end
  return rows
end

local function parameters(outcome, manifest)
  local parts = {}
  for _, kind in ipairs { { "given", "Given", "where from" }, { "chosen", "Chosen", "why" }, { "swept", "Swept", "" } } do
    local rows = parameter_rows(outcome, list_of(manifest[kind[1]]))
    if #rows > 0 then
      parts[#parts + 1] = "<h3>" .. kind[2] .. "</h3>" .. html.rows(rows, { "name", "value", kind[3] })
    end
  end
  local drawn = list_of(outcome.owner.drawn)
  parts[#parts + 1] = drawn.kind and paragraph(("Drawn: %s values (%s, seed %s)"):format(word(drawn.count), word(drawn.kind),
    word(drawn.seed))) or nil
  return table.concat(parts, "\n")
end

--- What a result is, and what it may be off by where that is known.
local function result_words(outcome, case, column)
  local error_column = outcome.by_key["error " .. column.of .. "_error"]
  local bound = error_column and case.values[error_column.name]
  local own = report.in_unit(column, case.values[column.name])
  return bound and own .. " \u{b1} " .. report.in_unit(column, bound, 2) or own
end

local function meanings(outcome)
  local rows = {}
  for _, entry in ipairs(numeric.map(list_of(outcome.owner.results), list_of)) do
    rows[#rows + 1] = { tostring(entry.name), tostring(entry.unit), tostring(entry.meaning or "") }
  end
  return #rows > 0 and html.rows(rows, { "result", "unit", "meaning" }) or ""
end

local function results(outcome)
  local columns, heading, rows = {}, {}, {}
  for _, column in ipairs(selection.columns(outcome)) do
    if column.kind ~= "error" then
      columns[#columns + 1], heading[#heading + 1] = column, report.head(column)
    end
  end
  for i = 1, math.min(#outcome.cases, most_cases) do
    rows[i] = numeric.map(columns, function(column) return result_words(outcome, outcome.cases[i], column) end)
  end
  return meanings(outcome) .. '<div class="wide">' .. html.rows(rows, heading) .. "</div>"
    .. (#outcome.cases > most_cases and ("<p>and %d more cases</p>"):format(#outcome.cases - most_cases) or "")
end

local function grouped(told, class)
  local lines = {}
  for _, group in ipairs(warnings.groups(told)) do
    local changes, more = warnings.changes_of(group, #told)
    if more > 0 then
      changes[#changes + 1] = ("and %d more, which explain tells"):format(more)
    end
    lines[#lines + 1] = ("<li%s>%s <em>(%s)</em>%s</li>"):format(class or "", html.plain(group.text),
      html.plain(warnings.cases_of(group.ids, #told)),
      table.concat(numeric.map(changes, function(words) return "<br>\u{2192} " .. html.plain(words) end)))
  end
  return #lines > 0 and "<ul>" .. table.concat(lines, "\n") .. "</ul>" or ""
end

--- For each case what it says of itself, as texts that can be grouped.
local function told_by(outcome, texts_of)
  return numeric.map(outcome.cases, function(case)
    local list = {}
    for _, entry in ipairs(texts_of(case)) do
      local own = type(entry) == "table" and entry or { text = entry }
      list[#list + 1] = { text = tostring(own.text), change = own.change and tostring(own.change) or nil }
    end
    return { id = case.name, warnings = list }
  end)
end

local function trust(outcome)
  local failed = grouped(told_by(outcome, function(case)
    return case.verdict ~= "finished" and { case.verdict .. ": " .. case.reason } or {}
  end), ' class="bad"')
  local warned = grouped(told_by(outcome, function(case) return list_of(case.ended.warnings) end))
  local remarked = grouped(told_by(outcome, function(case) return list_of(case.ended.remarks) end))
  local parts = {}
  for _, part in ipairs { { "Cases that did not finish", failed }, { "Known before they ran (warnings)", warned },
    { "Told when they ended (remarks)", remarked } } do
    parts[#parts + 1] = part[2] ~= "" and "<h3>" .. part[1] .. "</h3>" .. part[2] or nil
  end
  return #parts > 0 and table.concat(parts, "\n") or "<p>No warnings, no remarks, no failed cases.</p>"
end

--- A table of the study's own as lists of texts; nil if it is none.
local function table_words(t)
  if type(t) ~= "table" or type(t.columns) ~= "table" or type(t.rows) ~= "table" then
    return nil
  end
  local rows = numeric.map(t.rows, list_of)
  return tables.words { columns = numeric.map(t.columns, tostring), rows = rows }
end

--- Checks as a table, and the study's own tables; how many held, of how many.
local function checks(list)
  local rows, parts, held = {}, {}, 0
  for _, check in ipairs(numeric.map(list, list_of)) do
    local words = table_words(check.table)
    if words then
      parts[#parts + 1] = "<h3>" .. html.plain(check.name) .. "</h3>"
        .. html.rows(table.move(words, 2, #words, 1, {}), words[1])
    else
      held = held + (check.pass and 1 or 0)
      rows[#rows + 1] = { tostring(check.name), report.check_word(check.value), report.check_word(check.expected),
        report.check_word(check.tolerance), check.pass and "held" or "FAILED" }
    end
  end
  local body = #rows > 0 and html.rows(rows, { "check", "value", "expected", "tolerance", "verdict" })
    :gsub("<td>FAILED</td>", '<td class="bad">FAILED</td>') or ""
  return body .. table.concat(parts, "\n"), held, #rows
end

local kinds = { png = "image/png", svg = "image/svg+xml" }

local function picture(path, title)
  local kind = kinds[path:match("%.(%w+)$")]
  local code, text = jobs.program { "base64", "-w0", path }
  if code ~= 0 then
    fault.run("cannot read %s: %s", path, text)
  end
  return ('<figure><img alt="%s" src="data:%s;base64,%s"><figcaption>%s</figcaption></figure>'):format(html.plain(title),
    kind, text, html.plain(title))
end

--- The pictures of the study's figures in their order, then others that lie beside them.
local function figures(folder)
  local list, seen = {}, {}
  for _, entry in ipairs(numeric.map(list_of((decoded(folder .. "/figures.json") or {}).figures), list_of)) do
    for _, ending in ipairs { "png", "svg" } do
      local path = ("%s/figures/%s.%s"):format(folder, tostring(entry.name), ending)
      if not seen[tostring(entry.name)] and engine.kind_of_path(path) == "file" then
        list[#list + 1], seen[tostring(entry.name)] = picture(path, entry.title or entry.name), true
      end
    end
  end
  for _, path in ipairs(engine.list(folder .. "/figures", false)) do
    local name, ending = path:match("([^/]+)%.(%w+)$")
    if kinds[ending] and not seen[name] then
      list[#list + 1], seen[name] = picture(path, name), true
    end
  end
  return table.concat(list, "\n")
end

--- Adds a row for every setting below `node`: its path, value, whether the script gave it, meaning.
local function add_settings(rows, node, path)
  if type(node) ~= "table" then
    rows[#rows + 1] = { path, word(node), "", "" }
  elseif node.meaning and node.unit then
    rows[#rows + 1] = { path, with_unit(node.value, node.unit), node.given == false and "default" or "given",
      tostring(node.meaning) }
  else
    for _, name in ipairs(ordered.keys(node)) do
      add_settings(rows, node[name], (path ~= "" and path .. "." or "") .. tostring(name))
    end
  end
end

--- "block: body (material: neo_hookean, mesh: block)": what a part and those in it are.
local function kinds_in(node)
  local words = {}
  for _, name in ipairs(ordered.keys(node)) do
    local inner = node[name]
    if type(inner) == "table" and not inner.meaning then
      local own = kinds_in(inner)
      words[#words + 1] = (inner.is or own ~= "") and tostring(name) .. ": " .. word(inner.is or "") .. own or nil
    end
  end
  return #words > 0 and " (" .. table.concat(words, ", ") .. ")" or ""
end

local function modelled(manifest, case)
  local parts = {}
  for _, name in ipairs(ordered.keys(list_of(manifest.parts))) do
    local rows, node = {}, manifest.parts[name]
    add_settings(rows, node, "")
    if #rows > 0 and type(node) == "table" then
      local own = node.meaning and ": " .. with_unit(node.value, node.unit) or (node.is and ": " .. word(node.is) or "")
        .. kinds_in(node)
      parts[#parts + 1] = ("<details><summary>%s</summary><div class=\"wide small\">%s</div></details>"):format(
        html.plain(name .. own), html.rows(rows, { "setting", "value", "", "meaning" }))
    end
  end
  return #parts > 0 and paragraph("Every setting of the scene, of case " .. case.name .. ":") .. table.concat(parts, "\n")
    or ""
end

local function add_facts(rows, facts, names)
  for _, name in ipairs(names) do
    local value = list_of(facts)[name]
    rows[#rows + 1] = value ~= nil and { name, word(value) } or nil
  end
end

--- First start, last end and the number of different programs among the cases.
local function times(outcome)
  local first, last, programs = nil, nil, {}
  for _, case in ipairs(outcome.cases) do
    local run = list_of(case.ended.run)
    if type(run.started) == "string" and type(run.ended) == "string" then
      first = (not first or run.started < first) and run.started or first
      last = (not last or run.ended > last) and run.ended or last
    end
    programs[tostring(run.program)] = true
  end
  return first, last, #ordered.keys(programs)
end

local function versions(outcome, manifest)
  local rows, first, last, programs = {}, times(outcome)
  add_facts(rows, manifest.build, { "version", "commit", "compiler", "flags" })
  for _, name in ipairs(ordered.keys(list_of(list_of(manifest.build).libraries))) do
    rows[#rows + 1] = { name, word(manifest.build.libraries[name]) }
  end
  add_facts(rows, manifest.host, { "processor", "cores", "system" })
  rows[#rows + 1] = first and { "first case began", first } or nil
  rows[#rows + 1] = last and { "last case ended", last } or nil
  rows[#rows + 1] = programs > 1 and { "programs", ("%d different builds computed the cases"):format(programs) } or nil
  for _, file in ipairs(list_of(manifest.files)) do
    rows[#rows + 1] = { "file " .. tostring(file.path), tostring(file.hash) }
  end
  return html.rows(rows, { "what", "" }) .. "<p><code>stiction verify</code> on the output computes the cases again from the "
    .. "source that is kept with them.</p>"
end

--- The first case that finished, else the first, with its manifest.
local function example_of(outcome)
  local case = numeric.first_where(outcome.cases, function(case) return case.verdict == "finished" end)
  local own = outcome.cases[case or 1]
  return own, decoded(own.folder .. "/manifest.json") or {}
end

local function sums(outcome, held, count)
  local finished = 0
  for _, case in ipairs(outcome.cases) do
    finished = finished + (case.verdict == "finished" and 1 or 0)
  end
  return ("%d of %d case%s finished%s."):format(finished, #outcome.cases, #outcome.cases == 1 and "" or "s",
    count > 0 and ("; %d of %d checks held"):format(held, count) or "; no checks")
end

--- Sections on a fit and a sample in the output, or below or beside it, with their figures.
local function uncertainty(outcome)
  local parts = {}
  for _, kind in ipairs { { "fit", "Parameters from measured curves" }, { "sample", "Uncertain parameters" } } do
    for _, folder in ipairs { outcome.folder, outcome.folder .. "/" .. kind[1] } do
      local body = fit_page[kind[1]](folder)
      local own = body ~= "" and folder ~= outcome.folder and figures(folder) or ""
      parts[#parts + 1] = section(kind[1], kind[2], body .. own)
    end
  end
  return parts
end

--- The page, HTML. outcome: of outcomes.read.
function study_page.write(outcome)
  local case, manifest = example_of(outcome)
  local title = tostring(manifest.title or outcome.owner.name or outcome.folder:match("[^/]+$"))
  local check_body, held, count = checks(list_of(decoded(outcome.folder .. "/checks.json")))
  local parts = { section("parameters", "Parameters", parameters(outcome, manifest)),
    section("results", "Results", results(outcome)), section("checks", "Checks", check_body),
    section("figures", "Figures", figures(outcome.folder)), section("trust", "How far to trust it", trust(outcome)),
    section("modelled", "What was modelled", modelled(manifest, case)),
    section("versions", "With what it was computed", versions(outcome, manifest)) }
  for i, part in ipairs(uncertainty(outcome)) do
    table.insert(parts, 1 + i, part)
  end
  local links = {}
  for _, part in ipairs(parts) do
    local id, name = part:match('^<section id="(%w+)"><h2>(.-)</h2>')
    links[#links + 1] = id and ('<a href="#%s">%s</a>'):format(id, name) or nil
  end
  return ('<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8"><title>%s</title><style>\n%s%s</style></head><body>\n')
    :format(html.plain(title), html.style, own_style) .. "<h1>" .. html.plain(title) .. "</h1>\n"
    .. paragraph(type(manifest.question) == "string" and manifest.question or "")
    .. paragraph(sums(outcome, held, count)) .. "<nav>" .. table.concat(links, "\n") .. "</nav>\n"
    .. table.concat(parts, "\n") .. "\n</body></html>\n"
end

return study_page
