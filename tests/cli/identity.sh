#!/bin/sh
# What decides a result decides whether a case is reused: its scene and the program; words, checks and results do not.
. "$(dirname "$0")/common.sh"

ran() { # NUMBER: of cases that the last command started
  [ "$(grep -c ' started ' output)" = "$1" ] || complain "$(grep -c ' started ' output) cases ran, not $1: $(cat output)"
}

again() { # CODE "PARTS": the study drag once more
  expect "$1" "$2" "$stiction" run drag --no-figures --jobs 1
}

changed drag 's/^return/local mesh_file = "plate.msh"\
return/'
again 0 "checks held"
ran 3
cp -r out/drag first

# a note, a check, a figure, a result that another function makes, one more result: nothing runs
sed -i 's/soft rubber/soft natural rubber/; s/"the plane pushes back"/"pushes"/; s/colour = i - 1/colour = i/' drag/study.lua
sed -i 's/run:at(1\*s, "sole", "force_y")/2*run:at(1*s, "sole", "force_y")/' drag/study.lua
sed -i 's/^  results = {/  results = { { name = "steps", function(run) return run.cost.steps end },/' drag/study.lua
expect 0 "mu0  reused, results anew: study.lua has changed|3 cases: 3 reused, 0 to run" "$stiction" why drag
again 0 "results of 3 cases made anew from their histories|checks held"
ran 0
holds "new results: $(cat out/drag/summary.csv)" grep -q '^mu0,0,20,46.3' out/drag/summary.csv
holds "histories are touched" cmp -s first/mu0/series.h5 out/drag/mu0/series.h5
sed -i 's/2\*run:at/3*run:at/' drag/study.lua
expect 0 "results of 3 cases made anew|checks held" "$stiction" results drag
ran 0
holds "newer results: $(cat out/drag/summary.csv)" grep -q '^mu0,0,20,69.4' out/drag/summary.csv
holds "checks of them" [ -s out/drag/checks.json ]

# a value more, a parameter that only results see, a parameter that becomes an axis
sed -i 's/mu = { 0, 0.2/mu = { 0, 0.1, 0.2/; s/^  chosen = {/  chosen = { factor = { 3, "of results" },/; s/return 3\*run/return p.factor*run/' drag/study.lua
sed -i 's/function(run) return p.factor/function(run, p) return p.factor/' drag/study.lua
expect 0 "mu0.1  to run: it has not run|4 cases: 3 reused, 1 to run" "$stiction" why drag
again 0 "mu0.1  started (1 of 1)|checks held"
ran 1
again 0 "checks held"
ran 0
expect 0 "results of 4 cases made anew" "$stiction" run drag --no-figures --set factor=2
ran 0
holds "results of a parameter that is set: $(cat out/drag/summary.csv)" grep -q '^mu0,0,20,46.3' out/drag/summary.csv
sed -i 's/^    steps = { 10, .*//; s/^  sweep = {/  sweep = { steps = { 10, 12 },/; s/, set = { steps = 5 }//' drag/study.lua
expect 0 "mu0_steps10  reused, from mu0|mu0_steps12  to run: it has not run|4 reused, 4 to run" "$stiction" why drag
again 0 "checks held"
ran 4
holds "histories are lost" cmp -s first/mu0.4/series.h5 out/drag/mu0.4_steps10/series.h5
again 0 "checks held"
ran 0

# what the scene says runs again, and why tells it
changed other ''
"$stiction" run other --no-figures >/dev/null 2>&1
sed -i 's/poisson = 0.3/poisson = 0.31/; s/neo_hookean/mooney_rivlin/' other/block.lua
sed -i 's/poisson = 0.31/poisson = 0.3/; s/mooney_rivlin/neo_hookean/; s/density = p.density/density = 2*p.density/' other/block.lua
expect 0 "mu0.2  to run: it has changed|  bodies.block.density: 1000 kg m^-3 -> 2000 kg m^-3|1 case: 0 reused, 1 to run" \
  "$stiction" why other --case mu0.2
sed -i 's/density = 2\*p.density/density = p.density/' other/block.lua
expect 0 "  schedule.stages[1].steps: 10 -> 11|3 cases: 0 reused" "$stiction" why other --set steps=11
expect 2 "no finished case of these scenes in out/other; 'stiction why' says why" "$stiction" results other --set steps=11
expect 0 "3 cases: 3 reused" "$stiction" why other

# a study that moves takes its results along
mkdir below
mv other below/other
expect 0 "3 cases: 3 reused" "$stiction" why below/other --out out/other

# histories that are gone run again; damaged ones are told, and not overwritten
rm out/other/mu0/series.h5
echo nothing >out/other/mu0.2/series.h5
sed -i 's/run:at(1\*s/run:at(2*s/' below/other/study.lua
expect 0 "mu0  to run: out/other/mu0/series.h5 is gone" "$stiction" why below/other --out out/other
expect 1 "mu0  started (1 of 1)|mu0.2: result failed: |out/other/mu0.2/series.h5|stiction run STUDY --case mu0.2 --force" \
  "$stiction" run below/other --out out/other --no-figures
ran 1
holds "a damaged history was overwritten" grep -q nothing out/other/mu0.2/series.h5
expect 0 "mu0.2  started (1 of 1)" "$stiction" run below/other --out out/other --no-figures --case mu0.2 --force
expect 0 "checks held" "$stiction" results below/other --out out/other

# cases take over folders that are after each other's: two that swap, one whose own is to run, and none of those forced
changed swap 's/sweep = { mu = { 0, 0.2, 0.4 } }/sweep = { { mu = 0, n = 1 }, { mu = 0.2, n = 2 } }/
s/^  quick = {.*//
s/^  scene = /  case_id = function(p) return ("case%d"):format(p.n) end,\
  scene = /'
expect 0 "case2  finished" "$stiction" run swap --no-figures
sed -i 's/{ mu = 0, n = 1 }, { mu = 0.2, n = 2 }/{ mu = 0.2, n = 1 }, { mu = 0, n = 2 }/' swap/study.lua
expect 0 "results of 2 cases made anew|checks held" "$stiction" run swap --no-figures
ran 0
holds "swapped results: $(cat out/swap/summary.csv)" grep -q '^case2,0,.*,finished,' out/swap/summary.csv
sed -i 's/{ mu = 0.2, n = 1 }, { mu = 0, n = 2 }/{ mu = 0.3, n = 1 }, { mu = 0.2, n = 2 }/' swap/study.lua
expect 0 "case1  started (1 of 1)|checks held" "$stiction" run swap --no-figures
ran 1
sed -i 's/^  chosen = {/  chosen = { unread = { 1, "by scenes" },/' swap/study.lua
expect 0 "case2  started (2 of 2)|checks held" "$stiction" run swap --no-figures --jobs 1 --force
ran 2
holds "results are made anew of what runs anyway" [ "$(grep -c "made anew" output)" = 0 ]

# scenes that draw random numbers do not depend on those made before
changed dice 's/friction = stiction.friction.coulomb { mu = p.mu }/friction = stiction.friction.coulomb { mu = p.mu + 0.01*math.random() }/'
expect 0 "3 of 3" sh -c '"$1" run dice --no-figures --jobs 1; echo "$(grep -c ,finished, out/dice/summary.csv) of 3"' sh "$stiction"
expect 0 "3 cases: 3 reused" "$stiction" why dice
finish
