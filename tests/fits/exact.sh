#!/bin/sh
# The fit of STUDY with derivatives from the runs beside its cases: what fit.sh asks, in at most 15 cases, with best values that are
# those of the fit with differences: both end within a fifth of a standard error.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
stiction=$1 study=$2 out=$3 names=$4
rm -rf "$out"
mkdir -p "$out"
cp -r "$study" "$out/study"
sed -i "s/^return stiction.study {/return stiction.study { derivatives = { $names },/" "$out/study/study.lua"
grep -q "derivatives = { $names }" "$out/study/study.lua"
sh "$here/fit.sh" "$stiction" "$out/study" "$out/exact"
cases=$(sed -n 's/^ *"cases_of_search": \([0-9]*\).*/\1/p' "$out/exact/fit.json")
[ "$cases" -le 15 ] || { echo "$cases cases, more than 15"; exit 1; }
"$stiction" fit "$study" --quick --no-figures --out "$out/differences" >/dev/null
ends() { awk '/^ *"best":/ { best = $2 + 0 } /^ *"error":/ { print best, $2 + 0 }' "$1"; }
ends "$out/exact/fit.json" >"$out/ends_exact"
ends "$out/differences/fit.json" | paste -d " " - "$out/ends_exact" | tee "$out/ends"
awk '{ d = $1 - $3; if (d < 0) d = -d; if (d > 0.4 * $2 || NF != 4) bad = 1 } END { exit bad || NR != 3 }' "$out/ends" ||
  { echo "best values (of differences, with their errors, first) differ"; exit 1; }
