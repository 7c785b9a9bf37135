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
  fast_bonds = { b = 0.1*N*s/m, steps = 4 }, -- short steps: the last bonds snap within milliseconds
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
  local vertical = axes[#axes]
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
  local steps = p.steps_down * (model.steps or 1)
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
      energy = stiction.probe.energy { audit = model.scheme ~= nil },
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
    b = { 10*N*s/m, "a bond forms in b / w = 0.5 s, a part of the cycle; with 0 it would be whole at the first touch" },
    mesh_size = { 0.2*mm, "20 points over the contact radius; node A is a node" },
    mesh_size_3d = { 0.34*mm, "10 cells to node A; the pull-off is within 2 % of the section's" },
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
    set = { mesh_size_3d = 0.85*mm },
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

  check = function(cases, check)
    local case = {}
    for _, c in ipairs(cases) do case[c.id] = c end

    -- An independent solver of ours: Q1/P0 at 0.2 mm, rigid sphere; the force in the limit of small cells (71.13 N at
    -- 0.2 mm).
    local published = {
      A = { pull_off = 2.40, traction_A = 162.6e3 }, B = { pull_off = 2.71, traction_A = 236e3 },
      C = { pull_off = 3.78, traction_A = 304e3 },
    }
    for set, values in pairs(published) do
      local rigid = case[set .. "_rigid"]
      if rigid then
        check.close(set .. "_rigid: force at full depth", rigid.results.force_depth, 70.95, 0.005)
        check.close(set .. "_rigid: pull-off", rigid.results.pull_off, values.pull_off, 0.02)
        check.close(set .. "_rigid: peak traction at A", rigid.results.traction_A, values.traction_A, 0.02)
      end
    end
    if case.A_rigid then check.equal("A_rigid: node A bonds", case.A_rigid.results.bonded_A, 1.78, 0.03) end
    if case.A_fast_bonds then
      local pull_off = case.A_fast_bonds.results.pull_off
      check.close("A_fast_bonds: pull-off", pull_off, 1.22, 0.02)
      check.within("A_fast_bonds: pull-off between JKR and DMT", pull_off, 0.94, 1.26)
    end

    for _, c in ipairs(cases) do
      local model, set, r = models[c.p.model], sets[c.p.set], c.results
      local rigid = case[c.p.set .. "_rigid"]
      local list = bonded(c, c.p)
      local from, gone, step = {}, {}, 2 * (c.time[2] - c.time[1])
      for i, point in ipairs(list) do from[i], gone[i] = point.from, point.gone end
      check.non_decreasing(c.id .. ": bonds form in order of distance", from, step)
      check.non_increasing(c.id .. ": bonds break from the outside in", gone, step)
      if model.b then -- in the slow limit
        local worst, sigma0 = 0, math.sqrt((set.w * set.C_n) / (1*Pa^2))
        for _, point in ipairs(list) do worst = math.max(worst, math.abs(point.peak / sigma0 - 1)) end
        check.equal(c.id .. ": every bonded point peaks at sqrt(w C_n)", worst, 0, 0.02)
      end
      if rigid and model.space then
        check.close(c.id .. ": force at depth as in the section", r.force_depth, rigid.results.force_depth, 0.02)
        if not cases.quick then
          check.close(c.id .. ": pull-off as in the section", r.pull_off, rigid.results.pull_off, 0.02)
        end
      elseif rigid and model.law then
        check.close(c.id .. ": 31 % less force at depth", r.force_depth, 0.69 * rigid.results.force_depth, 0.02)
        check.close(c.id .. ": the same pull-off", r.pull_off, rigid.results.pull_off, 0.02)
      elseif rigid and model.scheme then
        check.ledger(c)
        check.close(c.id .. ": inertia changes nothing", r.pull_off, rigid.results.pull_off, 0.005)
        check.within(c.id .. ": kinetic over strain energy", r.kinetic_ratio, 0, 1e-4)
      elseif rigid and model.interpolation then
        check.within(c.id .. ": plain cells lock, so they are stiffer",
          r.force_depth / rigid.results.force_depth - 1, 0.001, 0.03)
      elseif rigid and model.deformable then
        local change = math.abs(r.force_depth / rigid.results.force_depth - 1)
        local mesh_error = case.A_coarse and math.abs(case.A_coarse.results.force_depth / rigid.results.force_depth - 1)
        check.within(c.id .. ": change of the force by the sphere's deformation, against the error of the mesh", change,
          0, mesh_error or 0.001)
        check.within(c.id .. ": its cost in cells evaluated, over the rigid sphere's",
          c.cost.cells_evaluated / rigid.cost.cells_evaluated, 1.01, 10)
      end
    end
    if case.A_rigid and case.B_rigid and case.C_rigid then
      check.increasing("higher C_n: higher peak at A",
        { case.A_rigid.results.traction_A, case.B_rigid.results.traction_A, case.C_rigid.results.traction_A })
    end
  end,

  figures = function(cases)
    local figure = stiction.figure
    local case = {}
    for _, c in ipairs(cases) do case[c.id] = c end
    local time, list = { label = "time", unit = "s" }, {}
    local beta = { label = "bond intensity β", unit = "1" }
    local traction = { label = "normal adhesion", unit = "kPa" }

    -- Seven points of set A, as in the paper's figures 3(a) and 3(b).
    local points, wanted = radius(case.A_rigid, case.A_rigid.p), { 0, 0.6, 1.2, 1.8, 2.4, 3.0, 3.4 }
    local function seven(of, y, sign)
      local curves = {}
      for i, d in ipairs(wanted) do
        local best = points[1]
        for _, point in ipairs(points) do
          if math.abs(point.d - d * 1e-3) < math.abs(best.d - d * 1e-3) then best = point end
        end
        curves[i] = { label = string.format("d = %.1f mm", best.d * 1e3), case = of, y = "top/" .. y, component = best.i,
          y_sign = sign, colour = i }
      end
      return curves
    end
    local function by_set(y, sign)
      local curves = {}
      for i, name in ipairs { "A", "B", "C" } do
        local c, set = case[name .. "_rigid"], sets[name]
        if c then
          curves[#curves + 1] = { case = c, y = "A/" .. y, y_sign = sign, colour = i,
            label = string.format("w = %g J/m², Cₙ = %g N/mm³", set.w / (1*J/m^2), set.C_n / (1*N/mm^3)) }
        end
      end
      return curves
    end
    local function lines(name, title, y, curves, extra)
      local t = { name = name, title = title, x = time, y = y, curves = curves, legend = "below" }
      for key, value in pairs(extra or {}) do t[key] = value end
      list[#list + 1] = figure.lines(t)
    end
    lines("figure_3a", "set A", beta, seven(case.A_rigid, "beta"), { colours = "sequential" })
    lines("figure_3b", "set A", traction, seven(case.A_rigid, "adhesion_n", -1), { colours = "sequential" })
    lines("figure_3c", "node A, d = 3.4 mm", beta, by_set "beta")
    lines("figure_3d", "node A, d = 3.4 mm", traction, by_set("adhesion_n", -1))

    -- What the models change: force of the block on the sphere over its height.
    local curves = {}
    local named = { rigid = "rigid sphere, section", deformable = "deformable sphere, section",
      space = "rigid sphere, quarter in space", st_venant_kirchhoff = "St Venant-Kirchhoff" }
    local styles = { rigid = "solid", deformable = "dash", space = "dot", st_venant_kirchhoff = "solid" }
    for i, name in ipairs { "rigid", "deformable", "space", "st_venant_kirchhoff" } do
      local c = case["A_" .. name]
      if c then
        local down = times(c.p)
        local height, f = {}, {}
        for k, value in ipairs(force(c, c.p)) do
          local t = c.time[k] * (1*s)
          height[k] = t < down and -c.p.speed * t or -c.p.depth + c.p.speed * (t - down)
          f[k] = value * N
        end
        curves[#curves + 1] = { label = named[name], x = height, y = f, colour = i, style = styles[name] }
      end
    end
    list[#list + 1] = figure.lines { name = "force", title = "set A", x = { label = "height of the sphere's pole", unit = "mm" },
      y = { label = "force on the sphere", unit = "N" }, curves = curves, legend = "below" }

    -- The peak's drift with the distance: finite at b = 10, none as bonds get fast.
    local drift = {}
    for i, name in ipairs { "A_rigid", "B_rigid", "C_rigid", "A_fast_bonds", "B_fast_bonds", "C_fast_bonds" } do
      local c = case[name]
      if c then
        local d, peak, set = {}, {}, sets[c.p.set]
        local sigma0 = math.sqrt((set.w * set.C_n) / (1*Pa^2))
        for k, point in ipairs(bonded(c, c.p)) do d[k], peak[k] = point.d * m, point.peak / sigma0 end
        drift[#drift + 1] = { label = "set " .. c.p.set .. (models[c.p.model].b and ", b = 0.1 N s/m" or ", b = 10 N s/m"),
          x = d, y = peak, colour = (i - 1) % 3 + 1, style = models[c.p.model].b and "dash" or "solid" }
      end
    end
    list[#list + 1] = figure.lines { name = "peak_traction", x = { label = "distance from the middle", unit = "mm" },
      y = { label = "peak traction / √(w Cₙ)", unit = "1" }, curves = drift, legend = "below" }

    local down = times(case.A_rigid.p)
    local space = case.A_space
    if space then
      local over = select(2, times(space.p))
      list[#list + 1] = figure.field {
        name = "block", title = "set A, while the bonds break", case = space, time = 2 * down, array = "beta",
        label = "bond intensity β", unit = "1", deformed = true, mesh = true, view = { azimuth = 25, elevation = 30 },
        mirror = { "x" }, width = "double", range = { 0, 1 },
        sphere = { centre = { 0*mm, 0*mm, space.p.sphere_radius }, radius = space.p.sphere_radius,
          path = { times = { 0*s, down, over }, z = { 0*mm, -space.p.depth, space.p.above } } },
        window = { -11*mm, 11*mm, -11.5*mm, 6*mm }, window_unit = "mm", crop = { zmax = 2*mm },
      }
    end
    list[#list + 1] = figure.field {
      name = "section", title = "set A at full depth", case = case.A_rigid, time = down, array = "von_mises",
      label = "von Mises stress", unit = "MPa", deformed = true, mesh = true, mirror = { "x" }, width = "double",
      window = { -8*mm, 8*mm, -6*mm, 2*mm }, window_unit = "mm",
      sphere = { centre = { 0*mm, case.A_rigid.p.sphere_radius }, radius = case.A_rigid.p.sphere_radius,
        path = { times = { 0*s, down }, y = { 0*mm, -case.A_rigid.p.depth } } },
    }
    return list
  end,
}
