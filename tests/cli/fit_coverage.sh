#!/bin/sh
# How often the 95 % intervals of a fit of real cases hold the truth: REPEATS fits of a SCENE to curves of its own with noise.
# SCENE: soft (a block slides), drift (the same with noise that is correlated), pull (a sphere drawn off at three speeds) or peel (a tape).
. "$(dirname "$0")/common.sh"
repeats=${2:-20}
scene=${3:-soft}
studies=$here/../../studies

truth() { # "CHOSEN" "FOLDER" LUA: writes truth_NAME.csv, x and y without noise, by FOLDER's study with those values
  cat >"$2/data.lua" <<END
local study, stiction = require "study", require "stiction"
local u = stiction.units
local function write(name, x, y)
  local file = io.open("truth_" .. name .. ".csv", "w")
  for i = 1, #x do file:write(("%.17g %.17g\n"):format(x[i], y[i])) end
  file:close()
end
return study:variant { fit = false, sample = false, figures = false, $1, check = function(cases) $3 end }
END
  expect 0 "" "$stiction" run "$2/data.lua" --trust --no-figures --out truth
}

noisy() { # NAME SEED SIGMA "HEADER" FILE [LENGTH]: the truth with noise of the deviation SIGMA, correlated over LENGTH
  awk -v seed="$2" -v sigma="$3" -v header="$4" -v over="${6:-0}" 'BEGIN { srand(seed); for (k = 0; k < 20; ++k) rand(); print header }
    { share = over > 0 && NR > 1 ? exp(-($1 - last) / over) : 0; last = $1
      noise = share * noise + sqrt(1 - share ^ 2) * sqrt(-2 * log(1 - rand())) * cos(6.283185307179586 * rand())
      printf "%s,%.9g\n", $1, $2 + sigma * noise }' "truth_$1.csv" >"$5"
}

edited() { # FILE "WORDS"...: the edits of a study took hold
  file=$1
  shift
  for words in "$@"; do
    holds "$file has no '$words': the study that it is made from has changed" grep -qF -- "$words" "$file"
  done
}

