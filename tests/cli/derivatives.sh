#!/bin/sh
# Derivatives of results: their columns, what a study makes of them, where there are none, what is refused.
. "$(dirname "$0")/common.sh"

changed drag 's/sweep = {/derivatives = { "mu", "young" }, sweep = {/'
sed -i 's/results = {/results = { { name = "slope", unit = "N\/m", meaning = "of friction over mu", function(run)\
  return run.p.mu > 0 and run:derivative("mu", function(r) return -r:last("sole", "force_x") end) or 0 end },/' drag/study.lua
expect 0 "no derivatives with respect to mu, which is 0|checks held" "$stiction" run drag --no-figures --jobs 1
column() { # CASE NAME: a number of summary.csv
  awk -F, -v case="$1" -v name="$2" 'NR == 1 { for (i = 1; i <= NF; ++i) at[$i] = i } $1 == case { print $at[name] }' out/drag/summary.csv
}
holds "derivatives at mu = 0: $(cat out/drag/summary.csv)" [ "$(column mu0 d_force_x_d_mu)" = nan ]
# all of its points slide: friction is mu times the force, which is proportional to E
awk -v d="$(column mu0.2 d_force_x_d_mu)" -v own="$(column mu0.2 slope)" -v e="$(column mu0.2 d_force_y_d_young)" \
  -v fx="$(column mu0.2 force_x)" -v fy="$(column mu0.2 force_y)" 'function off(a, b) { return a > b ? a / b - 1 : 1 - a / b }
  BEGIN { exit !(off(d, own) < 1e-9 && off(e * 1e6, fy) < 1e-4 && off(d * 0.2, fx) < 0.2) }' ||
  complain "derivatives are not those of a sliding block: $(cat out/drag/summary.csv)"
"$stiction" run drag --list >listed
holds "finished cases are to run again: $(cat listed)" [ "$(grep -c finished listed)" = 3 ]

"$stiction" show out/drag --columns case,d_force_x_d_mu --csv shown.csv >/dev/null
holds "show has no derivatives: $(cat shown.csv)" grep -q "^mu0.2,[1-9]" shown.csv
expect 0 "and their derivatives with respect to mu, young, of a run beside the case each" "$stiction" explain drag

# nothing runs where they cannot be
changed unknown 's/sweep = {/derivatives = { "nu" }, sweep = {/'
expect 2 "study.derivatives: the study has no parameter 'nu'" "$stiction" run unknown --no-figures
changed mesh 's/sweep = {/derivatives = { "cells" }, sweep = {/'
expect 2 "no derivatives with respect to cells: with it a little smaller there is no scene|block.cells" "$stiction" run mesh --no-figures
expect 2 "no derivatives with respect to cells: " "$stiction" explain mesh
changed flag 's/sweep = {/derivatives = { "word" }, sweep = {/; s/given = {/given = { word = "x",/'
expect 2 "study.derivatives: 'word' is x; only of a number there are derivatives" "$stiction" run flag --no-figures
changed zero 's/sweep = {/derivatives = { "mu" }, sweep = {/; s/run:at(2\*s, "sole", "force_x")/run:derivative("mu", function(r) return r:last("sole", "force_x") end)/'
expect 1 "case mu0 has no derivatives with respect to 'mu', which is 0 in it|mu0.2  finished" "$stiction" run zero --no-figures --jobs 1
# a case that has run without them is not taken for one that has them, though their scenes cannot be made
changed twice 's/given = {/given = { word = "x",/'
expect 0 "checks held" "$stiction" run twice --no-figures
sed -i 's/sweep = {/derivatives = { "word" }, sweep = {/' twice/study.lua
expect 2 "only of a number there are derivatives" "$stiction" run twice --no-figures
changed bare 's/run:at(2\*s, "sole", "force_x")/run:derivative("mu", function(r) return r:last("sole", "force_x") end)/'
expect 1 "has no derivatives with respect to 'mu'; the study asks for them: derivatives" "$stiction" run bare --no-figures --jobs 1
# a cavity of given volume: one correction is far from it
mkdir -p filled
cat >filled/study.lua <<'E'
local stiction = require "stiction"
local u = stiction.units
local m, s = u.m, u.s
return stiction.study { title = "A filled tube", question = "How does its pressure grow?", given = { v = 2, young = 1*u.MPa },
  derivatives = { "v", "young" },
  scene = function(p)
    return stiction.scene { kinematics = "axisymmetric", bodies = { tube = stiction.body { density = 1000*u.kg/m^3,
        mesh = stiction.mesh.block { origin = { 1*m, 0*m }, size = { 1*m, 0.2*m }, cells = { 4, 1 }, kind = "quad8" },
        material = stiction.material.neo_hookean { young = p.young, poisson = 0.4 } } },
      motions = { stiction.motion.fix { set = "tube.all", y = true } },
      loads = { stiction.load.gas { set = "tube.left", times = { 0*s, 1*s }, volume = { 1, p.v } } },
      scheme = stiction.scheme.quasi_static {},
      schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = 8 } } },
      probes = { gas = stiction.probe.gas { set = "tube.left" } } }
  end,
  results = { { name = "p", unit = "Pa", meaning = "pressure", function(run) return run:last("gas", "pressure") end } } }
