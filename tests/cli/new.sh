#!/bin/sh
# stiction new: studies to start from run as they are written; nothing that is there is touched.
. "$(dirname "$0")/common.sh"

expect 0 "wrote mine/study.lua|A sticky block|stiction run mine --quick" "$stiction" new mine
expect 0 "2 of 2 checks held|output: out/mine" "$stiction" run mine --quick --no-figures --jobs 1
expect 0 "stiction run mine2/deep/in --quick" "$stiction" new mine2/deep/in/
mkdir "a folder"
expect 0 "wrote a folder/ring.msh|stiction run 'a folder' --quick" "$stiction" new "a folder" --from own_mesh
expect 0 "checks held" "$stiction" run "a folder" --quick --no-figures --jobs 1

# every example is listed by its title, in at most 60 lines, and is written whole
expect 0 "sticky_block   A sticky block (what|own_mesh       A ring" "$stiction" new --list
cp output listed
for example in "$here"/../../studies/examples/*/; do
  name=$(basename "$example")
  holds "$name is not listed: $(cat listed)" grep -q "^$name  *[A-Z]" listed
  holds "$name is long" [ "$(wc -l <"$example/study.lua")" -le 60 ]
  expect 0 "wrote of_$name/study.lua" "$stiction" new "of_$name" --from="$name"
  holds "$name is not written whole" diff -r "$example" "of_$name"
  expect 0 "Case " "$stiction" explain "of_$name" --quick
done

# what is there stays as it is
echo kept >mine/note
cp -r mine before
expect 2 "new: the folder 'mine' is not empty; choose another name" "$stiction" new mine --from own_mesh
holds "mine was touched" diff -r before mine
: >file
expect 2 "there is a file at 'file'" "$stiction" new file
expect 2 "cannot make the folder file/inside" "$stiction" new file/inside
expect 2 "cannot " "$stiction" new /proc/stiction_study

# words that are wrong: one message, and nothing is written
: >names
ls -A >names
expect 2 "there is no example 'peeling_tap'; did you mean 'peeling_tape'?; there are bouncing_ball, " \
  "$stiction" new other --from peeling_tap
expect 2 "there is no example '../paper'" "$stiction" new other --from ../paper
expect 2 "new: --from: 1 required EXAMPLE missing" "$stiction" new other --from
expect 2 "new: NAME is required: stiction new NAME" "$stiction" new
expect 2 "new: unexpected '--form'; did you mean --from?" "$stiction" new other --form own_mesh
expect 2 "new: unexpected 'second'" "$stiction" new other second
for name in "" . .. / ./ "a:b" " a" 'a\b' "$(printf 'a\tb')" "$(printf 'a\377b')" "$(printf '%0300d' 0)"; do
  expect 2 "is no name for a study's folder: " "$stiction" new "$name"
done
holds "one line: $(cat output)" [ "$(wc -l <output)" = 1 ]
expect 2 "new: unexpected '-x'" "$stiction" new -x
holds "something was written: $(ls -A)" [ "$(ls -A)" = "$(cat names)" ]

expect 0 "Usage: stiction new|--from EXAMPLE" "$stiction" new --help
expect 0 "Usage: stiction new NAME" "$stiction" help new
expect 0 "stiction new NAME" "$stiction" help
expect 0 "new NAME" "$stiction" help commands
finish
