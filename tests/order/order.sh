#!/bin/sh
# Checks the sources below ROOT, its argument, against the rules of the architecture and prints every breach.
# - a layer of engine/ includes itself and what stands before it in engine/CMakeLists.txt, by "layer/file.hpp"
# - so does a room of a layer, where engine/CMakeLists.txt lists rooms; no file lies beside them
# - engine/ includes nothing of lua/ or postproc/ and names no study; postproc/ includes no layer but core
# - a file opens with a comment that ends as a sentence, and has 500 lines at most
# - a test's name holds no mark at which the list of tests is split
# - every proof stands in the collection of all.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
cd "$1"
layers=$(sed -n 's/^set(STICTION_LAYERS \([a-z ]*\))$/\1/p' engine/CMakeLists.txt)
[ -n "$layers" ] || { echo "engine/CMakeLists.txt: no line set(STICTION_LAYERS ...)"; exit 1; }
rooms=$(sed -n 's/^set(STICTION_ROOMS_\([a-z]*\) \([a-z_ ]*\))$/\1 \2/p' engine/CMakeLists.txt |
  awk '{ for (i = 2; i <= NF; ++i) printf "%s/%s ", $1, $i }')
for study in studies/proofs/*/study.lua; do
  name=$(basename "${study%/study.lua}")
  [ ! -f "$study" ] || grep -q "^  \"$name\",$" studies/proofs/collection.lua || { echo "$study: does not stand in collection.lua"; exit 1; }
done
studies=$(find studies -mindepth 2 -name study.lua | sed 's|/study.lua$||; s|.*/||' | sort -u | tr '\n' ' ')
find engine lua postproc studies tests -type f \( -name '*.hpp' -o -name '*.cpp' -o -name '*.lua' -o -name '*.sh' \
  -o -name '*.awk' \) | sort | xargs awk -v layers="$layers" -v rooms="$rooms" -v studies="$studies" -f "$here/order.awk"
