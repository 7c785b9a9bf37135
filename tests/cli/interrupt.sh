#!/bin/sh
# Ctrl-C: endless scripts and running sweeps end cleanly with exit code 1, and what was computed is readable.
. "$(dirname "$0")/common.sh"

# interrupted "CONDITION" COMMAND...: SIGINT once the condition holds, and a little later; leaves code and output
interrupted() {
  condition=$1
  shift
  "$@" >output 2>&1 </dev/null &
  id=$!
  await "$condition"
  kill -INT "$id"
  wait "$id"
  code=$?
}

await() { # "CONDITION": for a minute at most, then half a second
  for _ in $(seq 600); do
    eval "$1" && break
    sleep 0.1
  done
  sleep 0.5
}

printed() { # TEXT...: every one is among what the command printed
  for text in "$@"; do
    grep -qs "$text" output || return 1
  done
}

running() { [ "$(cases_running | wc -l)" = "$1" ]; }

cat >endless.lua <<'L'
print "begun"
while true do
  pcall(function() while true do end end)
end
L
interrupted "printed begun" "$stiction" run endless.lua
holds "the endless script ended with $code" [ "$code" = 1 ]
holds "no message: $(cat output)" printed "stopped by the user while a script was running, in endless.lua:3"

# what writes nothing ends at once, also within the engine: no memory is held
changed huge 's/cells = { 4,/cells = { 700,/'
for signal in INT TERM; do
  for command in "explain $work/huge" "run $work/huge --no-figures --out never" "bench $work/huge"; do
    # shellcheck disable=SC2086 # words
    "$stiction" $command >output 2>&1 </dev/null &
    id=$!
    case $command in explain*) sleep 0.3 ;; *) sleep 1.5 ;; esac # which has its answer within a second
    if kill -0 "$id"; then
      began=$(date +%s)
      kill -"$signal" "$id"
      wait "$id"
      code=$?
      holds "$command ended with $code on $signal" [ "$code" = 1 ]
      holds "no message of $command: $(cat output)" printed "stopped by the user"
      holds "$command took its time to end" [ $(($(date +%s) - began)) -le 5 ]
    else
      complain "$command had ended before it could be stopped: $(cat output)"
    fi
  done
done

changed drag ''
interrupted "running 2" "$stiction" run "$work/drag" --set steps=40000 --set cells=40 --no-figures --jobs 2 --out long
holds "the sweep ended with $code" [ "$code" = 1 ]
holds "no message: $(cat output)" printed "stopped; finished cases are kept"
holds "no row of a stopped case: $(cat long/summary.csv)" grep -q "^mu0,.*,stopped," long/summary.csv
holds "children are left" running 0

# a script that is caught at work in a case is stopped, not bad input
changed busy 's/return run:at(1\*s, "sole", "force_y")/print("at work") while true do end/'
interrupted 'printed "mu0: at work" "mu0.2: at work"' "$stiction" run "$work/busy" --no-figures --jobs 2 --out busy_out
holds "the busy sweep ended with $code" [ "$code" = 1 ]
for case in mu0 mu0.2; do
  holds "no row of the stopped script: $(cat busy_out/summary.csv)" grep -q "^$case,.*,stopped," busy_out/summary.csv
  holds "no reason: $(cat output)" printed "$case: stopped: stopped by the user while a script was running, in .*study.lua"
done

# killed outright: its children end too, and the sweep goes on
"$stiction" run "$work/drag" --set steps=40000 --set cells=40 --no-figures --jobs 2 --out killed >output 2>&1 </dev/null &
id=$!
await "running 2"
holds "two children run" running 2
kill -KILL "$id"
wait "$id" 2>/dev/null
await "running 0"
holds "children outlive their parent" running 0
expect 0 "mu0  to run" "$stiction" run "$work/drag" --set steps=40000 --set cells=40 --out killed --list
finish
