# Plants the listed faults in one file: awk -v file=engine/... -f plant.awk LISTS SOURCE > REWRITTEN
# A fault is "@ NUMBER FILE: meaning", the text as it stands after "- ", what stands in its place after "+ " (an
# expression), "= " (an expression of Eigen's) or "! " (statements). Only what stands between « and » is replaced; the
# rest of "- " says where. Each must occur exactly once.
function complain(text) {
  print file ": fault " text > "/dev/stderr"
  failed = 1
}

function rest_of_line() {
  return substr($0, 3)
}

FILENAME != ARGV[ARGC - 1] {
  if ($0 ~ /^@ /) {
    ours = substr($3, 1, length($3) - 1) == file
    if (ours)
      number[++faults] = $2
  } else if (ours && $0 ~ /^- /)
    old[faults] = old[faults] (faults in old && old[faults] != "" ? "\n" : "") rest_of_line()
  else if (ours && $0 ~ /^[+=!]/) {
    form[faults] = substr($0, 1, 1)
    new[faults] = new[faults] (new[faults] != "" ? "\n" : "") rest_of_line()
  }
  next
}

{ source = source $0 "\n" }

function switched(k, from, to) {
  if (file ~ /\.lua$/)
    return form[k] == "!" ? "if stiction_mutant(" number[k] ") then " to " else " from " end" \
                          : "stiction_either(" number[k] ", function() return " to " end, function() return " from " end)"
  if (form[k] == "!")
    return "if (stiction_mutant(" number[k] ")) { " to " } else { " from " }"
  if (form[k] == "=")
    return "(stiction_mutant(" number[k] ") ? (" to ").eval() : (" from ").eval())"
  return "(stiction_mutant(" number[k] ") ? (" to ") : (" from "))"
}

function place(k,    open, shut, whole, from) {
  open = index(old[k], "«")
  shut = index(old[k], "»")
  mark = length("«")
  whole = old[k]
  from = old[k]
  if (open > 0) {
    from = substr(old[k], open + mark, shut - open - mark)
    whole = substr(old[k], 1, open - 1) from substr(old[k], shut + mark)
  }
  at = index(source, whole)
  if (at == 0)
    return complain(number[k] " is nowhere: " whole)
  if (index(substr(source, at + 1), whole) > 0)
    return complain(number[k] " is at two places: " whole)
  start[k] = at + (open > 0 ? open - 1 : 0)
  size[k] = length(from)
  text[k] = switched(k, from, new[k])
}

END {
  for (k = 1; k <= faults; ++k)
    place(k)
  done = 1
  for (round = 1; round <= faults && !failed; ++round) {
    next_one = 0
    for (k = 1; k <= faults; ++k)
      if (!(k in planted) && (next_one == 0 || start[k] < start[next_one]))
        next_one = k
    k = next_one
    planted[k] = 1
    if (start[k] < done)
      complain(number[k] " overlaps another")
    out = out substr(source, done, start[k] - done) text[k]
    done = start[k] + size[k]
  }
  if (failed)
    exit 1
  if (file !~ /\.lua$/)
    print "#include \"mutants/switch.hpp\""
  printf "%s", out substr(source, done)
}
