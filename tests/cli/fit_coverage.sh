#!/bin/sh
# How often the 95 % intervals of a fit of real cases hold the truth: REPEATS fits of the tiny study to curves of its own with noise.
. "$(dirname "$0")/common.sh"
repeats=${2:-20}

changed soft 's/^  quick = .*/  fit = { parameters = { young = { 0.1*MPa, 10*MPa, scale = "log" }, mu = { 0.02, 0.5, start = 0.15 } },\
    data = { drag = { file = "drag.csv", x = "time", y = "force", sigma = 0.05*units("N\/m"),\
        against = { x = "time", y = "sole\/force_x", y_sign = -1, after = 1*s } } } },\
  quick = { sweep = { mu = { 0.2 } }, set = { steps = 5 } },/'
cat >soft/data.lua <<'END'
-- Writes the truth (mu = 0.1, 1.2 MPa) without noise.
local study = require "study"
return study:variant { fit = false, figures = false, sweep = { mu = { 0.1 } },
  chosen = { young = { 1.2 * require "stiction".units.MPa, "the truth" } },
  check = function(cases)
    local file = io.open("truth.csv", "w")
    local force = cases[1]:series("sole", "force_x")
    for i, t in ipairs(cases[1].time) do
      if t > 1.05 then file:write(("%.17g %.17g\n"):format(t, -force[i])) end
    end
    file:close()
  end }
END
expect 0 "" "$stiction" run soft/data.lua --trust --no-figures --out truth
holds "there are curves" [ -s truth.csv ]

inside_mu=0 inside_young=0 rejected=0
for i in $(seq "$repeats"); do
  awk -v seed="$i" 'BEGIN { srand(seed); for (k = 0; k < 20; ++k) rand(); print "time [s],force [N/m]" }
    { printf "%s,%.6f\n", $1, $2 + 0.05 * sqrt(-2 * log(1 - rand())) * cos(6.283185307179586 * rand()) }' truth.csv >soft/drag.csv
  "$stiction" fit soft --no-figures --out fit >output 2>&1 || rejected=$((rejected + 1))
  awk '/"high"/ { if (high == "") high = $2 + 0 } /"low"/ { if (low == "") low = $2 + 0 }
    /"name": "mu"/ { print "mu", low, high } /"name": "young"/ { print "young", low, high } /^ *}, *$|^ *{ *$/ { if ($0 ~ /^    [{}]/) { low = high = "" } }' \
    fit/fit.json >ends
  awk '$1 == "mu" { exit !($2 < 0.1 && 0.1 < $3) }' ends && inside_mu=$((inside_mu + 1))
  awk '$1 == "young" { exit !($2 < 1.2e6 && 1.2e6 < $3) }' ends && inside_young=$((inside_young + 1))
done
echo "of $repeats fits: mu within $inside_mu, young within $inside_young, $rejected rejected"
least=$((repeats * 90 / 100))
[ "$repeats" -ge 100 ] || least=$((repeats * 80 / 100))
holds "mu is within in $inside_mu of $repeats" [ "$inside_mu" -ge "$least" ]
holds "young is within in $inside_young of $repeats" [ "$inside_young" -ge "$least" ]
holds "the true model is rejected in $rejected of $repeats" [ "$rejected" -le $((1 + repeats / 50)) ]
finish
