#!/bin/sh
# Outputs of a newer version, damaged notes, a full disk, sweeps of what no scene reads: one message, nothing overwritten.
. "$(dirname "$0")/common.sh"

changed drag ''
"$stiction" run drag --no-figures --jobs 1 >/dev/null || complain "no output to damage"
cp -r out good

# of a newer version
sed -i 's/"layout": 2/"layout": 3/' out/drag/study.json
before=$(find out/drag -type f ! -name .lock -exec cksum {} + | sort)
newer="out/drag was written by a newer version of Stiction (layout 3;|choose another folder with --out"
for words in "run drag" "run drag --force" "run drag --list" "run drag --join" "why drag" "results drag" "figures drag" \
  "clean drag" "show drag" "compare out/drag good/drag" "report drag" "verify out/drag" "pack out/drag" "status drag" "status out/drag"; do
  # shellcheck disable=SC2086 # a list of words
  expect 2 "$newer" "$stiction" $words
done
holds "files of a newer version were changed" [ "$before" = "$(find out/drag -type f ! -name .lock -exec cksum {} + | sort)" ]

# whose the folder is, cannot be read
echo '{ "x": ' >out/drag/study.json
for words in "run drag --force" "why drag" "show drag" "clean drag"; do
  # shellcheck disable=SC2086 # a list of words
  expect 2 "out/drag/study.json is damaged|remove that file if the folder is this study's" "$stiction" $words
done
holds "damaged notes were overwritten" grep -q '{ "x": $' out/drag/study.json
rm out/drag/study.json
expect 0 "checks held" "$stiction" run drag --no-figures
holds "a case was run again" [ "$(grep -c started output)" = 0 ]

# what older versions left: told, and gone once the case runs anew
mkdir -p older/mu0
sed '1s/.*/{/; s/"made_of"/"other"/' out/drag/mu0/manifest.json >older/mu0/manifest.json
touch older/mu0/result.json older/mu0/case.json
expect 0 "mu0  to run: an older version of the program ran it|mu0.2  to run: it has not run" "$stiction" why drag --out older
expect 0 "checks held" "$stiction" run drag --no-figures --out older
holds "left of an older version: $(ls older/mu0)" sh -c '! ls older/mu0/*.json | grep -v manifest'

# a manifest that cannot be read is told where it counts
echo '{ "x": ' >out/drag/mu0.2/manifest.json
expect 2 "out/drag/mu0.2/manifest.json is damaged|--force" "$stiction" compare out/drag good/drag
expect 0 "mu0.2  to run: out/drag/mu0.2/manifest.json is damaged" "$stiction" why drag
expect 0 "out/drag/mu0.2/manifest.json is damaged: mu0.2 runs anew|mu0.2  started|checks held" "$stiction" run drag --no-figures
expect 0 "9 of 9 results" "$stiction" compare out/drag good/drag

# what was cut off behind the result as well, of histories it is told; what some other program has written anew is none of it
expect 0 "3 cases: 3 reused" "$stiction" why drag
cp -r out/drag cut
sed -i '$d' cut/mu0/manifest.json
truncate -s -1000 cut/mu0.2/series.h5
printf '\n' >>cut/mu0.4/manifest.json
expect 0 "mu0  to run: cut/mu0/manifest.json is damaged|mu0.2  reused; cut/mu0.2/series.h5 is damaged|mu0.4  reused" "$stiction" why \
  drag --out cut
expect 0 "2 of 3 cases done, 0 failed, 0 running, 1 waiting" "$stiction" status drag --out cut
expect 0 "cut/mu0/manifest.json is damaged: mu0 runs anew|cut/mu0.2/series.h5 is damaged; its results are kept|checks held" "$stiction" \
  run drag --no-figures --out cut
holds "others run again" [ "$(grep -c started output)" = 1 ]
expect 0 "3 cases: 3 reused" "$stiction" why drag --out cut
expect 0 "9 of 9 results" "$stiction" compare cut good/drag
cp cut/mu0.2/manifest.json kept.json
truncate -s -1000 cut/mu0.2/series.h5
expect 1 "mu0.2|result failed|--force" "$stiction" results drag --out cut
holds "what was had of it" cmp kept.json cut/mu0.2/manifest.json

# a sweep over what no scene reads is told, that of one it reads is not
changed slip 's/sweep = { mu = { 0, 0.2, 0.4 } }/sweep = stiction.sample.sobol { count = 2, seed = 1, of = { youn = { 1e6, 2e6 } } }/
  /^  quick =/d; s/case\.p\.mu/0.2/; s/ p\.mu/ 0.2/'
expect 0 "no scene reads the swept parameter 'youn'; did you mean 'young'?" "$stiction" run slip --no-figures
holds "told once" [ "$(grep -c 'no scene reads' output)" = 1 ]
expect 0 "checks held" "$stiction" run drag --no-figures --out read
holds "mu is read" [ "$(grep -c 'no scene reads' output)" = 0 ]

# every command that takes --quick says where there is no quick form
changed none '/^  quick =/d'
for words in "run none --list --quick" "why none --quick" "explain none --quick --case mu0"; do
  # shellcheck disable=SC2086 # a list of words
  expect 0 "the study has no quick form" "$stiction" $words
done
expect 2 "the study has no quick form|no finished case" "$stiction" figures none --quick
finish
