-- A soft block pressed onto a rigid plane and pulled off it again: how hard does it hold?
-- Change a number, run again; 'stiction explain' this study before, 'stiction help TOPIC' for every part of it.
local stiction = require "stiction"
local units = stiction.units -- numbers carry units: 5*mm; what does not fit together is refused
local mm, m, s, kg, J, N, MPa = units.mm, units.m, units.s, units.kg, units.J, units.N, units.MPa

return stiction.study {
  title = "A sticky block", question = "Does the pull-off force follow from the bond's strength?",
  given = { -- what is known from elsewhere
    width = 4*mm, height = 2*mm, young = 1*MPa, C = { 2e8*N/m^3, "of a whole bond" },
  },
  chosen = { -- what is yours, each with its reason; '--set cells=16' on the command line replaces one
    cells = { 8, "along the width; it is pulled evenly" }, steps = { 200, "on the way up; meet the peak within 1 %" },
  },
  sweep = { w = { 0.5*J/m^2, 1*J/m^2 } }, -- energy to break the bonds; each value is a case of its own
  quick = { set = { cells = 4 } }, -- what 'stiction run --quick' changes
  scene = function(p) -- the block stands on y = 0
    local block = stiction.mesh.block { size = { p.width, p.height }, cells = { p.cells, p.cells // 2 } }
    return stiction.scene {
      bodies = { block = stiction.body { mesh = block, density = 1000*kg/m^3,
        material = stiction.material.neo_hookean { young = p.young, poisson = 0 } } },
      obstacles = { plane = stiction.obstacle { shape = stiction.rigid.plane {} } },
      pairs = { sole = stiction.pair { secondary = "block.bottom", primary = "plane", -- bonds grow while it is pressed
        adhesion = stiction.adhesion.rcc { w = p.w, C_n = p.C, C_t = 0*N/m^3, b = 0.01*N*s/m } } },
      motions = { stiction.motion.drive { set = "block.top", times = { 0*s, 1*s, 2*s }, -- straight lines in between
        x = { 0*mm, 0*mm, 0*mm }, y = { 0*mm, -0.05*mm, 0.2*mm } } },
      scheme = stiction.scheme.quasi_static {}, -- slow: without inertia
      schedule = stiction.schedule { stages = {
        stiction.stage { to = 1*s, steps = p.steps // 4 }, stiction.stage { to = 2*s, steps = p.steps } } },
      probes = { sole = stiction.probe.contact { pair = "sole" }, top = stiction.probe.node { -- histories
        set = "block.top", near = { 0*mm, p.height } } },
    }
  end,
  results = { -- one number each of every case: columns of summary.csv
    { name = "pull_off", unit = "N/m", meaning = "largest force that the bonds hold, per depth",
      function(run) return -run:min("sole", "force_y") end },
  },
  check = function(cases, check) -- what this study claims; one that fails ends the run with exit code 1
    for _, case in ipairs(cases) do
      local p = case.p -- pulled evenly: all bonds bear their largest traction sqrt(w C) at once
      local strength = math.sqrt(p.w.si * p.C.si) * p.width.si
      check.close("strength of the bonds, " .. case.id, case.results.pull_off, strength, 0.02)
    end
  end,
  figures = function(cases)
    local curves = {}
    for i, case in ipairs(cases) do
      curves[i] = { label = ("w = %g J/m²"):format(case.p.w.si), case = case, x = "top/u_y", y = "sole/force_y" }
    end
    return { stiction.figure.lines { name = "force", title = "Pressed, then pulled off", curves = curves,
      x = { label = "way of the top", unit = "mm" }, y = { label = "force on the block", unit = "N/m" } } }
  end,
}
