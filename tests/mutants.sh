#!/bin/sh
# Plants the faults listed in tests/mutants/*.txt in a copy of the sources, all in one build that STICTION_MUTANT=NUMBER
# switches, and says which tests notice each.
set -eu
root=$(cd "$(dirname "$0")/.." && pwd)
lists=$root/tests/mutants
work=$root/build/mutants
tree=$work/tree
build=$work/build
results=$work/results.txt # key, number, what noticed it or nothing
units=$work/units.txt     # tests of the engine: passed, seconds, name, numbers reached
others=$work/others.txt   # all other tests: the same, after the lists they were tried with (listed.txt)
jobs=${JOBS:-2}           # for compiling; tests run one at a time
nice=${NICE:-10}          # of compiling
targets="stiction_tests stiction-engine stiction-mesher stiction-figures test_figures stiction_vtk_tests"
seed=${SEED:-1}           # of the choice of N
longest=${LONGEST:-300}   # s, tests that take longer are left out

usage() {
  echo "Usage: tests/mutants.sh [N] [--only NUMBER]... [--again] [--fresh] [--plant]"
  echo "Tries N faults taken at random (SEED=$seed), or all. What was noticed once is not tried again without --again."
  echo "--fresh measures anew which tests reach which fault; --plant ends when all are planted and compiled."
  exit "$1"
}

count="" only="" again=no fresh=no plant_only=no
while [ $# -gt 0 ]; do
  case $1 in
  --only) only="$only $2" && shift ;;
  --again) again=yes ;;
  --fresh) fresh=yes ;;
  --plant) plant_only=yes ;;
  --help | -h) usage 0 ;;
  *[!0-9]* | "") usage 2 ;;
  *) count=$1 ;;
  esac
  shift
done

say() { echo "mutants: $*" >&2; }

replace() { # NEW OLD: keeps the time of what has not changed
  if cmp -s "$1" "$2"; then rm "$1"; else mkdir -p "$(dirname "$2")" && mv "$1" "$2"; fi
}

# What two files of the copy need besides: the notes on tests, the switch for scripts.
equip() { # FILE, its text on standard input
  case $1 in
  tests/main.cpp) cat && echo '#include "mutants/listener.hpp"' ;;
  lua/bind/state.cpp)
    echo '#include "mutants/switch.hpp"'
    sed 's|^  watch_script(lua);|  lua_register(lua, "stiction_mutant", [](lua_State* l) { lua_pushboolean(l, stiction_mutant(static_cast<int>(lua_tointeger(l, 1)))); return 1; });\n  luaL_dostring(lua, "function stiction_either(k, new, old) if stiction_mutant(k) then return new() end return old() end");\n&|'
    ;;
  *) cat ;;
  esac
}

