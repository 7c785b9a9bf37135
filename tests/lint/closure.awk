# Prints for every .cpp among the files given (paths from the root) one line: itself and all project headers it
# includes, directly or not. Includes are looked up beside the file, then below engine/, lua/ and postproc/.
BEGIN {
  for (i = 1; i < ARGC; ++i)
    known[ARGV[i]] = 1
}
/^[ \t]*#[ \t]*include[ \t]*"/ {
  name = $0
  sub(/^[^"]*"/, "", name)
  sub(/".*$/, "", name)
  folder = FILENAME
  sub(/[^\/]*$/, "", folder)
  target = ""
  if ((folder name) in known) target = folder name
  else if (("engine/" name) in known) target = "engine/" name
  else if (("lua/" name) in known) target = "lua/" name
  else if (("postproc/" name) in known) target = "postproc/" name
  if (target != "")
    includes[FILENAME] = includes[FILENAME] " " target
}
function visit(file, count, list, i) {
  if (file in seen)
    return
  seen[file] = 1
  line = line " " file
  count = split(includes[file], list, " ")
  for (i = 1; i <= count; ++i)
    visit(list[i])
}
END {
  for (i = 1; i < ARGC; ++i)
    if (ARGV[i] ~ /\.cpp$/) {
      split("", seen)
      line = ""
      visit(ARGV[i])
      print substr(line, 2)
    }
}
