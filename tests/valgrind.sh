#!/bin/sh
# Runs the engine's tests, or those that a doctest filter names, and the replay of the seeds under valgrind, in a build of
# their own: valgrind.sh [FILTER]. It takes tens of minutes; a read or write out of bounds, or of nothing, or a leak fails it.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
build=$here/../build/valgrind
for tool in valgrind clang++-16; do
  command -v $tool >/dev/null || { echo "apt-get install valgrind clang-16" >&2; exit 2; }
done
cd "$here/.."
cmake --preset valgrind >/dev/null
cmake --build "$build" --target stiction_tests stiction_seeds stiction-mesher
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
