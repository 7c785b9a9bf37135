# Citations in sources that no entry of a bibliography answers: awk -f citations.awk references.bib physics.md FILE...
# A citation is "Surname YEAR", "Surname (YEAR)" or [key]; "physics.md N" names a section of that file.
BEGIN { year = "(1[89]|20)[0-9][0-9]"; name = "[A-Z][A-Za-z'-]*[a-z]" }

function told(what) {
  print FILENAME ":" FNR ": " what
  wrong = 1
}

FILENAME ~ /references\.bib$/ {
  key = $0
  sub(/^@[a-z]+\{/, "", key); sub(/,.*/, "", key)
  when = $0
  sub(/.*year = \{/, "", when); sub(/\}.*/, "", when)
  who = $0
  sub(/.*author = \{/, "", who); sub(/\}, [a-z]+ = .*/, "", who)
  gsub(/\{\\.|\}/, "", who)
  count = split(who, authors, / and /)
  for (i = 1; i <= count; ++i) { sub(/,.*/, "", authors[i]); names[authors[i], when] = key }
  if (key in keys) told("the key " key " stands twice")
  if (key !~ (when "[a-z]?$")) told("the key " key " does not end in its year " when)
  keys[key] = 0
  place[key] = FILENAME ":" FNR
  next
}

FILENAME ~ /physics\.md$/ && /^## [0-9]+\./ { section = $2; sub(/\./, "", section); sections[section] = 1 }

{
  rest = $0
  while (match(rest, name ",? \\(?" year "([^0-9.]|\\.[^0-9]|\\.?$)")) {
    found = substr(rest, RSTART, RLENGTH)
    rest = substr(rest, RSTART + RLENGTH - 1)
    match(found, year)
    when = substr(found, RSTART, 4)
    who = found
    sub(/,? .*/, "", who)
    if (who ~ /^(January|February|March|April|May|June|July|August|September|October|November|December|Congress)$/) continue
    if ((who, when) in names) ++keys[names[who, when]]
    else told("no entry of " who " " when " in references.bib")
  }
  rest = $0
  while (match(rest, /\[[a-z]+[12][0-9][0-9][0-9][a-z]?\]/)) {
    key = substr(rest, RSTART + 1, RLENGTH - 2)
    rest = substr(rest, RSTART + RLENGTH)
    if (key in keys) ++keys[key]
    else told("no entry " key " in references.bib")
  }
  rest = $0
  while (match(rest, /physics\.md [0-9]+/)) {
    number = substr(rest, RSTART + 11, RLENGTH - 11)
    rest = substr(rest, RSTART + RLENGTH)
    if (!(number in sections)) told("physics.md has no section " number)
  }
}

END {
  for (key in keys) if (!keys[key]) { print place[key] ": nothing cites " key; wrong = 1 }
  exit wrong
}
