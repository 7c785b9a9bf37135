#!/bin/sh
# Results that fail: told with their place; columns that are not there before anything runs; the sweep goes on.
. "$(dirname "$0")/common.sh"

# a column that no history has: before any case runs
changed column 's/"sole", "force_y"/"sole", "forcey"/'
expect 2 "result force_y: study.lua:34: case mu0 has no series 'sole/forcey'; did you mean 'sole/force_y'?|(in case mu0)" \
  "$stiction" run column --no-figures
holds "something ran" [ -z "$(find out -name series.h5)" ]
changed group 's/run:at(2\*s, "sole", "force_x")/run:max("soles", "force_x")/'
expect 2 "study.lua:36: case mu0 has no series 'soles/force_x'" "$stiction" run group --no-figures
changed last 's/"sole", "force_y")/"sole", "force_y") + (p.mu == 0.4 and run:max("sole", "nothing") or 0)/; s/function(run) return run:at/function(run, p) return run:at/'
expect 2 "case mu0.4 has no series 'sole/nothing'" "$stiction" run last --no-figures
holds "something ran" [ -z "$(find out -name series.h5)" ]

# what made-up values would break, print or never end is none of the rehearsal's business
changed deep 's/return run:at(1\*s, "sole", "force_y")/print("looked") local f, t = run:series("sole", "force_y"), run.time\
    local x = 1 while f[#f] > 1e6 or f[1] == 1 do x = x \/ 2 end\
    if f[#f] < 0 then error("no such force") end return f[#t]/'
expect 0 "mu0: looked|3 of 3 cases|checks held" sh -c '"$1" run deep --no-figures | tee kept; echo "3 of $(grep -c ": looked" kept) cases"' sh "$stiction"
# a column whose name depends on the values is found when it is wanted: after the first case, and no other is begun
changed late 's/return run:at(1\*s, "sole", "force_y")/return run:max("sole", run:max("sole", "force_y") > 10 and "forcey" or "force_y")/'
expect 2 "no series 'sole/forcey'" "$stiction" run late --no-figures --jobs 1
holds "more than one case ran" [ "$(find out/late -name series.h5 | wc -l)" = 1 ]

# one that raises: that result of that case is empty, the others stand, the sweep goes on, and the exit code tells
changed raises 's/function(run) return run:at(1\*s, "sole", "force_y")/function(run, p) if p.mu == 0.2 then local x = p.side.wrong.thing end return run:at(1*s, "sole", "force_y")/'
expect 1 "mu0.2  result failed: result force_y: study.lua:34|mu0.4  finished|2 of 3 cases finished" "$stiction" run raises --no-figures --jobs 1
holds "rows: $(cat out/raises/summary.csv)" grep -q '^mu0.2,0.2,nan,[0-9].*,result failed,' out/raises/summary.csv
holds "two finished rows" [ "$(grep -c ',finished,' out/raises/summary.csv)" = 2 ]
expect 1 "mu0.2: result failed: result force_y: study.lua:34|2 of 3 cases finished" "$stiction" run raises --no-figures
holds "a case was run again for its results" [ "$(grep -c started output)" = 0 ]
sed -i 's/if p.mu == 0.2 then local x = p.side.wrong.thing end//' raises/study.lua
expect 0 "results of 3 cases made anew|mu0.2  finished|checks held" "$stiction" run raises --no-figures
holds "a case was run again for mended results" [ "$(grep -c started output)" = 0 ]
expect 0 "results of 1 case made anew from its history|mu0.4  finished" "$stiction" results raises --case mu0.4
expect 2 "no finished case of these scenes in out/nowhere" "$stiction" results raises --out out/nowhere
holds "results made a folder" [ ! -e out/nowhere ]
changed text 's/return run:at(1\*s, "sole", "force_y")/return "much"/'
expect 1 "result force_y: study.lua:|: it must be a number, not a string" "$stiction" run text --no-figures --quick
changed undefined 's/return run:at(1\*s, "sole", "force_y")/return 0 \/ 0/'
expect 1 "result failed: result force_y: study.lua:|: it is not a number: its function divides by zero" "$stiction" run undefined --no-figures --quick
changed infinite 's/return run:at(1\*s, "sole", "force_y")/return 1 \/ 0/'
expect 1 "result force_y: study.lua:|: it is infinite" "$stiction" run infinite --no-figures --quick

# components of a vector-valued column are counted from 1
changed points 's/energy = stiction.probe.energy/points = stiction.probe.contact_line { pair = "sole" }, &/; s/return math.abs(run:at(2\*s, "sole", "force_x"))/local x = {}\
    for k = 1, 5 do x[k] = ("%g"):format(1e3*run:at(2*s, "points", "X", k)) end\
    return table.concat(x, " ") == "0 0.25 0.5 0.75 1" and run:at(2*s, "points", "X") == 0 and 1 or 99/'
expect 0 "2 of 2 checks held" "$stiction" run points --no-figures --quick

# checks that go wrong leave no pictures of earlier cases behind
if [ -x "$(dirname "$stiction")/../../postproc/stiction-figures" ]; then
  changed drawn ''
  "$stiction" run drawn --quick >/dev/null 2>&1
  touch -d '2001-01-01' out/drawn/figures/force.png
  changed drawn 's/check.holds(case.id/check.holds(case.nothing.id/'
  expect 2 "study.lua:41:" "$stiction" run drawn --quick
  holds "figures of these cases" [ out/drawn/figures/force.png -nt drawn/study.lua ]
fi

# a dot for a colon, and the reverse
changed dot 's/run:at(1\*s, /run.at(1*s, /'
expect 2 "study.lua:34: write run:at(...), with a colon, not run.at(...)" "$stiction" run dot --quick --no-figures
changed min 's/run:at(1\*s, /run.min(/'
expect 2 "write run:min(...), with a colon, not run.min(...)" "$stiction" run min --quick --no-figures
changed colon 's/check.within(/check:within(/'
expect 2 "study.lua:42: write check.within(...), with a dot, not check:within(...)" "$stiction" run colon --quick --no-figures
finish
