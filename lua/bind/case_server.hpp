// A process that has the library loaded and runs case after case, each in a child of its own.
#pragma once
#include <string>
#include <vector>

namespace stiction::bind {

/// A request as it goes through the pipe: the number of words on a line, then each with a 0 behind it.
std::string case_request(std::vector<std::string> const& words);

/// Serves standard input to its end: per request (the words of a command line) `run(words)` in a child, whose
/// end is told on descriptor 3 as {"code":, "over": whether it serves no more, "seconds": of the processor,
/// "memory": bytes at most}. A signal to stop goes on to the child, and is the end. Returns the exit code.
int serve_cases(int (*run)(std::vector<std::string> const& words));

} // namespace stiction::bind
