#!/bin/sh
# Runs clang-tidy over the sources of ROOT that BUILD compiles, two at a time: tidy.sh ROOT BUILD.
# A file whose text, headers, configuration and command are as when it last passed is not checked again: its stamp,
# named by their hash, lies in BUILD/lint.
set -eu
root=$1 build=$2
stamps=$build/lint
here=$(cd "$(dirname "$0")" && pwd)
mkdir -p "$stamps"
cd "$root"

common=$({ clang-tidy --version; cat .clang-tidy "$here/source_location.hpp"; sed -n 's/.*"command": *//p' "$build/compile_commands.json" | sed 's/ -o .*//' | sort -u; } | sha256sum)
todo=$(mktemp)
trap 'rm -f "$todo"' EXIT
find engine lua postproc \( -name '*.hpp' -o -name '*.cpp' \) | sort | xargs awk -f "$here/closure.awk" |
  while read -r source headers; do
    grep -q "\"file\": \".*/$source\"" "$build/compile_commands.json" || continue
    # shellcheck disable=SC2086 # headers is a list
    hash=$({ echo "$common $source"; cat "$source" $headers; } | sha256sum | cut -c1-32)
    [ -e "$stamps/$hash" ] || echo "$source $stamps/$hash $here/source_location.hpp"
  done > "$todo"

# shellcheck disable=SC2016 # expanded by the inner shell
xargs -r -P2 -L1 sh -c '
  if report=$(clang-tidy -p "$0" --quiet --extra-arg=-include --extra-arg="$3" "$1" 2>&1); then
    : > "$2"
  else
    echo "$report" | grep -E -A3 "(error|warning):" || echo "$report"
    exit 1
  fi' "$build" < "$todo"
