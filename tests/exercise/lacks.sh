#!/bin/sh
# A law that lacks something does not compile, and the compiler says first and in words what.
# usage: lacks.sh EXERCISE COMPILER FLAG...; EXERCISE holds the extracted header and list.
set -eu
export LC_ALL=C
here=$(cd "$(dirname "$0")" && pwd)
engine=$here/../../engine
exercise=$1
shift
if "$1" --version | grep -q clang; then set -- "$@" -ferror-limit=0; fi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

fail() {
  echo "$1"
  head -n 60 "$work/said"
  exit 1
}

# each law of lacks.cpp lacks one thing, and every complaint that there is comes once
if "$@" -fsyntax-only "$here/lacks.cpp" 2> "$work/said"; then
  fail "laws that lack something were taken"
fi
find "$engine" -name owed.hpp | sort | xargs cat | tr -d '\n' | sed 's/" *"//g' | grep -o 'static_assert([^"]*"[^"]*"' | sed 's/^[^"]*"//; s/"$//' > "$work/complaints"
[ "$(wc -l < "$work/complaints")" -ge 25 ] || fail "the complaints were not found in owed.hpp"
while read -r complaint; do
  grep -F "error: " "$work/said" | grep -qF -- "$complaint" || fail "nothing was told: $complaint"
done < "$work/complaints"
told=$(grep -c 'error: .* lacks `' "$work/said")
lacking=$(grep -cE '^struct (No|Linear)' "$here/lacks.cpp")
[ "$told" = "$lacking" ] || fail "$lacking laws lack one thing each, and $told complaints were made"
[ "$(grep -c 'error: ' "$work/said")" = "$told" ] || fail "something else was complained about"

# the exercise's law without one of its functions is refused first with these words
mkdir "$work/interface"
sed '/double steepest_fall/,/^  }/d' "$exercise/interface/delayed.hpp" > "$work/interface/delayed.hpp"
cp "$exercise/interface/law.hpp" "$work/interface"
echo '#include "interface/law.hpp"' > "$work/law.cpp"
compiler=$1
shift
"$compiler" -I"$exercise" "$@" -fsyntax-only "$work/law.cpp" 2> "$work/said" || fail "the exercise does not compile"
if "$compiler" -I"$work" "$@" -fsyntax-only "$work/law.cpp" 2> "$work/said"; then fail "taken without its steepest fall"; fi
grep -m 1 'error: ' "$work/said" | grep -qF 'an adhesion law lacks `double steepest_fall(BondStep const&) const`' ||
  fail "another complaint came first"
