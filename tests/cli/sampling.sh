#!/bin/sh
# stiction sample: numbers and files, extension, lists, a fit's covariance, failing cases, and what is refused.
. "$(dirname "$0")/common.sh"

changed soft 's/^  quick = .*/  sample = { of = { mu = { uniform = { 0.02, 0.2 } }, young = { log_normal = { 1*MPa, 0.2 } } }, count = 16 },\
  fit = { parameters = { young = { 0.1*MPa, 10*MPa, scale = "log" }, mu = { 0.02, 0.5, start = 0.15 } }, profiles = false,\
    data = { drag = { file = "drag.csv", x = "time", y = "force", sigma = 0.02*units("N\/m"),\
      against = { x = "time", y = "sole\/force_x", y_sign = -1, after = 1*s } } } },\
  quick = { sweep = { mu = { 0.2 } }, set = { steps = 5 } },/'
printf 'time [s],force [N/m]\n1.1,0.53\n1.2,1.04\n1.3,1.55\n1.4,1.99\n1.5,2.33\n1.6,2.31\n1.8,2.30\n2.0,2.315\n' >soft/drag.csv

expect 0 "16 points of sobol|force_x/(N/m)|mu  |young|polynomial|16 cases, 16 of them run now|output: out/soft/sample" \
  "$stiction" sample soft --no-figures
holds "a row per point" [ "$(wc -l <out/soft/sample/sample.csv)" = 17 ]
head -n 17 out/soft/sample/sample.csv >first
expect 0 "32 cases, 16 of them run now, 16 kept" "$stiction" sample soft --count 32 --no-figures
holds "more points keep those there are" [ "$(head -n 17 out/soft/sample/sample.csv)" = "$(cat first)" ]
expect 0 "0 of them run now, 16 kept" "$stiction" sample soft --no-figures
expect 0 "output: serial" "$stiction" sample soft --no-figures --jobs 1 --out serial
holds "the same however many at a time" cmp out/soft/sample/sample.json serial/sample.json

expect 0 "report.html" "$stiction" report soft
holds "one page on it" grep -q 'Whose the variance is' out/soft/sample/report.html
sed 's/count = 16 }/count = 8, design = "saltelli" }/' soft/study.lua >soft/pairs.lua
expect 0 "32 points of saltelli|pairs of points" "$stiction" sample soft/pairs.lua --no-figures --out pairs
sed 's/count = 16 }/count = 8, design = "latin_hypercube" }/' soft/study.lua >soft/cube.lua
expect 0 "8 points of latin_hypercube" "$stiction" sample soft/cube.lua --no-figures --out cube
sed 's/sample = { of = .*/sample = { list = { { mu = 0.1, young = 1*MPa }, { mu = 0.2, young = 2*MPa }, { mu = 0.3, young = 1*MPa } } },/' \
  soft/study.lua >soft/list.lua
expect 0 "3 points of a list|3 cases, 3 of them run now" "$stiction" sample soft/list.lua --no-figures --out list
printf 'mu,young [MPa]\n0.1,1\n0.15,1.1\n' >soft/values.csv
sed 's/sample = { of = .*/sample = { list = "values.csv" },/' soft/study.lua >soft/file.lua
expect 0 "2 points of a list" "$stiction" sample soft/file.lua --no-figures --out file
# what is wrong in a list is told with its place: file, row and column, or the point's number
in_file() { # HEAD ROW "PART|PART": a file of points that is refused so
  printf '%s\n0.1,1\n%s\n' "$1" "$2" >soft/values.csv
  expect 2 "$3" "$stiction" sample soft/file.lua --no-figures --out file
}
in_file 'mu,young [N]' '0.15,1.1' "values.csv: row 1, column 'young': 'young' must be like 1 MPa, not 1 N"
in_file 'mu,young' '0.15,1.1' "values.csv: row 1, column 'young': 'young' must be like 1 MPa, not 1"
in_file 'nu,young [MPa]' '0.15,1.1' "values.csv: row 1, column 'nu': the study has no parameter 'nu'; did you mean 'mu'?"
in_file 'mu,young [MPa]' '0.15,soft' "row 2, column 'young': 'soft' is no number"
in_file 'mu,young [MPa]' '# 0.15,1.1' "with as many rows; values.csv has 1"
expect 2 "--set mu: 'mu' is what study.sample draws" "$stiction" sample soft --no-figures --set mu=0.3 --out set
in_list() { # POINT "PART|PART": a second point that is refused so
  sed "s/{ mu = 0.2, young = 2\*MPa }/$1/" soft/list.lua >soft/other.lua
  expect 2 "$2" "$stiction" sample soft/other.lua --no-figures
}
in_list '{ mu = 0.2, young = 2*mm }' "study.sample.list[2]: 'young' must be like 1 MPa, not 2 mm"
in_list '0.2' "study.sample.list[2] is 0.2; { name = value, ... } is wanted"
in_list '{ 0.2, 2*MPa }' "study.sample.list[2] is a table that lacks names"
sed "s/{ mu = 0.1, young = 1\*MPa }/{ mu = 0.1 }/" soft/list.lua >soft/other.lua
expect 0 "3 points of a list" "$stiction" sample soft/other.lua --no-figures --out other
holds "what a point leaves out is the study's own: $(cat other/sample.csv)" [ "$(grep -c '^case,mu,young,\|,0\.[123],[12]000000,' other/sample.csv)" = 4 ]

