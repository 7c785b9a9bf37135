#!/bin/sh
# Checks below ROOT, its argument, that no law and no scheme is named in code outside its own header and the list of its
# kind, so that a new one needs no other edit, and that the check finds a name where one is planted.
set -eu
cd "$1"

# named FILE...: code of the engine that names an alternative of material, interface or scheme
named() {
  awk '
    FNR == NR || FILENAME ~ /^engine\/(interface\/law|dynamics\/scheme\/scheme)\.hpp$/ { # the lists, read first
      if (/^using [A-Za-z]+ =/) in_list = 1
      if (in_list) { list = list " " $0; if (/;/) in_list = 0 }
      next
    }
    !split_up {
      gsub(/using [A-Za-z]+ =|std::variant|[<>,;]/, " ", list)
      split(list, names, " ")
      for (i in names) law[names[i]] = 1
      split_up = 1
    }
    {
      line = $0
      gsub(/"([^"\\]|\\.)*"/, "", line)
      sub(/\/\/.*/, "", line)
      if (match(line, /^struct [A-Za-z]+ /)) own[FILENAME, substr(line, 8, RLENGTH - 8)] = 1
      while (match(line, /[A-Za-z_]+/)) {
        word = substr(line, RSTART, RLENGTH)
        line = substr(line, RSTART + RLENGTH)
        if (word in law && !((FILENAME, word) in own)) print FILENAME ":" FNR ": names " word
      }
    }' engine/material/material.hpp engine/interface/law.hpp engine/dynamics/scheme/scheme.hpp "$@"
}

planted=$(mktemp)
trap 'rm -f "$planted"' EXIT
echo 'bool plain = std::holds_alternative<material::Yeoh>(law); // not Ogden' > "$planted"
[ "$(named "$planted")" = "$planted:1: names Yeoh" ] || { echo "a planted name was not found"; exit 1; }

# shellcheck disable=SC2046 # no name holds a space
found=$(named $(find engine lua postproc -name '*.[ch]pp' ! -path engine/material/material.hpp \
  ! -path engine/interface/law.hpp ! -path 'engine/dynamics/scheme/scheme.[ch]pp' | sort))
[ -z "$found" ] || { echo "$found"; exit 1; }
