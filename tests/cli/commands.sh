#!/bin/sh
# Commands, their options, help pages, and words on the command line that are wrong.
. "$(dirname "$0")/common.sh"

for command in run figures solve bench peers show compare help explain; do
  expect 0 "Usage: stiction $command" "$stiction" "$command" --help
done
expect 0 "Subcommands" "$stiction" --help
expect 0 "0." "$stiction" --version
expect 2 "run|figures|bench" "$stiction"
expect 2 "unknown command 'rnu'; did you mean run?" "$stiction" rnu
expect 2 "run: study is required" "$stiction" run
expect 2 "unexpected '--quik'; did you mean --quick?" "$stiction" run "$tiny" --quik
expect 2 "--jobs" "$stiction" run "$tiny" --jobs 0
expect 2 "--jobs: 2.7 is no whole number from 1 to 4096" "$stiction" run "$tiny" --jobs 2.7
expect 2 "--jobs" "$stiction" run "$tiny" --jobs many
expect 2 "run: --checkpoint: -3 is no number of seconds, 0 or more" "$stiction" run "$tiny" --checkpoint -3

expect 0 "material|blatz_ko|adhesion" "$stiction" help
expect 0 "blatz_ko|neo_hookean" "$stiction" help materials
expect 0 "adhesion.rcc|w: |J/m^2" "$stiction" help rcc
expect 0 "MPa|kg m^-1 s^-2" "$stiction" help units
expect 0 "given|chosen|sweep|check" "$stiction" help study
expect 0 "Exit codes" "$stiction" help commands
expect 0 "run the cases of a study|--worker|stiction run --help" "$stiction" help run
expect 0 "whether workers live|stiction status --help" "$stiction" help status
expect 0 "page/index.html" "$stiction" help --html page
grep -q 'id="adhesion.rcc"' page/index.html || complain "the page has no adhesion.rcc"
: > file
expect 0 "probe.energy|scheme_loss" "$stiction" help probe.energy
holds "of commands alone" [ "$(grep -c -- --help output)" = 0 ]
expect 0 "probe.force" "$stiction" help probe.force
holds "no load" [ "$(grep -c load.force output)" = 0 ]
expect 2 "--html: no folder can be made at 'file/page'" "$stiction" help --html file/page
expect 2 "no help on 'blatz_k'; did you mean 'blatz_ko'?" "$stiction" help blatz_k

expect 0 "A block on a plane|descent|soft rubber|mu0.4|friction.coulomb" "$stiction" explain "$tiny"
expect 2 "there is no study at 'nowhere'" "$stiction" run nowhere
mkdir empty results
: > results/summary.csv
expect 2 "'empty' is a folder without study.lua" "$stiction" run empty
expect 2 "'results' is a folder of results, not the study they are of" "$stiction" why results
# what a disk does not take of what is printed is told
expect 1 "standard output took not all that was printed" sh -c 'trap "" XFSZ; ulimit -f 1; "$1" help units >none' sh "$stiction"
finish
