// The words on the command line as options by name.
#pragma once
#include <map>
#include <string>
#include <variant>
#include <vector>

namespace stiction::bind {

using Option = std::variant<bool, double, std::string, std::vector<std::string>>;

/// What the user asked for. An option not given has no entry.
struct CommandLine {
  std::string command; ///< "run", "help", ...; empty when parsing already answered (--help, an error)
  std::map<std::string, Option> options;
  int code = 0; ///< exit code when command is empty
};

/// Parses; prints help or one message about a wrong word itself.
CommandLine parse_command_line(int count, char const* const* words);

} // namespace stiction::bind
