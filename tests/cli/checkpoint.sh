#!/bin/sh
# Cases that are stopped and killed at random moments, they and the run that started them: the next run goes on where they
# stood, and ends bitwise as one that nobody disturbed. $2: how many moments.
. "$(dirname "$0")/common.sh"
moments=${2:-12}
seed=${3:-16}

random() { # N: 0 ... N - 1, the same ones for a seed
  seed=$(((seed * 1103515245 + 12345) % 2147483648))
  echo $((seed / 65536 % $1))
}

number() { printf '%s.%03d' "$(($1 / 1000))" "$(($1 % 1000))"; } # of thousandths

untimed() { # columns of a summary but for the seconds
  awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == "seconds") own = i } { $own = ""; print }' "$1"
}

cat >same.lua <<'L'
local engine = require "stiction.engine"
local test, equal = ...
for id in (engine.read_file "ids"):gmatch "%S+" do
  test(id, function()
    local a, b = engine.read_series("plain/" .. id .. "/series.h5"), engine.read_series("cut/" .. id .. "/series.h5")
    local columns = engine.series_columns(a)
    equal(table.concat(engine.series_columns(b), " "), table.concat(columns, " "))
    equal(#engine.series_time(b), #engine.series_time(a))
    for _, name in ipairs(columns) do
      local u, v = engine.series_column(a, name), engine.series_column(b, name)
      for i = 1, #u do
        if string.pack("d", u[i]) ~= string.pack("d", v[i]) then
          equal(("%s row %d: %.17g"):format(name, i, v[i]), ("%.17g"):format(u[i]))
        end
      end
    end
  end)
end
L

compare() { # plain and cut
  for file in fields fields.pvd steps.csv; do
    for id in $(cat ids); do
      diff -r "plain/$id/$file" "cut/$id/$file" >different || complain "$* $file of $id: $(cat different)"
    done
  done
  untimed plain/summary.csv >a
  untimed cut/summary.csv >b
  holds "$* summary: $(diff a b)" cmp -s a b
  "$stiction" luatest same.lua >output 2>&1 || complain "$* series: $(cat output)"
  holds "$* a checkpoint is left" [ -z "$(ls cut/*/checkpoint* 2>/dev/null)" ]
}

changed drag 's/mu = { 0, 0.2, 0.4 }/mu = { 0, 0.3 }/'
echo "mu0 mu0.3" >ids
settings="run $work/drag --set steps=1500 --no-figures --jobs 2 --checkpoint 0.02 --out"
began=$(date +%s%N)
# shellcheck disable=SC2086 # words
"$stiction" $settings plain >output 2>&1 || complain "the undisturbed run: $(cat output)"
whole=$((($(date +%s%N) - began) / 1000000)) # ms

disturb() { # starts a run, and ends it or its cases at a random moment
  # shellcheck disable=SC2086 # words
  "$stiction" $settings cut >"output.$1" 2>&1 </dev/null &
  id=$!
  if [ "$disturbed" = 0 ]; then # one at least has something to go on from
    await '[ -n "$(ls cut/*/checkpoint 2>/dev/null)" ]' || complain "no checkpoint is kept: $(cat output.*)"
  else
    sleep "$(number "$(random $((whole / 2 + 50)))")"
  fi
  case $(random 5) in
  0) kill -TERM $id ;;
  1) kill -INT $id ;;
  2) kill -KILL $id ;;
  3) pgrep -P $id | xargs -r kill -TERM ;;
  4) pgrep -P $id | xargs -r kill -KILL ;;
  esac 2>/dev/null
  wait $id 2>/dev/null
}

last() { # a run to the end, once all processes of those before have ended
  for _ in $(seq 100); do
    # shellcheck disable=SC2086 # words
    "$stiction" $settings cut >output.last 2>&1 && break
    grep -q "is in use by" output.last || break
    sleep 0.1
  done
  grep -q "checks held" output.last || complain "the last run after $disturbed moments: $(cat output.*)"
}

disturbed=0
while [ "$disturbed" -lt "$moments" ] && [ "$failures" = 0 ]; do
  rm -rf cut
  for attempt in 1 2 3; do
    disturb $attempt
    disturbed=$((disturbed + 1))
  done
  last
  cat output.* >>all_outputs
  compare "after $disturbed moments,"
done
# its files hold the same, if not in the same places
expect 0 "0 differ too much|histories equal to the last bit" "$stiction" verify cut
# a checkpoint that finds no room is told, once, and the case goes on; one that is damaged is refused
changed large 's/mu = { 0, 0.2, 0.4 }/mu = { 0.2 }/; s/schedule = stiction/output = stiction.output { frames = 0 }, schedule = stiction/'
(
  ulimit -f 3000 # blocks of 512 bytes
  expect 0 "where the case stands is not kept: cannot write|checks held" \
    "$stiction" run large --set cells=150 --set steps=2 --no-figures --checkpoint 0 --out full
  holds "told more than once" [ "$(grep -c "is not kept" output)" = 1 ]
  exit "$failures"
) || failures=$((failures + $?))
"$stiction" case drag --case mu0.3 --set steps=100 --stop-after 99 --out spoiled >output 2>&1
printf 'x' | dd of=spoiled/mu0.3/checkpoint bs=1 seek=2000 conv=notrunc 2>/dev/null
expect 0 "checkpoint spoiled/mu0.3/checkpoint is damaged: the case starts anew" \
  "$stiction" run drag --case mu0.3 --set steps=100 --no-figures --out spoiled
# what is made anew to go on is no work of the case: also of a body whose factor lasts for the whole run
changed linear 's/neo_hookean/linear_elastic/; s/mu = { 0, 0.2, 0.4 }/mu = { 0.3 }/
  s/^  results = {/  results = { { name = "work", function(run) return run.cost.work end },\
    { name = "factors", function(run) return run.cost.factorizations end },\
    { name = "columns", function(run) return run.cost.compliance_columns end },/'
settled="run linear --set steps=60 --no-figures --out"
# shellcheck disable=SC2086 # words
"$stiction" $settled at_once >output 2>&1 || complain "a linear body: $(cat output)"
holds "factors: $(cat at_once/summary.csv)" grep -q '^mu0.3,0.3,[0-9.e+]*,[1-3],' at_once/summary.csv
for after in 1 40 110; do
  rm -rf in_two
  "$stiction" case linear --case mu0.3 --set steps=60 --stop-after $after --out in_two >output 2>&1
  # shellcheck disable=SC2086 # words
  expect 0 "goes on from t = " "$stiction" $settled in_two
  untimed at_once/summary.csv >a
  untimed in_two/summary.csv >b
  holds "costs after $after: $(diff a b)" cmp -s a b
done
"$stiction" case drag --case mu0.3 --set steps=100 --stop-after 99 --out again >output 2>&1
expect 0 "finished" "$stiction" run drag --case mu0.3 --set steps=100 --no-figures --force --out again
holds "--force goes on" sh -c '! grep -q "goes on" output'
holds "no run went on where another had stopped" grep -qs "goes on from t = " all_outputs
finish
