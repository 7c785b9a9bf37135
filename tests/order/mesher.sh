#!/bin/sh
# gmsh brings copies of Eigen's functions made for other alignments. A program that exports its own has gmsh run those on
# memory that is not aligned for them.
set -eu
symbols=$(nm -D --defined-only "$1")
if printf '%s\n' "$symbols" | grep 5Eigen; then
  echo "$1 exports Eigen's functions to gmsh"
  exit 1
fi
