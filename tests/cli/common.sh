# Helpers of the black-box tests: each script is run in a fresh folder with $stiction and $tiny set.
# shellcheck shell=sh
stiction=$1
here=$(cd "$(dirname "$0")" && pwd)
tiny=$here/tiny
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
failures=0

complain() {
  echo "FAILED: $*"
  failures=$((failures + 1))
}

# expect CODE "PART|PART" COMMAND...: exit code, and every part in what it prints
expect() {
  wanted=$1
  parts=$2
  shift 2
  "$@" >output 2>&1 </dev/null
  code=$?
  [ "$code" = "$wanted" ] || complain "$* ended with $code, not $wanted: $(cat output)"
  old_ifs=$IFS
  IFS='|'
  for part in $parts; do
    grep -qF -- "$part" output || complain "$* does not say '$part': $(cat output)"
  done
  IFS=$old_ifs
}

# changed NAME SED-EXPRESSION: a copy of the tiny study, changed, as folder NAME
changed() {
  mkdir -p "$1"
  cp "$tiny"/*.lua "$1"
  sed -i "$2" "$1"/*.lua
}

serves_cases() { # PROCESS: whether it is one that runs cases, or a case of one
  { tr '\0' ' ' <"/proc/$1/cmdline"; } 2>/dev/null | grep -q "^$stiction cases"
}

cases_running() { # numbers of the processes that run a case of a run that was started in this test
  for folder in /proc/[0-9]*; do
    process=${folder#/proc/}
    case "$(readlink "$folder/cwd" 2>/dev/null)" in "$work"*) ;; *) continue ;; esac
    parent=$(sed 's/.*) [A-Z] \([0-9]*\).*/\1/' "$folder/stat" 2>/dev/null)
    serves_cases "$process" && serves_cases "$parent" && echo "$process"
  done
}

await() { # "CONDITION" [SECONDS]: whether it holds before that
  for _ in $(seq $((10 * ${2:-120}))); do
    eval "$1" && return 0
    sleep 0.1
  done
  return 1
}

holds() { # WHAT COMMAND...
  what=$1
  shift
  "$@" || complain "$what"
}

numbers_of_block() { # folder: results of both cases of the study `block` with every digit
  "$stiction" show "$1" --columns press,drag,strain,lost --csv - | sed 's/"//g'
}
near() { # FILE FILE TOLERANCE: columns that are numbers differ by no more, of the larger
  awk -F, -v most="$3" 'NR == FNR { for (i = 1; i <= NF; ++i) a[FNR, i] = $i; next }
    { for (i = 1; i <= NF; ++i) if ($i + 0 == $i && FNR > 1) {
        d = $i - a[FNR, i]; b = $i; if (d < 0) d = -d; if (b < 0) b = -b; ++seen
        if (d > most * b) { print FNR, i, $i, a[FNR, i]; bad = 1 } } }
    END { exit bad || seen < 8 }' "$1" "$2"
}

finish() {
  [ "$failures" = 0 ] && echo "all held"
  exit "$failures"
}
