#!/bin/sh
# Plants one breach of every rule in a small tree and checks that order.sh finds each, and none where there is none.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT

clean_tree() {
  rm -rf "$tree"
  mkdir -p "$tree/engine/core" "$tree/engine/mesh" "$tree/engine/contact/surface" "$tree/engine/contact/mortar" "$tree/engine/solid" "$tree/lua/bind" "$tree/postproc" \
    "$tree/studies/paper/pull_off" "$tree/studies/proofs/first_proof" "$tree/studies/proofs/second_proof" "$tree/tests"
  printf 'set(STICTION_LAYERS core mesh solid contact)\nset(STICTION_ROOMS_contact surface mortar)\n' > "$tree/engine/CMakeLists.txt"
  printf '// A.\n#include "contact/surface/a.hpp"\n#include "mesh/a.hpp"\n' > "$tree/engine/contact/mortar/a.cpp"
  echo '-- A study.' > "$tree/studies/paper/pull_off/study.lua"
  echo '-- A proof.' > "$tree/studies/proofs/first_proof/study.lua"
  printf -- '-- All proofs.\nreturn {\n  "first_proof",\n}\n' > "$tree/studies/proofs/collection.lua"
  printf '// One thing.\n#include <vector>\n#include "core/a.hpp"\n' > "$tree/engine/mesh/a.hpp"
  printf '// Two lines that are\n// one sentence.\n#include "mesh/a.hpp"\n' > "$tree/engine/solid/a.cpp"
  printf '// Reads files.\n#include "core/a.hpp"\n#include "local.hpp"\n' > "$tree/postproc/a.cpp"
}

# refuses WORDS FILE TEXT: with TEXT in FILE of the clean tree, order.sh fails and says WORDS
refuses() {
  clean_tree
  printf '%b' "$3" > "$tree/$2"
  if report=$(sh "$here/order.sh" "$tree"); then
    echo "not found: $1"
    exit 1
  fi
  case $report in
  "$2"*"$1"*) ;;
  *)
    echo "expected '$2 ... $1', got: $report"
    exit 1
    ;;
  esac
}

clean_tree
sh "$here/order.sh" "$tree"
refuses 'solid stands after mesh' engine/mesh/b.cpp '// B.\n#include "solid/a.hpp"\n'
refuses 'solid stands after core' engine/core/b.cpp '// B.\n  #  include <solid/a.hpp>\n'
refuses 'the engine knows nothing above it' engine/solid/b.cpp '// B.\n#include <lua.hpp>\n'
refuses 'the engine knows nothing above it' engine/solid/b.cpp '// B.\n#include "postproc/a.hpp"\n'
refuses 'not of the form' engine/solid/b.cpp '// B.\n#include "a.hpp"\n'
refuses 'names the study pull_off' engine/solid/b.cpp '// B.\nint pull_off();\n'
refuses 'contact/mortar stands after contact/surface' engine/contact/surface/b.cpp '// B.\n#include "contact/mortar/a.hpp"\n'
refuses 'layer/room/file.hpp' engine/contact/surface/b.cpp '// B.\n#include "contact/a.hpp"\n'
refuses 'lies in no room' engine/contact/b.cpp '// B.\n'
refuses 'lies in no layer' engine/b.cpp '// B.\n'
refuses 'figures come from files' postproc/b.cpp '// B.\n#include "solid/a.hpp"\n'
refuses 'does not open with a comment' engine/core/b.cpp '#pragma once\n// Late.\n'
refuses 'does not open with a comment' lua/b.lua '-- no sentence\n'
refuses 'more than 500' tests/b.cpp "// B.\n$(printf '%0500d' 0 | sed 's/0/\\n/g')"
refuses 'names a test with' tests/b.cpp '// B.\nTEST_CASE("one; two") {}\n'
refuses 'names a test with' tests/b.cpp '// B.\n  TEST_CASE("the range [0 1]") {}\n'
refuses 'does not stand in collection.lua' studies/proofs/second_proof/study.lua '-- B.\n'
echo "every planted breach was found"
