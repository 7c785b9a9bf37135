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
expect 0 "--accuracy 20%: cells = |--set cells=4 stands instead" "$stiction" run soft --accuracy 20% --set cells=4 --no-figures --out hand
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

# a claim stays with the case that it is of, through other values of parameters, results made anew and a sweep of one case
cat >block.lua <<'END'
local stiction = require "stiction"
local u = stiction.units
local mm, s = u.mm, u.s
return stiction.study {
  title = "A block pulled off", question = "How large is its largest pull, of a coarse sampling?",
  given = { young = 2*u.MPa, G = 5*u.J/u.m^2, strength = 100*u.kPa }, chosen = { cells = { 20, "along" }, steps = { 60, "coarse" } },
  scene = function(p)
    return stiction.scene { output = stiction.output { frames = 0 },
      bodies = { block = stiction.body { mesh = stiction.mesh.block { size = { 10*mm, 5*mm }, cells = { p.cells, p.cells // 2 } },
        material = stiction.material.neo_hookean { young = p.young, poisson = 0.45 }, interpolation = "mean_dilatation",
        density = 1000*u.kg/u.m^3 } },
      obstacles = { floor = stiction.obstacle { shape = stiction.rigid.plane {} } },
      pairs = { sole = stiction.pair { secondary = "block.bottom", primary = "floor", adhesion = stiction.adhesion.bilinear {
        K = 1e10*u.N/u.m^3, sigma_n = p.strength, sigma_t = p.strength, G_I = p.G, G_II = p.G } } },
      motions = { stiction.motion.drive { set = "block.top", times = { 0*s, 1*s }, x = { 0*mm, 0*mm }, y = { 0*mm, 0.8*mm } } },
      scheme = stiction.scheme.quasi_static {},
      schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = p.steps } } },
      probes = { top = stiction.probe.force { set = "block.top" } },
    }
  end,
  results = { { name = "peak", unit = "N/m", meaning = "largest pull", function(run) return run:max("top", "force_y") end } },
  trade = { quantities = { "peak" }, knobs = { { "cells", { 10, 20, 40 } }, { "steps", { 30, 60, 120 } } } },
}
END
block() { # OUT ARGUMENTS: runs it
  folder=$1
  shift
  "$stiction" run block.lua "$@" --no-figures --out "$folder" >block.log 2>&1
}
claims_of() { # OUT: what its cases may be off by, sorted
  awk -F, 'NR == 1 { for (i = 1; i <= NF; ++i) if ($i == "peak_error") at = i } NR > 1 { print (at ? $at : "") }' "$1/summary.csv" | sort
}
for set in strength=50kPa G=20J/m^2; do
  block "alone-${set%%=*}" --set "$set" --check-accuracy
  block kept --set "$set" --check-accuracy
done
holds "each case has its own claim" [ "$(claims_of kept)" = "$(for set in alone-*; do claims_of "$set"; done | sort)" ]
holds "two of them" [ "$(claims_of kept | sort -u | grep -c .)" = 2 ]
claims_of kept >before
block kept
expect 0 "case  finished" "$stiction" results block.lua --out kept
holds "claims are kept, and none is made of another case" [ "$(claims_of kept | grep .)" = "$(cat before)" ]

# the largest value of a history may lie between two steps, at the same two where the steps are halved
for set in young=20MPa young=10MPa G=20J/m^2; do
  out=${set%J*}
  block "claim-$out" --set "$set" --check-accuracy
  block "truth-$out" --set "$set" --set steps=600 --set cells=40
  holds "$set: the claim holds: $(claims_of "claim-$out")" awk -F, -v claim="$(claims_of "claim-$out")" \
    'FNR == 2 { value[++n] = $2 } END { d = value[1] - value[2]; exit !(claim > 0 && d * d < claim * claim) }' \
    "claim-$out/summary.csv" "truth-$out/summary.csv"
done

# nor is anything promised of what takes steps, or goes on without a limit
sed 's|results = {.*|results = {{ name = "peak", unit = "1", meaning = "", function(_, p) return p.cells ^ 0.5 end },\
    { name = "fine", unit = "1", meaning = "", function(_, p) return 1 + 1 / p.cells / p.steps end },\
    { name = "held", unit = "1", meaning = "", function(_, p) return 1 + 1 / p.steps end } },|
  s|quantities = { "peak" }, knobs = { { "cells", { 10, 20, 40 } }|quantities = { "peak", "fine", "held" }, knobs = { { "cells", { 5, 10, 20, 40 } }|' \
  block.lua >levels.lua
expect 0 "uncertainty of peak is not known: it moves more at each finer level of cells|uncertainty of held is not known: cells moves others" \
  "$stiction" trade levels.lua --no-figures
expect 0 "--accuracy 5%: |peak: how far it is off is not known: it moves more|held: how far it is off is not known: cells moves" \
  "$stiction" run levels.lua --accuracy 5% --no-figures --out levels
holds "an error of what is sure alone" [ "$(head -n 1 levels/summary.csv | grep -o '[a-z]*_error')" = fine_error ]
expect 2 "--accuracy 5%: held: how far it is off is not known" "$stiction" run levels.lua --accuracy 5% --of held --no-figures

# where the model is a knob, what each rung is off by
expect 0 "model formula: off by 0.1|the error of the model alone|model half_space: off by 0.0|and of its resolution" \
  "$stiction" trade "$here/../../studies/trade/ladder" --quick --no-figures --out off
finish
