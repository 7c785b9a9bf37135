#!/bin/sh
# Ctrl-C: endless scripts and running sweeps end cleanly with exit code 1, and what was computed is readable.
. "$(dirname "$0")/common.sh"

# interrupted CHILDREN COMMAND...: SIGINT once that many run, and a little later; leaves code and output
interrupted() {
  wanted=$1
  shift
  "$@" >output 2>&1 </dev/null &
  id=$!
  await "$wanted"
  kill -INT "$id"
  wait "$id"
  code=$?
}

children() { # processes that run a case of the study `drag`
  for words in /proc/[0-9]*/cmdline; do
    { tr '\0' ' ' <"$words"; } 2>/dev/null | grep -o "case $work/drag --case .*"
  done
}

await() { # a number of children, for a minute at most, then half a second
  for _ in $(seq 600); do
    [ "$(children | wc -l)" = "$1" ] && break
    sleep 0.1
  done
  sleep 0.5
}

cat >endless.lua <<'L'
while true do
  pcall(function() while true do end end)
end
L
interrupted 0 "$stiction" run endless.lua
holds "the endless script ended with $code" [ "$code" = 1 ]
holds "no message: $(cat output)" grep -q "stopped by the user while a script was running, in endless.lua:2" output

changed drag ''
interrupted 2 "$stiction" run "$work/drag" --set steps=40000 --set cells=40 --no-figures --jobs 2 --out long
holds "the sweep ended with $code" [ "$code" = 1 ]
holds "no message: $(cat output)" grep -q "stopped; finished cases are kept" output
holds "no row of a stopped case: $(cat long/summary.csv)" grep -q "^mu0,.*,stopped," long/summary.csv
holds "children are left" [ -z "$(children)" ]

# killed outright: its children end too, and the sweep goes on
"$stiction" run "$work/drag" --set steps=40000 --set cells=40 --no-figures --jobs 2 --out killed >output 2>&1 </dev/null &
id=$!
await 2
holds "two children run" [ "$(children | wc -l)" = 2 ]
kill -KILL "$id"
wait "$id" 2>/dev/null
await 0
holds "children outlive their parent" [ -z "$(children)" ]
expect 0 "mu0  to run" "$stiction" run "$work/drag" --set steps=40000 --set cells=40 --out killed --list
finish
