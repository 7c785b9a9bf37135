#!/bin/sh
# Output folders: one run at a time, one study, and no case's data lost to other parameters.
. "$(dirname "$0")/common.sh"

appears() { # FILE: waits for it, a minute at most
  for _ in $(seq 600); do
    [ -e "$1" ] && return
    sleep 0.1
  done
}

column() { # NAME FILE: of a table of commas
  awk -F, -v name="$1" 'NR == 1 { for (i = 1; i <= NF; ++i) if ($i == name) at = i } NR > 1 { print $1, $at }' "$2"
}

# the right numbers, of a run that nobody disturbs
changed drag ''
expect 0 "checks held" "$stiction" run drag --set steps=400 --no-figures --jobs 1 --out alone
column force_y alone/summary.csv >right
holds "three cases" [ "$(wc -l <right)" = 3 ]

# two at once, the second a little later each time: it is refused, or runs when the first has ended; no wrong number
for delay in 0 0.1 0.3 0.6 1 1.5 2.5; do
  rm -rf both
  "$stiction" run drag --set steps=400 --no-figures --jobs 1 --out both >first 2>&1 </dev/null &
  id=$!
  sleep "$delay"
  "$stiction" run drag --set steps=400 --no-figures --jobs 1 --out both >second 2>&1 </dev/null
  second=$?
  wait "$id"
  code=$?
  for which in first second; do
    if [ "$which" = first ]; then ended=$code; else ended=$second; fi
    if [ "$ended" = 2 ]; then
      holds "$which, $delay s later: $(cat $which)" \
        grep -q "both is in use by 'stiction run .*drag/study.lua' (process [0-9]*, since .*); wait until that ends, stop it, or choose another folder with --out" $which
    else
      holds "the $which of two, $delay s later, ended with $ended: $(cat $which)" [ "$ended" = 0 ]
    fi
  done
  holds "both refused each other" [ "$code$second" != 22 ]
  column force_y both/summary.csv >got
  holds "wrong numbers, $delay s later: $(cat got)" cmp -s right got
done

# every other command that writes there waits its turn too; those that read go on
"$stiction" run drag --set steps=40000 --no-figures --jobs 1 --out busy >first 2>&1 </dev/null &
id=$!
appears busy/mu0/series.h5
expect 2 "is in use by" "$stiction" run drag --out busy --quick
expect 2 "is in use by" "$stiction" case drag --case mu0 --out busy
expect 0 "mu0  to run" "$stiction" run drag --out busy --list
expect 0 "Nothing to change" "$stiction" explain drag
expect 2 "no finished case in busy with these parameters" "$stiction" figures drag --out busy

# its holder killed outright: the lock goes with the last of its processes
kill -KILL "$id"
wait "$id" 2>/dev/null
for _ in $(seq 100); do
  "$stiction" run drag --set steps=400 --no-figures --jobs 1 --out busy >second 2>&1 </dev/null && break
  grep -q "in use" second || break
  sleep 0.1
done
column force_y busy/summary.csv >got
holds "after a kill: $(cat second)" cmp -s right got

# a lock that somebody holds who is no program of ours
if command -v flock >/dev/null; then
  expect 2 "busy is in use by another process" flock busy/.lock "$stiction" run drag --out busy --no-figures
  # one that has only just taken it and not yet said who it is
  flock busy/.lock sh -c 'echo >taken; sleep 0.3; printf "%s %s\nnow\nsome run\n" $$ "$(hostname)" >busy/.lock
    for _ in $(seq 600); do [ -e over ] && break; sleep 0.1; done' &
  appears taken
  expect 2 "busy is in use by 'some run' (process |, since now)" "$stiction" run drag --out busy --no-figures
  : >over
  wait $!
fi

