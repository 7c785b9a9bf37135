-- The commands of the program, one module each; each returns its exit code.
local function lines(text)
  local list = {}
  for line in text:gmatch("([^\n]*)\n") do
    list[#list + 1] = line
  end
  return list
end

return function(command, options)
  local words = command == "help" and options.topic and options.topic:match("^new\n(.*)%.$")
  if words then -- as the launchers hand them on: each with the end of its line, then a dot
    command, options = "new", { words = lines(words) }
  end
  return require("stiction.cli." .. command)(options)
end
