#!/bin/sh
# What a case that has finished costs who lists, shows or reuses it: one line of one file is read and decoded once, whatever
# else its folder holds. Counts of two sweeps, so that what is paid once falls out.
. "$(dirname "$0")/common.sh"

changed few 's/mu = { 0, 0.2, 0.4 }/mu = { 0, 0.1, 0.2, 0.3 }/; s/schedule = stiction/output = stiction.output { frames = 0 }, schedule = stiction/
  s/steps = { 10,/steps = { 1,/'
cp -r few many
sed -i 's/mu = { 0, 0.1, 0.2, 0.3 }/mu = { 0, 0.1, 0.2, 0.3, 0.15, 0.25, 0.35, 0.4, 0.45, 0.5, 0.55, 0.6 }/' many/study.lua
for study in few many; do
  expect 0 "checks held" "$stiction" run $study --no-figures
done

cat >count.lua <<'L'
local test, equal = ...
local engine = require "stiction.engine"
local commands = require "stiction.cli"
local names = { "first_line", "read_file", "decode_json", "kind_of_path", "absolute", "list", "scene_text", "preview", "read_series" }
local counts, bytes = {}, 0
for _, name in ipairs(names) do
  local own = engine[name]
  engine[name] = function(...)
    local answers = table.pack(own(...))
    counts[name] = (counts[name] or 0) + 1
    if name == "first_line" or name == "read_file" then
      bytes = bytes + #(answers[1] or "")
    end
    return table.unpack(answers, 1, answers.n)
  end
end

local function count(study, command, options)
  counts, bytes = {}, 0
  options.study = study
  equal(commands(command, options), 0)
  return counts, bytes
end

--- What each of eight further cases costs.
local function costs(command, options, wanted)
  test(command, function()
    count("few", command, options) -- what a process reads once
    local few, few_bytes = count("few", command, options)
    count("many", command, options)
    local many, many_bytes = count("many", command, options)
    for _, name in ipairs(names) do
      equal(("%s %g"):format(name, ((many[name] or 0) - (few[name] or 0)) / 8), ("%s %g"):format(name, wanted[name] or 0))
    end
    local own = (many_bytes - few_bytes) / 8
    equal(own < 4000 and "small" or own, "small")
  end)
end

local once = { first_line = 1, decode_json = 1, kind_of_path = 1 } -- is series.h5 there?
costs("run", { list = true }, once)
costs("why", {}, once)
costs("run", { ["no-figures"] = true }, once)
costs("status", {}, once)
costs("show", {}, { first_line = 1, decode_json = 1 })
costs("show", { where = "mu > 0.1", csv = "shown.csv" }, { first_line = 1, decode_json = 1 })
L
"$stiction" luatest count.lua >output 2>&1
holds "costs of a case: $(grep -v '^mu' output)" grep -q '6 passed, 0 failed' output
finish
