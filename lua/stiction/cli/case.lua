-- One case of a sweep, run in a process of its own for `stiction run`.
local case_module = require "stiction.case"
local claims = require "stiction.claims"
local derivatives = require "stiction.derivatives"
local engine = require "stiction.engine"
local evaluation = require "stiction.evaluation"
local fault = require "stiction.fault"
local hold = require "stiction.hold"
local identity = require "stiction.identity"
local ordered = require "stiction.ordered"
local output = require "stiction.output"
local problem = require "stiction.problem"
local provenance = require "stiction.provenance"
local study_module = require "stiction.study"
local sweep = require "stiction.sweep"

local between_messages, between_checkpoints = 0.1, 600 -- s

local function tell(message)
  return engine.tell_parent(engine.encode_json(message))
end

--- Parameters of one section with their notes, for the manifest.
local function section_of(p, names, notes)
  local plain, section = output.plain(p), setmetatable({}, { json = "object" })
  for _, name in ipairs(names) do
    local note = notes[name] and notes[name].note
    local value = plain[name]
    if type(value) ~= "table" then
      value = { value = value, unit = type(value) == "number" and "1" or nil }
    end
    section[name] = { value = value.value, unit = value.unit, note = note }
  end
  return section
end

local function manifest(study, case, names, options)
  local text = engine.encode_json {
    files = output.files_read(study, case),
    study = study.name, title = study.title, question = study.question, version = engine.version,
    quick = options.quick or false, set = options.set or {},
    given = section_of(case.p, ordered.keys(study.given), study.given),
    chosen = section_of(case.p, ordered.keys(study.chosen), study.chosen),
    swept = section_of(case.p, names, {}), made_of = "@",
  }
  return (text:gsub('"made_of":"@"', function() return '"made_of":' .. output.made_of(case, study) end))
end

--- Tells the parent how far the case is, and, once, that it has begun.
local function progress_teller(begin)
  local last = 0
  return function(progress)
    begin()
    local now = engine.clock()
    if now - last >= between_messages then
      last = now
      tell { progress = progress }
    end
  end
end

--- A line on the case's checkpoint, to whoever listens.
local function note(text)
  if not tell { note = text } then
    engine.complain("stiction: " .. text .. "\n")
  end
end

--- Fingerprint of the case; a fault if what it is made of is not what its sweep began with.
local function fingerprint_of(study, case, options)
  local own, wanted = output.fingerprint(study, case), options.fingerprint
  if wanted and (own ~= wanted or hold.differing(options.out, study)) then
    fault.changed("%s: the study, a file that it reads or the program was changed while its cases ran; cases that ended "
      .. "are kept, the same command runs what must run anew", study.source.name)
  end
  return own
end

--- What the engine is to do with a case beside computing it.
local function settings_of(options, case, text, fingerprint)
  local folder = output.case_folder(options.out, case)
  return { out = folder, case_id = case.id, manifest = text,
    rehearse = options.rehearse or 0, alone = options.alone, threads = options.threads or 1, stop_after = options["stop-after"] or 0,
    checkpoint = folder .. "/checkpoint", every = options.checkpoint or between_checkpoints,
    program = identity.program(), anew = options.force, -- what a checkpoint holds goes with so many ranks
    fingerprint = options.ranks and ("%s of %d ranks"):format(fingerprint, options.ranks) or fingerprint }
end

--- One of several ranks' part in the case, whose first one does all else.
local function take_part(options, study, begin)
  local case = sweep.find(sweep.cases(study, options), options.case)
  local settings = settings_of(options, case, "{}", fingerprint_of(study, case, options))
  engine.run(study:scene_of(case), settings, progress_teller(begin), note)
  return 0
end

--- Runs the case; begin() is called once it computes.
local function run(options, study, begin)
  if engine.rank() > 0 then
    return take_part(options, study, begin)
  end
  local cases, names = sweep.cases(study, options)
  local case = sweep.find(cases, options.case)
  local fingerprint = fingerprint_of(study, case, options)
  local made = provenance.begin(options, output.program())
  provenance.keep(options.out, study, output.files_read(study, case))
  local text = manifest(study, case, names, options)
  output.begin(options.out, case, text)
  local folder = output.case_folder(options.out, case)
  local result, answers
  if study.problem then
    begin()
    result, answers = problem.solve(study, case)
  else
    local settings = settings_of(options, case, text, fingerprint)
    settings.beside = derivatives.of(study, case)
    result = engine.run(study:scene_of(case), settings, progress_teller(begin), note)
    derivatives.note(study, case, result)
  end
  engine.watch_lines(true)
  evaluation.note(study, case, result)
  result.fingerprint = fingerprint
  if result.verdict == "finished" then
    evaluation.fill(study, case, result, answers or case_module.new(case.id, case.p, folder))
  end
  result.run, result.point = provenance.ended(made), options.point
  if options["for"] and not claims.may_write(options.out, case.id, options["for"]) then
    return 1 -- another run does it by now: this one was taken for dead
  end
  output.write_result(options.out, case, result)
  if not result.goes_on then
    engine.remove(folder .. "/checkpoint")
  end
  tell { ended = result }
  return result.verdict == "finished" and 0 or 1
end

--- f(...) without noting the lines of scripts, as the sweep has run the same ones before; where that ends with a fault
--- of theirs before anything is computed, again with them, for its place. `computes`: whether that has begun.
local function unwatched(computes, f, ...)
  engine.watch_lines(false)
  local held, value = engine.call(f, ...)
  engine.watch_lines(true)
  if held then
    return value
  elseif computes() or (value.kind ~= "input" and value.kind ~= "script") then
    error(value, 0)
  end
  return f(...)
end

--- The case on its own or, as part of a sweep, in the folder that this holds.
local function run_in(options, followed)
  local begun = false
  local function computes() return begun end
  local study = unwatched(computes, study_module.load, options.study, options.trust)
  local function run_unwatched()
    return unwatched(computes, run, options, study, function() begun = true end)
  end
  if followed then
    return run_unwatched()
  end
  return hold.folder(options.out, study, "case", run_unwatched)
end

return function(options)
  local held, value = engine.call(run_in, options, engine.follow_parent())
  if held then
    return value
  end
  if not tell { fault = tostring(value) .. (value.trace or ""), kind = value.kind } then
    error(value, 0)
  end
  return (value.kind == "input" or value.kind == "script" or value.kind == "changed") and 2 or 1
end
