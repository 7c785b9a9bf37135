#!/bin/sh
# stiction fit: what it finds and leaves, kept cases, kills, failing cases, and what is refused.
. "$(dirname "$0")/common.sh"

changed soft 's/^  quick = .*/  fit = { parameters = { young = { 0.1*MPa, 10*MPa, scale = "log", start = 3*MPa }, mu = { 0.02, 0.5, start = 0.15 } },\
    data = { drag = { file = "drag.csv", x = "time", y = "force", sigma = "scatter",\
        against = { x = "time", y = "sole\/force_x", y_sign = -1, after = 1*s } },\
      press = { file = "press.csv", x = "time", y = "force", sigma = 0.1*units("N\/m"), against = function(run)\
        local t, f = {}, {}\
        for i, at in ipairs(run.time) do if at <= 1 then t[#t + 1], f[#f + 1] = at, run:series("sole", "force_y")[i] end end\
        return t, f end } },\
    finer = { cells = 8 }, further = { { descent = 0.03*mm } } },\
  quick = { sweep = { mu = { 0.2 } }, set = { steps = 5 } },/'
cat >soft/drag.csv <<'END'
# made up for this test: mu = 0.1, 1 MPa
time [s],force [N/m],scatter [N/m]
1.1,0.53,0.02
1.2,1.04,0.02
1.3,1.55,0.02
1.4,1.99,0.02
1.5,2.33,0.02
1.6,2.31,0.02
1.7,2.335,0.02
1.8,2.30,0.02
1.9,2.34,0.02
2.0,2.315,0.02
END
printf 'time [s],force [N/m]\n0.2,4.7\n0.4,9.2\n0.6,13.85\n0.8,18.7\n1.0,23.4\n' >soft/press.csv

value_of() { # NAME FILE: what the first "NAME": of a fit.json is
  sed -n "s/^ *\"$1\": \([^,]*\),*\$/\1/p" "$2" | head -n 1
}
between() { awk -v x="$1" -v a="$2" -v b="$3" 'BEGIN { exit !(x >= a && x <= b) }'; }

expect 0 "15 points of 2 curves, 2 parameters|determined: mu and young|the model agrees|drag with descent = |output: out/soft/fit" \
  "$stiction" fit soft --no-figures
json=out/soft/fit/fit.json
holds "mu is found: $(value_of best $json)" between "$(value_of best $json)" 0.099 0.101
holds "the simulation's own error" grep -q '"simulation_error": 0.00' $json
holds "curves with residuals" [ "$(wc -l <out/soft/fit/curves.csv)" = 16 ]
holds "the data are kept with their content" [ "$(find out/soft/fit/source -name drag.csv | wc -l)" = 1 ]
holds "no row of another study in the sweep" [ ! -e out/soft/summary.csv ]
expect 0 "0 of them run now" "$stiction" fit soft --no-figures
expect 0 "output: serial" "$stiction" fit soft --no-figures --jobs 1 --out serial
cp serial/fit.json unforced
expect 0 "run now, 0 kept" "$stiction" fit soft --no-figures --jobs 1 --out serial --force
holds "forced or not" cmp serial/fit.json unforced
holds "the same to the last bit, however many at a time" cmp $json serial/fit.json
holds "and its path" cmp out/soft/fit/fit.csv serial/fit.csv

expect 0 "recomputed from the kept source|0 differ too much" "$stiction" verify serial
expect 0 "report.html" "$stiction" report soft
holds "one page on it" grep -q 'Parameters from measured curves' out/soft/fit/report.html

# killed in the middle, it goes on where it was and ends alike
"$stiction" fit soft --no-figures --jobs 1 --out killed >/dev/null 2>&1 &
process=$!
await '[ "$(ls -d killed/p* 2>/dev/null | wc -l)" -ge 6 ]' 60
kill -9 $process 2>/dev/null
wait $process 2>/dev/null
await '"$stiction" fit soft --no-figures --out killed >output 2>&1' 60 # its last case may still hold the folder
holds "a killed fit ends alike" cmp $json killed/fit.json
holds "what it had is kept: $(tail -n 2 output)" [ "$(sed -n 's/.* now, \([0-9]*\) kept/\1/p' output)" -ge 3 ]

