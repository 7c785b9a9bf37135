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
jobs=${JOBS:-2}           # of the compiler
nice=${NICE:-10}          # of compiling
workers=${WORKERS:-2}     # faults tried at a time by the engine's tests; other tests run one at a time
targets="stiction_tests stiction-engine stiction-mesher stiction-figures test_figures stiction_vtk_tests"
seed=${SEED:-1}           # of the choice of N
budget=${BUDGET:-1e9}     # s, of the engine's tests, and of all others, on one fault
longest=${LONGEST:-300}   # s, tests that take longer are left out

usage() {
  echo "Usage: tests/mutants.sh [N] [--only NUMBER]... [--again] [--fresh] [--check | --plant | --as-built]"
  echo "Tries N faults taken at random (SEED=$seed), or all. What was noticed once is not tried again without --again."
  echo "--fresh measures anew which tests reach which fault; --check ends when all are planted, --plant when they are"
  echo "compiled as well, --as-built begins there."
  exit "$1"
}

count="" only="" again=no fresh=no check=no plant_only=no as_built=no one=""
while [ $# -gt 0 ]; do
  case $1 in
  --as-built) as_built=yes ;;
  --one) one=$2 && shift ;; # the engine's tests on one fault, in a process of its own
  --only) only="$only $2" && shift ;;
  --again) again=yes ;;
  --fresh) fresh=yes ;;
  --check) check=yes ;;
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
  tests/*.?pp) # clang before 16 captures no structured bindings
    if grep -q 'auto const&* \[' "$root/$1"; then sed '/^ *\(CAPTURE\|INFO\)(.*);$/d'; else cat; fi
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
  { cmake -S "$tree" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DSTICTION_SANITIZE=ON -DSTICTION_UNITY=OFF -DCMAKE_C_COMPILER=clang \
    -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_CXX_FLAGS_RELEASE="-O0 -DNDEBUG" \
    -DCMAKE_CXX_FLAGS="-w -idirafter $tree/tests -include $tree/tests/lint/source_location.hpp" &&
    nice -n "$nice" ninja -C "$build" -k 0 -j "$jobs" $targets; } >"$work/build.log" 2>&1 ||
    { grep -E 'error|FAILED' "$work/build.log" || tail -n 20 "$work/build.log"; exit 1; }
}

# All tests but those of the sources, of the installation and of what takes minutes.
other_tests() {
  ctest --test-dir "$build" -N -LE full -E '^(engine|lint|order|install|extremes|seeds)/' | sed -n 's/^ *Test *#[0-9]*: //p'
}

run_unit_tests() { # SECONDS, names parted by commas: the first one that fails
  OPENBLAS_NUM_THREADS=1 timeout -k 5 "$1" "$build/tests/stiction_tests" -aa=1 -tc="$2" >"$scratch/output" 2>&1 </dev/null && return
  name=$(sed -n 's/^TEST CASE:  *//p' "$scratch/output" | head -n 1)
  echo "engine/${name:-no end in time}"
}

run_other_test() { # SECONDS NAME: its name if it fails
  pattern=$(printf '%s' "$2" | sed 's/[^A-Za-z0-9_/]/./g')
  timeout -k 5 "$1" ctest --test-dir "$build" -R "^$pattern\$" >"$scratch/output" 2>&1 </dev/null && return
  echo "$2"
}

measure_units() {
  rm -f "$units" "$work"/share.*
  tests=$("$build/tests/stiction_tests" -c | sed -n 's/.*filters: *\([0-9][0-9]*\).*/\1/p')
  for k in $(seq "$workers"); do
    truncate -s 4096 "$work/reached.$k"
    STICTION_MUTANTS_REACHED=$work/reached.$k STICTION_MUTANTS_TESTS=$work/share.$k "$build/tests/stiction_tests" \
      -f=$((tests * (k - 1) / workers + 1)) -l=$((tests * k / workers)) >"$work/units.$k.log" 2>&1 </dev/null &
  done
  wait
  cat "$work"/share.* >"$units"
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

# NUMBER FILE ALL: seconds and names of the tests that passed and reach it (or all), those first that are quick and reach
# little else.
reaching() {
  awk -F '\t' -v k="$1" -v all="$3" '$1 == 1 {
    for (i = 4; i <= NF && $i != k; ++i);
    if (i <= NF || all)
      printf "%g\t%s\t%s\n", ($2 + 1e-3) * NF, $2, $3 }' "$2" | sort -g | cut -f 2- |
    awk -F '\t' -v most="$budget" '{ sum += $1 } NR == 1 || sum <= most'
}

