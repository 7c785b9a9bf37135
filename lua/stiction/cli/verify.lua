-- stiction verify: cases recomputed from the source that is kept with them, beside what was kept.
local archive = require "stiction.archive"
local engine = require "stiction.engine"
local outcomes = require "stiction.outcomes"
local provenance = require "stiction.provenance"
local report = require "stiction.report"
local verification = require "stiction.verification"

local most = 20 -- lines of a kind

local function show_first(list, line)
  for i = 1, math.min(#list, most) do
    report.line("%s", line(list[i]))
  end
  if #list > most then
    report.line("and %d more", #list - most)
  end
end

local function plural(count, word)
  return ("%d %s%s"):format(count, word, count == 1 and "" or "s")
end

local function number(x)
  return type(x) == "number" and engine.number_text(x) or "none"
end

--- Files against the metadata of a packed output; true if all are there and as packed.
local function check_files(folder)
  if engine.kind_of_path(folder .. "/" .. archive.metadata) ~= "file" then
    return true
  end
  local complaints = archive.complaints(folder)
  show_first(complaints, function(words) return "file: " .. words end)
  if #complaints == 0 then
    report.line("all files are what %s lists", archive.metadata)
  end
  return #complaints == 0
end

local function check_summary(outcome)
  local lost = verification.lost(outcome)
  show_first(lost, function(entry) return ("%s: %s"):format(entry.case, entry.reason) end)
  local list = verification.summary(outcome)
  show_first(list, function(entry)
    return ("summary.csv: %s: %s is %s, but %s in the case's own file"):format(entry.case, entry.name,
      number(entry.got), number(entry.kept))
  end)
  return #list == 0 and #lost == 0
end

local function how_compared(found, tolerance)
  if found.foreign == 0 then
    return "computed by this program on this processor, so to the last bit"
  end
  return ("%s by another build of the program, on another processor or by several ranks, so within %g of the largest value of the "
    .. "result; the largest difference is %.2g"):format(found.foreign == found.cases and "computed"
    or plural(found.foreign, "case"), tolerance, found.largest)
end

local function show(found, asked, all, tolerance)
  report.line()
  show_first(found.left, function(entry) return ("%s: not recomputed: %s"):format(entry.case, entry.reason) end)
  show_first(found.differences, function(entry)
    return ("%s: %s was %s, is now %s"):format(entry.case, entry.name, number(entry.kept), number(entry.got))
  end)
  show_first(found.others, function(entry)
    return ("%s: series.h5 %s"):format(entry.case, entry.gone and "is gone" or "is not what the kept source gives")
  end)
  report.line("%d of %s%s recomputed from the kept source: %s", found.cases, plural(asked, "case"),
    asked < all and (" chosen of %d"):format(all) or "", how_compared(found, tolerance))
  report.line("%d of %s equal to the last bit, %d differ%s too much", found.equal, plural(found.values, "result"),
    #found.differences, #found.differences == 1 and "s" or "")
  if found.histories > 0 then
    report.line("%d of %d histor%s equal to the last bit; fields are not compared", found.histories - #found.others, found.histories,
      found.histories == 1 and "y" or "ies")
  end
end

local function verify(place, options)
  local packed = archive.is(options.study)
  local folder = packed and archive.unpack(options.study, place) or outcomes.folder(options.study, options.out)
  local tolerance = verification.tolerance(options)
  local outcome = outcomes.read(folder)
  local good = check_files(folder)
  good = check_summary(outcome) and good
  local cases, all = verification.choose(outcome, options.sample)
  if all == 0 then
    report.line("no case has finished: there is nothing to recompute")
    return 1
  end
  local found = verification.recompute(place .. "/again", outcome, cases, options, tolerance)
  show(found, #cases, all, tolerance)
  if found.stopped then
    engine.complain("stiction: stopped\n")
  end
  return good and not found.stopped and found.cases == #cases and #found.differences == 0 and #found.others == 0 and 0
    or 1
end

return function(options)
  return provenance.in_scratch(verify, options)
end
