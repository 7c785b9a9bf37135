#!/bin/sh
# One, two and three threads of a case: the same histories to the last bit, of scenes of every kind large enough to be shared.
. "$(dirname "$0")/common.sh"
scale=${2:-1} # of their sizes

mkdir shared
cat >shared/study.lua <<'L'
local stiction = require "stiction"
local u = stiction.units
local mm, s, MPa, kg, m, J, N = u.mm, u.s, u.MPa, u.kg, u.m, u.J, u.N

local function plate(p, bonds) -- pressed and dragged
  local n = 8 * math.floor(9 * p.scale)
  return { bodies = { block = stiction.body { density = 1000*kg/m^3,
      mesh = stiction.mesh.block { size = { 10*mm, 5*mm }, cells = { n, n / 2 } },
      material = stiction.material.neo_hookean { young = 5*MPa, poisson = 0.4 } } },
    pairs = { sole = stiction.pair { secondary = "block.bottom", primary = "floor",
      friction = stiction.friction.coulomb { mu = 0.4 }, adhesion = bonds } } }
end

local function box(p, material, bulk) -- the same in space
  local n = 2 * math.floor(8 * p.scale)
  return { kinematics = "three_dimensional", control = stiction.control { bulk = bulk },
    bodies = { block = stiction.body { density = 1000*kg/m^3, material = material,
      mesh = stiction.mesh.box { size = { 10*mm, 10*mm, 5*mm }, cells = { n, n, n / 2 } } } },
    pairs = { sole = stiction.pair { secondary = "block.bottom", primary = "floor",
      friction = stiction.friction.coulomb { mu = 0.3 } } } }
end

local function mortar(p)
  local n = 16 * math.floor(5 * p.scale)
  local parts = plate(p)
  parts.bodies.ground = stiction.body { density = 1000*kg/m^3,
    mesh = stiction.mesh.block { origin = { -5*mm, -5*mm }, size = { 20*mm, 5*mm }, cells = { n, n / 4 } },
    material = stiction.material.neo_hookean { young = 2*MPa, poisson = 0.3 } }
  parts.pairs.sole = stiction.pair { secondary = "block.bottom", primary = "ground.top", discretisation = "mortar",
    friction = stiction.friction.coulomb { mu = 0.4 } }
  parts.motions = { stiction.motion.fix { set = "ground.bottom" } }
  return parts
end

local hooke = stiction.material.linear_elastic { young = 5*MPa, poisson = 0.3 }
local kinds = {
  plane = plate,
  bonded = function(p) return plate(p, stiction.adhesion.rcc { w = 1*J/m^2, C_n = 1e9*N/m^3, C_t = 1e9*N/m^3,
    b = 0.01*N*s/m }) end,
  mortar = mortar,
  space = function(p) return box(p, stiction.material.neo_hookean { young = 5*MPa, poisson = 0.3 }, "direct") end,
  linear = function(p) return box(p, hooke, "direct") end,
  multigrid = function(p) return box(p, hooke, "multigrid") end,
}

return stiction.study {
  title = "Shared by threads",
  given = { scale = 1 },
  sweep = { kind = { "plane", "bonded", "mortar", "space", "linear", "multigrid" } },
  scene = function(p)
    local parts = kinds[p.kind](p)
    local down = parts.kinematics and "z" or "y"
    parts.motions = parts.motions or {}
    local drive = { set = "block.top", times = { 0*s, 1*s, 2*s }, x = { 0*mm, 0*mm, 0.1*mm }, y = { 0*mm, 0*mm, 0*mm } }
    drive[down] = { 0*mm, -0.1*mm, -0.1*mm }
    table.insert(parts.motions, stiction.motion.drive(drive))
    if not parts.bodies.ground then
      parts.obstacles = { floor = stiction.obstacle { shape = stiction.rigid.plane {} } }
    end
    parts.scheme = stiction.scheme.quasi_static {}
    parts.schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = 2 }, stiction.stage { to = 2*s, steps = 2 } } }
    parts.probes = { sole = stiction.probe.contact { pair = "sole" }, line = stiction.probe.contact_line { pair = "sole" },
      energy = stiction.probe.energy {} }
    return stiction.scene(parts)
  end,
}
L
sed -i "s/given = { scale = 1 }/given = { scale = $scale }/" shared/study.lua

for threads in 1 2 3; do
  expect 0 "" "$stiction" run shared --no-figures --jobs 1 --threads $threads --out by$threads
  holds "the manifest says $threads threads" grep -q "\"threads\": *$threads" by$threads/kindplane/manifest.json
done
cat >same.lua <<'L'
local engine = require "stiction.engine"
local test, equal = ...
for _, id in ipairs { "plane", "bonded", "mortar", "space", "linear", "multigrid" } do
  for _, threads in ipairs { 2, 3 } do
    test(("%s by %d threads"):format(id, threads), function()
      local a, b = engine.read_series("by1/kind" .. id .. "/series.h5"), engine.read_series("by" .. threads .. "/kind" .. id .. "/series.h5")
      local columns = engine.series_columns(a)
      equal(#columns > 10, true)
      for _, name in ipairs(columns) do
        local u, v = engine.series_column(a, name), engine.series_column(b, name)
        equal(#u, #v)
        for i = 1, #u do
          if string.pack("d", u[i]) ~= string.pack("d", v[i]) then
            equal(("%s row %d: %.17g"):format(name, i, v[i]), ("%.17g"):format(u[i]))
          end
        end
      end
    end)
  end
end
L
"$stiction" luatest same.lua >output 2>&1 || complain "$(cat output)"

# the number of threads is not what a case is made of
expect 0 "kindplane  finished" "$stiction" run shared --list --threads 2 --out by1
expect 2 "--threads" "$stiction" run shared --threads 0
expect 2 "--threads" "$stiction" run shared --threads two
expect 2 "--threads" "$stiction" bench shared --threads 9999
finish
