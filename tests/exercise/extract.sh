#!/bin/sh
# Takes the exercise out of GUIDE: its header, and ROOT's list of interface laws with the exercise's edit made, below
# INTO/interface.
# usage: extract.sh GUIDE ROOT INTO
set -eu
guide=$1
list=$2/engine/interface/law.hpp
into=$3/interface
mkdir -p "$into"
awk '/^```cpp$/ { on = 1; next } /^```$/ { on = 0 } on' "$guide" > "$into/delayed.hpp"
awk '
  FNR == NR {
    if (/^```diff$/) on = 1
    else if (/^```$/) on = 0
    else if (on) {
      mark = substr($0, 1, 1)
      text = substr($0, 2)
      if (mark == "-") { action[text] = "drop"; ++wanted }
      if (mark == " ") { action[text] = "keep"; ++wanted }
      if (mark == "+") more[last] = more[last] text "\n"
      else last = text
    }
    next
  }
  $0 in action { ++met; if (action[$0] == "keep") print; printf "%s", more[$0]; next }
  { print }
  END { if (met != wanted || !wanted) { print "the edit does not fit " FILENAME > "/dev/stderr"; exit 1 } }
' "$guide" "$list" > "$into/law.hpp"
