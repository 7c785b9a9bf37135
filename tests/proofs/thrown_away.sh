#!/bin/sh
# A case of every proof, with every third step made once and thrown away before it is made again: its histories are
# bitwise those of the undisturbed run.
set -u
stiction=$1 proofs=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failures=0
for study in "$proofs"/*/; do
  name=$(basename "$study")
  id=$("$stiction" run "$study" --quick --list --out "$work/list" 2>/dev/null | sed -n '1s/  .*//p')
  [ -n "$id" ] || continue
  for often in 0 3; do
    "$stiction" case "$study" --quick --case "$id" --out "$work/$name/$often" --rehearse "$often" >"$work/output" 2>&1
  done
  plain=$work/$name/0/$id/series.h5
  [ -f "$plain" ] || continue # contact problems alone
  cmp "$plain" "$work/$name/3/$id/series.h5" || {
    echo "FAILED: $name, case $id"
    failures=$((failures + 1))
  }
done
exit "$((failures > 0))"