sed 's/sample = { of = .*/sample = { fit = true, count = 8 },/' soft/study.lua >soft/fitted.lua
expect 2 "there is no fit in out/fitted/fit/fit.json" "$stiction" sample soft/fitted.lua --no-figures
expect 0 "determined: mu and young" "$stiction" fit soft/fitted.lua --no-figures
expect 0 "8 points of sobol|depend on each other" "$stiction" sample soft/fitted.lua --no-figures

sed -i 's/"best": /"bets": /' out/fitted/fit/fit.json
expect 2 "fit.json is damaged; run the fit again" "$stiction" sample soft/fitted.lua --no-figures

# parameters of one curve alone: whose is to be said; those that `against` alone reads belong to no case
cat >soft/own.json <<'END'
{ "parameters": [
  { "name": "young", "key": "young", "unit": "Pa", "log": true, "best": 1e6, "error": 1e4, "relative_error": 0.01 },
  { "name": "one.zero", "key": "zero", "curve": "one", "unit": "m", "log": false, "best": 1e-6, "error": 1e-7, "relative_error": 0.1 },
  { "name": "one.mu", "key": "mu", "curve": "one", "unit": "1", "log": false, "best": 0.1, "error": 1e-4, "relative_error": 1e-3 },
  { "name": "two.mu", "key": "mu", "curve": "two", "unit": "1", "log": false, "best": 0.2, "error": 1e-4, "relative_error": 1e-3 } ],
"curves": [ { "name": "one" }, { "name": "two" } ], "free": [ "young", "one.zero", "one.mu", "two.mu" ],
"covariance": [ [ 1e-4, 9e-4, 0, 0 ], [ 9e-4, 1e-2, 0, 0 ], [ 0, 0, 1e-6, 0 ], [ 0, 0, 0, 1e-6 ] ] }
END
of_curve() { # WHAT study.sample.fit IS: the study in soft/curve.lua
  sed "s/sample = { of = .*/sample = { fit = $1, count = 4 },/" soft/study.lua >soft/curve.lua
}
of_curve '"own.json"'
expect 2 'each of the curves one, two has a '"'mu'"' of its own; say whose: fit = { curve = "one" }' "$stiction" sample soft/curve.lua --no-figures
of_curve '{ file = "own.json", curve = "too" }'
expect 2 "has no curve 'too'; did you mean 'two'?; its curves: one, two" "$stiction" sample soft/curve.lua --no-figures
of_curve '{ file = "own.json", curve = "two" }'
expect 0 "left out, as no case has it (the fit's \`against\` alone reads it): one.zero" "$stiction" sample soft/curve.lua --no-figures
holds "mu is that of the curve" [ "$(awk -F, 'NR > 1 && $2 > 0.19 && $2 < 0.21' out/curve/sample/sample.csv | wc -l)" = 4 ]
holds "what is drawn is that of the curve" grep -q '^mu  *0.2 1 .*two$' output
grep -q remark: output && complain "a curve that was asked for is remarked: $(cat output)"
of_curve true
mkdir -p asked
sed '/"name": "one\./d; s/, "one.zero", "one.mu"//; s/^"covariance.*/"covariance": [ [ 1e-4, 0 ], [ 0, 1e-6 ] ] }/' soft/own.json >asked/fit.json
expect 0 "4 points of sobol|remark: mu is the curve two's own, and no other curve's; every point takes it" "$stiction" sample \
  soft/curve.lua --no-figures --out asked
holds "whose it is stands in the file: $(cat asked/sample.json)" grep -q '"curve": "two"' asked/sample.json

# a parameter at its bound is held there, one with a distribution of its own, or one value, is not drawn as the fit has it
sed 's/, "two.mu" ]/ ]/; s/"free": \[.*/"free": [ "young" ],/; s/^"covariance.*/"covariance": [ [ 1e-4 ] ] }/' asked/fit.json >soft/bound.json
of_curve '"bound.json"'
expect 0 "held at its bound  two" "$stiction" sample soft/curve.lua --no-figures --out bound
holds "mu is that of the fit" [ "$(awk -F, 'NR > 1 && $2 == 0.2' bound/sample.csv | wc -l)" = 4 ]
of_curve '"own.json", of = { mu = { uniform = { 0.3, 0.4 } } }'
expect 0 "not as the fit has it, but as sample.of or sample.set say: mu" "$stiction" sample soft/curve.lua --no-figures --out otherwise
holds "mu is that of the distribution" [ "$(awk -F, 'NR > 1 && $2 > 0.3 && $2 < 0.4' otherwise/sample.csv | wc -l)" = 4 ]
of_curve '"own.json", set = { mu = 0.35 }'
expect 0 "not as the fit has it, but as sample.of or sample.set say: mu" "$stiction" sample soft/curve.lua --no-figures --out otherwise
holds "mu is that of set" [ "$(awk -F, 'NR > 1 && $2 == 0.35' otherwise/sample.csv | wc -l)" = 4 ]

