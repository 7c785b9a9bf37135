-- The patch test of contact: uniform pressure through the interface of two blocks, whatever their meshes.
--
--     v v v v v v v v   pressure                     v v v v v v v v
--    +---------------+                              +---------------+
--    |     upper     |   exact: the same pressure   |          ___--| <- pressure all round
--    +-+-+-+-+-+-+-+-+   everywhere                 |   ___---      | <-
--    |     lower     |                              |---            | <-
--    +---------------+  "flat"                      +---------------+  "inclined" and "curved" (plane, by gmsh)
--     held in y, its left side in x
--
-- In statics contact alone cannot hold the upper block: one corner of its top is led to where the exact solution has it.
--
-- Poisson's ratio is zero and both blocks have the same modulus, so nothing slides and no friction is needed.
-- "tied": the blocks are one, by constraint.tied instead of a pair.
-- "matching": nodes face nodes. "nonmatching": 3 cells below, 4 above (2 and 3 in space), times `level`.
--
--     ./stiction run studies/proofs/patch_test
local stiction = require "stiction"
local units = stiction.units
local m, s, kg, Pa = units.m, units.s, units.kg, units.Pa
local mesh, numeric = stiction.mesh, stiction.numeric

local rise = 0.15 -- of the inclined interface over the middle, and of the curved one's crown, m

local quadratic = { quad8 = true, tri6 = true, hex20 = true, tet10 = true }

local function is_space(p)
  return p.kind:find("^hex") ~= nil or p.kind:find("^tet") ~= nil
end

local function is_quadratic(p)
  return quadratic[p.kind] == true
end

--- Cells across and in height: {below, above}.
local function counts(p)
  local below, above = 3, 4
  if is_space(p) then
    below, above = 2, 3
  end
  return { below * p.level, (p.interface == "matching" and below or above) * p.level }
end

--- A block that stands on z (y in the plane) = base, n cells along every side.
local function block(p, base, n)
  if is_space(p) then
    return mesh.box { origin = { 0*m, 0*m, base * m }, size = { 1*m, 1*m, 1*m }, cells = { n, n, n }, kind = p.kind }
  end
  return mesh.block { origin = { 0*m, base * m }, size = { 1*m, 1*m }, cells = { n, n }, kind = p.kind }
end

--- Height of the interface's ends and of its middle over 0.
local shapes = { inclined = { left = -rise, right = rise }, curved = { left = 0, right = 0, middle = rise } }

--- The end (1 or 0, y) of the interface; through its middle if that is curved.
local function interface_edge(shape, right, name)
  local edge = { to = { (right and 1 or 0) * m, (right and shape.right or shape.left) * m }, name = name }
  if shape.middle then
    edge.through = { 0.25*m, 0.75 * shape.middle * m, 0.5*m, shape.middle * m, 0.75*m, 0.75 * shape.middle * m }
    if not right then
      edge.through = { 0.75*m, 0.75 * shape.middle * m, 0.5*m, shape.middle * m, 0.25*m, 0.75 * shape.middle * m }
    end
  end
  return stiction.edge(edge)
end

local function edge(x, y, name)
  return stiction.edge { to = { x * m, y * m }, name = name }
end

--- Lower and upper block with a common edge that is not level.
local function shaped_blocks(p)
  local shape, n = shapes[p.interface], counts(p)
  return {
    lower = mesh.gmsh { size = 1 / n[1] * m, kind = p.kind, start = { 0*m, -1*m }, edges = {
      edge(1, -1, "bottom"), edge(1, shape.right, "right"), interface_edge(shape, false, "top"), edge(0, -1, "left") } },
    upper = mesh.gmsh { size = 1 / n[2] * m, kind = p.kind, start = { 0*m, shape.left * m }, edges = {
      interface_edge(shape, true, "bottom"), edge(1, 1, "right"), edge(0, 1, "top"), edge(0, shape.left, "left") } },
  }
end

local function is_flat(p)
  return shapes[p.interface] == nil
end

