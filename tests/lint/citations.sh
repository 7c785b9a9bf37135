#!/bin/sh
# Checks that what is cited below ROOT, its argument, stands in engine/references.bib, and nothing else does.
set -eu
cd "$1"
export LC_ALL=C
find engine lua studies tests postproc README.md \( -name '*.hpp' -o -name '*.cpp' -o -name '*.lua' -o -name '*.md' \) |
  grep -v '^tests/lint/' | sort | xargs awk -f tests/lint/citations.awk engine/references.bib engine/physics.md
