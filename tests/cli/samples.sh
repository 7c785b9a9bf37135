#!/bin/sh
# Sampled and zipped sweeps, those chosen with --where, and sweeps of which some cases fail.
. "$(dirname "$0")/common.sh"

ran() { # NUMBER: of cases that the last command started
  [ "$(grep -c ' started ' output)" = "$1" ] || complain "$(grep -c ' started ' output) cases ran, not $1: $(cat output)"
}

# a sample has its seed written down; more of it keep what has run
changed drawn 's/^  sweep = .*/  sweep = stiction.sample.sobol { count = 4, seed = 7, of = { mu = { 0, 0.5 } } },/; s/^  quick = .*//'
expect 0 "s1  started|s4  finished|checks held" "$stiction" run drawn --no-figures --jobs 1
ran 4
holds "the seed: $(cat out/drawn/study.json)" grep -q '"seed": 7' out/drawn/study.json
sed -i 's/count = 4/count = 6/' drawn/study.lua
expect 0 "s6  finished|checks held" "$stiction" run drawn --no-figures --jobs 1
ran 2
sed -i 's/stiction.sample.sobol { count = 6, seed = 7, of = { mu = { 0, 0.5 } } }/stiction.sample.zip { mu = { 0.1, 0.2 }, cells = { 3, 4 } }/; s/^    cells = .*//' drawn/study.lua
expect 0 "cells3_mu0.1  to run|cells4_mu0.2  to run" "$stiction" run drawn --list
sed -i 's/mu = { 0.1, 0.2 }, cells/mu = { 0.1 }, cells/' drawn/study.lua
expect 2 "sample.zip: 'mu' must be a list as long as the others" "$stiction" run drawn --list

# --where: what is chosen runs, the summary has all that there is
changed drag ''
expect 0 "mu0.2  to run|mu0.4  to run" "$stiction" run drag --where 'mu > 0.1' --list
holds "others are listed" [ "$(wc -l <output)" = 2 ]
expect 0 "1 of 3 cases finished: no checks until all are; missing: mu0 (to run), mu0.2 (to run)" \
  "$stiction" run drag --where 'mu > 0.3 and young == 1e6' --no-figures
ran 1
expect 0 "2 of 3 cases finished" "$stiction" run drag --where 'mu < 0.1' --no-figures
holds "rows: $(cat out/drag/summary.csv)" [ "$(grep -c ',finished,' out/drag/summary.csv)" = 2 ]
expect 2 "--where 'mu > 1' holds for none of the 3 cases" "$stiction" run drag --where 'mu > 1'
expect 2 "no parameter or result 'muu'; did you mean 'mu'?" "$stiction" run drag --where 'muu > 1'
expect 2 "--case and --where both choose" "$stiction" run drag --where 'mu > 1' --case mu0

# cases that fail are rows, with what is known; the others run, and are judged and drawn
changed fails 's/schedule = stiction.schedule { stages/schedule = stiction.schedule { seconds = p.mu == 0.2 and 1e-9*s or nil, stages/'
expect 1 "mu0.4  finished|2 of 3 cases finished: checks and figures of these; missing: mu0.2 (|4 of 4 checks held" \
  "$stiction" run fails --jobs 1
ran 3
holds "a row: $(cat out/fails/summary.csv)" grep -q '^mu0.2,0.2,nan,nan,[a-z ]*,' out/fails/summary.csv
holds "the checks" [ "$(grep -c '"pass": true' out/fails/checks.json)" = 4 ]
if [ -x "$(dirname "$stiction")/../../postproc/stiction-figures" ]; then
  holds "no figure" [ -s out/fails/figures/force.png ]
fi
sed -i 's/for i, case in ipairs(cases) do/for i = 1, 3 do local case = cases[i] local _ = case.id/' fails/study.lua
expect 1 "no figures with cases missing: study.lua:|attempt to index a nil value" "$stiction" run fails --jobs 1
finish