plant() {
  mkdir -p "$tree"
  listed=" $(cat "$lists"/*.txt | sed -n 's/^@ [0-9]* \([^ ]*\):.*/\1/p' | sort -u | tr '\n' ' ')"
  twice=$(cat "$lists"/*.txt | sed -n 's/^@ \([0-9]*\) .*/\1/p' | sort -n | uniq -d)
  [ -z "$twice" ] || { say "numbers given twice: $twice" && exit 1; }
  for file in $listed; do
    [ -f "$root/$file" ] || { say "no file $file" && exit 1; }
  done
  git -C "$root" ls-files --cached --others --exclude-standard >"$work/files"
  wrong=0
  while read -r file; do
    [ -f "$root/$file" ] || continue
    case $file in
    *.cpp | *.hpp | *.lua | *.txt)
      case $listed in
      *" $file "*) awk -v file="$file" -f "$lists/plant.awk" "$lists"/*.txt "$root/$file" >"$work/planted" || wrong=1 ;;
      *) cat "$root/$file" >"$work/planted" ;;
      esac
      equip "$file" <"$work/planted" >"$work/new"
      replace "$work/new" "$tree/$file"
      ;;
    *)
      mkdir -p "$tree/$(dirname "$file")"
      cmp -s "$root/$file" "$tree/$file" || cp -p "$root/$file" "$tree/$file"
      ;;
    esac
  done <"$work/files"
  (cd "$tree" && find . -type f | sed 's|^\./||' | sort) | comm -23 - "$work/files.sorted" | (cd "$tree" && xargs -r rm)
  [ "$wrong" = 0 ] || exit 1
}

# Clang with few optimizations and what makes STICTION_SANITIZE quick takes half of the time that a release does.
compile() {
  # shellcheck disable=SC2086 # lists of words
  { cmake -S "$tree" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DSTICTION_SANITIZE=ON -DCMAKE_C_COMPILER=clang \
    -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_CXX_FLAGS_RELEASE="-O0 -DNDEBUG" \
    -DCMAKE_CXX_FLAGS="-w -idirafter $tree/tests -include $tree/tests/lint/source_location.hpp" &&
    nice -n "$nice" ninja -C "$build" -k 0 -j "$jobs" $targets; } >"$work/build.log" 2>&1 ||
    { grep -E 'error|FAILED' "$work/build.log" || tail -n 20 "$work/build.log"; exit 1; }
}

# All tests but those of the sources, of the installation and of what takes minutes.
other_tests() {
  ctest --test-dir "$build" -N -LE full -E '^(engine|lint|order|install|extremes|seeds)/' | sed -n 's/^ *Test *#[0-9]*: //p'
}

run_unit_tests() { # SECONDS NAMES parted by commas; the first failing one on failure
  OPENBLAS_NUM_THREADS=1 timeout -k 5 "$1" "$build/tests/stiction_tests" -aa=1 -tc="$2" >"$work/output" 2>&1 </dev/null && return
  name=$(sed -n 's/^TEST CASE:  *//p' "$work/output" | head -n 1)
  echo "engine/${name:-no end in time}"
}

run_other_test() { # SECONDS NAME
  pattern=$(printf '%s' "$2" | sed 's/[^A-Za-z0-9_/]/./g')
  timeout -k 5 "$1" ctest --test-dir "$build" -R "^$pattern\$" >"$work/output" 2>&1 </dev/null && return
  echo "$2"
}

measure_units() {
  rm -f "$units"
  truncate -s 4096 "$work/reached"
  STICTION_MUTANTS_REACHED=$work/reached STICTION_MUTANTS_TESTS=$units "$build/tests/stiction_tests" >"$work/units.log" 2>&1 </dev/null || true
  touch "$units"
  awk -F '\t' '$1 == 0 { print "mutants: fails without a fault, left out: " $3 }' "$units" >&2
}

measure_others() {
  if [ "$fresh" = yes ] || [ ! -f "$others" ]; then
    : >"$others"
    cat "$lists"/*.txt | sed -n 's/^@ \([0-9]*\) .*/\1/p' >"$work/listed.txt"
  fi
  other_tests | while read -r name; do
    cut -f 3 "$others" | grep -qxF -- "$name" && continue
    rm -f "$work/reached" && truncate -s 4096 "$work/reached"
    from=$(date +%s.%N)
    passed=1
    [ -z "$(STICTION_MUTANTS_REACHED=$work/reached run_other_test "$longest" "$name")" ] || passed=0
    [ "$passed" = 1 ] || say "fails without a fault, left out: $name"
    numbers=$(od -An -v -tu1 -w1 "$work/reached" | awk '$1 == 1 { printf "\t%d", NR - 1 }')
    printf '%s\t%.2f\t%s%s\n' "$passed" "$(echo "$(date +%s.%N) - $from" | bc)" "$name" "$numbers" >>"$others"
  done
}

reaching() { # NUMBER FILE: seconds and names of the tests that passed and reach it, quickest first
  awk -F '\t' -v k="$1" -v all="$3" '$1 == 1 { for (i = 4; i <= NF; ++i) if ($i == k || all) { print $2 "\t" $3; next } if (all) print $2 "\t" $3 }' "$2" |
    sort -g
}

