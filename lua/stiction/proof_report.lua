-- The report of proofs: one table of all rows for people, one file of them for programs.
local engine = require "stiction.engine"
local progress = require "stiction.progress"
local report = require "stiction.report"
local tables = require "stiction.tables"

local proof_report = {}

local function in_unit(value, unit)
  return value == nil and "-" or ("%.5g"):format(value / (engine.parse_unit(unit) or 1))
end

local function percent(error)
  return error == 0 and "0" or error < 1e-6 and ("%.0e"):format(error) or ("%.3g %%"):format(100 * error)
end

local function each(levels, word)
  local words = {}
  for i, level in ipairs(levels) do
    words[i] = word(level)
  end
  return table.concat(words, ", ")
end

local function size_word(p)
  return ("%s, %s"):format(p.seconds and progress.duration(p.seconds) or "-",
    p.unknowns and ("%d"):format(p.unknowns) or "-")
end

local head = { "case", "quantity", "unit", "reference", "kind", "resolutions", "computed", "error", "order", "allowed",
  "verdict", "time, unknowns" }

local function words_of(entry)
  local p = entry.proof
  return { p.case, p.quantity, p.unit, in_unit(entry.expected, p.unit), p.kind,
    each(p.levels, function(level) return ("%.3g"):format(level.h) end) .. " " .. p.resolution,
    each(p.levels, function(level) return in_unit(level.value, p.unit) end),
    each(p.levels, function(level) return percent(level.error) end),
    p.order and ("%.2f"):format(p.order) or "-", percent(entry.tolerance / p.scale),
    entry.pass and "held" or "FAILED", size_word(p) }
end

local function markdown(rows)
  local lines = {}
  for i, words in ipairs(rows) do
    lines[#lines + 1] = "| " .. table.concat(words, " | ") .. " |"
    if i == 1 then
      lines[#lines + 1] = "|" .. (" --- |"):rep(#words)
    end
  end
  return lines
end

local function proofs_of(checks)
  local rows, other, notes = { head }, { count = 0, held = 0 }, {}
  for _, entry in ipairs(checks) do
    if entry.proof then
      rows[#rows + 1] = words_of(entry)
      if entry.proof.note then
        notes[#notes + 1] = ("- *%s*: %s"):format(entry.name, entry.proof.note)
      end
    elseif not entry.table then
      other.count = other.count + 1
      other.held = other.held + (entry.pass and 1 or 0)
    end
  end
  return rows, other, notes
end

local function failed_lines(checks)
  local lines = {}
  for _, entry in ipairs(checks) do
    if not entry.pass then
      lines[#lines + 1] = ("- **failed**: %s: value %s, expected %s, tolerance %s"):format(entry.name,
        tostring(entry.value), tostring(entry.expected), tostring(entry.tolerance))
    end
  end
  return lines
end

local function figure_lines(part, folder)
  local lines = {}
  for _, path in ipairs(engine.list(part.out .. "/figures", false)) do
    local relative = path:sub(1, #folder + 1) == folder .. "/" and path:sub(#folder + 2) or path
    if path:find("%.png$") then
      lines[#lines + 1] = ("![%s](%s)"):format(path:match("([^/]+)%.png$"), relative)
    end
  end
  return lines
end

local function append(lines, more)
  table.move(more, 1, #more, #lines + 1, lines)
end

local function section(part, folder)
  local rows, other, notes = proofs_of(part.checks)
  local lines = { "## " .. part.study.title, "", part.study.question, "",
    ("`%s`, %s."):format(part.study.name, progress.duration(part.seconds)), "" }
  if #rows > 1 then
    append(lines, markdown(rows))
    lines[#lines + 1] = ""
  end
  if other.count > 0 then
    append(lines, { ("Further checks: %d of %d held."):format(other.held, other.count), "" })
  end
  append(lines, notes)
  append(lines, failed_lines(part.checks))
  lines[#lines + 1] = ""
  append(lines, figure_lines(part, folder))
  lines[#lines + 1] = ""
  return lines, rows
end

local preface = [[
# Proofs

Every answer known beforehand against what Stiction computes. Kind: *exact* is a closed form, *published* a
number from the literature, *ours* a converged computation of our own by other means. Errors are relative to
the reference (or to the scale that the study states), the finest resolution is the last and decides; order is
observed between the two finest. %s]]

local function verdict_line(parts)
  local held, count = 0, 0
  for _, part in ipairs(parts) do
    for _, entry in ipairs(part.checks) do
      local counts = not entry.table
      count, held = count + (counts and 1 or 0), held + (counts and entry.pass and 1 or 0)
    end
  end
  return ("%d of %d checks of %d studies held."):format(held, count, #parts)
end

--- Writes report.md and report.json into `folder` and prints the rows.
--- parts: list of {study =, out =, code =, seconds =, checks =}.
function proof_report.write(folder, parts, quick)
  local lines = { preface:format(quick and "Quick form: coarser and fewer than the full one." or ""), verdict_line(parts),
    "" }
  local all = { { "case", "quantity", "reference", "computed", "error", "order", "verdict" } }
  local data = {}
  for _, part in ipairs(parts) do
    local text, rows = section(part, folder)
    append(lines, text)
    for i = 2, #rows do
      local row = rows[i]
      all[#all + 1] = { row[1], row[2], row[4] .. " " .. row[3], row[7]:match("[^ ]+$"), row[8]:match("[^,]+$"):gsub("^ ", ""),
        row[9], row[11] }
    end
    data[#data + 1] = { study = part.study.name, code = part.code, seconds = part.seconds, checks = part.checks }
  end
  for _, joined in ipairs(tables.join(parts)) do
    append(lines, { "## " .. joined.title, "" })
    append(lines, markdown(tables.words(joined)))
    lines[#lines + 1] = ""
    data[#data + 1] = { table = joined.title, columns = joined.columns, rows = joined.rows }
  end
  engine.write_file(folder .. "/report.md", table.concat(lines, "\n") .. "\n")
  engine.write_file(folder .. "/report.json", engine.encode_json(data, 2) .. "\n")
  report.line()
  report.table(all)
  report.line()
  report.line("%s", verdict_line(parts))
end

return proof_report
