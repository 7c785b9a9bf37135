# The rules of order.sh on one pass over all files; paths are given from the root.
function breach(text) {
  print file ":" (FNR > 1 && file == FILENAME ? FNR ":" : "") " " text
  failed = 1
}
function finish() { # what is known only at a file's end
  if (file == "")
    return
  if (lines > 500)
    breach("has " lines " lines, more than 500: split it")
  if (!sentence)
    breach("does not open with a comment of one sentence")
}
BEGIN {
  count = split(layers, names, " ")
  for (i = 1; i <= count; ++i)
    rank[names[i]] = i
  room_count = split(rooms, names, " ")
  for (i = 1; i <= room_count; ++i) {
    room_rank[names[i]] = i
    divided[substr(names[i], 1, index(names[i], "/") - 1)] = 1
  }
  study_count = split(studies, study, " ")
}
FNR == 1 {
  finish()
  file = FILENAME
  sentence = 0
  in_opening = 1
  mark = FILENAME ~ /\.[ch]pp$/ ? "//" : FILENAME ~ /\.lua$/ ? "--" : "#"
  split(file, part, "/")
  top = part[1]
  layer = top == "engine" ? part[2] : ""
  if (layer != "" && !(layer in rank))
    breach("lies in no layer of engine/CMakeLists.txt")
  room = layer in divided ? layer "/" part[3] : ""
  if (room != "" && !(room in room_rank))
    breach("lies in no room of its layer in engine/CMakeLists.txt")
}
{ lines = FNR }
in_opening && !(FNR == 1 && /^#!/) {
  if (index($0, mark) == 1)
    sentence = sentence || /[.?!:]$/
  else
    in_opening = 0
}
/^[ \t]*#[ \t]*include[ \t]*["<]/ {
  name = $0
  sub(/^[^"<]*["<]/, "", name)
  sub(/[">].*$/, "", name)
  target = name
  sub(/\/.*$/, "", target)
  own = name ~ /\// && target in rank
  if (layer != "" && own && rank[target] > rank[layer])
    breach("includes \"" name "\", but " target " stands after " layer)
  wanted = name
  sub(/\/[^\/]*$/, "", wanted)
  if (layer != "" && own && target in divided && !(wanted in room_rank))
    breach("includes \"" name "\", which is not of the form \"layer/room/file.hpp\"")
  if (room in room_rank && target == layer && room_rank[wanted] > room_rank[room])
    breach("includes \"" name "\", but " wanted " stands after " room)
  if (layer != "" && (target == "lua" || target == "postproc" || target == "bind" || name ~ /^lua|^lauxlib|^lualib/))
    breach("includes \"" name "\": the engine knows nothing above it")
  if (layer != "" && !own && /"/)
    breach("includes \"" name "\", which is not of the form \"layer/file.hpp\"")
  if (top == "postproc" && own && target != "core")
    breach("includes \"" name "\": figures come from files, not from the engine")
}
FILENAME ~ /\.cpp$/ && /TEST_CASE[A-Z_]*\(".*[;[\]].*"\)/ {
  breach("names a test with one of ; [ ], at which the list of tests is split")
}
layer != "" {
  for (i = 1; i <= study_count; ++i)
    if (index($0, study[i]))
      breach("names the study " study[i])
}
END {
  finish()
  exit failed
}
