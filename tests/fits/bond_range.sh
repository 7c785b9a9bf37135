#!/bin/sh
# studies/fit/bond_range: of long bonds a pull-off tells work and strength, of short ones (JKR's limit) the work alone, and the fit says which.
set -eu
stiction=$1 study=$2 out=$3
rm -rf "$out"
mkdir -p "$out"

complain() { echo "$1"; cat "$out/said"; exit 1; }
fitted() { # SCRIPT: must end with 0
  "$stiction" fit "$study/$1.lua" --no-figures --out "$out/$1" >"$out/said" 2>&1 || complain "$1 is refused or rejected"
}
says() { grep -qF -- "$1" "$out/said" || complain "it does not say '$1'"; }
ends_of() { # NAME SCRIPT: low and high of what is claimed, - where open
  awk -v name="\"$1\"" '/^    {/ { low = high = "-"; own = inner = "" } /"statistical"/ { inner = "yes" }
    /}/ { inner = "" } /"low":/ && inner == "" { low = $2 + 0 } /"high":/ && inner == "" { high = $2 + 0 }
    /^      "name":/ { own = $2; sub(",", "", own) } /^    }/ { if (own == name) print low, high }' "$out/$2/fit.json"
}
holds() { # NAME SCRIPT VALUE WIDEST: the claim holds the value, and is no wider
  ends_of "$1" "$2" >"$out/ends"
  read -r low high <"$out/ends"
  awk -v a="$low" -v b="$high" -v x="$3" -v w="$4" 'BEGIN { exit !(a != "-" && b != "-" && a + 0 <= x && x <= b + 0 && b <= w * a) }' ||
    complain "$1 of $2 is claimed to be $low .. $high; $3 should lie within, and the ends within a factor of $4"
}

fitted study
says "determined: sigma0 and w"
says "the model agrees with the data"
holds w study 0.05 1.1
holds sigma0 study 1e4 1.5

fitted short
says "determined: w"
says "NOT DETERMINED by these data: sigma0"
says "the model agrees with the data"
holds w short 0.05 1.1
[ "$(ends_of sigma0 short | cut -d ' ' -f 2)" = - ] || complain "sigma0 of short bonds has an end above: $(ends_of sigma0 short)"
