#!/bin/sh
# What explain would warn of, told by a run before its cases start, once for those alike, and left in its files.
. "$(dirname "$0")/common.sh"

changed strained 's/descent = 0.02/descent = 0.3/; s/neo_hookean/linear_elastic/'
expect 0 "warning: body block will be strained by about 30 %|(or alike, in all 3 cases: mu0, mu0.2, mu0.4)|-> material.neo_hookean{" \
  "$stiction" run strained --no-figures
holds "before any case starts" [ "$(grep -n 'warning:' output | cut -d: -f1)" -lt "$(grep -n started output | head -n 1 | cut -d: -f1)" ]
holds "once" [ "$(grep -c 'warning:' output)" = 1 ]
holds "the head of summary.csv" grep -q 'seconds,set,warnings$' out/strained/summary.csv
holds "every row: $(cat out/strained/summary.csv)" [ "$(grep -c 'body block will be strained by about 30 %' out/strained/summary.csv)" = 3 ]
holds "the manifest" grep -q '"text": "body block will be strained by about 30 %' out/strained/mu0/manifest.json
expect 2 "--strict: 1 warning" "$stiction" run strained --strict --no-figures --out nothing
expect 2 "--strict: 1 warning" "$stiction" run strained --strict --no-figures
holds "a strict run began a case" [ -z "$(find nothing -name series.h5)" ]

expect 0 "checks held" "$stiction" run "$tiny" --strict --no-figures
holds "no warnings" [ "$(grep -c 'warning:' output)" = 0 ]
holds "nothing to warn of" grep -q '"warnings": \[\]' out/tiny/mu0/manifest.json

# what cases remark at their end, once for those alike
expect 0 "remark: at t = |(or alike, in all 2 cases: pillars2, pillars4)" \
  "$stiction" run "$here"/../../studies/examples/fibrillar_pad --quick --no-figures --out pad
holds "a remark once: $(grep remark: output)" [ "$(grep -c remark: output)" = 1 ]
expect 0 "pillars2: remark: at t" "$stiction" run "$here"/../../studies/examples/fibrillar_pad --quick --no-figures --out one --case pillars2
finish