# cases that fail are data: the search retreats, and says so
mkdir edge
cp soft/* edge
sed -i 's/^  scene = function(p)/&\n    if p.young < 0.95*MPa then error("too soft") end/' edge/study.lua
expect 0 "failed, taken as too far|too soft|determined: mu and young" "$stiction" fit edge --no-figures --no-profiles
holds "the same best values: $(value_of best out/edge/fit/fit.json)" between "$(value_of best out/edge/fit/fit.json)" 0.099 0.101
mkdir crushed # where cases do not converge; that is kept as well
cp soft/* crushed
sed -i 's/y = { 0\*mm, -p.descent, -p.descent }/y = { 0*mm, (p.young < 0.95*MPa and -60 or -1) * p.descent, -p.descent }/' crushed/study.lua
expect 0 "failed, taken as too far|not converged|determined: mu and young" "$stiction" fit crushed --no-figures --no-profiles
expect 0 "0 of them run now|failed, taken as too far" "$stiction" fit crushed --no-figures --no-profiles
sed -i 's/p.young < 0.95/p.young > 0.95/' edge/study.lua
expect 2 "too soft" "$stiction" fit edge --no-figures

# a parameter of one curve's comparison alone, further starts, an outlier under a robust loss, errors that are not told
cp soft/study.lua soft/own.lua
sed -i 's/start = 0.15 } },/start = 0.4 } }, starts = 6, loss = "cauchy",/; s/file = "drag.csv", x = "time", y = "force", sigma = "scatter",/file = "off.csv",\
  x = "time", y = "force", own = { zero = { -1*units("N\/m"), 1*units("N\/m") } },/; s/sigma = 0.1\*units("N\/m"),/weight = 2,/
  s/against = { x = "time", y = "sole.force_x", y_sign = -1, after = 1\*s } },/against = function(run, p)\
    local t, f = {}, {}\
    for i, at in ipairs(run.time) do if at >= 1 then t[#t + 1], f[#f + 1] = at, p.zero.si - run:series("sole", "force_x")[i] end end\
    return t, f end },/' soft/own.lua
sed 's/^1.3,1.55/1.3,1.85/' soft/drag.csv >soft/off.csv
expect 0 "6  start|determined: mu and young|NOT CLAIMED, whatever the data say: drag.zero|not claimed|errors of the data were not given" "$stiction" fit soft/own.lua --no-figures \
  --no-profiles --out own
holds "mu is found all the same: $(value_of best own/fit.json)" between "$(value_of best own/fit.json)" 0.095 0.105

# where all slides the drag is mu times a force that goes with the modulus: only their product is told; and what nothing tells
sed 's/file = "drag.csv"/file = "slip.csv"/; s/^      press = .*/      }, unused = function(run)/; s/^    finer = .*/    finer = { steps = 20 } },/' \
  soft/study.lua | sed '/unused = function/,/return t, f end } },/d; s/^    data = { drag/    data = { drag/' >soft/slip.lua
sed -i 's/y_sign = -1, after = 1\*s } },$/y_sign = -1, after = 1*s } } },/' soft/slip.lua
sed '/^1.[1-6]/d' soft/drag.csv >soft/slip.csv
sed -i 's/start = 0.15/start = 0.08/' soft/slip.lua
expect 0 "determined only in combination: mu and young; what these data tell is mu * young" "$stiction" fit soft/slip.lua \
  --no-figures --no-profiles --out slip

# noise that is correlated along a curve: as it is told, and as residuals tell it
sed 's/sigma = "scatter",/&  correlation = 0.2*s,/' soft/study.lua >soft/declared.lua
expect 0 "the noise of drag is correlated over 0.2 s: its 10 points are worth 3.2 independent ones|determined: mu" "$stiction" fit \
  soft/declared.lua --no-figures --no-profiles --out declared
holds "so says its file" grep -q '"correlation": 0.2' declared/fit.json
holds "whitened residuals beside those of the points" grep -q '^curve,x,y,sigma,model,residual,whitened$' declared/curves.csv
sed 's/sigma = "scatter",/&  correlation = "estimated",/' soft/study.lua >soft/estimated.lua
expect 0 "the noise of drag is correlated over |, as its residuals tell" "$stiction" fit soft/estimated.lua --no-figures \
  --no-profiles --out estimated

# the same noise as a table of covariances; and beside noise of each point's own
awk -F, '$1 > 0 && /^[0-9]/ { x[++n] = $1; s[n] = $3 } END { for (i = 1; i <= n; ++i) for (k = 1; k <= n; ++k) {
  d = x[i] > x[k] ? x[i] - x[k] : x[k] - x[i]
  printf "%.12g%s", s[i] * s[k] * exp(-d / 0.2), k < n ? "," : "\n" } }' soft/drag.csv >soft/common.txt
{ echo "# covariances of drag.csv" && cat soft/common.txt; } >soft/common.csv
sed 's/sigma = "scatter",/covariance = { file = "common.csv", unit = "N^2\/m^2" },/' soft/study.lua >soft/common.lua
expect 0 "the noise of drag is as common.csv says: its 10 points are worth 3.2 independent ones|determined: mu" "$stiction" fit \
  soft/common.lua --no-figures --no-profiles --out common
