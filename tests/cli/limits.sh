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

# a half space keeps so many numbers of each point at its peak
cat >grid.lua <<'L'
local stiction = require "stiction"
local u = stiction.units
local mm, um, s = u.mm, u.um, u.s
return stiction.study {
  title = "grid", given = { n = 256, w = 0*u.J/u.m^2 },
  scene = function(p)
    return stiction.scene { kinematics = "three_dimensional", scheme = stiction.scheme.quasi_static {},
      bodies = { base = stiction.body.half_space { young = 1*u.MPa, poisson = 0.3, size = { 2*mm, 2*mm }, points = { p.n, p.n },
        boundary = "free" } },
      obstacles = { ball = stiction.obstacle.height_map { surface = stiction.surface.sphere { radius = 10*mm },
        times = { 0*s, 1*s }, z = { 0*um, -10*um } } },
      pairs = { touch = stiction.pair { secondary = "base.surface", primary = "ball",
        adhesion = p.w.si > 0 and stiction.adhesion.potential { w = p.w, delta = 10*um } or nil } },
      schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = 1 } } },
      probes = { touch = stiction.probe.contact { pair = "touch" } } }
  end,
}
L
peak() { # OPTION...: kB at the peak, by one thread: what each other one keeps to itself comes and goes
  rm -rf grid
  "$stiction" run grid.lua --no-figures --threads 1 --out grid "$@" >output 2>&1 || complain "grid: $(cat output)"
  sed -n 's/.*"peak_memory":\([0-9]*\)[0-9][0-9][0-9]\..*/\1/p' grid/case/manifest.json
}
arrays() { # OPTION...
  small=$(peak "$@" --set n=256)
  large=$(peak "$@" --set n=512)
  echo $(((large - small) / (8 * (512 * 512 - 256 * 256) / 1000)))
}
if ! grep -q __asan_init "$stiction"; then # which pads what it keeps
  dry=$(arrays)
  pulled=$(arrays --set 'w=0.05 J/m^2')
  holds "$dry numbers of a dry point, fewer than 26" [ "${dry:-99}" -lt 26 ]
  holds "$pulled numbers of a point that is pulled, fewer than 40" [ "${pulled:-99}" -lt 40 ]
fi
finish
