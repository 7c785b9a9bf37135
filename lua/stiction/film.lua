-- A film of one case: a field at the times that were kept of its run.
local case_module = require "stiction.case"
local drawing = require "stiction.drawing"
local engine = require "stiction.engine"
local fault = require "stiction.fault"
local field_pictures = require "stiction.field_pictures"
local figure = require "stiction.figure"
local obstacles = require "stiction.obstacles"
local provenance = require "stiction.provenance"
local report = require "stiction.report"

local film = {}

--- Writes a film of the one case that is left into `file`; options.field, frames, rate or nil; false if the figure program
--- failed.
function film.draw(outcome, cases, file, options)
  if not file:find("%.ogv$") then
    fault.input("--animate: a film's name ends in .ogv (Ogg/Theora), unlike %s", file)
  elseif #cases ~= 1 then
    fault.input("--animate: a film shows one case, and %d are chosen; give --case ID, one of those that "
      .. "'stiction show %s' lists", #cases, outcome.folder)
  end
  local case = cases[1]
  local field = options.field or field_pictures.default(case.folder)
  local unit = field_pictures.unit(field)
  if not field_pictures.file(case.folder) then
    fault.input("--animate: case %s has no fields (fields.pvd); a scene's output{ frames = ... } says how many", case.name)
  end
  local kept = #obstacles.frame_times(case)
  if options.frames and options.frames > kept then
    fault.input("--frames %g: case %s has %d, and a film shows 2 of them or more; more are kept where output{ frames = ... } "
      .. "says so", options.frames, case.name, kept)
  end
  local run = case_module.new(case.name, {}, case.folder, engine.absolute(case.folder))
  local picture = figure.field { name = "film", title = case.name, case = run, array = field, unit = unit, deformed = true,
    view = field_pictures.view(case.folder), film = { frames = options.frames, rate = options.rate } }
  local drawn = provenance.in_scratch(drawing.one, picture, "film.ogv", file)
  if drawn then
    report.line("%s: %s of case %s over its time", file, field, case.name)
  end
  return drawn
end

return film
