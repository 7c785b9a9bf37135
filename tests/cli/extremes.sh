#!/bin/sh
# stiction extremes: its argument is judged before anything runs, and its own study is found from anywhere.
. "$(dirname "$0")/common.sh"

expect 2 "'tiny' is no study of extremes: its case mu0 has no parameter 'scene'|'stiction run' runs other studies" \
  "$stiction" extremes "$tiny" --no-figures
changed half "s/  sweep = .*/  sweep = { { scene = 'a', axis = 'b', level = 'c' } },/; s/mu = p.mu/mu = 0.2/"
expect 2 "has no parameter 'want'" "$stiction" extremes half --no-figures
expect 2 "there is no study at 'nowhere'" "$stiction" extremes nowhere
holds "something ran" [ ! -e out ]
expect 0 "law-base-all  to run" "$stiction" extremes --quick --list
expect 2 "there is no case 'nothing'" "$stiction" extremes --quick --case nothing
expect 0 "1 cells: 1 converged|output: out/extremes" "$stiction" extremes --quick --case law-base-all --no-figures
expect 0 "law-base-all  converged" "$stiction" extremes --quick --list
# a pressure that follows, beside points that come and go before they settle
expect 0 "1 cells: 1 converged" "$stiction" extremes --quick --case cup-seal-bonds --no-figures
finish
