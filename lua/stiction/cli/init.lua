-- The commands of the program, one module each; each returns its exit code.
return function(command, options)
  return require("stiction.cli." .. command)(options)
end
