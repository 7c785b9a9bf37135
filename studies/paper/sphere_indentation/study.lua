-- Example 4.1 of the paper: a stiff sphere presses on a soft adhesive block and is pulled off again.
--
--              .-'''-.          down by `depth`, then up to `above` over the surface, at `speed`
--             | sphere |
--      ________'-._.-'________
--     |       O    A          |     contact points on "block.top"; A lies at d = 3.4 mm from the middle O
--     |        block          |
--     |_______________________|     held at the bottom, free at the side
--
-- Three sets (w, C_n) times four models of the same scene, and what each model costs and changes: the sphere rigid or
-- deformable, an axisymmetric section or a quarter in space, another bulk law. Then the limit of fast bonds (b = 0.1),
-- plain cells, coarser cells and inertia, each with set A alone.
--
--     ./stiction run studies/paper/sphere_indentation            18 cases
--     ./stiction run studies/paper/sphere_indentation --quick    6 cases on a coarser mesh; run in CI
local stiction = require "stiction"
local units = stiction.units
local mm, m, s, kg, J, N, Pa, MPa = units.mm, units.m, units.s, units.kg, units.J, units.N, units.Pa, units.MPa

local sets = {
  A = { w = 20*J/m^2, C_n = 1e9*N/m^3 },
  B = { w = 20*J/m^2, C_n = 2e9*N/m^3 },
  C = { w = 40*J/m^2, C_n = 2e9*N/m^3 },
}

-- What each model changes in the scene; "rigid" is the one to compare with.
local models = {
  rigid = {},
  deformable = { deformable = true },
  space = { space = true },
  st_venant_kirchhoff = { law = "st_venant_kirchhoff" },
  fast_bonds = { b = 0.1*N*s/m },
  plain = { interpolation = "plain" },
  coarse = { coarser = 2 },
  inertia = { scheme = stiction.scheme.theta_xi {} },
}

local function times(p)
  return p.depth / p.speed, (2 * p.depth + p.above) / p.speed
end

local function cell(p)
  return (models[p.model].coarser or 1) * (models[p.model].space and p.mesh_size_3d or p.mesh_size)
end

local function block(p)
  local model, zero = models[p.model], 0*mm
  local mesh
  if model.space then
    mesh = stiction.mesh.quarter_cylinder {
      radius = p.block_radius, height = p.block_height, fine = { p.fine_radius, p.fine_depth }, fine_size = cell(p),
      coarse_size = 4 * cell(p),
    }
  else
    mesh = stiction.mesh.block {
      origin = { zero, -p.block_height }, size = { p.block_radius, p.block_height },
      cells = { p.block_radius / cell(p), p.block_height / cell(p) },
    }
  end
  return stiction.body {
    mesh = mesh, density = p.block_density, interpolation = model.interpolation or "mean_dilatation",
    material = stiction.material[model.law or "neo_hookean"] { young = p.block_young, poisson = p.block_poisson },
  }
end

local function sphere_body(p)
  return stiction.body {
    mesh = stiction.mesh.quarter_disc {
      centre = { 0*mm, p.sphere_radius }, radius = p.sphere_radius, fine = { 5*mm, 1*mm }, fine_size = cell(p),
      coarse_size = 1*mm,
    },
    density = p.sphere_density,
    material = stiction.material.neo_hookean { young = p.sphere_young, poisson = p.sphere_poisson },
  }
end

local function scene(p)
  local model, set = models[p.model], sets[p.set]
  local down, over = times(p)
  local path = { 0*m, -p.depth, p.above }
  local axes = model.space and { "x", "y", "z" } or { "x", "y" }
  local vertical, zero = axes[#axes], {}
  local function point(d) return model.space and { d, 0*mm, 0*mm } or { d, 0*mm } end
  local centre = model.space and { 0*mm, 0*mm, p.sphere_radius } or { 0*mm, p.sphere_radius }
  local fix, drive = stiction.motion.fix, stiction.motion.drive

  local motions = { fix { set = "block.bottom" } }
  if model.space then
    motions[2] = fix { set = "block.symmetry_x", y = false, z = false }
    motions[3] = fix { set = "block.symmetry_y", x = false, z = false }
  else
    motions[2] = fix { set = "block.left", y = false }
  end
  local bodies, obstacles = { block = block(p) }, nil
  if model.deformable then
    bodies.sphere = sphere_body(p)
    motions[#motions + 1] = fix { set = "sphere.axis", y = false }
    motions[#motions + 1] = drive { set = "sphere.flat", times = { 0*s, down, over }, y = path }
  else
    obstacles = { sphere = stiction.obstacle {
      shape = stiction.rigid.sphere { centre = centre, radius = p.sphere_radius }, times = { 0*s, down, over },
      [vertical] = path,
    } }
  end
  local steps = p.steps_down
  return stiction.scene {
    kinematics = model.space and "three_dimensional" or "axisymmetric",
    bodies = bodies, obstacles = obstacles, motions = motions,
    pairs = {
      contact = stiction.pair {
        secondary = "block.top", primary = model.deformable and "sphere.arc" or "sphere",
        adhesion = stiction.adhesion.rcc { w = set.w, C_n = set.C_n, C_t = 0*N/m^3, b = model.b or p.b },
      },
    },
    scheme = model.scheme or stiction.scheme.quasi_static {},
    schedule = stiction.schedule { stages = {
      stiction.stage { to = down, steps = steps },
      stiction.stage { to = 2 * down, steps = steps },
      stiction.stage { to = over, steps = math.ceil(steps * (p.above / p.depth)) },
    } },
    output = stiction.output { frames = p.frames },
    probes = {
      contact = stiction.probe.contact { pair = "contact" },
      A = stiction.probe.contact_point { pair = "contact", near = point(p.d_A) },
      top = stiction.probe.contact_line { pair = "contact" },
      energy = stiction.probe.energy {},
    },
  }
end

-- The block's force on the sphere, upwards; a quarter model carries a quarter of it.
local function force(run, p)
  local space = models[p.model].space
  local values, result = run:series("contact", space and "force_z" or "force_y"), {}
  for i, f in ipairs(values) do result[i] = -f * (space and 4 or 1) end
  return result
end

local function largest(values, sign)
  local best = 0
  for _, value in ipairs(values) do best = math.max(best, (sign or 1) * value) end
  return best
end

-- Time at which a history first reaches a level, linear between steps; nil if it never does.
local function reaches(time, values, level)
  for i = 2, #values do
    if values[i] >= level then
      return time[i - 1] + (time[i] - time[i - 1]) * (level - values[i - 1]) / (values[i] - values[i - 1])
    end
  end
end

-- The contact points along the radius y = 0: {d =, i =} from the middle outwards, d in m.
local function radius(run, p)
  local space = models[p.model].space
  local points, i = {}, 1
  while pcall(run.series, run, "top", "X", i) do
    if not space or math.abs(run:series("top", "Y", i)[1]) < 1e-9 then
      points[#points + 1] = { d = run:series("top", "X", i)[1], i = i }
    end
    i = i + 1
  end
  table.sort(points, function(a, b) return a.d < b.d end)
  return points
end

-- Of every point of the radius that bonded fully: d, when it bonded, when half of the bond was gone, peak traction.
local function bonded(run, p)
  local list = {}
  for _, point in ipairs(radius(run, p)) do
    local beta = run:series("top", "beta", point.i)
    local from = reaches(run.time, beta, 1)
    if from then
      local gone
      for k = #beta, 1, -1 do
        if beta[k] >= 0.5 then gone = run.time[k] break end
      end
      list[#list + 1] = {
        d = point.d, i = point.i, from = from, gone = gone, peak = largest(run:series("top", "adhesion_n", point.i), -1),
      }
    end
  end
  return list
end

local function ratio_of_energies(run)
  return run:max("energy", "kinetic") / run:max("energy", "strain")
end

return stiction.study {
  title = "Indentation of a soft adhesive block by a stiff sphere (paper, example 4.1)",
  question = "Bonds form and break under a sphere: when, at which traction, and which model of the scene is enough?",

  given = {
    sphere_young = { 7e10*Pa, "4.1" }, sphere_poisson = { 0.3, "4.1" }, sphere_density = { 2500*kg/m^3, "4.1" },
    block_young = { 5*MPa, "4.1" }, block_poisson = { 0.48, "4.1" }, block_density = { 1000*kg/m^3, "4.1" },
    d_A = { 3.4*mm, "figure 3(c): node A" },
  },
  chosen = {
    sphere_radius = { 10*mm, "not in the text" },
    block_radius = { 10*mm, "not in the text; 2.5 times the contact radius" },
    block_height = { 10*mm, "not in the text" },
    depth = { 1.5*mm, "so that node A has the time to bond" },
    speed = { 0.75*mm/s, "down and back in the 4 s of the paper's cycle" },
    above = { 1*mm, "beyond the start, until every bond has gone" },
    b = { 10*N*s/m, "a bond forms in b / w = 0.5 s, a part of the cycle" },
    mesh_size = { 0.2*mm, "20 points over the contact radius; node A is a node" },
    mesh_size_3d = { 0.425*mm, "8 cells to node A; the force is within 2 % of the section's" },
    fine_radius = { 4.25*mm, "a little more than the contact radius at full depth" },
    fine_depth = { 1.7*mm, "where the stress varies fast" },
    steps_down = { 150, "10 um a step, 1/14 of u0 = sqrt(w / C_n)" },
    frames = { 6, "for the pictures" },
  },
  sweep = {
    { set = "A", model = "rigid" }, { set = "A", model = "deformable" }, { set = "A", model = "space" },
    { set = "A", model = "st_venant_kirchhoff" },
    { set = "B", model = "rigid" }, { set = "B", model = "deformable" }, { set = "B", model = "space" },
    { set = "B", model = "st_venant_kirchhoff" },
    { set = "C", model = "rigid" }, { set = "C", model = "deformable" }, { set = "C", model = "space" },
    { set = "C", model = "st_venant_kirchhoff" },
    { set = "A", model = "fast_bonds" }, { set = "B", model = "fast_bonds" }, { set = "C", model = "fast_bonds" },
    { set = "A", model = "plain" }, { set = "A", model = "coarse" }, { set = "A", model = "inertia" },
  },
  quick = {
    sweep = {
      { set = "A", model = "rigid" }, { set = "A", model = "deformable" }, { set = "A", model = "space" },
      { set = "B", model = "rigid" }, { set = "C", model = "rigid" }, { set = "A", model = "fast_bonds" },
    },
    set = { mesh_size_3d = 0.85*mm, steps_down = 75 },
  },
  case_id = function(p) return p.set .. "_" .. p.model end,
  scene = scene,

  results = {
    { name = "force_depth", unit = "N", meaning = "force on the sphere at full depth",
      function(run, p) return largest(force(run, p)) end },
    { name = "pull_off", unit = "N", meaning = "largest force that the bonds hold",
      function(run, p) return largest(force(run, p), -1) end },
    { name = "traction_A", unit = "Pa", meaning = "largest adhesion at node A",
      function(run) return -run:min("A", "adhesion_n") end },
    { name = "bonded_A", unit = "s", meaning = "time at which node A is fully bonded; 0: never",
      function(run) return reaches(run.time, run:series("A", "beta"), 1) or 0 end },
    { name = "kinetic_ratio", unit = "1", meaning = "largest kinetic over largest strain energy", ratio_of_energies },
  },
}