# two studies of one name: the second has a folder of its own, and keeps it when the first is gone
mkdir -p elsewhere
cp -r drag elsewhere/drag
expect 0 "checks held" "$stiction" run drag --no-figures
cp out/drag/summary.csv first.csv
expect 0 "checks held|output: out/drag-" "$stiction" run elsewhere/drag --no-figures
holds "the first one's summary" cmp -s first.csv out/drag/summary.csv
expect 2 "out/drag holds the output of another study, $work/drag/study.lua; choose another folder with --out" \
  "$stiction" run elsewhere/drag --no-figures --out out/drag
mv drag gone
expect 0 "output: out/drag-" "$stiction" run elsewhere/drag --no-figures
holds "nothing ran anew: $(cat output)" [ "$(grep -c started output)" = 0 ]
expect 0 "mu0.2 " "$stiction" show elsewhere/drag
rm -r out/drag-*
expect 0 "checks held" "$stiction" run elsewhere/drag --no-figures
holds "the folder of its name, now free" grep -qx "output: out/drag" output
rm -r gone
mv elsewhere/drag drag

# --set and --quick beside the study's own values: nobody's data is lost, the folder of the id is the last one's
rm -rf out
expect 0 "checks held" "$stiction" run drag --no-figures
cp out/drag/mu0.2/series.h5 own.h5
expect 0 "checks held" "$stiction" run drag --no-figures --set cells=2
holds "rows of what was set" grep -q '^mu0.2,.*,cells=2,$' out/drag/summary.csv
holds "the last run's own folder" [ "$(head -n 1 out/drag/mu0.2/manifest.json | grep -c '"parameters":{"cells":2,')" = 1 ]
holds "the study's own data are lost" cmp -s own.h5 out/drag/mu0.2@*/series.h5
expect 0 "mu0.2  finished" "$stiction" run drag --list
expect 0 "mu0.2  finished" "$stiction" run drag --set cells=2 --list
expect 0 "mu0.2  started (1 of 1)" "$stiction" run drag --no-figures --quick
expect 0 "checks held" "$stiction" run drag --no-figures
holds "a finished case was run again" [ "$(grep -c started output)" = 0 ]
holds "back in its place" cmp -s own.h5 out/drag/mu0.2/series.h5
holds "rows of the study's own values" [ "$(grep -c ',,$' out/drag/summary.csv)" = 3 ]
expect 0 "checks held" "$stiction" run drag --no-figures --set cells=2
holds "what was set is run again" [ "$(grep -c started output)" = 0 ]
# figures of what lies beside
expect 0 "figures: out/drag/figures" "$stiction" figures drag
holds "figures of the study's own values" grep -q '"mu0.2@[0-9a-f]*/series.h5"' out/drag/figures.json

# a name is the same however a value is written, and none of the output's own
sed 's/^  sweep = .*/  sweep = { side = { 1*mm, 2*mm } },/; s/^  given = .*/  given = { descent = 0.02*mm, mu = 0.2 },/' drag/study.lua >side.lua
cp drag/block.lua .
expect 0 "side1  to run" "$stiction" run side.lua --list --set "side=0.001 m"
expect 0 "side1.5  to run" "$stiction" run side.lua --list --set "side=1.5*mm"
changed named 's/^  quick = /  case_id = function() return "figures" end, quick = /; s/{ 0, 0.2, 0.4 }/{ 0.2 }/'
expect 2 "a case cannot be called 'figures'" "$stiction" run named --list

# a case without fields leaves two files, whose manifest is JSON with the result before all else
changed bare 's/      probes = { sole/      output = stiction.output { frames = 0 },\n&/'
expect 0 "mu0.2  finished" "$stiction" run bare --no-figures --case mu0.2 --out two
holds "left: $(ls two/mu0.2)" [ "$(echo two/mu0.2/*)" = "two/mu0.2/manifest.json two/mu0.2/series.h5" ]
holds "the result" grep -q '^{"result":{"case":"mu0.2".*"verdict":"finished"' two/mu0.2/manifest.json
finish
