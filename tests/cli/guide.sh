#!/bin/sh
# Every whole study in README.md and in the guide for writing studies runs and holds what it claims.
. "$(dirname "$0")/common.sh"

root=$here/../..
for page in README.md lua/README.md; do
  awk '/^```lua/ { on = 1; file = "study_" ++count ".lua"; next } /^```/ { on = 0 } on { print > file }' "$root/$page"
  for study in study_*.lua; do
    grep -q "stiction.study" "$study" || complain "$page: $study is no study"
    expect 0 "finished|output:" "$stiction" run "$study" --quick --no-figures --out "out_$study"
  done
  rm study_*.lua
done
finish
