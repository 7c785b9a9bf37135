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
