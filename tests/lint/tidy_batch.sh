#!/bin/sh
# Checks sources of one folder and makes their stamps if nothing is found: tidy_batch.sh BUILD (SOURCE STAMP)...
# Joined into one text they share what their headers cost, a third of the whole; if something is found so, perhaps only
# names that clash, each is checked alone.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
build=$1
shift

# The analyser does not follow calls into templates: over Eigen's, cells.cpp alone takes it 40 s more.
tidy() { # OPTION... FILE
  clang-tidy --quiet --extra-arg=-include --extra-arg="$here/source_location.hpp" \
    --extra-arg=-Xclang --extra-arg=-analyzer-config --extra-arg=-Xclang --extra-arg=c++-template-inlining=false "$@" 2>&1
}

joined() { # SOURCE STAMP...: fails if there is but one
  [ $# -gt 2 ] || return 1
  folder=$(mktemp -d) source_folder=$(dirname "$1")
  trap 'rm -rf "$folder"' EXIT
  sed -n "/\"command\": .*\/$(echo "$1" | sed 's/[/.]/\\&/g')\",\$/{s/ -o .*/ -c batch.cpp\",/;p}" "$build/compile_commands.json" |
    sed "1i [{ \"directory\": \"$folder\"," >"$folder/compile_commands.json"
  echo '"file": "batch.cpp" }]' >>"$folder/compile_commands.json"
  stamps=
  while [ $# -gt 0 ]; do
    cat "$1" >>"$folder/batch.cpp"
    stamps="$stamps $2"
    shift 2
  done
  # shellcheck disable=SC2086 # a list
  cp .clang-tidy "$folder" # found there, and for our headers; as --config-file names in all of Eigen would be checked, too
  tidy -p "$folder" --extra-arg=-iquote"$source_folder" "$folder/batch.cpp" >/dev/null && touch $stamps
}

joined "$@" && exit
failed=0
while [ $# -gt 0 ]; do
  if report=$(tidy -p "$build" "$1"); then
    : >"$2"
  else
    echo "$report" | grep -E -A3 "(error|warning):" || echo "$report"
    failed=1
  fi
  shift 2
done
exit $failed
