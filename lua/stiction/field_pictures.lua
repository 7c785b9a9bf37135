-- What pictures of an output's fields need to know: units by name, and whether a case is seen from a side.
local engine = require "stiction.engine"
local fault = require "stiction.fault"
local manifest = require "stiction.manifest"
local ordered = require "stiction.ordered"

local field_pictures = {}

local unit_of = { von_mises = "Pa", cauchy_stress = "Pa", contact_pressure = "Pa", normal_adhesion = "Pa",
  tangential_adhesion = "Pa", displacement = "m", velocity = "m/s", beta = "1", status = "1", gap = "m", friction = "Pa" }

--- The unit of a field; bad input if there is none of this name.
function field_pictures.unit(name)
  local names = ordered.keys(unit_of)
  return unit_of[name] or fault.input("--field: there is no field '%s'%s; fields: %s", name, fault.meant(name, names),
    table.concat(names, ", "))
end

--- Does a case in this folder know its bodies' surfaces only?
local function of_surfaces(scene)
  for _, body in pairs(type(scene) == "table" and scene.bodies or {}) do
    if body.kind == "body.half_space" then
      return true
    end
  end
  return false
end

--- The field that a case in this folder is shown by where none is asked for.
function field_pictures.default(folder)
  return of_surfaces(manifest.read(folder).scene) and "contact_pressure" or "von_mises"
end

--- From where a case in this folder is seen: {} if it is a solid, nil if it is plane.
function field_pictures.view(folder)
  local scene = manifest.read(folder).scene
  if type(scene) ~= "table" or scene.kinematics ~= "three_dimensional" then
    return nil
  end
  return not of_surfaces(scene) and {} or nil -- a surface is seen from above
end

--- The index of the frames that are kept in this folder, nil if there are none.
function field_pictures.file(folder)
  local file = folder .. "/fields.pvd"
  return engine.kind_of_path(file) == "file" and engine.absolute(file) or nil
end

return field_pictures
