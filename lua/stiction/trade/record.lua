-- What a trade leaves behind: trade.csv, trade.json in its output and, of the full form, beside the study.
local engine = require "stiction.engine"
local fault = require "stiction.fault"
local output = require "stiction.output"
local sweep = require "stiction.sweep"
local units = require "stiction.units"

local record = {}

--- Counts that a run's cost consists of, as the result of its case names them.
record.counts = { "factorizations", "solves", "cells_evaluated", "contact_iterations", "steps", "iterations" }

--- Where the trade of a study is kept for `run --accuracy`.
function record.kept_file(study)
  local source = study.source
  return source.whole and source.folder .. "/trade.json" or source.file:gsub("%.lua$", ".trade.json")
end

--- Of what the study says and of the files in its scene; a trade measured on others does not count.
local function fingerprint(study)
  return study.identity .. output.data_identity(study, sweep.trade(study, {})[1])
end

--- "0.00025 m" of a level, as --set reads it.
function record.setting(value)
  if units.is_quantity(value) then
    return ("%.12g %s"):format(value.si,
      engine.dimension_text(value.metre, value.kilogram, value.second))
  end
  return type(value) == "number" and engine.number_text(value) or tostring(value)
end

--- {knob = setting} of one run.
function record.settings(knobs, run)
  local settings = {}
  for i, knob in ipairs(knobs) do
    settings[knob.name] = record.setting(knob.levels[run.levels[i]])
  end
  return settings
end

local function word(x)
  return x == nil and "" or type(x) == "number" and engine.number_text(x) or tostring(x)
end

local function judged_of(trade)
  local list = {}
  for _, quantity in ipairs(trade.quantities) do
    list[#list + 1] = not quantity.watched and quantity or nil
  end
  return list
end

--- trade.csv: a row per run: settings, quantities and their errors (of a curve the error alone), bound (largest error
--- with the reference's own), costs, verdict, whether it is the default and whether it lies on the front. A number of the last whose
--- name a knob or a quantity has is called NAME_counted.
function record.write_csv(trade)
  local head = { "case" }
  for _, knob in ipairs(trade.knobs) do
    head[#head + 1] = knob.name
  end
  local judged = judged_of(trade)
  for _, quantity in ipairs(judged) do
    head[#head + 1] = not quantity.curve and quantity.name or nil
    head[#head + 1] = quantity.name .. "_error"
  end
  local taken = {}
  for _, name in ipairs(head) do
    taken[name] = true
  end
  for _, names in ipairs { { "error", "bound", "work", "seconds" }, record.counts } do
    for _, name in ipairs(names) do
      head[#head + 1] = taken[name] and name .. "_counted" or name
    end
  end
  table.move({ "verdict", "default", "front" }, 1, 3, #head + 1, head)
  local lines = { table.concat(head, ",") }
  for _, run in ipairs(trade.runs) do
    local words, settings = { run.id }, record.settings(trade.knobs, run)
    for _, knob in ipairs(trade.knobs) do
      words[#words + 1] = settings[knob.name]
    end
    for _, quantity in ipairs(judged) do
      words[#words + 1] = not quantity.curve and word((run.values or {})[quantity.name]) or nil
      words[#words + 1] = word((run.errors or {})[quantity.name])
    end
    for _, name in ipairs { "error", "bound", "work", "seconds" } do
      words[#words + 1] = word(run[name])
    end
    for _, name in ipairs(record.counts) do
      words[#words + 1] = word(run.counts[name])
    end
    words[#words + 1] = run.verdict
    words[#words + 1] = tostring(run.default)
    words[#words + 1] = tostring(run.front)
    lines[#lines + 1] = table.concat(words, ",")
  end
  engine.write_file(trade.folder .. "/trade.csv", table.concat(lines, "\n") .. "\n")
end

--- References by name; of a curve its uncertainty relative to its norm, no points.
local function plain_references(trade)
  local plain = {}
  for _, quantity in ipairs(trade.quantities) do
    local its = trade.references[quantity.name]
    local relative = { curve = true, uncertainty = its.uncertainty / its.scale, scale = 1, doubt = its.doubt }
    plain[quantity.name] = quantity.curve and relative or its
  end
  return plain
end

local function plain_values(trade, run)
  local plain = {}
  for _, quantity in ipairs(run.values and trade.quantities or {}) do
    plain[quantity.name] = not quantity.curve and run.values[quantity.name] or nil
  end
  return run.values and plain
end

local function plain(trade)
  local kept = {
    study = trade.study.name, fingerprint = fingerprint(trade.study), quick = trade.quick,
    references = plain_references(trade), runs = {},
  }
  for _, run in ipairs(trade.runs) do
    kept.runs[#kept.runs + 1] = {
      case = run.id, settings = record.settings(trade.knobs, run), values = plain_values(trade, run),
      errors = run.errors, error = run.error, bound = run.bound, work = run.work, seconds = run.seconds,
      verdict = run.verdict, default = run.default, front = run.front,
    }
  end
  return kept
end

--- Writes trade.json into the output and, `keep` given, beside the study.
function record.write_json(trade, keep)
  local text = engine.encode_json(plain(trade), 2) .. "\n"
  engine.write_file(trade.folder .. "/trade.json", text)
  if keep then
    engine.write_file(record.kept_file(trade.study), text)
  end
end

--- The kept trade of a study; bad input with the command that makes one where there is none of its present words.
function record.read(study, name)
  local text = engine.read_file(record.kept_file(study))
  local command = ("'stiction trade %s'"):format(name)
  if not text then
    fault.input("--accuracy: what accuracy costs in '%s' was not measured yet; measure it with: %s", study.name,
      command)
  end
  local kept = engine.decode_json(text)
  if not kept or kept.fingerprint ~= fingerprint(study) then
    fault.input("--accuracy: '%s' was changed since its trade was measured; measure again with: %s", study.name,
      command)
  end
  return kept
end

return record
