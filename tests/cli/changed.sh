#!/bin/sh
# Studies, their files and the program changed after or while cases run: nothing stale is taken for new, nothing is mixed.
. "$(dirname "$0")/common.sh"

appears() { # FILE: waits for it, a minute at most
  for _ in $(seq 600); do
    [ -e "$1" ] && return
    sleep 0.1
  done
}

# a mesh is named from the study's folder on, wherever the program is started; a changed one makes results stale
mkdir elsewhere
sed -e 's/local block = .*//' -e 's/block\.bottom/block.floor/' -e 's/block\.top/block.ceiling/' \
  -e 's|block(p)|stiction.body { density = p.density, material = material(p), mesh = mesh }|' \
  -e 's|^return|local mesh = stiction.mesh.msh_file { path = "plate.msh", scale = 1*mm }\
local function material(p) return stiction.material.neo_hookean { young = p.young, poisson = 0.3 } end\
return|' "$tiny/study.lua" >elsewhere/imported.lua
cp "$here/../mesh/data/plate_quad4_binary.msh" elsewhere/plate.msh
expect 0 "checks held" "$stiction" run elsewhere/imported.lua --no-figures
expect 0 "mu0  finished|mu0.4  finished" "$stiction" run elsewhere/imported.lua --list
cp "$here/../mesh/data/plate_quad8_v41.msh" elsewhere/plate.msh
expect 0 "mu0  to run|mu0.4  to run" "$stiction" run elsewhere/imported.lua --list
rm elsewhere/plate.msh
expect 2 "mesh file $work/elsewhere/plate.msh: cannot be read" "$stiction" run elsewhere/imported.lua

# only what is read counts: notes, logs, backups and output in the study's folder, while it runs and after
changed noisy ''
"$stiction" run noisy --no-figures --jobs 1 --out noisy/out --set steps=2000 >noisy/log.txt 2>&1 </dev/null &
id=$!
appears noisy/out/mu0/series.h5
echo "remember" >noisy/notes.txt
cp noisy/study.lua noisy/study.lua~
echo "swap" >noisy/.study.lua.swp
echo "return 3" >noisy/unused.lua
wait "$id"
code=$?
holds "the sweep among notes ended with $code: $(cat noisy/log.txt)" [ "$code" = 0 ]
echo "return 4" >noisy/unused.lua
expect 0 "mu0  finished|mu0.2  finished|mu0.4  finished" "$stiction" run noisy --out noisy/out --set steps=2000 --list
holds "what was read: $(head -n 1 noisy/out/mu0/manifest.json)" \
  [ "$(head -n 1 noisy/out/mu0/manifest.json | grep -o '"path":"[a-z]*.lua"' | wc -l)" = 2 ]
holds "the manifest says it too" grep -q '"path": "block.lua"' noisy/out/mu0/manifest.json

# a module that is read only when a scene or a result needs it counts as well
changed late 's/^local block = .*//; s/block(p)/require "block"(p)/; s/return run:at(1\*s, "sole", "force_y")/return require("factor") * run:at(1*s, "sole", "force_y")/'
echo "return 1" >late/factor.lua
expect 0 "checks held" "$stiction" run late --no-figures
expect 0 "mu0  finished|mu0.2  finished|mu0.4  finished" "$stiction" run late --list
echo "return 2" >late/factor.lua
expect 0 "mu0  finished|mu0.2  finished|mu0.4  finished" "$stiction" run late --list
expect 0 "mu0  reused, results anew: factor.lua has changed" "$stiction" why late
expect 0 "results of 3 cases made anew from their histories|checks held" "$stiction" run late --no-figures
holds "a case was run again for its results" [ "$(grep -c started output)" = 0 ]
holds "the results of another module: $(cat out/late/summary.csv)" grep -q '^mu0,0,46.3' out/late/summary.csv
echo "return 1" >late/factor.lua
expect 0 "results of 3 cases made anew" "$stiction" run late --no-figures
sed -i 's/poisson = 0.3/poisson = 0.4/' late/block.lua
expect 0 "mu0  to run|mu0.2  to run|mu0.4  to run" "$stiction" run late --list

# and is held to what the sweep began with
"$stiction" run late --set steps=20000 --no-figures --jobs 1 --out lates >output 2>&1 </dev/null &
id=$!
appears lates/mu0/series.h5
sed -i 's/poisson = 0.4/poisson = 0.35/' late/block.lua
wait "$id"
code=$?
holds "the sweep with a late module ended with $code: $(cat output)" [ "$code" = 2 ]
holds "no message: $(cat output)" grep -q "was changed while its cases ran" output
holds "a case was run with another module" [ ! -e lates/mu0.2/series.h5 ]

# so does what a trusted script opens
changed opens 's/^return stiction.study/local f = io.open("table.csv") local young = f:read("n") f:close()\
return stiction.study/; s/young = { 1\*MPa/young = { young*MPa/'
echo 1 >table.csv
expect 0 "checks held" "$stiction" run opens --trust --no-figures
expect 0 "mu0  finished" "$stiction" run opens --trust --list
echo 2 >table.csv
expect 0 "mu0  to run" "$stiction" run opens --trust --list

# a study changed while it runs: what has begun ends as the study was, nothing else begins
changed edited ''
"$stiction" run edited --set steps=20000 --no-figures --jobs 1 --out edits >output 2>&1 </dev/null &
id=$!
appears edits/mu0/series.h5
cp edited/block.lua before.lua
sed -i 's/poisson = 0.3/poisson = 0.4/' edited/block.lua
wait "$id"
code=$?
holds "the changed sweep ended with $code: $(cat output)" [ "$code" = 2 ]
holds "no message: $(cat output)" grep -q "study.lua: the study, a file that it reads or the program was changed" output
expect 0 "mu0  to run|mu0.2  to run|mu0.4  to run" "$stiction" run edited --set steps=20000 --out edits --list
cp before.lua edited/block.lua
expect 0 "mu0  finished|mu0.2  to run|mu0.4  to run" "$stiction" run edited --set steps=20000 --out edits --list

# a program built anew while its sweep runs: the sweep ends as it began
mkdir -p program/lua/bind
own=$work/program/lua/bind/stiction-engine
cp "$stiction" "$own"
"$own" run edited --set steps=20000 --no-figures --jobs 1 --out rebuilt >output 2>&1 </dev/null &
id=$!
appears rebuilt/mu0/series.h5
rm "$own"
printf '#!/bin/sh\nexit 7\n' >"$own"
chmod +x "$own"
wait "$id"
code=$?
holds "the sweep of a replaced program ended with $code: $(cat output)" [ "$code" = 0 ]
holds "three finished rows" [ "$(grep -c ',finished,' rebuilt/summary.csv)" = 3 ]
finish