E
number() { # STUDY SETTING NAME: a number of its summary with that setting
  rm -rf "out/$1"
  "$stiction" run "$1" --no-figures --set "$2" >ran 2>&1 || cat ran
  awk -F, -v name="$3" 'NR == 1 { for (i = 1; i <= NF; ++i) at[$i] = i } NR == 2 { print $at[name] }' "out/$1/summary.csv"
}
less=$(number filled v=1.99 p) more=$(number filled v=2.01 p) own=$(number filled v=2 p)
slope=$(number filled v=2 d_p_d_v) young=$(number filled v=2 d_p_d_young)
awk -v a="$less" -v b="$more" -v d="$slope" -v p="$own" -v e="$young" 'function off(x, y) { return x > y ? x / y - 1 : 1 - x / y }
  BEGIN { exit !(off(d, (b - a) / 0.02) < 1e-3 && off(e * 1e6, p) < 1e-4) }' ||
  complain "derivatives of a given volume: p $less $own $more, dp/dv $slope, dp/dE $young"
# a viscous disc that strikes a floor and rubs on it: what a step leaves undone of a difference in speed would add up
mkdir -p struck
cat >struck/study.lua <<'E'
local stiction = require "stiction"
local u = stiction.units
local mm, m, s, ms, Pa = u.mm, u.m, u.s, u.ms, u.Pa
return stiction.study { title = "A viscous disc", question = "How much does it keep?", given = { visc = 100*Pa*s },
  derivatives = { "visc" },
  scene = function(p)
    return stiction.scene { bodies = { disc = stiction.body { density = 1000*u.kg/m^3, velocity = { 0.3*m/s, 0.5*m/s },
        mesh = stiction.mesh.half_disc { centre = { 0*mm, -5.2*mm }, radius = 5*mm, size = 1*mm },
        material = stiction.material.neo_hookean { young = 1*u.MPa, poisson = 0.4 },
        damping = stiction.damping.kelvin_voigt { shear_viscosity = p.visc, bulk_viscosity = p.visc } } },
      obstacles = { floor = stiction.obstacle { shape = stiction.rigid.plane { normal = { 0, -1 } } } },
      pairs = { touch = stiction.pair { secondary = "disc.arc", primary = "floor", friction = stiction.friction.coulomb { mu = 0.3 } } },
      schedule = stiction.schedule { stages = { stiction.stage { to = 6*ms, steps = 300 } } }, output = stiction.output { frames = 0 },
      probes = { energy = stiction.probe.energy {} } }
  end,
  results = { { name = "kept", unit = "J/m", meaning = "kinetic energy", function(run) return run:last("energy", "kinetic") end } } }
E
less=$(number struck 'visc=99.9 Pa s' kept) more=$(number struck 'visc=100.1 Pa s' kept)
slope=$(number struck 'visc=100 Pa s' d_kept_d_visc)
awk -v a="$less" -v b="$more" -v d="$slope" 'BEGIN { x = d / ((b - a) / 0.2); exit !(x > 0.997 && x < 1.003) }' ||
  complain "derivative of a struck disc: kept $less $more, d/dvisc $slope"
holds "a case ran where none could" [ -z "$(find out/unknown out/mesh out/flag -name series.h5 2>/dev/null)" ]
finish
