#!/bin/sh
# What explain says of a study before it runs: text, data, and exit codes.
. "$(dirname "$0")/common.sh"
studies=$here/../../studies

expect 0 "A block on a plane|Body block|material.neo_hookean{young = 1 MPa|unknowns|Pair sole" "$stiction" explain "$tiny"
expect 0 "5 on block.bottom|per point|friction.coulomb{mu = 0}|Numbers of pair sole|one step|memory" "$stiction" explain "$tiny"
expect 0 "Nothing to change" "$stiction" explain "$tiny"
expect 0 "friction.coulomb{mu = 0.4}" "$stiction" explain "$tiny" --case mu0.4
expect 0 "to 1 s in 5 steps" "$stiction" explain "$tiny" --quick
expect 0 "9 on block.bottom" "$stiction" explain "$tiny" --set cells=8
expect 0 "\"warnings\"|\"sections\"|\"case\": \"mu0.4\"|\"unit\": \"m/s\"" "$stiction" explain "$tiny" --case mu0.4 --json
[ -e out ] && complain "explain wrote output"

expect 2 "there is no study at 'nowhere'" "$stiction" explain nowhere
expect 2 "mu0.9" "$stiction" explain "$tiny" --case mu0.9
changed wrong 's/primary = "floor"/primary = "flor"/'
expect 2 "there is no obstacle or set" "$stiction" explain wrong
changed stretched 's/descent = 0.02/descent = 0.3/; s/neo_hookean/linear_elastic/'
expect 0 "What to change|body block will be strained by about 30 %|-> material.neo_hookean{" "$stiction" explain stretched

# a fit: its data, parameters, cases and time, and what would be refused
changed soft 's/^  quick = .*/  fit = { parameters = { young = { 0.1*MPa, 10*MPa, scale = "log", start = 3*MPa }, mu = { 0.02, 0.5, start = 0.15 } },\
    data = { drag = { file = "drag.csv", x = "time", y = "force", sigma = 0.02*units("N\/m"), correlation = 50*units("ms"),\
        against = { x = "time", y = "sole\/force_x", y_sign = -1, after = 1*s } } }, finer = { cells = 8 }, noise = 1e-6 },\
  quick = { sweep = { mu = { 0.2 } }, set = { steps = 5 } },/'
printf 'time [s],force [N/m]\n1.1,0.53\n1.2,1.04\n1.4,2.0\n1.6,2.31\n' >soft/drag.csv
expect 0 "Fit|4 points of drag.csv: time 1.1 to 1.6 s, force 0.53 to 2.31 N/m; standard errors|0.02 N/m, correlated over 0.05 s" \
  "$stiction" explain soft
expect 0 "0.02 to 0.5, from 0.15|0.1 MPa to 10 MPa, logarithmic, from 3 MPa|about 24|starts 1, steps 6, derivatives 4, profiles 12, finer 1" \
  "$stiction" explain soft
expect 0 "120 evaluations| a case, one at a time, finer ones more|Nothing to change" "$stiction" explain soft
expect 0 '"fit": {|"sum": 24|"used": true|"seconds": 0.' "$stiction" explain soft --json
sed 's/finer = { cells = 8 }, noise = 1e-6/starts = 8, profiles = false/' soft/study.lua >soft/many.lua
expect 0 "about 42|starts 8, noise 4, steps 18, derivatives 12;|has neither \`finer\` nor a trade" "$stiction" explain soft/many.lua
sed 's/mu = { 0.02, 0.5, start = 0.15 }/&, cells = { 2, 8 }/' soft/study.lua >soft/mesh.lua
expect 0 "'cells' changes the mesh" "$stiction" explain soft/mesh.lua --json
expect 0 "refused|stiction fit would be refused|stiction help fit" "$stiction" explain soft/mesh.lua
sed 's/drag.csv/drug.csv/' soft/study.lua >soft/lost.lua
expect 0 "refused|drug.csv" "$stiction" explain soft/lost.lua
cp -r soft idle
sed -i 's/young = p.young/young = stiction.units.MPa/' idle/block.lua
expect 0 "NOT USED by the scene|What to change" "$stiction" explain idle
expect 0 "the scene is the same from young = 0.1 MPa to 10 MPa" "$stiction" explain idle --json

sphere=$studies/paper/sphere_indentation
expect 0 "rigid.sphere{centre = {0 m, 10 mm}, radius = 10 mm}|11840 times stiffer" \
  "$stiction" explain "$sphere" --case A_deformable --set mesh_size=0.4mm
expect 0 "lock at nu = 0.48|mean_dilatation" "$stiction" explain "$sphere" --case A_plain --set mesh_size=0.4mm
expect 0 "nothing is fast|scheme.quasi_static{}" "$stiction" explain "$sphere" --case A_inertia --set mesh_size=0.4mm
expect 0 "three-dimensional|Nothing to change" "$stiction" explain "$sphere" --case A_space --quick
expect 0 "Nothing to change" "$stiction" explain "$sphere" --quick
expect 0 "6.67 mm|V* normal|Nothing to change" "$stiction" explain "$studies/paper/plate_on_cylinder" --quick
expect 0 "speed / c_s|Nothing to change" "$stiction" explain "$studies/proofs/bar_impact"
expect 0 "theta = 1/2) with the inertia of contact nodes" "$stiction" explain "$studies/proofs/bar_impact" --case paper
finish
