#!/bin/sh
# stiction trade and run --accuracy: the ladder, its outputs, their use, and what is refused.
. "$(dirname "$0")/common.sh"

changed soft 's/^  quick = .*/  trade = { quantities = { "force_y", "force_x",\
    { name = "history", series = "sole\/force_y" }, { name = "zero", curve = function(run) return { 0, 1 }, { 0, 1e-6 } end,\
      reference = function() return 0 end, scale = 1 } }, set = { mu = 0.2 }, combinations = 2,\
    knobs = { { "cells", { 2, 4, 8 } }, { "steps", { 5, 10 } } },\
    quick = { knobs = { { "cells", { 2, 4 } } } } },\
  quick = { sweep = { mu = { 0.2 } }, set = { steps = 5 } },/'

expect 2 "was not measured yet|: 'stiction trade soft'" "$stiction" run soft --accuracy 5% --no-figures
expect 0 "force_y: reference|history: reference a curve +-|zero: reference a curve, exact|default|front|output: out/soft/trade" "$stiction" trade soft --no-figures
holds "trade.csv" grep -q '^case,cells,steps,force_y,force_y_error,force_x,force_x_error,history_error,zero_error,error,bound,work,seconds' \
  out/soft/trade/trade.csv
holds "five runs and at most two combinations" [ "$(wc -l <out/soft/trade/trade.csv)" -ge 6 ]
holds "one default" [ "$(grep -c ",true,[a-z]*$" out/soft/trade/trade.csv)" = 1 ]
holds "kept beside the study" [ -s soft/trade.json ]
cut -d, -f1-10 out/soft/trade/trade.csv >first
expect 0 "recomputed from the kept source|0 differ too much|histories equal to the last bit" "$stiction" verify out/soft/trade
expect 0 "stiction verify trade.tar.gz" "$stiction" pack out/soft/trade
expect 0 "all files are what|recomputed from the kept source|0 differ too much" "$stiction" verify trade.tar.gz

# a curve of a column that is not there, before anything runs
sed 's|sole/force_y" }|sole/forcey" }|' soft/study.lua >soft/curve.lua
expect 2 "curve history: case cells4_steps10 has no series 'sole/forcey'; did you mean" "$stiction" trade soft/curve.lua --no-figures
holds "something ran" [ -z "$(find out/curve -name series.h5)" ]
rm soft/curve.lua

# a trade again runs nothing, and says the same on another number of processes: counts, no seconds
expect 0 "force_y: reference" "$stiction" trade soft --no-figures
holds "a finished run was run again" [ "$(grep -c started output)" = 0 ]
expect 0 "force_y: reference" "$stiction" trade soft --no-figures --jobs 1 --out again
holds "the trade does not repeat" [ "$(cut -d, -f1-10 again/trade.csv)" = "$(cat first)" ]

expect 0 "--accuracy 20%: cells = |of the default's work" "$stiction" run soft --accuracy 20% --no-figures
holds "errors in summary.csv" grep -q 'seconds,force_x_error,force_y_error,history_error,zero_error,set,warnings$' out/soft/summary.csv
promise="force_y within its error of what its trade measured"
value_of() { # COLUMN CASE: of out/soft/summary.csv
  awk -F, -v name="$1" -v id="$2" 'NR == 1 { for (i = 1; i <= NF; ++i) if ($i == name) at = i } $1 == id { print $at }' out/soft/summary.csv
}
holds "only the measured scene has errors" [ "$(value_of force_x_error mu0.2)" != "" ] &&
  holds "no error where nothing was measured" [ "$(value_of force_x_error mu0.4)$(value_of force_y_error mu0)" = "" ]
