-- What each kind of probe records, asked of the engine with small scenes that have one of each.
local engine = require "stiction.engine"
local stiction = require "stiction"
local units = stiction.units
local m, s, kg, Pa = units.m, units.s, units.kg, units.Pa

local columns = {}

local fillers = {
  plane_strain = { pair = "pair", set = "body.top", obstacle = "obstacle", body = "body", spring = "spring",
    near = { 0*m, 1*m } },
  three_dimensional = { pair = "pair", set = "body.top", obstacle = "obstacle", body = "body",
    spring = "spring", near = { 0*m, 0*m, 1*m } },
}

local function probe_of(kind, filler, audit)
  local t = {}
  for _, parameter in ipairs(kind.parameters) do
    t[parameter.name] = parameter.required and filler[parameter.name] or nil
    if parameter.name == "audit" then
      t.audit = audit
    end
  end
  return stiction.probe[kind.name](t)
end

local function scene_of(kinds, kinematics)
  local filler, plane, probes = fillers[kinematics], kinematics == "plane_strain", {}
  for _, kind in ipairs(kinds) do
    probes[kind.name] = probe_of(kind, filler, true)
  end
  local mesh = plane and stiction.mesh.block { size = { 1*m, 1*m }, cells = { 1, 1 } }
    or stiction.mesh.box { size = { 1*m, 1*m, 1*m }, cells = { 1, 1, 1 } }
  return stiction.scene {
    kinematics = kinematics,
    bodies = { body = stiction.body { mesh = mesh, density = 1*kg/m^3, relaxing = { { share = 1, time = 1*s } },
      material = stiction.material.linear_elastic { young = 1*Pa, poisson = 0 } } },
    obstacles = { obstacle = stiction.obstacle { shape = stiction.rigid.plane(plane and {} or { normal = { 0, 0, 1 } }) } },
    pairs = { pair = stiction.pair { secondary = "body.bottom", primary = "obstacle" } },
    motions = { stiction.motion.fix { set = "body.top" } },
    loads = { -- what is above the body up to a point is as good as a cavity
      stiction.load.gas { set = "body.top", times = { 0*s, 1*s }, volume = { 1, 1 },
        centre = plane and { 0*m, 2*m } or { 0*m, 0*m, 2*m } },
      stiction.load.surface_stress { set = "body.top", gamma = 1*units.N/m },
    },
    springs = { spring = stiction.spring { from = "body.top", stiffness = 1*units.N/m } },
    probes = probes,
    schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = 1 } } },
  }
end

local of_half_spaces = { contact = true, rigid = true, energy = true }

--- A half space with one of each kind that records more or other things there.
local function half_space_scene(kinds)
  local probes, filler = {}, fillers.three_dimensional
  for _, kind in ipairs(kinds) do
    probes[kind.name] = of_half_spaces[kind.name] and probe_of(kind, filler, nil) or nil
  end
  return stiction.scene {
    kinematics = "three_dimensional",
    bodies = { body = stiction.body.half_space { young = 1*Pa, poisson = 0, size = { 1*m, 1*m }, points = { 2, 2 } } },
    obstacles = { obstacle = stiction.obstacle.height_map { surface = stiction.surface.sphere { radius = 1*m },
      times = { 0*s, 1*s }, z = { 1*m, 1*m } } },
    scheme = stiction.scheme.quasi_static {},
    pairs = { pair = stiction.pair { secondary = "body.surface", primary = "obstacle" } },
    probes = probes,
    schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = 1 } } },
  }
end

--- By kind of probe a list of {name, unit, meaning}, of the kinds of the catalog's category "probe".
function columns.by_kind(kinds)
  local found, plane, known = {}, {}, {}
  local in_plane = engine.probe_columns(scene_of(kinds, "plane_strain"))
  for _, column in ipairs(in_plane) do
    plane[column.probe .. "/" .. column.name] = column.unit
  end
  for _, column in ipairs(engine.probe_columns(scene_of(kinds, "three_dimensional"))) do
    local unit, list = plane[column.probe .. "/" .. column.name], found[column.probe] or {}
    local note = not unit and " (in space)" or unit ~= column.unit and (" (%s in plane strain)"):format(unit) or ""
    list[#list + 1] = { column.name, column.unit .. note, column.meaning }
    found[column.probe] = list
    known[column.probe .. "/" .. column.name] = true
  end
  for _, column in ipairs(in_plane) do
    if not known[column.probe .. "/" .. column.name] then
      table.insert(found[column.probe], { column.name, column.unit .. " (in the plane)", column.meaning })
    end
  end
  for _, column in ipairs(engine.probe_columns(half_space_scene(kinds))) do
    if not known[column.probe .. "/" .. column.name] then
      table.insert(found[column.probe], { column.name, column.unit .. " (of half spaces)", column.meaning })
    end
  end
  return found
end

return columns