# what cannot be told is a "-", and the help says why
sed 's/^  scene = function(p)/&\n    if p.mu > 0.1 then error("too rough") end/' soft/list.lua >soft/rough.lua
expect 1 "2 of 3 cases failed" "$stiction" sample soft/rough.lua --no-figures --out rough
holds "a result that one case has: $(cat output)" grep -q '^force_x/(N/m)  *-  *-  *-  *-  *-  *-$' output
expect 0 'A "-" stands where there is|an offset of the measured height, are left out|100000 cases' "$stiction" help sample

# cases that fail are listed by where they lie, and the rest is told
mkdir edge
cp soft/* edge
sed -i 's/^  scene = function(p)/&\n    if p.mu < 0.065 then error("too slippery") end/; s/count = 16/count = 32/' edge/study.lua
expect 1 "8 of 32 cases failed|too slippery|they lie at small mu: between" "$stiction" sample edge --no-figures
holds "in the units of the study: $(cat output)" grep -q '^  young = 1\?[0-9.]* MPa: \|, young = [0-9.]* MPa: ' output
sed 's/if p.mu < 0.065 then error("too slippery") end/error("never")/' edge/study.lua >edge/never.lua
expect 2 "never" "$stiction" sample edge/never.lua --no-figures
grep -q 'no scene reads' output && complain "scenes that cannot be made are said to read nothing: $(cat output)"
expect 1 "8 of 32 cases failed" "$stiction" sample edge --no-figures
holds "they are in sample.json" grep -q '"reason": "bad input: .*too slippery' out/edge/sample/sample.json
# of saltelli's design each coordinate occurs in several points: where failures lie is told by those that are independent
sed 's/if p.mu < 0.065 .* end$/if p.descent < 0.015*mm then error("too little") end/
  s/count = 32/count = 8, design = "saltelli"/; s/of = { mu/of = { descent = { uniform = { 0.01*mm, 0.03*mm } }, mu/' \
  edge/study.lua >edge/pairs.lua
expect 1 "10 of 40 cases failed|they lie at small descent|(chance 0.01)" "$stiction" sample edge/pairs.lua --no-figures
holds "and along no other: $(grep lie output)" [ "$(grep -c 'they lie at' output)" = 1 ]

refused() { # SED-EXPRESSION "PART|PART"
  sed "$1" soft/study.lua >soft/other.lua
  expect 2 "$2" "$stiction" sample soft/other.lua --no-figures
}
refused 's/uniform = { 0.02, 0.2 }/unifrom = { 0.02, 0.2 }/' "did you mean 'uniform'?"
refused 's/uniform = { 0.02, 0.2 }/uniform = { 0.2, 0.02 }/' "uniform takes { low, high }"
refused 's/uniform = { 0.02, 0.2 }/uniform = { 0.2, 0.02 }/' "low below high, both of one dimension, not { 0.2, 0.02 }"
refused 's/mu = { uniform = { 0.02, 0.2 } }/mu = { 0.02, 0.2 }/' "study.sample.of.mu must be one of { uniform ="
refused 's/count = 16/count = 16, set = { mu = 0.1 }/' "'mu' stands in both of and set (0.1); leave it in one of them"
refused 's/of = { mu =/of = { nu =/' "the study has no parameter 'nu'; did you mean 'mu'?"
refused 's/log_normal = { 1\*MPa, 0.2 }/log_normal = { 1*mm, 0.2 }/' "must be like"
refused 's/count = 16/count = 1/' "2 or more, is wanted"
refused 's/count = 16/count = 100000000/' "count = 100000000; it is 2 to 100000, each a case of its own: take fewer points"
refused 's/count = 16/count = 30000, design = "saltelli"/' "30000 of saltelli's design are 120000 cases, at most 100000: take fewer points"
refused 's/count = 16/design = "sobel"/' "did you mean 'sobol'?"
refused 's/count = 16/results = { "forse_x" }/' "no result 'forse_x'; did you mean 'force_x'?"
refused 's/sample = { of = .*/sample = { count = 3 },/' "study.sample needs of = "
expect 2 "has no \`sample = { of = { ... } }\`" "$stiction" sample "$tiny"
finish