same=$(value_of best declared/fit.json)
holds "what a length says as well: $(value_of best common/fit.json) $same" between "$(value_of best common/fit.json)" \
  "$(awk "BEGIN { printf \"%.12g\", $same * (1 - 1e-6) }")" "$(awk "BEGIN { printf \"%.12g\", $same * (1 + 1e-6) }")"
holds "the table is among the files" grep -q '"path": "common.csv"' common/fit.json
expect 0 "correlated as common.csv says" "$stiction" explain soft/common.lua
sed 's/sigma = "scatter",/&  correlation = 0.2*s, white = 0.02*units("N\/m"),/' soft/study.lua >soft/white.lua
expect 0 "the noise of drag is correlated over 0.2 s, beside what each point has for itself: its 10 points are worth 4.75 independent ones" "$stiction" fit \
  soft/white.lua --no-figures --no-profiles --out white

# a wrong model is rejected
sed 's/file = "drag.csv"/file = "wrong.csv"/' soft/study.lua >soft/wrong.lua
sed 's/^1\.1,0.53/1.1,1.9/; s/^2.0,2.315/2.0,1.2/' soft/drag.csv >soft/wrong.csv
expect 1 "MODEL REJECTED by the data|whether others end lower is not known" "$stiction" fit soft/wrong.lua --no-figures --no-profiles --out wrong
holds "so says its file" grep -q '"rejected": true' wrong/fit.json

# what cannot be moved a little says why
sed 's/mu = { 0.02, 0.5, start = 0.15 }/steps = { 5, 20 }, &/' soft/study.lua >soft/whole.lua
expect 0 "NOT DETERMINED by these data: steps|1 derivatives could not be had|a whole number is wanted" \
  "$stiction" fit soft/whole.lua --no-figures --no-profiles --out whole

