#!/bin/sh
# Checks that what is cited below ROOT, its argument, stands in engine/references.bib, and nothing else does; and that
# pages point at files that are there.
set -eu
cd "$1"
export LC_ALL=C
find engine lua studies tests postproc README.md CONTRIBUTING.md \( -name '*.hpp' -o -name '*.cpp' -o -name '*.lua' -o -name '*.md' \) |
  grep -v '^tests/lint/' | sort | xargs awk -f tests/lint/citations.awk engine/references.bib engine/physics.md

links() { # PAGE: what it points at
  grep -oE '\]\([^)#][^)]*\)' "$1" | sed 's/^](//; s/)$//; s/#.*//' | grep -v '^http' || true
}

missing=$(find . -name '*.md' ! -path './build/*' ! -path './out/*' ! -path './.git/*' | sort | while read -r page; do
  links "$page" | while read -r link; do
    [ -e "$(dirname "$page")/$link" ] || echo "$page: there is no $link"
  done
done)
[ -z "$missing" ] || { echo "$missing"; exit 1; }
