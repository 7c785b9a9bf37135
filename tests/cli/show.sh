#!/bin/sh
# Outputs are shown, filtered, sorted, written as csv and compared, without running or changing anything.
. "$(dirname "$0")/common.sh"

# ask COMMAND OPTIONS: what the program does with a command and its options, a table in Lua; its exit code
ask() {
  cat >ask.lua <<END
local test = ...
local engine = require "stiction.engine"
local held, value = engine.call(require "stiction.cli", "$1", $2)
if not held then engine.complain("stiction: " .. tostring(value) .. "\n") end
local told = not held and (value.kind == "input" or value.kind == "script") and 2 or 1
engine.write(("\nexit code %d\n"):format(held and value or told))
test("asked", function() end)
END
  "$stiction" luatest ask.lua >asked 2>&1
  sed '/^$/{N;/^\nexit code/d}; /^exit code/d; /^1 passed, 0 failed$/d' asked
  return "$(sed -n 's/^exit code //p' asked)"
}

"$stiction" run "$tiny" --out a --no-figures --jobs 1 >/dev/null || complain "no output to look at"
before=$(find a -type f -exec cksum {} + | sort)
expect 0 "case   verdict    mu  force_y/(N/m)  force_x/(N/m)|mu0.2  finished  0.2|a: 3 cases: 3 finished" ask show '{ study = "a" }'
expect 0 "3 cases" ask show '{ study = "nothing here", out = "a/" }'

# filter, order, columns
expect 0 "3 cases: 3 finished; 2 chosen" ask show '{ study = "a", where = "mu > 0.1 and force_x > 0", sort = "-mu" }'
holds "order: $(cat output)" [ "$(sed -n '2s/ .*//p; 3s/ .*//p' output | tr '\n' ' ')" = "mu0.4 mu0.2 " ]
expect 0 "; 0 chosen" ask show '{ study = "a", where = "verdict ~= '"'finished'"'" }'
expect 0 "case   young/(kg m^-1 s^-2)  steps|mu0                 1000000     10" ask show '{ study = "a", columns = "case,young,steps" }'
expect 2 "--where: a has no parameter or result 'forcex'; did you mean 'force_x'?; there are: case, verdict, mu" \
  ask show '{ study = "a", where = "mu > 1 and forcex > 1" }'
expect 2 "--sort: a has no parameter or result 'my'; did you mean 'mu'?" ask show '{ study = "a", sort = "-my" }'
expect 2 "--columns: a has no parameter or result 'stpes'; did you mean 'steps'?" ask show '{ study = "a", columns = "stpes" }'
expect 2 "--where 'mu = 0.2': ')' expected near '='; it is an expression in Lua" ask show '{ study = "a", where = "mu = 0.2" }'

# what does not fit is counted and named
COLUMNS=30 expect 0 "and 2 more columns, which --columns|prints: force_y," ask show '{ study = "a" }'

# csv: every digit of the rows and columns that are chosen
expect 0 "case,verdict,mu,force_y,force_x|mu0.2,finished,0.2,$(grep '^mu0.2,' a/summary.csv | cut -d, -f 3,4)" \
  ask show '{ study = "a", where = "mu == 0.2", csv = "-" }'
expect 0 "chosen.csv" ask show '{ study = "a", sort = "-force_x", columns = "case,force_x", csv = "chosen.csv" }'
holds "csv: $(cat chosen.csv)" [ "$(sed -n 's/,.*//p' chosen.csv | tr '\n' ' ')" = "case mu0.4 mu0.2 mu0 " ]
expect 0 "both.csv|both.h5: table 'cases'" ask show '{ study = "a", csv = "both.csv", h5 = "both.h5" }'
holds "all that is asked for is written" [ -s both.csv ] && holds "and the second" [ -s both.h5 ]
expect 2 "a/summary.csv is what this table is read from" ask show '{ study = "a", csv = "a/summary.csv" }'

# cases that failed or never ended are shown with their reason
changed raises 's/function(run) return run:at(1\*s, "sole", "force_y")/function(run, p) if p.mu == 0.2 then error("no force") end return run:at(1*s, "sole", "force_y")/'
"$stiction" run raises --no-figures --jobs 1 >/dev/null 2>&1
sed -i 's/^{"result":.*/{/' out/raises/mu0.4/manifest.json
sed -i '/^mu0.4,/d' out/raises/summary.csv
expect 0 "mu0.2  result failed  0.2              -         4.6709|mu0.2: result failed: result force_y: study.lua:34|no force|mu0.4  not finished|1 finished, 1 result failed, 1 not finished" \
  ask show '{ study = "raises" }'
expect 0 "; 1 chosen" ask show '{ study = "raises", where = "force_y > 0" }'

