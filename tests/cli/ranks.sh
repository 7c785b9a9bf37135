#!/bin/sh
# A case that several processes share: 1, 2 and 4 ranks give the answers of one process to 1e-8, linear and at finite
# strain, with friction; how they are refused, stopped, taken up and ended. Exit code 77, with the reason, where this build
# has no PETSc.
. "$(dirname "$0")/common.sh"

cp -r "$here/block" .

"$stiction" run block --ranks 2 --no-figures --out none >output 2>&1 </dev/null
if grep -q "built without PETSc" output; then
  expect 2 "petsc-dev|cmake --build" "$stiction" run block --ranks 2 --out none
  [ "$failures" = 0 ] || exit 1
  echo "skipped: petsc-dev is not installed, or was not when this was built"
  exit 77
fi

# refused before anything runs
expect 2 "openmpi-bin" env PATH=/nowhere "$stiction" run block --ranks 2 --out none1
expect 2 "cannot be shared by several ranks|bodies in space|without --ranks" "$stiction" run block --ranks 2 --set plane=1 --out none2
expect 2 "cannot be shared by several ranks|one process's" "$stiction" run block --ranks 2 --set bulk=direct --out none3
expect 2 "output.problems_every" "$stiction" run block --ranks 2 --problems 1 --out none4
expect 2 "--ranks: 1.5 is no whole number from 1 to" "$stiction" run block --ranks 1.5 --out none5
holds "nothing has run" [ -z "$(find none[1-5] -name series.h5 2>/dev/null)" ]

# the same answers
expect 0 "finished" "$stiction" run block --no-figures --set bulk=multigrid --out alone
numbers_of_block alone >alone.csv
for ranks in 1 2 4; do
  expect 0 "finished" "$stiction" run block --no-figures --ranks $ranks --out "of$ranks"
  numbers_of_block "of$ranks" >"of$ranks.csv"
  holds "$ranks ranks: $(near alone.csv "of$ranks.csv" 1e-8)" near alone.csv "of$ranks.csv" 1e-8
  holds "the manifest tells of $ranks ranks" grep -q "\"ranks\": $ranks" "of$ranks/lawfinite/manifest.json"
done
expect 0 "finished" "$stiction" run block --no-figures --set relaxes=1 --set bulk=multigrid --out relaxing1
expect 0 "finished" "$stiction" run block --no-figures --set relaxes=1 --ranks 3 --out relaxing3
for folder in relaxing1 relaxing3; do
  numbers_of_block $folder >$folder.csv
done
holds "bodies that relax, 3 ranks: $(near relaxing1.csv relaxing3.csv 1e-8)" near relaxing1.csv relaxing3.csv 1e-8
holds "they have another answer than those that do not" [ "$(sed -n 2p relaxing1.csv)" != "$(sed -n 2p alone.csv)" ]
expect 0 "finished" "$stiction" run block --no-figures --ranks 2 --out again
numbers_of_block again >again.csv
holds "two runs of two ranks: $(diff of2.csv again.csv)" cmp -s of2.csv again.csv
holds "fields of two runs" cmp -s of2/lawfinite/fields/000002.vtu again/lawfinite/fields/000002.vtu

# stopped: by a signal that mpirun hands on at once; at others it ends all itself
"$stiction" run block --no-figures --ranks 2 --case lawlinear --set steps=20000 --checkpoint 0.5 --out long >long.txt 2>&1 </dev/null &
run=$!
await '[ -s long/lawlinear/checkpoint ]' || complain "it keeps no checkpoint: $(cat long.txt)"
kill -TERM $run
wait $run
code=$?
holds "stopped with $code: $(cat long.txt)" [ "$code" = 1 ]
holds "a checkpoint is kept: $(cat long.txt)" grep -q "the next run of the case goes on from there" long.txt
holds "no rank is left" [ -z "$(pgrep -f "^$stiction case .*long .*--member")" ]

# taken up; then one rank dies: one message, and nothing is left of the others
"$stiction" run block --no-figures --ranks 2 --case lawlinear --set steps=20000 --out long >long.txt 2>&1 </dev/null &
run=$!
await 'grep -q "goes on from t =" long.txt' || complain "not taken up: $(cat long.txt)"
kill -KILL "$(pgrep -f "^$stiction case .*long .*--member" | tail -n 1)"
wait $run
code=$?
holds "killed: ended with $code: $(cat long.txt)" [ "$code" = 1 ]
holds "why: $(cat long.txt)" grep -q "its process ended by signal 9" long.txt
holds "no rank is left of those killed" [ -z "$(pgrep -f "^$stiction case .*long .*--member")" ]

# what started them is killed: nobody who begins the case anew meets them
"$stiction" run block --no-figures --ranks 2 --case lawlinear --set steps=20000 --out long >long.txt 2>&1 </dev/null &
run=$!
await 'grep -q "goes on from t =" long.txt' || complain "not taken up again: $(cat long.txt)"
kill -KILL "$(pgrep -P $run -f "^$stiction cases")"
wait $run
holds "what served is killed: $(cat long.txt)" grep -q "its process ended by signal 9" long.txt
await '[ -z "$(pgrep -f "^$stiction case .*long .*--member")" ]' 20 || complain "ranks are left without who started them"
finish