# Batches of unit tests, each twice as long as the one before: seconds and names parted by commas, a comma of theirs as
# doctest's wildcard.
batches() {
  awk -F '\t' 'function flush() { if (names != "") print int(10 * sum + 20) "\t" names; names = ""; sum = 0; most *= 2 }
    BEGIN { most = 2 } { if (sum + $1 > most) flush(); sum += $1; gsub(",", "?", $2); names = names (names == "" ? "" : ",") $2 } END { flush() }'
}

by_units() { # NUMBER: the first test of the engine that notices it, or nothing
  export STICTION_MUTANT="$1"
  reaching "$1" "$units" 0 | batches >"$scratch/batches"
  while IFS="$(printf '\t')" read -r seconds names; do
    seen=$(run_unit_tests "$seconds" "$names")
    [ -z "$seen" ] || { echo "$seen" && return; }
  done <"$scratch/batches"
}

by_others() { # NUMBER: the first other test that notices it, or nothing
  export STICTION_MUTANT="$1"
  all=1
  grep -qx "$1" "$work/listed.txt" && all=0
  reaching "$1" "$others" "$all" >"$scratch/batches"
  while IFS="$(printf '\t')" read -r seconds name; do
    seen=$(run_other_test "$(echo "$seconds * 10 + 20" | bc | cut -d. -f1)" "$name")
    [ -z "$seen" ] || { echo "$seen" && return; }
  done <"$scratch/batches"
}

known() { # KEY: what noticed it before
  awk -F '\t' -v key="$1" '$1 == key && $3 != "" { print $3; exit }' "$results"
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
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
if [ -n "$one" ]; then
  key=$(awk -F '\t' -v k="$one" '$1 == k { print $2 }' "$work/entries")
  printf '%s\t%s\t%s\n' "$key" "$one" "$(by_units "$one")" >>"$results"
  exit
fi

if [ "$as_built" = no ]; then
  git -C "$root" ls-files --cached --others --exclude-standard | sort >"$work/files.sorted"
  plant
  [ "$check" = no ] || exit 0
  compile
  [ "$plant_only" = no ] || exit 0
fi
touch "$results"
[ "$again" = no ] || : >"$results"
for k in $only; do
  sed -i "/^[^\t]*\t$k\t/d" "$results"
done
entries >"$work/entries"
choose >"$work/chosen"
if [ "$fresh" = yes ] || [ -z "$(find "$units" -newer "$build/tests/stiction_tests" 2>/dev/null)" ]; then
  say "measuring which tests of the engine reach what"
  measure_units
fi
while IFS="$(printf '\t')" read -r number key rest; do
  [ -n "$(known "$key")" ] || echo "$number"
done <"$work/chosen" | xargs -r -P "$workers" -n 1 sh "$0" --one
[ -n "${UNITS_ONLY:-}" ] || measure_others
while IFS="$(printf '\t')" read -r number key head why; do
  seen=$(known "$key")
  if [ -z "$seen" ] && [ -z "${UNITS_ONLY:-}" ]; then
    seen=$(by_others "$number")
    printf '%s\t%s\t%s\n' "$key" "$number" "$seen" >>"$results"
  fi
  if [ -n "$seen" ]; then
    echo "$number $head: noticed by $seen"
  elif [ -n "$why" ]; then
    echo "$number $head: EQUIVALENT, $why"
  else
    echo "$number $head: NOT NOTICED"
  fi
done <"$work/chosen" | tee "$work/report.txt"
awk '/: noticed by /{ ++seen } /: EQUIVALENT, /{ ++same }
  END { printf "%d of %d noticed (%.1f %%), %d explained as equivalent\n", seen, NR, 100 * seen / NR, same }' "$work/report.txt"
