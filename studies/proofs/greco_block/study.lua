-- The friction benchmark of Raous, Chabrand and Lebon (1988): a long bar pressed on a rigid plane and pushed
-- from its side; half of it, with symmetry at its middle.
--
--        50 MPa   v v v v v v v v
--   150 MPa  --> +---------------+|
--            --> |    40 mm      || symmetry: u_x = 0
--            --> |               ||
--        (0,0)   +---------------+|  u_y = 0 at (40 mm, 0)
--   ------------ rigid plane, mu = 1: open near x = 0, then slip, then stick
--
--     ./stiction run studies/proofs/greco_block
local stiction = require "stiction"
local units = stiction.units
local mm, MPa, GPa, s, kg, m = units.mm, units.MPa, units.GPa, units.s, units.kg, units.m

-- u_x (m) at x (m): our own converged values (128 x 128 bilinear cells of another program), and the mean of the
-- codes in the publication
local reference = {
  x = { 0, 1.25e-3, 5e-3, 7.5e-3, 11.25e-3 },
  ours = { 2.8602e-5, 2.7225e-5, 2.2867e-5, 1.9807e-5, 1.5413e-5 },
  published = { 2.86e-5, 2.72e-5, 2.28e-5, 1.98e-5, 1.50e-5 },
}

local function scene(p)
  local probes = { line = stiction.probe.contact_line { pair = "support" }, energy = stiction.probe.energy {} }
  for i, x in ipairs(reference.x) do
    probes["at_" .. i] = stiction.probe.node { set = "bar.bottom", near = { x*m, 0*mm } }
  end
  return stiction.scene {
    bodies = {
      bar = stiction.body {
        mesh = stiction.mesh.block { size = { p.side, p.side }, cells = { p.cells, p.cells }, kind = p.kind },
        material = stiction.material.linear_elastic { young = p.young, poisson = p.poisson }, density = p.density,
      },
    },
    obstacles = { plane = stiction.obstacle { shape = stiction.rigid.plane {} } },
    pairs = {
      support = stiction.pair { secondary = "bar.bottom", primary = "plane",
        friction = stiction.friction.coulomb { mu = p.mu } },
    },
    motions = {
      stiction.motion.fix { set = "bar.right", y = false },
      stiction.motion.fix { set = "bar.bottom", near = { p.side, 0*mm }, x = false },
    },
    loads = {
      stiction.load.traction { set = "bar.top", times = { 0*s, 1*s }, y = { 0*MPa, -p.top } },
      stiction.load.traction { set = "bar.left", times = { 0*s, 1*s }, x = { 0*MPa, p.side_pressure } },
    },
    scheme = stiction.scheme.quasi_static {},
    schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = 1 } } },
    probes = probes,
  }
end

local results = {}
for i in ipairs(reference.x) do
  results[i] = { name = "u_" .. i, unit = "m", meaning = "u_x at x = " .. reference.x[i] .. " m",
    function(run) local u = run:series("at_" .. i, "u_x"); return u[#u] end }
end
local function edge(inside)
  return function(run, p)
    local x = 0
    local count = p.cells * (p.kind == "quad8" and 2 or 1)
    for k = 1, count + 1 do
      local status = run:series("line", "status", k)
      if inside(status[#status]) then
        x = (k - 1) / count * p.side:to("m")
      end
    end
    return x
  end
end
results[#results + 1] = { name = "open_to", unit = "m", meaning = "last node that is open", edge(function(w) return w == 0 end) }
results[#results + 1] = { name = "slip_to", unit = "m", meaning = "last node that slides", edge(function(w) return w == 2 end) }

return stiction.study {
  title = "Friction benchmark of Raous, Chabrand and Lebon",
  question = "Where does a pushed bar open, slide and stick, and how far does it slip?",
  given = {
    side = { 40*mm, "" }, young = { 130*GPa, "" }, poisson = { 0.2, "" }, mu = { 1, "" },
    top = { 50*MPa, "" }, side_pressure = { 150*MPa, "" }, density = { 1000*kg/m^3, "not used in statics" },
  },
  sweep = { { kind = "quad4", cells = 32 }, { kind = "quad4", cells = 64 }, { kind = "quad4", cells = 128 },
    { kind = "quad8", cells = 32 } },
  quick = { sweep = { { kind = "quad4", cells = 32 }, { kind = "quad4", cells = 64 } } },
  case_id = function(p) return p.kind .. "_" .. p.cells end,
  scene = scene,
  results = results,
  check = function(cases, check)
    local quads = cases:where { kind = "quad4" }
    local fine = quads[#quads]
    for i, x in ipairs(reference.x) do
      local values = {}
      for k, case in ipairs(quads) do
        values[k] = { case.p.side / case.p.cells, case.results["u_" .. i] }
      end
      check.proof { case = "GRECO block", quantity = ("u_x at %g mm"):format(1e3 * x), unit = "um", kind = "ours",
        source = "128 x 128 Q4 of another program", reference = reference.ours[i], values = values,
        resolution = "m cell", tolerance = 0.005, run = fine }
    end
    local edge_values = { {}, {} }
    for k, case in ipairs(quads) do
      edge_values[1][k] = { case.p.side / case.p.cells, case.results.open_to }
      edge_values[2][k] = { case.p.side / case.p.cells, case.results.slip_to }
    end
    for i, row in ipairs { { "opens up to", 3.3e-3 }, { "slides up to", 29.8e-3 } } do
      check.proof { case = "GRECO block", quantity = row[1], unit = "mm", kind = "ours", source = "128 x 128 Q4 of another program",
        reference = row[2], values = edge_values[i], resolution = "m cell", scale = fine.p.side / fine.p.cells,
        tolerance = 1, run = fine, note = "error in cells of the finest mesh" }
    end
    if not cases.quick then
      local quad8 = cases:find { kind = "quad8", cells = 32 }
      check.close("quadratic cells agree at x = 0", quad8.results.u_1, reference.ours[1], 0.005)
    end
  end,
  figures = function(cases)
    local curves = {}
    for _, case in ipairs(cases) do
      local x, u = {}, {}
      for i, place in ipairs(reference.x) do
        x[i], u[i] = place, case.results["u_" .. i]
      end
      curves[#curves + 1] = { label = case.p.kind .. ", " .. case.p.cells .. "² cells", x = x, y = u }
    end
    curves[#curves + 1] = { label = "reference (ours, 128²)", x = reference.x, y = reference.ours, style = "dash" }
    curves[#curves + 1] = { label = "published mean", x = reference.x, y = reference.published, style = "dot" }
    return { stiction.figure.lines { name = "slip", title = "Tangential displacement of the lower side",
      x = { label = "x", unit = "mm" }, y = { label = "uₓ", unit = "um" }, curves = curves } }
  end,
}
