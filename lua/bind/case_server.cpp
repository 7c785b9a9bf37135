// Requests from standard input, a child for each, its end on descriptor 3.
#include "bind/case_server.hpp"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <fmt/format.h>
#include <iostream>
#include <optional>
#include <sys/wait.h>
#include <unistd.h>

#include "bind/interrupt.hpp"
#include "bind/process.hpp"
#include "core/error.hpp"

namespace stiction::bind {

namespace {

constexpr int request_descriptor = 0;

/// Text to the next such byte, which is left out; nothing at the end of the pipe or at a signal.
std::optional<std::string> read_to(char end) {
  std::string text;
  for (char byte = 0; ::read(request_descriptor, &byte, 1) == 1; text.push_back(byte))
    if (byte == end)
      return text;
  return std::nullopt;
}

std::optional<std::vector<std::string>> next_request() {
  auto const count = read_to('\n');
  if (!count)
    return std::nullopt;
  std::vector<std::string> words(std::stoul(*count));
  for (auto& word : words) {
    auto read = read_to('\0');
    if (!read)
      return std::nullopt;
    word = std::move(*read);
  }
  return words;
}

/// While it lives, SIGINT and SIGTERM wait.
class SignalsWait {
public:
  SignalsWait() {
    sigset_t both;
    sigemptyset(&both);
    sigaddset(&both, SIGINT);
    sigaddset(&both, SIGTERM);
    sigprocmask(SIG_BLOCK, &both, &before_);
  }
  SignalsWait(SignalsWait const&) = delete;
  SignalsWait& operator=(SignalsWait const&) = delete;
  ~SignalsWait() { sigprocmask(SIG_SETMASK, &before_, nullptr); }

private:
  sigset_t before_{};
};

/// The child for these words, or 0 in it; signals go to it from now on.
pid_t fork_followed(std::vector<std::string> const& words) {
  SignalsWait const wait;
  pid_t const child = fork();
  if (child < 0)
    throw core::RunError("cannot start a process for a case");
  hand_signals_on(child, std::ranges::count(words, "--ranks") > 0 ? stops_ranks : 0);
  return child;
}

void tell_end(End const& end) {
  auto const line = fmt::format("{{\"code\": {}, \"over\": {}, \"seconds\": {}, \"memory\": {}}}\n", end.code,
                                stop_flag().load(), end.cpu_seconds, end.peak_memory);
  if (write(message_descriptor, line.data(), line.size()) !=
      static_cast<ssize_t>(line.size())) // a pipe takes it whole
    std::raise(SIGTERM);                 // nobody listens any more
}

} // namespace

std::string case_request(std::vector<std::string> const& words) {
  auto request = fmt::format("{}\n", words.size());
  for (auto const& word : words)
    request.append(word).push_back('\0');
  return request;
}

int serve_cases(int (*run)(std::vector<std::string> const& words)) {
  pid_t const server = getpid();
  while (auto const words = next_request()) {
    pid_t const child = fork_followed(*words);
    if (child == 0) {
      follow_parent(true); // whoever finds the server dead may begin its case anew
      if (getppid() != server)
        _exit(128 + SIGKILL);
      int const code = run(*words);
      std::cout.flush();
      std::fflush(nullptr);
      _exit(code);
    }
    int status = 0;
    rusage usage{};
    while (wait4(child, &status, 0, &usage) < 0 && errno == EINTR) {
    }
    hand_signals_on(0);
    tell_end(end_of(status, usage));
    if (stop_flag())
      return 1;
  }
  return 0;
}

} // namespace stiction::bind
