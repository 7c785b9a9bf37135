#!/bin/sh
# A case that several processes share: 1, 2 and 4 ranks give the answers of one process to 1e-8, linear and at finite
# strain, with friction; how they are refused, stopped, taken up and ended. Exit code 77, with the reason, where this build
# has no PETSc.
. "$(dirname "$0")/common.sh"

mkdir block
cat >block/study.lua <<'L'
-- A small block pressed onto a plane and dragged.
local stiction = require "stiction"
local u = stiction.units
local mm, s, ms, kg, m, MPa, N = u.mm, u.s, u.ms, u.kg, u.m, u.MPa, u.N
local laws = { linear = stiction.material.linear_elastic { young = 5*MPa, poisson = 0.3 },
  finite = stiction.material.neo_hookean { young = 5*MPa, poisson = 0.3 } }
local function of(time, column, sign)
  return function(run) return sign * run:at(time, "sole", column) end
end
return stiction.study {
  title = "A block on a plane", chosen = { steps = { 4, "few" }, plane = { 0, "1: in the plane" }, bulk = { "automatic", "or not" } },
  sweep = { law = { "linear", "finite" } },
  scene = function(p)
    local flat = p.plane == 1
    local z, depth, down = 0*mm, { 4*mm, 4*mm, 2*mm }, { 0*mm, -0.1*mm, -0.1*mm }
    return stiction.scene {
      kinematics = flat and "plane_strain" or "three_dimensional",
      bodies = { block = stiction.body { material = laws[p.law], density = 1000*kg/m^3, mesh = flat
        and stiction.mesh.block { size = { 4*mm, 2*mm }, cells = { 8, 4 } }
        or stiction.mesh.box { size = depth, cells = { 8, 8, 4 } } } },
      obstacles = { floor = stiction.obstacle { shape = stiction.rigid.plane {} } },
      pairs = { sole = stiction.pair { secondary = "block.bottom", primary = "floor",
        friction = stiction.friction.coulomb { mu = 0.3 } } },
      motions = { flat and stiction.motion.drive { set = "block.top", times = { 0*s, 1*s, 2*s }, x = { z, z, 0.05*mm }, y = down }
        or stiction.motion.drive { set = "block.top", times = { 0*s, 1*s, 2*s }, x = { z, z, 0.05*mm }, y = { z, z, z }, z = down } },
      scheme = stiction.scheme.quasi_static {},
      control = stiction.control { bulk = p.bulk },
      schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = 2 }, stiction.stage { to = 2*s, steps = p.steps } } },
      probes = { sole = stiction.probe.contact { pair = "sole" }, ledger = stiction.probe.energy {} },
      output = stiction.output { frames = 1 },
    }
  end,
  results = {
    { name = "press", unit = "N", meaning = "normal force", of(1*s, "force_z", 1) },
    { name = "drag", unit = "N", meaning = "friction", of(2*s, "force_x", -1) },
    { name = "strain", unit = "J", meaning = "strain energy at the end",
      function(run) return run:at(2*s, "ledger", "strain") end },
    { name = "lost", unit = "J", meaning = "friction loss", function(run) return run:at(2*s, "ledger", "friction_loss") end },
  },
}
L

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
expect 2 "not in range 1 to" "$stiction" run block --ranks 1.5 --out none5
holds "nothing has run" [ -z "$(find none[1-5] -name series.h5 2>/dev/null)" ]

# the same answers
numbers() { # folder: results of both cases with every digit
  "$stiction" show "$1" --columns press,drag,strain,lost --csv - | sed 's/"//g'
}
near() { # FILE FILE TOLERANCE: columns that are numbers differ by no more, of the larger
  awk -F, -v most="$3" 'NR == FNR { for (i = 1; i <= NF; ++i) a[FNR, i] = $i; next }
    { for (i = 1; i <= NF; ++i) if ($i + 0 == $i && FNR > 1) {
        d = $i - a[FNR, i]; b = $i; if (d < 0) d = -d; if (b < 0) b = -b; ++seen
        if (d > most * b) { print FNR, i, $i, a[FNR, i]; bad = 1 } } }
    END { exit bad || seen < 8 }' "$1" "$2"
}
expect 0 "finished" "$stiction" run block --no-figures --set bulk=multigrid --out alone
numbers alone >alone.csv
for ranks in 1 2 4; do
  expect 0 "finished" "$stiction" run block --no-figures --ranks $ranks --out "of$ranks"
  numbers "of$ranks" >"of$ranks.csv"
  holds "$ranks ranks: $(near alone.csv "of$ranks.csv" 1e-8)" near alone.csv "of$ranks.csv" 1e-8
  holds "the manifest tells of $ranks ranks" grep -q "\"ranks\": $ranks" "of$ranks/lawfinite/manifest.json"
done
expect 0 "finished" "$stiction" run block --no-figures --ranks 2 --out again
numbers again >again.csv
holds "two runs of two ranks: $(diff of2.csv again.csv)" cmp -s of2.csv again.csv
holds "fields of two runs" cmp -s of2/lawfinite/fields/000002.vtu again/lawfinite/fields/000002.vtu

# stopped: longer than mpirun waits before it hands the signal on
"$stiction" run block --no-figures --ranks 2 --case lawlinear --set steps=20000 --out long >long.txt 2>&1 </dev/null &
run=$!
await '[ -s long/lawlinear/series.h5 ]' || complain "it does not start: $(cat long.txt)"
sleep 1
kill -TERM $run
wait $run
code=$?
holds "stopped with $code: $(cat long.txt)" [ "$code" = 1 ]
holds "a checkpoint is kept" [ -s long/lawlinear/checkpoint ]
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
finish
