-- Hands a study's figures to the figure program.
local claims = require "stiction.claims"
local engine = require "stiction.engine"
local fault = require "stiction.fault"
local figure = require "stiction.figure"
local jobs = require "stiction.jobs"
local report = require "stiction.report"

local drawing = {}

--- The figure program: beside this one when installed, in its build folder otherwise.
local function find_program()
  local folder = engine.program_folder()
  for _, path in ipairs { folder .. "/stiction-figures", folder .. "/../../postproc/stiction-figures" } do
    if engine.kind_of_path(path) == "file" then
      return path
    end
  end
end

--- f(...) once nobody else draws into this folder.
function drawing.alone(folder, f, ...)
  local own = claims.of(folder)
  local office = own or claims.open(folder, "draws")
  local answers = table.pack(engine.call(office.alone, office, "=figures", f, ...))
  if not own then
    office:close(true)
  end
  if not answers[1] then
    error(answers[2], 0)
  end
  return table.unpack(answers, 2, answers.n)
end

--- Draws what the file `spec` asks for into the folder; false if the figure program failed, nil if there is none.
function drawing.run(spec, folder)
  local program = find_program()
  if not program then
    report.line("figures: not drawn, the figure program was not built; %s says what they show", spec)
    return nil
  end
  local code, text = jobs.program { program, spec, "--out", folder }
  if code ~= 0 then
    engine.complain(("stiction: the figure program failed (exit code %d):\n%s\n"):format(code, text))
  end
  return code == 0
end

--- Draws a figure in the folder `place` and puts what it made there, called `made`, into `file`; false if the figure program
--- failed, nil if there is none.
function drawing.one(place, picture, made, file)
  local spec = place .. "/figures.json"
  engine.write_file(spec, engine.encode_json { figures = { picture } })
  local drawn = drawing.run(spec, place)
  if drawn then
    engine.write_file(file, engine.read_file(place .. "/" .. made) or fault.run("the figure program made no %s", made))
  end
  return drawn
end

--- Writes figures.json and draws into figures/; false if the figure program failed.
function drawing.draw(study, cases, folder)
  if not study.figures then
    return true
  end
  local spec, pictures = folder .. "/figures.json", figure.spec(study, cases)
  if #pictures.figures == 0 then
    report.line("figures: study.figures gives none")
    return true
  end
  engine.write_file(spec, engine.encode_json(pictures, 2) .. "\n")
  return drawing.run(spec, folder .. "/figures") ~= false
end

return drawing