# Batches of unit tests, each twice as long as the one before: seconds and names parted by commas.
batches() {
  awk -F '\t' 'function flush() { if (names != "") print int(10 * sum + 20) "\t" names; names = ""; sum = 0; most *= 2 }
    BEGIN { most = 2 } { if (sum + $1 > most) flush(); sum += $1; names = names (names == "" ? "" : ",") $2 } END { flush() }'
}

notice() { # NUMBER: the first test that notices it, or nothing
  export STICTION_MUTANT="$1"
  reaching "$1" "$units" 0 | batches >"$work/batches"
  while IFS="$(printf '\t')" read -r seconds names; do
    seen=$(run_unit_tests "$seconds" "$names")
    [ -z "$seen" ] || { echo "$seen" && return; }
  done <"$work/batches"
  all=1
  grep -qx "$1" "$work/listed.txt" && all=0
  reaching "$1" "$others" "$all" >"$work/batches"
  while IFS="$(printf '\t')" read -r seconds name; do
    seen=$(run_other_test "$(echo "$seconds * 10 + 20" | bc | cut -d. -f1)" "$name")
    [ -z "$seen" ] || { echo "$seen" && return; }
  done <"$work/batches"
}

# Number, key that changes with the entry, file and meaning, why it is equivalent.
entries() {
  cat "$lists"/*.txt | awk '
    function flush() { if (number != "") printf "%s\t%s\t%s\t%s\n", number, number "." length(body) "." sum, head, why }
    /^@ / { flush(); number = $2; head = substr($0, index($0, $3)); body = ""; sum = 0; why = "" }
    /^~ / { why = substr($0, 3); next }
    { body = body $0; for (i = 1; i <= length($0); ++i) sum = (sum * 31 + index("abcdefghijklmnopqrstuvwxyz0123456789_.+-*/()<>=!&|?:", substr($0, i, 1)) + 1) % 1000003 }
    END { flush() }'
}

choose() {
  if [ -n "$only" ]; then
    for k in $only; do awk -F '\t' -v k="$k" '$1 == k' "$work/entries"; done
  elif [ -n "$count" ]; then
    awk -v seed="$seed" 'BEGIN { srand(seed) } { print rand() "\t" $0 }' "$work/entries" | sort -g | cut -f 2- | head -n "$count" | sort -n
  else
    cat "$work/entries"
  fi
}

mkdir -p "$work"
git -C "$root" ls-files --cached --others --exclude-standard | sort >"$work/files.sorted"
plant
[ "$plant_only" = no ] || { entries | wc -l | xargs echo "planted:" >&2; }
compile
[ "$plant_only" = no ] || exit 0
touch "$results"
[ "$again" = no ] || : >"$results"
say "measuring which tests reach what"
if [ "$fresh" = yes ] || [ -z "$(find "$units" -newer "$build/tests/stiction_tests" 2>/dev/null)" ]; then measure_units; fi
measure_others
entries >"$work/entries"
choose >"$work/chosen"
while IFS="$(printf '\t')" read -r number key head why; do
  known=$(awk -F '\t' -v key="$key" '$1 == key && $3 != "" { print $3; exit }' "$results")
  if [ -z "$known" ] || [ -n "$only" ]; then
    known=$(notice "$number")
    printf '%s\t%s\t%s\n' "$key" "$number" "$known" >>"$results"
  fi
  if [ -n "$known" ]; then
    echo "$number $head: noticed by $known"
  elif [ -n "$why" ]; then
    echo "$number $head: EQUIVALENT, $why"
  else
    echo "$number $head: NOT NOTICED"
  fi
done <"$work/chosen" | tee "$work/report.txt"
awk '/: noticed by /{ ++seen } /: EQUIVALENT, /{ ++same } END { printf "%d of %d noticed (%.1f %%), %d explained as equivalent\n", seen, NR, 100 * seen / NR, same }' "$work/report.txt"