make_soft() { # [FOLDER EDIT]
  folder=${1:-soft}
  changed "$folder" 's/^  quick = .*/  fit = { parameters = { young = { 0.1*MPa, 10*MPa, scale = "log" }, mu = { 0.02, 0.5, start = 0.15 } },\
    data = { drag = { file = "drag.csv", x = "time", y = "force", sigma = 0.05*units("N\/m"),\
        against = { x = "time", y = "sole\/force_x", y_sign = -1, after = 1*s } } } },\
  quick = { sweep = { mu = { 0.2 } }, set = { steps = 5 } },/'
  edited "$folder/study.lua" 'drag = { file = "drag.csv"'
  sed -i "${2:-}" "$folder/study.lua"
  truth 'sweep = { mu = { 0.1 } }, chosen = { young = { 1.2*u.MPa, "the truth" } }' "$folder" '
    local x, y, force = {}, {}, cases[1]:series("sole", "force_x")
    for i, t in ipairs(cases[1].time) do
      if t > 1.05 then x[#x + 1], y[#y + 1] = t, -force[i] end
    end
    write("drag", x, y)'
  true_values="mu 0.1 young 1.2e6"
}
noise_soft() { noisy drag "$1" 0.05 "time [s],force [N/m]" soft/drag.csv; }

make_drift() {
  make_soft drift 's/steps = { 10/steps = { 40/; s/sigma = 0.05/correlation = 0.05*s, &/'
  edited drift/study.lua 'steps = { 40' 'correlation = 0.05*s, sigma'
}
noise_drift() { noisy drag "$1" 0.05 "time [s],force [N/m]" drift/drag.csv 0.05; }

make_pull() {
  mkdir pull
  sed '/^    finer = /d; s/0.05\*mm, "twenty/0.1*mm, "ten/; s/steps = { 150, /steps = { 50, /' "$studies/fit/pull_off/study.lua" >pull/study.lua
  edited pull/study.lua '0.1*mm, "ten' 'steps = { 50, '
  holds "pull/study.lua still has a finer mesh" [ "$(grep -c '^    finer = ' pull/study.lua)" = 0 ]
  touch pull/slow.csv pull/middle.csv pull/quick.csv
  truth 'chosen = { young = { 0.8*u.MPa, "" .. "the truth" }, w = { 0.6*u.J/u.m^2, "the truth" },
    b = { 0.03*u.N*u.s/u.m, "the truth" } }' pull '
    for i, name in ipairs { "slow", "middle", "quick" } do
      local height, pulled = study.definition.fit.data[name].against(cases[i], cases[i].p)
      local x, y = {}, {}
      for k = 0, 39 do
        x[k + 1] = height[1] + (height[#height] - height[1]) * k / 39
        y[k + 1] = stiction.numeric.interpolate(height, pulled, x[k + 1])
      end
      write(name, x, y)
    end'
  true_values="young 0.8e6 w 0.6 b 0.03"
}
noise_pull() {
  for name in slow middle quick; do
    noisy "$name" "$1$(printf %s "$name" | wc -c)" 3e-4 "height [m],pull [N]" "pull/$name.csv"
  done
}

make_peel() {
  mkdir peel
  sed '/^  sweep = /d; s/^  quick = .*/  sweep = {}, fit = { parameters = { w = { 2*J\/m^2, 50*J\/m^2, start = 14*J\/m^2, scale = "log" },\
      young = { 20*MPa, 500*MPa, start = 70*MPa, scale = "log" } },\
    data = { pull = { file = "pull.csv", x = "time", y = "force", sigma = 0.5*N\/m, against = { x = "time", y = "pull\/force_y" } } } },/
    s/given = { young = 100\*MPa, /given = { young = 100*MPa, w = 10*J\/m^2, /; s/length = { 6.4\*mm/length = { 4*mm/
    s/lift = { 4\*mm/lift = { 2*mm/; s/C = { 1e9/C = { 2e8/; s/steps = { 200/steps = { 80/' "$studies/examples/peeling_tape/study.lua" >peel/study.lua
  edited peel/study.lua 'pull = { file = "pull.csv"' 'given = { young = 100*MPa, w = 10*J/m^2, ' 'length = { 4*mm' 'lift = { 2*mm' \
    'C = { 2e8' 'steps = { 80'
  truth 'given = { w = 10*u.J/u.m^2 }' peel 'write("pull", cases[1].time, cases[1]:series("pull", "force_y"))'
  true_values="w 10 young 1e8"
}
noise_peel() { noisy pull "$1" 0.5 "time [s],force [N/m]" peel/pull.csv; }

"make_$scene"
rejected=0
: >ends
for i in $(seq "$repeats"); do
  "noise_$scene" "$i"
  "$stiction" fit "$scene" --no-figures --out fit >output 2>&1 || rejected=$((rejected + 1))
  awk '/"high"/ { if (high == "") high = $2 + 0 } /"low"/ { if (low == "") low = $2 + 0 }
    /"name": / { name = $2; gsub(/[",]/, "", name); print name, low, high }
    /^    [{}]/ { low = high = "" }' fit/fit.json >>ends
done
least=$((repeats * 90 / 100))
[ "$repeats" -ge 100 ] || least=$((repeats * 80 / 100))
# shellcheck disable=SC2086
set -- $true_values
while [ $# -gt 1 ]; do
  inside=$(awk -v name="$1" -v value="$2" '$1 == name && $2 != "" && $2 < value + 0 && value + 0 < $3 { ++n } END { print n + 0 }' ends)
  bias=$(awk -v name="$1" -v value="$2" '$1 == name && NF == 3 { sum += (($2 + $3) / 2 - value) / ($3 - $2); ++n } END { print n ? sum / n : 1 }' ends)
  echo "of $repeats fits $inside hold $1, the middles are off by $bias of the intervals"
  holds "$1 is within in $inside of $repeats" [ "$inside" -ge "$least" ]
  [ "$repeats" -lt 100 ] || holds "$1 is off by less than a tenth of its interval" awk -v bias="$bias" 'BEGIN { exit !(bias < 0.1 && bias > -0.1) }'
  shift 2
done
echo "$rejected rejected"
holds "the true model is rejected in $rejected of $repeats" [ "$rejected" -le $((1 + repeats / 50)) ]
finish