holds "each column its own error" [ "$(value_of force_x_error mu0.2)" != "$(value_of force_y_error mu0.2)" ]
holds "what was measured is checked once, at mu = 0.2" [ "$(grep -c "$promise" out/soft/checks.json)" = 1 ]
cp soft/trade.json measured
sed -i 's/"force_y": 2[0-9]\./"force_y": 99./' soft/trade.json
expect 1 "$promise" "$stiction" run soft --accuracy 20% --no-figures
mv measured soft/trade.json
cp soft/trade.json measured
sed -i '/"force_y": {/,/}/s/"uncertainty": [^,]*/"uncertainty": 1.5/' soft/trade.json
expect 0 "--accuracy 20% of force_y" "$stiction" run soft --accuracy 20% --of force_y --no-figures
holds "a claim holds the doubt of the reference" awk -v error="$(value_of force_y_error mu0.2)" 'BEGIN { exit !(error >= 1.5) }'
mv measured soft/trade.json
expect 2 "the best that was measured is|finer levels" "$stiction" run soft --accuracy 1e-9 --no-figures
# one number decides where one is asked for; a scene that was not measured is told as such, and can be measured
expect 0 "--accuracy 20% of force_y: " "$stiction" run soft --accuracy 20% --of force_y --no-figures --case mu0.2 --out one
holds "only what was asked for is claimed" grep -q 'seconds,force_y_error,set,warnings$' one/summary.csv
expect 2 "no 'force_z'; did you mean 'force_y'?|it measures: force_y, force_x, history, zero" "$stiction" run soft --accuracy 20% --of force_z
expect 2 "give one of them" "$stiction" run soft --of force_y
expect 0 "mu0: not the scene that was measured (mu = 0, measured with 0.2; young = |is not known|--check-accuracy" \
  "$stiction" run soft --accuracy 20% --set young=2MPa --no-figures --out two
holds "no claim is written" grep -q 'seconds,set,warnings$' two/summary.csv
expect 0 "with cells=|with steps=|mu0.2: off by at most|(force_x |checks held" \
  "$stiction" run soft --accuracy 20% --set young=2MPa --check-accuracy --case mu0.2 --no-figures --out two
holds "now it is" grep -q 'seconds,force_x_error,force_y_error,history_error,zero_error,set,warnings$' two/summary.csv
expect 1 "mu0.2: off by no more than asked for" \
  "$stiction" run soft --accuracy 3% --of force_y --set young=2MPa --set mu=0.2 --check-accuracy --no-figures --out three
expect 0 "mu0.4: off by at most" "$stiction" run soft --check-accuracy --of force_y --set mu=0.4 --no-figures --out four
holds "claims need no measured trade" grep -q 'seconds,force_y_error,set,warnings$' four/summary.csv
# what is 0 whatever the settings is off by nothing
expect 0 "mu0: off by at most|force_x 0%" "$stiction" run soft --check-accuracy --set mu=0 --case mu0 --no-figures --out five
holds "an error that is no number: $(cat output five/summary.csv)" [ "$(cat output five/summary.csv | grep -c -- '[-,]nan')" = 0 ]
expect 2 "has no \`trade" "$stiction" run "$tiny" --check-accuracy
expect 2 "write a share above 0" "$stiction" run soft --accuracy lots --no-figures
sed -i 's/soft rubber/softer rubber/' soft/study.lua
expect 2 "was changed since its trade was measured" "$stiction" run soft --accuracy 20% --no-figures

rm soft/trade.json
expect 0 "force_y: reference" "$stiction" trade soft --quick --no-figures --out quick
holds "the quick form is not kept" [ ! -e soft/trade.json ]
expect 2 "has no \`trade" "$stiction" trade "$tiny"
sed -i 's/{ 2, 4, 8 }/{ 2, 5, 8 }/' soft/study.lua
expect 2 "the default cells = 4 must be one of its levels" "$stiction" trade soft
sed -i 's/"force_x",$/"farce_x",/; s/{ 2, 5, 8 }/{ 2, 4, 8 }/' soft/study.lua
expect 2 "no result 'farce_x'" "$stiction" trade soft

# what was measured of the repository's own studies still stands beside them, is of their present words and still comes out
for name in plate_on_cylinder sphere_indentation bar_impact hertz sliding_die ladder all_rungs; do
  expect 0 "--accuracy 10%:|of the default's work|checks held" "$stiction" run "$here/../../studies/trade/$name" \
    --accuracy 10% --no-figures --out "$name"
  holds "$name: what was measured is checked" grep -q "within its error of what" "$name/checks.json"
  expect 2 "the best that was measured is|: 'stiction trade" "$stiction" run "$here/../../studies/trade/$name" \
    --accuracy 1e-9 --list
done

# where the model is a knob, what each rung is off by
expect 0 "model formula: off by 0.1|the error of the model alone|model half_space: off by 0.0|and of its resolution" \
  "$stiction" trade "$here/../../studies/trade/ladder" --quick --no-figures --out off
finish
