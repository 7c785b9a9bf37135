-- What stiction peers prints and leaves: two tables, peers.json and peers.csv.
local engine = require "stiction.engine"
local report = require "stiction.report"

local record = {}

local function word(format, value)
  return value and format:format(value) or "-"
end

--- The peer's name, with what it took of its own choice, and whether it ran here.
local function peer_words(row)
  return row.pair.peer .. (row.theirs.note and " " .. row.theirs.note or "") .. (row.theirs.stored and " (stored)" or "")
end

--- Times of a peer that ran elsewhere are not shown.
local function cost_words(row)
  local ours, theirs = row.ours, row.theirs
  local here = not theirs.stored
  return { row.pair.name, peer_words(row), word("%.4g", ours.seconds), word("%.4g", here and theirs.seconds), word("%.3g", row.ratio),
    word("%.0f", ours.memory), word("%.0f", theirs.memory), word("%d", ours.unknowns and ours.unknowns // 1 | 0),
    word("%d", theirs.unknowns), word("%d", ours.iterations and ours.iterations // 1 | 0), word("%d", theirs.iterations) }
end

local function show_costs(rows)
  local lines = { { "case", "peer", "s", "its s", "ratio", "MiB", "its MiB", "unknowns", "its unknowns", "iterations", "its iterations" } }
  for _, row in ipairs(rows) do
    lines[#lines + 1] = cost_words(row)
  end
  report.line("\nProcessor time, memory and counts: Stiction's, the peer's (its), peer / Stiction")
  report.table(lines)
end

local function verdict(row, quantity)
  local own, allowed = row.differences[quantity.name], row.allowed[quantity.name]
  return own == nil and "no answer" or not allowed and "several answers" or own <= allowed and "" or "DIFFER"
end

local function show_results(rows)
  local lines = { { "case", "peer", "result", "unit", "Stiction", "peer", "difference", "allowed", "" } }
  for _, row in ipairs(rows) do
    for _, quantity in ipairs(row.pair.known.quantities) do
      local name = quantity.name
      lines[#lines + 1] = { row.pair.name, peer_words(row), name, quantity.symbol, word("%.7g", (row.ours.results or {})[name]),
        word("%.7g", row.theirs.results[name]), word("%.2e", row.differences[name]), word("%.2e", row.allowed[name]),
        verdict(row, quantity) }
    end
  end
  report.line("\nResults")
  report.table(lines)
end

--- Both tables, then the pairs that have no answer or another one.
function record.show(rows)
  show_costs(rows)
  show_results(rows)
  report.line()
  for _, row in ipairs(rows) do
    if row.ours.failed then
      report.line("%s: no answer: %s", row.pair.name, row.ours.failed)
    elseif not row.agrees then
      report.line("%s: Stiction and %s differ by more than is allowed", row.pair.name, row.pair.peer)
    end
  end
end

local function object(t)
  return setmetatable(t, { json = "object" })
end

local function write_json(folder, rows)
  local list = {}
  for i, row in ipairs(rows) do
    list[i] = { case = row.pair.case, size = row.pair.size, parameters = object(row.pair.set), peer = row.pair.peer,
      stiction = row.ours, ["peer's"] = row.theirs, differences = object(row.differences), allowed = object(row.allowed),
      agrees = row.agrees, ratio = row.ratio }
  end
  engine.write_file(folder .. "/peers.json", engine.encode_json(list, 2) .. "\n")
end

local function csv(value)
  return value == nil and "" or type(value) == "number" and engine.number_text(value) or tostring(value)
end

--- peers.csv: a row per pair and quantity: what both sides gave, and by what they differ.
local function write_csv(folder, rows)
  local lines = { "case,parameters,peer,stored,quantity,unit,stiction,peer's,difference,allowed" }
  for _, row in ipairs(rows) do
    local function add(quantity, unit, ours, theirs, difference, allowed)
      local words = { row.pair.case, row.pair.name:match(" (.*)"), row.pair.peer, tostring(row.theirs.stored == true), quantity, unit }
      for i, value in ipairs { ours or false, theirs or false, difference or false, allowed or false } do
        words[6 + i] = csv(value or nil)
      end
      lines[#lines + 1] = table.concat(words, ",")
    end
    for _, quantity in ipairs(row.pair.known.quantities) do
      add(quantity.name, quantity.symbol, (row.ours.results or {})[quantity.name], row.theirs.results[quantity.name],
        row.differences[quantity.name], row.allowed[quantity.name])
    end
    for _, cost in ipairs { { "seconds", "s" }, { "memory", "MiB" }, { "unknowns", "1" }, { "iterations", "1" } } do
      add(cost[1], cost[2], row.ours[cost[1]], row.theirs[cost[1]])
    end
  end
  engine.write_file(folder .. "/peers.csv", table.concat(lines, "\n") .. "\n")
end

--- Both files, after every pair.
function record.write(folder, rows)
  write_json(folder, rows)
  write_csv(folder, rows)
end

return record
