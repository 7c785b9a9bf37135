#!/bin/sh
# What the machine does not give: memory, room for files; and scripts that never end. One clear message, data so far kept.
. "$(dirname "$0")/common.sh"

limited() { # LIMIT COMMAND...: under `ulimit LIMIT`
  limit=$1
  shift
  # shellcheck disable=SC2086
  (ulimit $limit && exec "$@")
}

if ! grep -q __asan_init "$stiction"; then # whose shadow wants all addresses
  echo 'local t = {} for i = 1, 1e9 do t[i] = i end' >hungry.lua
  expect 1 "memory ran out: the process held|GB that it may take|--jobs" limited "-v 2000000" "$stiction" run hungry.lua
  # so little that no thread starts: it must end all the same
  for kilobytes in 80000 150000 200000; do
    limited "-v $kilobytes" timeout -s KILL 60 "$stiction" help >output 2>&1 </dev/null
    code=$?
    [ "$code" -lt 128 ] || complain "with $kilobytes kB of addresses it ended with $code: $(cat output)"
  done
  changed large 's/cells = { p.cells, p.cells }/cells = { 1000, 1000 }/'
  expect 1 "memory ran out: the process held|explain STUDY" \
    limited "-v 900000" "$stiction" run large --case mu0 --no-figures --jobs 1 --out large_out
  grep -q 'std::bad_alloc' output && complain "bad_alloc is no message"
fi

# a file that may grow no more: the case says so
changed drag ''
expect 1 "File too large|what was written before stays readable" limited "-f 200" "$stiction" run drag --case mu0 \
  --set steps=400 --no-figures --out small
grep -q 'signal' output && complain "a signal is no message"

cat >endless.lua <<'L'
local function spin()
  while true do end
end
spin()
L
"$stiction" run endless.lua >output 2>&1 </dev/null &
id=$!
for _ in $(seq 600); do
  grep -qs "endless.lua:2 is still running after" output && break
  sleep 0.1
done
kill -INT "$id"
wait "$id"
holds "no word of the endless loop: $(cat output)" grep -q "endless.lua:2 is still running after .* s of the script's own work" output
finish