--- Nodes whose displacement gives the stress at the interface: {name =, set =, near =, depth =} in both blocks, along
--- the edges that stand on it; depth 0 at the interface, 1 at the other end of the edge, 0.5 at its middle.
local function edge_nodes(p)
  local nodes = {}
  for b, body in ipairs { "lower", "upper" } do
    local n = counts(p)[b]
    for i = 0, n do
      for j = 0, is_space(p) and n or 0 do
        for _, depth in ipairs(is_quadratic(p) and { 0, 0.5, 1 } or { 0, 1 }) do
          local z = (b == 1 and -1 or 1) * depth / n * m
          local near = is_space(p) and { i / n * m, j / n * m, z } or { i / n * m, z }
          nodes[#nodes + 1] = { name = ("%s_%d_%d_%d"):format(body, i, j, 2 * depth), set = body .. ".all", near = near }
        end
      end
    end
  end
  return nodes
end

local function motions(p)
  local fix, list = stiction.motion.fix, {}
  for _, body in ipairs { "lower", "upper" } do
    if is_space(p) then
      list[#list + 1] = fix { set = body .. ".left", y = false, z = false }
      list[#list + 1] = fix { set = body .. ".front", x = false, z = false }
    else
      list[#list + 1] = fix { set = body .. ".left", y = false }
    end
  end
  local times, path = { 0*s, 1*s }, { 0*m, -2 * (p.pressure / p.young) * m }
  if is_space(p) then
    list[#list + 1] = fix { set = "lower.bottom", x = false, y = false }
    list[#list + 1] = stiction.motion.drive { set = "upper.top", near = { 0*m, 0*m, 1*m }, times = times, z = path }
  else
    list[#list + 1] = fix { set = "lower.bottom", x = false }
    list[#list + 1] = stiction.motion.drive { set = "upper.top", near = { 0*m, 1*m }, times = times, y = path }
  end
  return list
end

local function loads(p)
  local traction, times, path = stiction.load.traction, { 0*s, 1*s }, { 0*Pa, -p.pressure }
  local list = { traction { set = "upper.top", times = times, [is_space(p) and "z" or "y"] = path } }
  if not is_flat(p) then
    list[2] = traction { set = "upper.right", times = times, x = path }
    list[3] = traction { set = "lower.right", times = times, x = path }
  end
  return list
end

local function scene(p)
  local n = counts(p)
  local meshes = is_flat(p) and { lower = block(p, -1, n[1]), upper = block(p, 0, n[2]) } or shaped_blocks(p)
  local bodies = {}
  for name, its in pairs(meshes) do
    bodies[name] = stiction.body { mesh = its, density = p.density,
      material = stiction.material.linear_elastic { young = p.young, poisson = 0 } }
  end
  local tied = p.method == "tied"
  local probes = { points = not tied and stiction.probe.contact_line { pair = "joint" } or nil }
  for _, node in ipairs(is_flat(p) and edge_nodes(p) or {}) do
    probes[node.name] = stiction.probe.node { set = node.set, near = node.near }
  end
  return stiction.scene {
    kinematics = is_space(p) and "three_dimensional" or "plane_strain",
    bodies = bodies, motions = motions(p), loads = loads(p), probes = probes,
    pairs = not tied and { joint = stiction.pair { secondary = "upper.bottom", primary = "lower.top",
      discretisation = p.method } } or nil,
    constraints = tied and { stiction.constraint.tied { set = "upper.bottom", to = "lower.top" } } or nil,
    scheme = stiction.scheme.quasi_static {}, control = stiction.control {
      force_tolerance = (p.method ~= "node_to_segment" and p.interface ~= "curved") and 1e-12 or 1e-9 },
    schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = 1 } } },
  }
end

--- Pressures of the contact points: {x, p}, ascending in x.
local function pressures(run)
  local points = {}
  for k = 1, math.maxinteger do
    local found, X = pcall(run.series, run, "points", "X", k)
    if not found then
      break
    end
    points[k] = { x = X[1], p = run:last("points", "pressure", k) }
  end
  table.sort(points, function(a, b) return a.x < b.x end)
  return points
end

--- Compressive stress at the interface in the edge that stands on it at i, j (the cells' own, not averaged): the
--- derivative of the displacement along the edge.
local function stress(run, p, body, i, j)
  local function u(depth)
    return run:last(("%s_%d_%d_%d"):format(body, i, j, 2 * depth), is_space(p) and "u_z" or "u_y")
  end
  local h = 1 / counts(p)[body == "lower" and 1 or 2]
  local slope = (is_quadratic(p) and 4 * u(0.5) - 3 * u(0) - u(1) or u(1) - u(0)) / h
  return p.young.si * slope * (body == "lower" and 1 or -1)
end

--- The one of the list farthest from the pressure, Pa.
local function farthest(values, p)
  local off = numeric.map(values, function(value) return value - p.pressure.si end)
  return p.pressure.si + numeric.extreme(off)
end

--- Stress of one block along x at j = 0: {x, stress}.
local function profile(run, p, body)
  local n, x, values = counts(p)[body == "lower" and 1 or 2], {}, {}
  for i = 0, n do
    x[i + 1], values[i + 1] = i / n, stress(run, p, body, i, 0)
  end
  return x, values
end

local function worst_stress(run, p)
  local values = {}
  for b, body in ipairs { "lower", "upper" } do
    local n = counts(p)[b]
    for i = 0, n do
      for j = 0, is_space(p) and n or 0 do
        values[#values + 1] = stress(run, p, body, i, j)
      end
    end
  end
  return farthest(values, p)
end

local function worst_pressure(run, p)
  if p.method == "tied" then
    return worst_stress(run, p)
  end
  return farthest(numeric.map(pressures(run), function(point) return point.p end), p)
end

--- What a case is judged by: the stress where meshes have edges that stand on the interface, the contact pressure else.
local function judged(run, p)
  return is_flat(p) and worst_stress(run, p) or worst_pressure(run, p)
end

local function miss(case)
  return math.abs(case.results.judged / case.p.pressure.si - 1)
end

local function cases_of(kinds, interfaces, levels, methods)
  local cases = {}
  for _, interface in ipairs(interfaces) do
    for _, kind in ipairs(kinds) do
      for _, level in ipairs(levels) do
        for _, method in ipairs(methods or { "node_to_segment", "mortar" }) do
          cases[#cases + 1] = { kind = kind, interface = interface, level = level, method = method }
        end
      end
    end
  end
  return cases
end

local names = { node_to_segment = "node to segment", mortar = "mortar", tied = "tied" }
local plane, space = { "quad4", "tri3", "quad8", "tri6" }, { "hex8", "tet4", "hex20", "tet10" }

local function joined(...)
  local all = {}
  for _, list in ipairs { ... } do
    table.move(list, 1, #list, #all + 1, all)
  end
  return all
end

local function percents(cases)
  return table.concat(numeric.map(cases, function(case) return ("%.3g %%"):format(100 * miss(case)) end), ", ")
end

--- A row of the report for all levels of one kind of cells, interface and method.
local function row(check, cases, tolerance, note)
  local fine = cases[#cases]
  local p = fine.p
  check.proof {
    case = ("Patch, %s, %s, %s"):format(p.interface, p.kind, names[p.method]),
    quantity = is_flat(p) and "stress farthest from the pressure" or "contact pressure farthest from the applied one",
    unit = "Pa", kind = "exact", source = "uniform pressure", reference = p.pressure, tolerance = tolerance,
    values = numeric.map(cases, function(case) return { 1 / counts(case.p)[1], case.results.judged } end),
    resolution = "m cell", run = fine, note = note,
  }
end

local function check_matching(check, nodes, mortar)
  row(check, mortar, 1e-10)
  row(check, nodes, 1e-10)
end

local function check_nonmatching(check, nodes, mortar)
  row(check, mortar, 1e-3, "node to segment misses by " .. percents(nodes))
  for i, case in ipairs(mortar) do
    check.holds(case.id .. ": at least 10 times better than node to segment", 10 * miss(case) < miss(nodes[i]))
    check.holds(case.id .. ": to rounding", miss(case) < 1e-10)
  end
end

--- Facets of two meshes along an arc leave gaps and overlap, so there is no exact patch; with curved facets they fade.
local function check_curved(check, nodes, mortar)
  local finest = #mortar
  check.non_increasing(mortar[1].p.kind .. " along an arc: mortar's miss falls", numeric.map(mortar, miss))
  check.holds(mortar[1].p.kind .. " along an arc: mortar at least 10 times better on the finest mesh",
    10 * miss(mortar[finest]) < miss(nodes[finest]))
end

local checks = { matching = check_matching, nonmatching = check_nonmatching, inclined = check_nonmatching,
  curved = check_curved }
local interfaces = { "matching", "nonmatching", "inclined", "curved" }

--- f(node-to-segment cases, mortar cases) of every interface and kind of cells that was run, levels ascending.
local function each_kind(cases, f)
  for _, interface in ipairs(interfaces) do
    for _, kind in ipairs(joined(plane, space)) do
      local its = cases:where { interface = interface, kind = kind }
      if #its:where { method = "mortar" } > 0 then
        f(its:where { method = "node_to_segment" }, its:where { method = "mortar" }, interface)
      end
    end
  end
end

--- Tied meshes, whose stress is uniform to rounding.
local function check_tied(cases, check)
  for _, kind in ipairs(joined(plane, space)) do
    local its = cases:where { method = "tied", kind = kind }
    if #its > 0 then
      row(check, its, 1e-10)
    end
  end
end

local function profile_figure(cases)
  local curves, styles = {}, { node_to_segment = "solid", mortar = "points" }
  for k, kind in ipairs { "quad4", "quad8", "tri6" } do
    for _, method in ipairs { "node_to_segment", "mortar" } do
      local its = cases:where { interface = "nonmatching", kind = kind, method = method }
      if #its > 0 then
        local x, values = profile(its[#its], its[#its].p, "lower")
        curves[#curves + 1] = { label = kind .. (method == "mortar" and ", mortar" or ", node to segment"), x = x,
          y = values, style = styles[method], colour = k }
      end
    end
  end
  local p = cases[1].p
  curves[#curves + 1] = { label = "exact", x = { 0, 1 }, y = { p.pressure.si, p.pressure.si }, style = "dash", colour = 5 }
  return stiction.figure.lines { name = "stress", title = "Stress of the lower block at a nonmatching interface",
    x = { label = "x", unit = "m" }, y = { label = "compressive stress", unit = "Pa" }, curves = curves, legend = "below" }
end

local function miss_figure(cases, space_or_plane, widest)
  local curves, colour = {}, 0
  each_kind(cases, function(nodes, mortar, interface)
    if interface ~= "nonmatching" or is_space(nodes[1].p) ~= (space_or_plane == "space") then
      return
    end
    colour = colour + 1
    for _, its in ipairs { nodes, mortar } do
      curves[#curves + 1] = { x = numeric.map(its, function(case) return counts(case.p)[1] end),
        y = numeric.map(its, function(case) return 100 * math.max(miss(case), 1e-16) end), colour = colour,
        style = its == nodes and "solid" or "points",
        label = nodes[1].p.kind .. (its == nodes and ", node to segment" or ", mortar") }
    end
  end)
  curves[#curves + 1] = { label = "allowed: 0.1 %", x = { 2, widest }, y = { 0.1, 0.1 }, style = "dash", colour = 6 }
  return stiction.figure.lines { name = "miss_" .. space_or_plane,
    title = "Largest deviation of the stress, nonmatching interface",
    x = { label = "cells across the lower block", unit = "1" }, y = { label = "deviation (%)", unit = "1", log = true },
    curves = curves, legend = "below" }
end

local function field_figure(cases)
  local figures = {}
  for _, method in ipairs { "node_to_segment", "mortar" } do
    local case = cases:find { interface = "nonmatching", kind = "quad4", level = 2, method = method }
    figures[#figures + 1] = stiction.figure.field { name = method, case = case, time = "last", array = "cauchy_stress",
      component = 2, label = "stress in y", unit = "Pa", mesh = true, range = { -10.5*Pa, -9.5*Pa },
      title = method == "mortar" and "mortar" or "node to segment" }
  end
  return stiction.figure.panel { name = "field", columns = 2, figures = figures }
end

return stiction.study {
  title = "Patch test of contact",
  question = "Does uniform pressure pass through an interface whose meshes do not match?",
  given = { pressure = { 10*Pa, "" }, young = { 1000*Pa, "" }, density = { 1*kg/m^3, "not used in statics" } },
  sweep = joined(cases_of(plane, { "matching", "nonmatching", "inclined" }, { 1, 2, 4 }),
    cases_of({ "quad8", "tri6" }, { "curved" }, { 2, 4, 8 }),
    cases_of(space, { "matching", "nonmatching" }, { 1, 2 }),
    cases_of(joined(plane, space), { "nonmatching" }, { 1, 2 }, { "tied" })),
  quick = { sweep = joined(cases_of({ "quad4", "tri6" }, { "matching", "nonmatching", "inclined" }, { 1, 2 }),
    cases_of({ "hex8", "tet10" }, { "nonmatching" }, { 1 }),
    cases_of({ "quad8", "tri3", "hex8", "tet10" }, { "nonmatching" }, { 1 }, { "tied" })) },
  case_id = function(p)
    return ("%s_%s_%s_%d"):format(p.interface, p.kind, p.method == "node_to_segment" and "nts" or p.method, p.level)
  end,
  scene = scene,
  results = {
    { name = "judged", unit = "Pa", judged,
      meaning = "stress at the interface farthest from the pressure; not flat: the contact pressure instead" },
    { name = "pressure", unit = "Pa", meaning = "contact pressure farthest from the applied one; tied: the stress",
      worst_pressure },
  },
  check = function(cases, check)
    each_kind(cases, function(nodes, mortar, interface) checks[interface](check, nodes, mortar) end)
    check_tied(cases, check)
  end,
  figures = function(cases)
    return { profile_figure(cases), miss_figure(cases, "plane", 12), miss_figure(cases, "space", 4), field_figure(cases) }
  end,
}
