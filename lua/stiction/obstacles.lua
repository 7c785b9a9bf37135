-- The rigid obstacles of a case, as plane pictures draw them.
local engine = require "stiction.engine"
local manifest = require "stiction.manifest"
local ordered = require "stiction.ordered"

local obstacles = {}

--- Numbers as a manifest writes them, alone or in lists, in SI.
local function plain(value)
  if type(value) ~= "table" then
    return value
  elseif value.value ~= nil then
    return plain(value.value)
  end
  local list = {}
  for i, entry in ipairs(value) do
    list[i] = plain(entry)
  end
  return list
end

local shape_of = {
  ["rigid.plane"] = function(shape)
    return { point = plain(shape.point) or { 0, 0 }, normal = plain(shape.normal) or { 0, 1 } }
  end,
  ["rigid.circle"] = function(shape)
    return { centre = plain(shape.centre) or { 0, 0 }, radius = plain(shape.radius) }
  end,
  ["rigid.torus"] = function(shape) -- its section
    local centre = plain(shape.centre) or { 0, 0 }
    return { centre = { plain(shape.major_radius), centre[2] }, radius = plain(shape.minor_radius) }
  end,
  ["rigid.polyline"] = function(shape)
    return { points = plain(shape.points), closed = plain(shape.closed) or nil }
  end,
}
shape_of["rigid.sphere"] = shape_of["rigid.circle"]
shape_of["rigid.height_map"] = function(_, settings) -- over its size, as a line
  return settings and settings.profile and { points = plain(settings.profile) }
end

--- The times of a case's frames, s.
function obstacles.frame_times(case)
  local times = {}
  for time in (engine.read_file(case.folder .. "/fields.pvd") or ""):gmatch('timestep="([^"]+)"') do
    times[#times + 1] = tonumber(time)
  end
  return times
end

--- Name of the probe that says where an obstacle is, nil if there is none.
local function probe_of(scene, obstacle)
  for _, name in ipairs(ordered.keys(scene.probes or {})) do
    local probe = scene.probes[name]
    if type(probe) == "table" and probe.kind == "probe.rigid" and probe.obstacle == obstacle then
      return name
    end
  end
end

--- Where it goes: as it was told to, or, where a probe follows it, as at the frames.
local function path_of(case, scene, name)
  local given, probe = scene.obstacles[name], probe_of(scene, name)
  if probe then
    local path = { times = obstacles.frame_times(case), x = {}, y = {}, angle = {} }
    for i, time in ipairs(path.times) do
      path.x[i], path.y[i] = case:at(time, probe, "u_x"), case:at(time, probe, "u_y")
      path.angle[i] = case:at(time, probe, "angle")
    end
    return #path.times > 0 and path or nil
  end
  return given.times and { times = plain(given.times), x = plain(given.x), y = plain(given.y), angle = plain(given.angle) }
end

--- A list of {centre =, radius =}, {point =, normal =} or {points =, closed =}, with path, pivot and hollow, in SI; nil
--- where none can be drawn. One that is free and followed by no probe is left out, as nothing tells where it is.
--- `moving`: on their paths, else as at the start.
function obstacles.of(case, moving)
  local written = manifest.read(case.folder)
  local scene, settings = written.scene, (written.settings or {}).obstacles or {}
  if type(scene) ~= "table" or scene.kinematics == "three_dimensional" then
    return nil
  end
  local list = {}
  for _, name in ipairs(ordered.keys(scene.obstacles or {})) do
    local given = scene.obstacles[name]
    local make = shape_of[given.shape.kind]
    local followed = not moving or (plain(given.mass) or 0) == 0 or probe_of(scene, name)
    local entry = make and followed and make(given.shape, settings[name])
    if entry then
      entry.hollow = given.shape.side == "inside" or nil
      entry.pivot = plain(given.pivot)
      entry.path = moving and path_of(case, scene, name) or nil
      list[#list + 1] = entry
    end
  end
  return #list > 0 and list or nil
end

return obstacles
