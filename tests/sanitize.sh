#!/bin/sh
# Builds everything but the figures under the address, leak and undefined-behaviour sanitizers and runs the fast tests
# but proofs and experiments, which take the sanitizers too long.
set -eu
root=$(cd "$(dirname "$0")/.." && pwd)
cd "$root"
cmake --preset sanitize >/dev/null
cmake --build --preset sanitize -j "$(nproc)"
ctest --preset sanitize -j "$(nproc)"
