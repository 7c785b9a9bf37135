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
holds "a case ran where none could" [ -z "$(find out/unknown out/mesh out/flag -name series.h5 2>/dev/null)" ]
finish
