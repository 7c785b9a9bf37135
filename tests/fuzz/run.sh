#!/bin/sh
# Fuzzes every reader, or those named, for SECONDS each: run.sh [SECONDS [TARGET...]]; 600 s if none are given.
# What makes a reader fail is kept among the seeds, which the tests replay from then on; exit code 1.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
build=$root/build/fuzz
seconds=${1:-600}
[ $# -eq 0 ] || shift

clang=$(command -v clang++) || { echo "apt-get install clang libclang-rt-14-dev" >&2; exit 2; }
runtime=$("$clang" -print-file-name=libclang_rt.fuzzer-x86_64.a) # its name alone where there is none
[ -e "$runtime" ] || [ -e "$("$clang" -print-resource-dir)/lib/linux/libclang_rt.fuzzer-x86_64.a" ] || {
  echo "apt-get install libclang-rt-14-dev" >&2
  exit 2
}
cd "$root"
cmake --preset fuzz >/dev/null
cmake --build "$build"
[ $# -gt 0 ] || set -- stl msh heights mesh_file problem series result script

found=0
for target in "$@"; do
  corpus=$build/corpus/$target findings=$build/findings/$target
  mkdir -p "$corpus" "$findings"
  echo "== $target, $seconds s"
  OPENBLAS_NUM_THREADS=1 "$build/tests/fuzz/fuzz_$target" -max_total_time="$seconds" -timeout=60 -max_len=4096 \
    -rss_limit_mb=2048 -close_fd_mask=1 -print_final_stats=1 -artifact_prefix="$findings/" "$corpus" \
    "$here/seeds/$target" 2>"$findings/log" || found=1
  grep -E '^(Done|stat::number_of_executed_units|SUMMARY|==.*ERROR)' "$findings/log" || true
  for finding in "$findings"/crash-* "$findings"/timeout-* "$findings"/oom-* "$findings"/leak-*; do
    [ -e "$finding" ] || continue
    mv "$finding" "$here/seeds/$target/"
    echo "kept as tests/fuzz/seeds/$target/$(basename "$finding")"
  done
done
exit $found
