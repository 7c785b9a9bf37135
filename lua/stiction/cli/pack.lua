-- stiction pack: one archive of an output, which says what its files are and can be verified elsewhere.
local archive = require "stiction.archive"
local crate = require "stiction.crate"
local engine = require "stiction.engine"
local fault = require "stiction.fault"
local outcomes = require "stiction.outcomes"
local provenance = require "stiction.provenance"
local report = require "stiction.report"
local verification = require "stiction.verification"

--- Title and question of the study, as the first case's manifest tells them, and the licence that was given.
local function about(outcome, license)
  for _, case in ipairs(outcome.cases) do
    local manifest = engine.decode_json(engine.read_file(case.folder .. "/manifest.json") or "")
    if type(manifest) == "table" and type(manifest.title) == "string" then
      return { title = manifest.title, question = type(manifest.question) == "string" and manifest.question or "",
        license = license }
    end
  end
  return { title = outcome.folder:match("[^/]+$"), question = "", license = license }
end

local function write(place, outcome, file, license)
  local files = archive.files(outcome.folder)
  local name = engine.absolute(outcome.folder):match("[^/]+$")
  archive.pack(file, outcome.folder, files, name, crate.describe(outcome, files, about(outcome, license)), place)
  local again, all = verification.count(outcome, place), #outcome.cases
  report.line("%s: %d case%s, %d files, %.3g MB; %s", file, all, all == 1 and "" or "s", #files, engine.file_size(file) / 1e6,
    again == 0 and "none can be computed again, as no source of a finished case is kept"
      or ("'stiction verify %s' computes %s again"):format(file, again == all and "them" or ("%d of them"):format(again)))
  local lost = verification.lost(outcome)
  for _, entry in ipairs(lost) do
    report.line("%s: %s", entry.case, entry.reason)
  end
  return #lost == 0 and 0 or 1
end

return function(options)
  local outcome = outcomes.read(outcomes.folder(options.study, options.out))
  local file = options.to or engine.absolute(outcome.folder):match("[^/]+$") .. ".tar.gz"
  if not file:find("%.tar%.gz$") and not file:find("%.tgz$") then
    fault.input("--to: an archive's name ends in .tar.gz or .tgz, unlike %s", file)
  elseif engine.kind_of_path(file) then
    fault.input("there is %s already; choose another name with --to, or remove it", file)
  elseif engine.kind_of_path(engine.absolute(file):match("^(.*)/")) ~= "folder" then
    fault.input("--to: there is no folder for %s", file)
  end
  local writable, lock, words = engine.call(engine.lock, outcome.folder .. "/.lock", "stiction pack")
  if writable and not lock then
    fault.input("%s is in use by %s; wait until that ends", outcome.folder, words)
  end
  local held, value = engine.call(provenance.in_scratch, write, outcome, file, options.license)
  if writable then
    engine.unlock(lock)
  end
  if not held then
    error(value, 0)
  end
  return value
end
