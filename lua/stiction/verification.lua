-- Kept cases computed again from the source that is kept with them, and what comes out beside what was kept.
local engine = require "stiction.engine"
local fault = require "stiction.fault"
local jobs = require "stiction.jobs"
local ordered = require "stiction.ordered"
local output = require "stiction.output"
local provenance = require "stiction.provenance"

local verification = {}

--- The cases that finished, all or `count` of them: always the same ones of the same names; and the number of all.
function verification.choose(outcome, count)
  local finished = {}
  for _, case in ipairs(outcome.cases) do
    finished[#finished + 1] = case.verdict == "finished" and case.ended.results and case or nil
  end
  local all = #finished
  if count and count < all then
    local place = {}
    for i, case in ipairs(finished) do
      place[case] = i
    end
    table.sort(finished, function(a, b)
      local one, other = engine.hash(a.name), engine.hash(b.name)
      return one == other and a.name < b.name or one < other
    end)
    finished = table.move(finished, 1, count, 1, {})
    table.sort(finished, function(a, b) return place[a] < place[b] end)
  end
  return finished, all
end

--- Where summary.csv says something else than the cases' own files: list of {case =, name =, kept =, got =}.
function verification.summary(outcome)
  local list = {}
  for _, case in ipairs(outcome.cases) do
    for _, name in ipairs(case.row.case and case.ended ~= case.row and ordered.keys(case.results) or {}) do
      local kept = tonumber(case.row[name])
      if kept ~= case.results[name] then
        list[#list + 1] = { case = case.name, name = name, kept = case.results[name], got = kept }
      end
    end
  end
  return list
end

--- Cases that ended, as summary.csv says, whose own files do not say so any more: list of {case =, reason =}.
function verification.lost(outcome)
  local list = {}
  for _, case in ipairs(outcome.cases) do
    if case.ended == case.row then
      list[#list + 1] = { case = case.name, reason = "its files are gone: summary.csv alone tells of it" }
    elseif case.verdict == "unreadable" then
      list[#list + 1] = { case = case.name, reason = case.reason }
    end
  end
  return list
end

--- How many of the cases can be computed again: those that finished and whose source is kept.
function verification.count(outcome, place)
  local count, known = 0, {}
  for _, case in ipairs((verification.choose(outcome))) do
    local files = provenance.files_of(case.ended)
    local key = files and engine.encode_json(files)
    if key and known[key] == nil then
      known[key] = provenance.lay_out(outcome.folder, files, place .. "/count" .. count) ~= nil
    end
    count = count + (key and known[key] and 1 or 0)
  end
  return count
end

local function list_or_none(x)
  return type(x) == "table" and x or {}
end

--- How a case was run: {quick =, set =, trade = (true: as one of a ladder, or nil), files =, program =, processor =, shared = by
--- several ranks}; nil and the reason if its files do not say.
local function how_run(case)
  local run, files, set = case.ended.run, provenance.files_of(case.ended), {}
  if type(run) ~= "table" or not files then
    return nil, "it does not say how it was run, as older versions did not; run it again"
  end
  for i, setting in ipairs(list_or_none(run.set)) do
    set[i] = tostring(setting)
  end
  return { quick = run.quick == true, set = set, trade = run.trade == true or nil, files = files, program = run.program,
    processor = run.processor, shared = run.ranks ~= nil }
end

--- Cases that were run with the same source and options: list of {files =, quick =, set =, trade =, cases =}; and the others, as
--- {case =, reason =}.
local function groups_of(cases)
  local groups, by_key, left = {}, {}, {}
  for _, case in ipairs(cases) do
    local how, reason = how_run(case)
    local key = how and engine.encode_json { how.quick, how.set, how.files, how.trade }
    if not how then
      left[#left + 1] = { case = case.name, reason = reason }
    elseif not by_key[key] then
      how.cases = {}
      groups[#groups + 1], by_key[key] = how, how
    end
    if how then
      table.insert(by_key[key].cases, case)
    end
  end
  return groups, left
end

--- The first of the files that was read now and not when the case was kept; nil if there is none.
local function other_file(kept, read)
  local known = {}
  for _, file in ipairs(kept) do
    known[file.hash] = true
  end
  for _, file in ipairs(list_or_none(read)) do
    if not known[file.hash] then
      return file.path
    end
  end
end

--- Runs the cases of a group; told(case, result, folder) for each. True if the user stopped it.
local function run_group(group, place, options, told)
  local by_id, list = {}, {}
  for i, case in ipairs(group.cases) do
    local id = tostring(case.ended.case or case.name)
    list[i], by_id[id] = { id = id, point = type(case.ended.point) == "string" and case.ended.point or nil }, case
  end
  local settings = { study = group.study, folder = place .. "/out", quick = group.quick, set = group.set, trade = group.trade,
    trust = options.trust, jobs = math.floor(options.jobs or engine.cores()), threads = 1, tolerant = true }
  return jobs.run(list, settings, function(case, result)
    told(by_id[case.id], result, settings.folder .. "/" .. case.id)
  end) == "stopped"
end

--- The largest magnitude of each result among the cases.
local function scales_of(outcome)
  local scales = {}
  for _, case in ipairs(outcome.cases) do
    for name, value in pairs(case.results) do
      scales[name] = type(value) == "number" and math.max(scales[name] or 0, math.abs(value)) or scales[name]
    end
  end
  return scales
end

--- Do two histories say the same? Those of a case that was stopped and went on lie elsewhere in their file.
local function same_history(kept, got)
  if engine.read_file(kept) == engine.read_file(got) then
    return true
  end
  local readable, same = pcall(engine.same_series, kept, got)
  return readable and same
end

--- Compares the history that a case gave with the kept one where there are both; adds to the report.
local function compare_histories(report, case, folder)
  local kept, got = case.folder .. "/series.h5", folder .. "/series.h5"
  local is_kept, is_got = engine.kind_of_path(kept) == "file", engine.kind_of_path(got) == "file"
  if is_kept or is_got then
    report.histories = report.histories + 1
    report.others[#report.others + 1] = not (is_kept and is_got and same_history(kept, got))
      and { case = case.name, gone = not is_kept } or nil
  end
end

--- Compares what a case gave, in this folder, with what was kept; adds to the report.
local function compare(report, case, result, folder, scales, tolerance)
  local how = how_run(case)
  local other = other_file(how.files, result.files)
  if result.verdict ~= case.verdict or other then
    report.left[#report.left + 1] = { case = case.name, reason = other and "it now reads another file: " .. other
      or ("it ended as '%s'%s"):format(result.verdict, result.reason ~= "" and ": " .. tostring(result.reason) or "") }
    return
  end
  local same_build = how.program == output.program() and how.processor == engine.processor() and not how.shared
  report.cases, report.foreign = report.cases + 1, report.foreign + (same_build and 0 or 1)
  for _, name in ipairs(ordered.keys_of(case.results, result.results or {})) do
    local kept, got = case.results[name], (result.results or {})[name]
    local apart = kept ~= got and (type(kept) ~= "number" or type(got) ~= "number") and math.huge
      or kept ~= got and math.abs(kept - got) / scales[name] or 0
    report.values, report.largest = report.values + 1, math.max(report.largest, apart)
    report.equal = report.equal + (apart == 0 and 1 or 0)
    if apart > (same_build and 0 or tolerance) then
      report.differences[#report.differences + 1] = { case = case.name, name = name, kept = kept, got = got,
        apart = apart }
    end
  end
  if same_build then
    compare_histories(report, case, folder)
  end
end

--- Computes the cases again below `place`. tolerance: relative to the largest value of the result among the cases,
--- where another build of the program or another processor made them. {cases =, foreign = those of another build, values =,
--- equal = to the last bit, largest = difference, differences = {{case =, name =, kept =, got =, apart =}}, histories = (of this
--- build, that were compared), others = {{case =, gone =}} (whose history is another one than was kept), left = {{case =, reason =}}
--- (not recomputed), stopped =}.
function verification.recompute(place, outcome, cases, options, tolerance)
  local report = { cases = 0, foreign = 0, values = 0, equal = 0, largest = 0, differences = {}, histories = 0, others = {},
    stopped = false }
  local scales = scales_of(outcome)
  local groups, left = groups_of(cases)
  report.left = left
  for i, group in ipairs(groups) do
    local own = place .. ("/%d"):format(i)
    local study, reason = provenance.lay_out(outcome.folder, group.files, own)
    group.study = study
    for _, case in ipairs(study and {} or group.cases) do
      report.left[#report.left + 1] = { case = case.name, reason = reason }
    end
    report.stopped = report.stopped or study ~= nil and run_group(group, own, options, function(case, result, folder)
      compare(report, case, result, folder, scales, tolerance)
    end)
  end
  return report
end

--- The relative difference that --tolerance allows, by default 1e-6.
function verification.tolerance(options)
  local words = options.tolerance
  local value = words == nil and 1e-6 or tonumber(words)
  if not value or value < 0 or value ~= value then
    fault.input("--tolerance must be a relative difference of 0 or more, not %s", tostring(words))
  end
  return value
end

return verification
