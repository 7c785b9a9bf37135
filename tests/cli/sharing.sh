#!/bin/sh
# Several runs in one folder: each case once, no row lost, nothing left of those that were killed; and cleaning up.
. "$(dirname "$0")/common.sh"

appears() { # FILE: waits for it, a minute at most
  for _ in $(seq 600); do
    [ -e "$1" ] && return
    sleep 0.1
  done
}

rows() { sed 's/,[^,]*,\([^,]*\),\([^,]*\)$/,\1,\2/' "$1"; } # without the seconds

started() { cat "$@" | grep -c ' started '; }

# three runs of a case each, side by side: three rows
changed drag ''
for round in 1 2 3; do
  rm -rf side
  for id in 0 0.2 0.4; do
    "$stiction" run drag --case mu$id --no-figures --out side >log.$id 2>&1 </dev/null &
    eval "id_$(echo $id | tr . _)=\$!"
  done
  # shellcheck disable=SC2154
  for id in $id_0 $id_0_2 $id_0_4; do
    wait "$id" || complain "a run of one case, round $round: $(cat log.*)"
  done
  holds "rows of round $round: $(cat side/summary.csv)" [ "$(grep -c ',finished,' side/summary.csv)" = 3 ]
done
holds "claims are left: $(ls -A side/.claims)" [ -z "$(ls -A side/.claims)" ]

# a sweep that three share: each case once, the same summary as of one
sed 's/mu = { 0, 0.2, 0.4 }/mu = { 0, 0.05, 0.1, 0.15, 0.2, 0.25, 0.3, 0.35, 0.4, 0.45, 0.5, 0.55 }/' drag/study.lua >drag/many.lua
expect 0 "checks held" "$stiction" run drag/many.lua --no-figures --out alone
for which in 1 2 3; do
  "$stiction" run drag/many.lua --join --jobs 1 --no-figures --out shared >join.$which 2>&1 </dev/null &
  eval "join_$which=\$!"
done
# shellcheck disable=SC2154
for which in $join_1 $join_2 $join_3; do
  wait "$which" || complain "a run that joins: $(cat join.*)"
done
holds "each case once: $(cat join.*)" [ "$(started join.*)" = 12 ]
holds "all judge all" [ "$(cat join.* | grep -c '24 of 24 checks held')" = 3 ]
rows alone/summary.csv >one
rows shared/summary.csv >other
holds "the same summary: $(diff one other)" cmp -s one other

# one that is killed outright: the others finish what it had begun
"$stiction" run drag/many.lua --join --jobs 1 --no-figures --set steps=400 --out killed >join.1 2>&1 </dev/null &
id=$!
appears killed/mu0/series.h5
"$stiction" run drag/many.lua --join --jobs 1 --no-figures --set steps=400 --out killed >join.2 2>&1 </dev/null &
other=$!
appears killed/mu0.05/series.h5
kill -KILL "$id"
wait "$id" 2>/dev/null
wait "$other" || complain "the run that is left: $(cat join.2)"
holds "all rows: $(cat killed/summary.csv)" [ "$(grep -c ',finished,' killed/summary.csv)" = 12 ]
holds "claims of the dead are left: $(ls -A killed/.claims)" [ -z "$(ls -A killed/.claims)" ]

# who shares and who does not
"$stiction" run drag --join --jobs 1 --no-figures --set steps=40000 --out busy >log 2>&1 </dev/null &
id=$!
appears busy/mu0/series.h5
expect 2 "busy is in use by 'stiction run |wait until that ends, stop it, or choose another folder with --out" \
  "$stiction" run drag --no-figures --set steps=40000 --out busy
expect 2 "case mu0 is being run by process $id on|--join" "$stiction" run drag --no-figures --set steps=40000 --out busy --case mu0
expect 2 "is in use by" "$stiction" clean drag --out busy
expect 2 "--join: a sweep that is shared takes no --force" "$stiction" run drag --join --force --out busy
kill "$id"
wait "$id"

# summary.csv tells all that is there: what --set and --quick left, and what went before
expect 0 "checks held" "$stiction" run drag --no-figures
expect 0 "checks held" "$stiction" run drag --no-figures --set mu=0.3
expect 0 "checks held" "$stiction" run drag --no-figures --quick
expect 0 "checks held" "$stiction" run drag --no-figures --set cells=3 --set mu=0.2
holds "rows of four forms: $(cat out/drag/summary.csv)" [ "$(grep -c ',finished,' out/drag/summary.csv)" = 6 ]
holds "what is set: $(cat out/drag/summary.csv)" grep -q '^mu0.2,.*,cells=3,$' out/drag/summary.csv
holds "and beside it" [ "$(grep -c '^mu0.2@.*,steps=5,$' out/drag/summary.csv)" = 1 ]
expect 0 "checks held" "$stiction" run drag --no-figures
ran=$(grep -c ' started ' output)
holds "a case ran again: $(cat output)" [ "$ran" = 0 ]
holds "all is told still: $(cat out/drag/summary.csv)" [ "$(grep -c ',finished,' out/drag/summary.csv)" = 6 ]

# a case that was killed is a row, and runs again
"$stiction" run drag --no-figures --set steps=20000 --case mu0.2 --out crash >log 2>&1 </dev/null &
id=$!
appears crash/mu0.2/series.h5
kill -KILL "$(cases_running)"
wait "$id"
code=$?
holds "the run of a case that was killed ended with $code: $(cat log)" [ "$code" = 1 ]
holds "a row of the crash: $(cat crash/summary.csv)" grep -q '^mu0.2,0.2,nan,nan,crashed,' crash/summary.csv
expect 0 "mu0.2  to run" "$stiction" run drag --list --set steps=20000 --out crash

# clean: nothing that some run of the study would reuse; what it no longer has, and what killed runs left
expect 0 "out/drag: 0 removed" "$stiction" clean drag
touch out/drag/summary.csv.123.part
mkdir -p out/drag/mine
touch out/drag/mine/notes.txt
sed -i 's/poisson = 0.3/poisson = 0.31/' drag/block.lua
expect 0 "out/drag/mu0.3: a case that the study no longer has|out/drag/mu0.2@|summary.csv.123.part: a draft|to remove" "$stiction" clean drag --list
holds "only listed" [ -d out/drag/mu0.3 ]
expect 0 "removed" "$stiction" clean drag
holds "left: $(ls out/drag)" [ "$(grep -rl '^{"result":' out/drag | wc -l)" = 3 ]
holds "what is not ours" [ -e out/drag/mine/notes.txt ]
expect 0 "checks held" "$stiction" run drag --no-figures
expect 0 "source of no case that is left|out/drag: 1 removed" "$stiction" clean drag

# another study of the same name is not shown as this one's
mkdir -p elsewhere
cp -r drag elsewhere/drag
for command in "run elsewhere/drag --list" "why elsewhere/drag" "figures elsewhere/drag" "results elsewhere/drag" "clean elsewhere/drag"; do
  # shellcheck disable=SC2086 # words
  expect 2 "out/drag holds the output of another study, $work/drag/study.lua; choose another folder with --out" \
    "$stiction" $command --out out/drag
done
expect 2 "there is no output folder out/drag-" "$stiction" clean elsewhere/drag
"$stiction" run elsewhere/drag --list >listed
holds "another's cases: $(cat listed)" [ "$(grep -c finished listed)" = 0 ]
finish
