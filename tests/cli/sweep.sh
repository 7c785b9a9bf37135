#!/bin/sh
# A sweep: outputs, checks, resuming, --force, --jobs, --case, --quick, --set, --list, figures, bench.
. "$(dirname "$0")/common.sh"

expect 0 "mu0  to run" "$stiction" run "$tiny" --list
expect 0 "checks held|output: out/tiny" "$stiction" run "$tiny" --jobs 2 --no-figures
for file in summary.csv checks.json mu0/series.h5 mu0.2/manifest.json mu0.4/manifest.json; do
  holds "$file is missing" [ -s "out/tiny/$file" ]
done
holds "the head of summary.csv" grep -q '^case,mu,force_y,force_x,verdict,steps,iterations,contact,seconds,set,warnings$' out/tiny/summary.csv
holds "three finished rows" [ "$(grep -c ',finished,' out/tiny/summary.csv)" = 3 ]
holds "what answered contact" grep -q ",finished,[0-9]*,[0-9]*,newton [0-9]*," out/tiny/summary.csv
expect 0 "mu0.4  finished" "$stiction" run "$tiny" --list

# the same with one job: the same numbers to the last bit
expect 0 "checks held" "$stiction" run "$tiny" --jobs 1 --no-figures --out single
for id in mu0 mu0.2 mu0.4; do
  holds "$id differs with --jobs" cmp "out/tiny/$id/series.h5" "single/$id/series.h5"
done
holds "summaries differ" [ "$(cut -d, -f1-7 out/tiny/summary.csv)" = "$(cut -d, -f1-7 single/summary.csv)" ]

# nothing to do: no case is started; a lost or failed case is run again, --force runs all
expect 0 "checks held" "$stiction" run "$tiny" --no-figures
holds "a finished case was run again" [ "$(grep -c started output)" = 0 ]
rm out/tiny/mu0.2/manifest.json
sed -i 's/"finished"/"not converged"/' out/tiny/mu0.4/manifest.json
expect 1 "mu0.2 (to run), mu0.4 (not converged)" "$stiction" results "$tiny"
expect 0 "mu0.2  started (1 of 2)|mu0.4  started (2 of 2)" "$stiction" run "$tiny" --no-figures --jobs 1
expect 0 "mu0  started (1 of 3)" "$stiction" run "$tiny" --no-figures --force

expect 0 "mu0.2  started (1 of 1)" "$stiction" run "$tiny" --quick --out quick2 --no-figures
expect 0 "mu0.3  finished" "$stiction" run "$tiny" --set mu=0.3 --out fixed --no-figures
holds "one row" [ "$(wc -l <fixed/summary.csv)" = 2 ]
expect 0 "1 of 3 cases finished" "$stiction" run "$tiny" --case mu0.2 --out one --no-figures
expect 0 "checks held" "$stiction" run "$tiny" --quick --out one --no-figures
holds "checks of two cases" [ -s one/checks.json ]
expect 0 "1 of 3 cases finished" "$stiction" run "$tiny" --case mu0.2 --out one --no-figures
holds "the checks of an earlier run are left as if of this" [ ! -e one/checks.json ]

# contact problems kept for solve; a run that keeps others runs anew
expect 0 "mu0.2  started (1 of 1)" "$stiction" run "$tiny" --quick --problems 10 --out kept --no-figures
holds "of every tenth step" [ -s kept/mu0.2/problems/000010.h5 ] && holds "of others" [ ! -e kept/mu0.2/problems/000005.h5 ]
expect 0 "converged by    newton" "$stiction" solve kept/mu0.2/problems/000010.h5 --with newton
expect 0 '"converged": true|"method": "newton"|"force": [|"displacement": [|"free": [' \
  "$stiction" solve kept/mu0.2/problems/000010.h5 --with newton --json
expect 0 "checks held" "$stiction" run "$tiny" --quick --problems 10 --out kept --no-figures
holds "kept once" [ "$(grep -c started output)" = 0 ]
expect 0 "mu0.2  started (1 of 1)" "$stiction" run "$tiny" --quick --problems 4 --out kept --no-figures
holds "of every fourth step alone: $(ls kept/mu0.2/problems)" [ "$(echo kept/mu0.2/problems/*)" = "kept/mu0.2/problems/000004.h5 kept/mu0.2/problems/000008.h5" ]

# a changed scene makes its results stale, other words do not
changed stale ''
expect 0 "checks held" "$stiction" run stale --no-figures
sed -i 's/soft rubber/softer rubber/' stale/study.lua
expect 0 "checks held" "$stiction" run stale --no-figures
holds "a case was run again for a note" [ "$(grep -c started output)" = 0 ]
sed -i 's/young = { 1\*MPa/young = { 1.1*MPa/' stale/study.lua
expect 0 "mu0  started" "$stiction" run stale --no-figures

changed wrong 's/case.results.force_y > 0/case.results.force_y < 0/'
expect 1 "check failed: mu0: the plane pushes back: value false, expected true|3 of 6 checks held" \
  "$stiction" run wrong --no-figures
holds "checks.json names the failure" grep -q '"pass": false' out/wrong/checks.json

expect 0 "A block on a plane|phase|iterations|needed|factorization|times what it cannot do without" "$stiction" bench "$tiny" --quick
expect 0 '"phases"|"factorizations"|"limit"' "$stiction" bench "$tiny" --json
expect 0 "product|preconditioning|times what it cannot do without" "$stiction" bench "$(dirname "$0")/../../studies/proofs/half_space_formula" --case hertz_64
expect 0 "case punch|evaluations" "$stiction" bench "$(dirname "$0")/../../studies/proofs/half_space_formula" --case punch
expect 2 "no finished case in empty" "$stiction" figures "$tiny" --out empty
expect 2 "no finished case in out/wrong with these parameters" "$stiction" figures wrong --set steps=7
rm out/wrong/mu0/manifest.json
sed -i 's/poisson = 0.3/poisson = 0.31/' wrong/block.lua
expect 0 "2 of 3 cases finished with these parameters|have changed since" "$stiction" figures wrong
finish
