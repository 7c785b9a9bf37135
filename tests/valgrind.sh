#!/bin/sh
# Runs the engine's tests, or those that a doctest filter names, and the replay of the seeds under valgrind:
# valgrind.sh [FILTER]. It takes tens of minutes; a read or write out of bounds, or of nothing, or a leak fails it.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
build=$here/../build
command -v valgrind >/dev/null || { echo "apt-get install valgrind" >&2; exit 2; }
[ -x "$build/tests/stiction_tests" ] || { echo "no tests are built: run ./stiction test first" >&2; exit 2; }
export OPENBLAS_NUM_THREADS=1 OPENBLAS_CORETYPE=Haswell # valgrind knows no AVX-512
check() {
  valgrind --quiet --error-exitcode=1 --leak-check=full --show-leak-kinds=definite --errors-for-leak-kinds=definite \
    --suppressions="$here/valgrind.supp" "$@"
}
check "$build/tests/stiction_tests" --test-case="${1:-*}"
[ $# -eq 0 ] || exit 0
for target in stl msh mesh_file problem series result script; do
  check "$build/tests/fuzz/stiction_seeds" "$target" "$here/fuzz/seeds/$target"
done
