#!/bin/sh
# Runs the fit of STUDY into OUT in its quick form: the values that data.lua calls the truth lie within the intervals that are claimed.
set -eu
stiction=$1 study=$2 out=$3
rm -rf "$out"
"$stiction" fit "$study" --quick --no-figures --out "$out"
most=40
[ "$(basename "$study")" != rate_series ] || most=100 # a case for each of its points
cases=$(sed -n 's/^ *"cases_of_search": \([0-9]*\).*/\1/p' "$out/fit.json")
[ "$cases" -le $most ] || { echo "$cases cases, more than $most"; exit 1; }
awk '/^    "?{/ || /^    {/ { low = high = name = "" } /"high":/ && high == "" { high = $2 + 0 } /"low":/ && low == "" { low = $2 + 0 }
  /"name":/ { name = $2; gsub(/[",]/, "", name) } /^    }/ { if (name != "") print name, low, high }' "$out/fit.json" >"$out/ends"
cat "$out/ends"
held=0
while read -r name low high; do
  value=$(sed -n "s/.*[{ ]$name = { \([0-9.e-]*\)[*,][^}]*\"the truth\".*/\1/p" "$study/data.lua" | head -n 1)
  [ -n "$value" ] || continue
  [ "$name" != young ] || value=${value}e6 # MPa
  awk -v x="$value" -v a="$low" -v b="$high" 'BEGIN { exit !(x >= a && x <= b) }' ||
    { echo "$name = $value lies outside $low .. $high"; exit 1; }
  held=$((held + 1))
done <"$out/ends"
[ "$held" -ge 2 ] || { echo "only $held parameters were compared"; exit 1; }
