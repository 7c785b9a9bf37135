-- A sphere drawn off a sticky block that relaxes: the bonds know no rate, and yet hold more the quicker it goes.
local stiction = require "stiction"
local u = stiction.units
local mm, um, s, Pa = u.mm, u.um, u.s, u.Pa
local function at_once(p) -- E0 / E: the bulk modulus stays
  local G0, K = p.young.si * (1 + p.share) / (2 * (1 + p.poisson)), p.young.si / (3 * (1 - 2 * p.poisson))
  return 9 * K * G0 / (3 * K + G0) / p.young.si
end
local function lost(run, p) -- in the bulk while it is drawn off
  return p.share > 0 and run:max("energy", "relaxation_loss") - run:at(p.held, "energy", "relaxation_loss") or 0
end

return stiction.study {
  title = "Sphere drawn off a block that relaxes",
  question = "How much more does a sphere hold that is drawn off quickly, where the bulk alone loses?",
  given = { radius = { 5*mm, "sphere" }, young = { 5e6*Pa, "at rest" }, poisson = { 0.48, "at rest" },
    w = { 1*u.J/u.m^2, "bonds" }, time = { 1*s, "it relaxes in" }, zone = { 0.2*mm, "E*/C, that the bonds span" } },
  chosen = { size = { 5*mm, "20 contact radii" }, held = { 1e4*s, "until all has relaxed" } },
  sweep = { { share = 0, pace = 1 }, { share = 9, pace = 1e-4 }, { share = 9, pace = 1e-3 }, { share = 9, pace = 1e-2 },
    { share = 9, pace = 0.1 }, { share = 9, pace = 1 }, { share = 9, pace = 100 } },
  quick = { sweep = { { share = 0, pace = 1 }, { share = 9, pace = 1e-4 }, { share = 9, pace = 1e-2 }, { share = 9, pace = 100 } } },
  case_id = function(p) return p.share > 0 and ("pace_%g"):format(p.pace) or "elastic" end,
  scene = function(p)
    local h, C, off = p.zone / 10, p.young / (1 - p.poisson ^ 2) / p.zone, p.held + 76*um / (p.pace * p.zone / p.time)
    return stiction.scene { kinematics = "axisymmetric", output = stiction.output { frames = 0 },
      bodies = { block = stiction.body { density = 1000*u.kg/u.m^3, interpolation = "mean_dilatation",
        mesh = stiction.mesh.graded_block { origin = { 0*mm, -p.size }, size = { p.size, p.size }, growth = 1.25,
          fine = { 0.4*mm, 6 * h }, fine_size = h, coarse_size = p.size / 12 },
        material = stiction.material.linear_elastic { young = p.young, poisson = p.poisson },
        relaxing = p.share > 0 and { { share = p.share, time = p.time } } or nil } },
      obstacles = { sphere = stiction.obstacle { times = { 0*s, p.held / 2, p.held, off }, y = { 0*um, -16*um, -16*um, 60*um },
        shape = stiction.rigid.sphere { centre = { 0*mm, p.radius }, radius = p.radius } } },
      motions = { stiction.motion.fix { set = "block.bottom" }, stiction.motion.fix { set = "block.left", y = false } },
      pairs = { contact = stiction.pair { secondary = "block.top", primary = "sphere",
        adhesion = stiction.adhesion.rcc { w = p.w, C_n = C, C_t = 0 * C, b = 0*u.N*s/u.m } } },
      scheme = stiction.scheme.quasi_static {}, schedule = stiction.schedule { stages = {
        stiction.stage { to = p.held, steps = 20 }, stiction.stage { to = off, steps = 200 } } },
      probes = { contact = stiction.probe.contact { pair = "contact" },
        energy = stiction.probe.energy { audit = true } } }
  end,
  results = { { name = "lost", unit = "J", meaning = "in the bulk, while it is drawn off", lost },
    { name = "pull_off", unit = "N", meaning = "largest", function(run) return run:max("contact", "force_y") end } },
  check = function(cases, check)
    local holds, all = cases:values "pull_off", cases:where { share = 9 }
    check.close("drawn off slowly it holds as if nothing relaxed", holds[2], holds[1], 0.03)
    check.non_decreasing("the quicker the more", { table.unpack(holds, 2) }, 0.01 * holds[1])
    check.within("at most E0 / E times as much", holds[#holds] / holds[1], 1.5, at_once(all[1].p))
    check.holds("the bulk loses most in between",
      all:find { pace = 1e-2 }.results.lost > 5 * math.max(all[1].results.lost, all[#all].results.lost))
    check.ledger(all[#all])
  end,
  figures = function(cases)
    local c, at_rest = cases:where { share = 9 }, cases:find { share = 0 }.results.pull_off
    local paces = stiction.numeric.map(c, function(case) return case.p.pace end)
    return { stiction.figure.lines { name = "pull_off", curves = {
      { label = "relaxing", x = paces, y = c:values "pull_off", style = "points" },
      { label = "elastic, at rest", x = { paces[1], paces[#paces] }, y = { at_rest, at_rest } } },
      x = { label = "speed * relaxation time / zone of the bonds", log = true }, y = { label = "pull-off", unit = "mN" } } }
  end,
}
