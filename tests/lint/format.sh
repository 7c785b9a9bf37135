#!/bin/sh
# Checks that clang-format would change nothing below ROOT, its argument.
set -eu
cd "$1"
find engine lua postproc tests \( -name '*.hpp' -o -name '*.cpp' \) -print0 | xargs -0 -r clang-format --dry-run -Werror
