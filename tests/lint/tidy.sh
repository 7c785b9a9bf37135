#!/bin/sh
# Runs clang-tidy over the sources of ROOT that BUILD compiles, two batches at a time: tidy.sh ROOT BUILD.
# A file whose text, headers, configuration and command are as when it last passed is not checked again: its stamp,
# named by their hash, lies in BUILD/lint.
set -eu
root=$1 build=$2
stamps=$build/lint
here=$(cd "$(dirname "$0")" && pwd)
mkdir -p "$stamps"
cd "$root"
database=$build/lint/database # of commands, one for each file, whatever is compiled together
cmake -S "$root" -B "$database" -G Ninja -DSTICTION_UNITY=OFF -DBUILD_TESTING=OFF >"$stamps/database.log" 2>&1 ||
  { cat "$stamps/database.log"; exit 1; }

common=$({
  clang-tidy --version
  cat .clang-tidy "$here/source_location.hpp" "$here/tidy_batch.sh"
  sed -n 's/.*"command": *//p' "$database/compile_commands.json" | sed 's/ -o .*//' | sort -u # flags, each kind once
} | sha256sum)
todo=$(mktemp)
trap 'rm -f "$todo"' EXIT
find engine lua postproc \( -name '*.hpp' -o -name '*.cpp' \) | sort | xargs awk -f "$here/closure.awk" |
  while read -r source headers; do
    grep -q "\"file\": \".*/$source\"" "$database/compile_commands.json" || continue
    # shellcheck disable=SC2086 # headers is a list
    hash=$({ echo "$common $source"; cat "$source" $headers; } | sha256sum | cut -c1-32)
    [ -e "$stamps/$hash" ] || echo "$source $stamps/$hash"
  done > "$todo"

batches=$(awk '{ # up to 24 of a layer
    split($1, part, "/")
    folder = part[1] == "postproc" ? part[1] : part[1] "/" part[2]
    if (folder != last || count == 24) { separator = last == "" ? "" : "\n"; count = 0 } else separator = " "
    printf "%s%s", separator, $0
    ++count
    last = folder
  } END { print "" }' "$todo" | sed '/^$/d')
echo "$batches" | xargs -r -P2 -L1 sh "$here/tidy_batch.sh" "$database"