refused() { # NAME SED-EXPRESSION "PART|PART": a copy of the study, or of its data, that is refused with this message
  mkdir -p "$1"
  cp soft/study.lua soft/block.lua soft/*.csv "$1"
  sed -i "$2" "$1/study.lua" "$1"/*.csv
  expect 2 "$3" "$stiction" fit "$1" --no-figures
}
refused unit 's/^time \[s\],force \[N.m\]$/time [s],force/' "column 'force' names no unit|units = { force = "
refused order 's/^1.3,1.55/1.15,1.55/' "drag.csv: time does not increase from row 2 (1.2) to row 3 (1.15)"
refused number 's/^1.3,1.55/1.3,nan/' "row 3, column 'force': 'nan' is no number"
refused few '/^1.[2-9]/d; /^2.0/d; /^0.[4-8]/d; /^1.0/d' "2 measured points for 2 parameters"
refused beyond 's/^2.0,2.315/2.5,2.315/' "the data go from 1.1 to 2.5 in time (SI), the run from 1 to 2"
refused start 's/start = 3\*MPa/start = 30*MPa/' "begin at 30 MPa, which is not between its bounds 0.1 MPa and 10 MPa"
refused own 's/, start = 3\*MPa//; s/{ 0.1\*MPa, 10/{ 2*MPa, 10/' "begin at 1 MPa (the study's own value)"
refused mesh 's/mu = { 0.02, 0.5, start = 0.15 }/mu = { 0.02, 0.5, start = 0.15 }, cells = { 2, 8 }/' "'cells' changes the mesh"
refused bounds 's/{ 0.1\*MPa, 10\*MPa/{ 10*MPa, 0.1*MPa/' "the first must be less"
refused dimension 's/{ 0.1\*MPa, 10\*MPa/{ 0.1*mm, 10*mm/; s/start = 3\*MPa/start = 3*mm/' "the dimensions differ"
refused sigma 's/^1.3,1.55,0.02/1.3,1.55,0/' "sigma[3] is 0"
refused length 's/sigma = "scatter",/sigma = "scatter", correlation = 0*s,/' "correlation is 0 s; a length is above 0"
refused negative 's/sigma = "scatter",/sigma = "scatter", correlation = -0.1*s,/' "correlation is -0.1 s; a length is above 0"
refused across 's/sigma = "scatter",/sigma = "scatter", correlation = 0.1*mm,/' "correlation is 0.1 mm; it must be a length along time, like 1 s"
refused word 's/sigma = "scatter",/sigma = "scatter", correlation = "told",/' "correlation is told; it must be a length along time, like 1 s, or"
refused long 's/sigma = "scatter",/sigma = "scatter", correlation = 5*s,/' "longer than the curve, 0.9 in SI|own = { zero = { from, to } }"
refused short 's/sigma = 0.1/correlation = "estimated", &/' 'correlation = "estimated" takes 10 points, there are 5'
refused alone 's/sigma = "scatter",/white = 0.1*units("N\/m"), &/' "say sigma of that, and correlation"
refused white 's/sigma = "scatter",/&  correlation = 0.1*s, white = 0.1*mm,/' "white is 0.1 mm; it must be above 0 and like force"
table() { # NAME FILE-COMMAND UNIT SETTINGS "PART|PART": a table of covariances that is refused so
  mkdir -p "$1"
  cp soft/*.lua soft/*.csv "$1"
  eval "$2" >"$1/common.csv"
  sed "s/sigma = \"scatter\",/covariance = { file = \"common.csv\", unit = \"$3\" },$4/" soft/study.lua >"$1/study.lua"
  expect 2 "$5" "$stiction" fit "$1" --no-figures
}
table unlike "cat soft/common.csv" N "" 'unit = "N"; it must be like the square of force, in N/m'
table unknown "cat soft/common.csv" "N.2" "" "unknown unit 'N.2'"
table both "cat soft/common.csv" 'N^2\/m^2' " sigma = \"scatter\"," "covariance says all of the noise; leave out sigma"
table less "cut -d, -f1-9 soft/common.txt | head -9" 'N^2\/m^2' "" "has 9 rows for 10 points"
table narrow "cut -d, -f1-9 soft/common.txt" 'N^2\/m^2' "" "10 rows of 9; as many columns as rows are wanted, and no head"
table headed "sed 1s/^[^,]*/force/ soft/common.txt" 'N^2\/m^2' "" "row 1, column 1: 'force' is no number"
table skew "sed '2s/^[^,]*/0.0001/' soft/common.txt" 'N^2\/m^2' "" "(2, 1) and (1, 2) differ; a covariance is symmetric"
table gone "sed '1s/^[^,]*/0/' soft/common.txt" 'N^2\/m^2' "" "variance 1 is 0; it is above 0"
table flat "yes 1,1,1,1,1,1,1,1,1,1 | head -10" 'N^2\/m^2' "" "is not positive definite: the least eigenvalue of its correlations is"
refused key 's/finer = {/finest = {/' "unknown key 'finest'; did you mean 'finer'?"
refused loss 's/finer = {/loss = "hubert", finer = {/' "did you mean 'huber'?"
refused setting 's/finer = { cells/finer = { cels/' "study.fit.finer: the study has no parameter 'cels'; did you mean 'cells'?"
refused same 's/finer = { cells = 8/finer = { cells = 4/' "study.fit.finer: cells = 4 is what the cases have already"
refused coarser 's/finer = { cells = 8/finer = { cells = 2/' "study.fit.finer: cells = 2 is coarser than the cases' 4"
refused larger 's/finer = { cells = 8/finer = { descent = 0.03*mm/' "study.fit.finer: descent = 0.03 mm is coarser than the cases' 0.02 mm"
refused fitted 's/finer = { cells = 8/finer = { young = 2*MPa/' "study.fit.finer: 'young' is fitted"
refused held 's/against = { x = "time"/case = { young = 1*MPa }, &/' "study.fit.data.drag: case.young = 1 MPa stands beside the fit's own"
refused further 's/further = { { descent/further = { { descend/' \
  "study.fit.further: the study has no parameter 'descend'; did you mean 'descent'?"
expect 2 "begin at 30 MPa" "$stiction" fit soft --no-figures --set 'young=30 MPa' --out begun
refused nobody 's/mu = { 0.02, 0.5, start = 0.15 }/nu = { 0.02, 0.5 }, mu = { 0.02, 0.5, start = 0.15 }/' \
  "the study has no parameter 'nu'; did you mean 'mu'?"
refused column 's/y_sign = -1/y_sine = -1/' "unknown key 'y_sine'; did you mean 'y_sign'?"
refused ways 's/= at, run/= math.abs(at - 0.55), run/' "the run's time goes back and forth"
refused units 's/{ x = "time", y = "sole/{ x = "sole\/force_y", y = "sole/' \
  "sole/force_y of the run is in N/m, time of the file in s"
refused clock 's/^time \[s\],force/time [mm],force/' "time of the run is in s, time of the file in mm"
refused series 's/sole\/force_x/sole\/forse_x/' "has no series 'sole/forse_x'; did you mean"
expect 2 "has no \`fit = { parameters =, data = }\`" "$stiction" fit "$tiny"
finish
