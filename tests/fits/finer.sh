#!/bin/sh
# Curves of cells half as large as those that are fitted: the data alone would exclude the truth, what is claimed does not, and the
# misfit is laid to the cells, not to the model.
set -eu
stiction=$1 studies=$2 out=$3
rm -rf "$out"
mkdir -p "$out/studies/fit"
cp -r "$studies/pull_off" "$out/studies/fit"
cd "$out"
"$stiction" run studies/fit/pull_off/data.lua --trust --no-figures --set cell=0.025mm --set steps=600 --out made >made.txt 2>&1 ||
  { cat made.txt; exit 1; }
"$stiction" fit studies/fit/pull_off --quick --no-figures --out fit | tee said
grep -q "no agreement yet: chi square" said
grep -q "refine before the model is blamed" said
awk '/^ *"name": "w"/ { exit } /"high":/ || /"low":/ { print $1, $2 + 0 }' fit/fit.json | tail -n 4 >ends # claimed, then of the data
cat ends
awk 'NR == 1 { high = $2 } NR == 2 { low = $2 } NR == 3 { data = $2 } END { exit !(low < 0.6 && 0.6 < high && data < 0.6) }' ends ||
  { echo "w = 0.6 J/m^2 should lie within what is claimed, and above what the data alone say"; exit 1; }