# outputs that cannot be read: one message
expect 2 "there is neither an output folder nor a study at 'nowhere'" ask show '{ study = "nowhere" }'
expect 2 "there is no output folder out/tiny; 'stiction run' on the study makes it" ask show "{ study = \"$tiny\" }"
mkdir empty
expect 2 "empty holds no results" ask show '{ study = "empty" }'
cp -r a broken
sed -i '3s/finished.*//' broken/summary.csv
expect 2 "broken/summary.csv is damaged: line 3 has 5 entries, its head 11" ask show '{ study = "broken" }'
cp -r a newer
sed -i 's/"layout": 2/"layout": 3/' newer/study.json
expect 2 "newer was written by a newer version of Stiction (layout 3;" ask show '{ study = "newer" }'
cp -r a cut
printf '{"result":{"verdict":' >cut/mu0/manifest.json
expect 0 "mu0    unreadable|mu0: unreadable: cut/mu0/manifest.json is damaged" ask show '{ study = "cut" }'
# the summary alone is enough for what it holds
mkdir bare
cp a/summary.csv a/study.json bare
expect 0 "mu0.4  finished  0.4         23.927         5.5723" ask show '{ study = "bare" }'
mkdir hand
printf 'case,steps,law,force,verdict,steps,iterations,contact,seconds,force_error,set,warnings\na,4,rcc,2,finished,8,9,,1,0.1,,\n' >hand/summary.csv
echo '{ "results": [7, { "name": "force", "unit": "kN" }] }' >hand/study.json
expect 0 "case  steps  law  measure_steps  force/(kN)  force_error/(kN)|a         4  rcc              8       0.002            0.0001" \
  ask show '{ study = "hand", columns = "case,steps,law,measure_steps,force,force_error" }'

# comparison
"$stiction" run "$tiny" --out same --no-figures --jobs 1 >/dev/null
expect 0 "3 cases matched by their parameters, 0 by their names|parameters, settings, files and program are the same|9 of 9 results and verdicts are equal (to the last bit)" \
  ask compare '{ a = "a", b = "same" }'
"$stiction" run "$tiny" --out b --set steps=8 --set young=2*MPa --no-figures --jobs 1 >/dev/null
expect 1 "0 cases matched by their parameters, 3 by their names|parameter steps|parameter young|2000000 kg m^-1 s^-2  all|setting bodies.block.material.young|setting schedule.stages.1.steps|4 of 9 results and verdicts" \
  ask compare '{ a = "a", b = "b" }'
"$stiction" run "$tiny" --out c --set steps=9 --no-figures --jobs 1 >/dev/null
expect 1 "parameter steps" ask compare '{ a = "a", b = "c" }'
sed -n 's/^mu.*force_[xy].* //p' output >relative
holds "the furthest is not first: $(cat relative)" sh -c 'sort -gr relative | cmp -s - relative && [ "$(sort -u relative | wc -l)" -gt 2 ]'
expect 0 "9 of 9 results and verdicts are equal (within 0.0001, relative)" ask compare '{ a = "a", b = "c", tolerance = 1e-4 }'
expect 2 "--tolerance must be a relative difference of 0 or more, not -1" ask compare '{ a = "a", b = "c", tolerance = -1 }'
"$stiction" run "$tiny" --out one --case mu0.4 --no-figures >/dev/null
expect 1 "A: one, 1 case|B: a, 3 cases|1 case matched by their parameters|only in B (2): mu0, mu0.2|3 of 3 results" ask compare '{ a = "one", b = "a" }'
expect 1 "only in A (2): mu0, mu0.2" ask compare '{ a = "a", b = "one" }'
expect 2 "there is neither an output folder nor a study at 'missing'" ask compare '{ a = "a", b = "missing" }'
expect 2 "broken/summary.csv is damaged" ask compare '{ a = "a", b = "broken" }'

# what results may be off by stands beside their difference
changed soft 's/^  quick = .*/  trade = { quantities = { "force_y", "force_x" }, set = { mu = 0.2 }, knobs = { { "steps", { 5, 10, 20 } } } },\
  quick = { sweep = { mu = { 0.2 } }, set = { steps = 5 } },/'
"$stiction" run soft --case mu0.2 --check-accuracy --no-figures --jobs 1 >/dev/null
expect 0 "mu0.2  finished         23.715         4.6709" ask show '{ study = "soft" }'
expect 1 "A may be off by  B may be off by|file study.lua" ask compare '{ a = "soft", b = "b" }'

# the same by words on the command line
expect 0 "; 1 chosen" "$stiction" show a --where 'mu > 0.3'
expect 0 "mu0.4,5.57" "$stiction" show nothing --out a --sort -mu --columns case,force_x --csv -
expect 2 "--csv nowhere/a.csv: there is no folder" "$stiction" show nothing --out a --csv nowhere/a.csv
expect 2 "--sheet nowhere/a.png: there is no folder" "$stiction" show nothing --out a --sheet nowhere/a.png --csv b.csv
holds "nothing is written then" [ ! -e b.csv ]
expect 0 "9 of 9 results" "$stiction" compare a same
expect 0 "(within 0.0001, relative)" "$stiction" compare a c --tolerance 1e-4 --all
expect 2 "compare: " "$stiction" compare a
expect 0 "--where" "$stiction" show --help
expect 0 "--tolerance" "$stiction" compare --help
expect 0 "show STUDY|compare A B" "$stiction" help commands

holds "an output was changed" [ "$before" = "$(find a -type f -exec cksum {} + | sort)" ]
finish
