-- Constructors, conversion to the engine's input, JSON, order of walking, the sandbox.
local test, equal, fails = ...
local stiction = require "stiction"
local engine = require "stiction.engine"
local loader = require "stiction.loader"
local ordered = require "stiction.ordered"

test("constructors tag their table with kind and line, also in a tail call", function()
  local function tail()
    return stiction.material.blatz_ko {}
  end
  local part = tail()
  equal(engine.part(part), "material.blatz_ko")
  equal(engine.part {}, "")
end)

test("unknown categories and kinds are told with what was meant", function()
  fails("stiction has no 'materail'; did you mean 'material'?", function() return stiction.materail end)
  fails("there is no material.blatz_k; did you mean 'blatz_ko'?", function() return stiction.material.blatz_k end)
  fails("material needs a kind", function() return stiction.material {} end)
  fails("material.blatz_ko takes one table", function() return stiction.material.blatz_ko(3) end)
end)

test("heights that are a function become numbers at the points of a relief, of which other parts keep the function", function()
  local u = stiction.units
  local ramp = stiction.surface.map { heights = function(x, y) return 10 * x + y end }
  local relief = stiction.relief { set = "top", surface = ramp, size = { 2*u.m, 1*u.m }, points = { 4, 2 } }
  equal(table.concat(relief.surface.heights, " "), "-7.75 -2.75 2.25 7.25 -7.25 -2.25 2.75 7.75")
  equal(engine.part(relief.surface), "surface.map")
  equal(type(ramp.heights), "function")
end)

test("a study asks what explain tells of a scene", function()
  local u = stiction.units
  local told = stiction.explain(stiction.scene {
    bodies = { block = stiction.body { mesh = stiction.mesh.block { size = { 1*u.m, 1*u.m }, cells = { 2, 2 } }, density = 1*u.kg/u.m^3,
      material = stiction.material.linear_elastic { young = 1*u.Pa, poisson = 0 } } },
    motions = { stiction.motion.fix { set = "block.bottom" } }, scheme = stiction.scheme.quasi_static {},
    schedule = stiction.schedule { stages = { stiction.stage { to = 1*u.s, steps = 1 } } },
  })
  equal(told.sections[1].title, "Body block")
  equal(#told.warnings, 0)
end)

local function refused(part, value)
  fails(part, engine.validate, { thing = value })
end

test("what cannot be part of a scene is refused with its path", function()
  local cycle = {}
  cycle.again = { cycle }
  refused("thing: a function cannot be part of a scene", print)
  refused("thing: nan is not a finite number", math.abs(0/0))
  refused("thing: inf is not a finite number", math.huge)
  refused("thing.again[1]: this table contains itself", cycle)
  refused("thing.a[2]: a function cannot", { a = { 1, print } })
  refused("thing: this table mixes names and list elements", { 1, a = 2 })
  refused("thing: this list has holes: 2 elements, but the last one is number 3", { [1] = 1, [3] = 3 })
  refused("thing: a key of this table is neither", { [true] = 1 })
  refused("thing: a key of this table is neither", { [1.5] = 1 })
end)

test("JSON keeps every digit, sorts names, and reads back", function()
  local value = engine.decode_json(engine.encode_json { b = { 1, 2.5, "x\n" }, a = true, c = 0.1 })
  equal(value.b[2], 2.5)
  equal(value.c, 0.1)
  equal(engine.encode_json { b = 1, a = 0.1 }, '{"a":0.1,"b":1}')
  equal(engine.encode_json {}, "[]")
  equal(engine.encode_json { x = 0/0 }, '{"x":null}')
  equal(engine.decode_json("{\"a\": "), nil)
  fails("a list or have names only", engine.encode_json, { a = { [1.5] = 2 } })
end)

test("tables are walked in one order", function()
  equal(table.concat(ordered.keys { b = 1, a = 1, [2] = 1, [1] = 1 }, " "), "1 2 a b")
end)

test("a script sees neither files nor clock, and cannot reach the library", function()
  local function use(text)
    return engine.load_script(text, "x.lua", loader.environment(false))
  end
  for _, name in ipairs { "os.execute", "os.clock", "os.getenv", "io.open", "io.lines" } do
    fails("x.lua:1: " .. name .. " is not there: a study is kept from running programs", use(name .. "('x')"))
    fails("--trust", use(name .. "('x')"))
  end
  for _, name in ipairs { "load", "loadfile", "dofile", "debug.getinfo", "package.path", "collectgarbage",
    "math.randomseed" } do
    fails(name .. " is not there: ", use("local x = " .. name .. "('x')"))
  end
  local environment = loader.environment(false)
  engine.load_script("string.format = nil", "x.lua", environment)()
  equal(type(string.format), "function")
  equal(engine.load_script("return getmetatable('')", "x.lua", environment)(), false)
  equal(type(loader.environment(true)), "table")
end)

test("files of parts stand from the folder of the study on, and a scene knows them", function()
  local parts = require "stiction.parts"
  local own = require "stiction.api"("/studies/own")
  local body = own.body { mesh = own.mesh.msh_file { path = "meshes/block.msh" } }
  local scene = { bodies = { a = body, b = { mesh = body.mesh } },
    obstacles = { own.obstacle { shape = own.rigid.surface { path = "/data/head.stl" } } } }
  scene.again = scene
  equal(body.mesh.path, "/studies/own/meshes/block.msh")
  equal(table.concat(parts.files(scene), " "), "/studies/own/meshes/block.msh /data/head.stl")
  equal(stiction.mesh.msh_file { path = "block.msh" }.path, "block.msh")
  equal(#parts.files { stiction.mesh.block {}, 3, "words" }, 0)
end)
