// Starting, reading and ending child processes.
#include "bind/process.hpp"

#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>

#include "bind/lock.hpp"
#include "core/error.hpp"

extern char** environ;

namespace stiction::bind {

namespace {

/// A pipe whose ends close on exec; dup2 in the child makes the copies that stay.
struct Pipe {
  int ends[2] = {-1, -1};
  Pipe() {
    if (pipe2(ends, O_CLOEXEC) != 0)
      throw core::RunError(fmt::format("cannot open a pipe: {}", std::strerror(errno)));
  }
  Pipe(Pipe const&) = delete;
  Pipe& operator=(Pipe const&) = delete;
  ~Pipe() {
    for (int const end : ends)
      if (end >= 0)
        close(end);
  }
  int take_reader() {
    int const reader = std::exchange(ends[0], -1);
    fcntl(reader, F_SETFL, O_NONBLOCK);
    return reader;
  }
};

/// A pair of sockets, of which the second is the child's: writing to a child that is gone raises no signal.
struct Requests {
  int ends[2] = {-1, -1};
  explicit Requests(bool wanted) {
    if (wanted && socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
      throw core::RunError(fmt::format("cannot open a socket: {}", std::strerror(errno)));
  }
  Requests(Requests const&) = delete;
  Requests& operator=(Requests const&) = delete;
  ~Requests() {
    for (int const end : ends)
      if (end >= 0)
        close(end);
  }
};

struct Actions {
  posix_spawn_file_actions_t files{};
  posix_spawnattr_t attributes{};
  Actions(Pipe const& messages, Pipe const& prints, Requests const& requests) {
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_adddup2(&files, messages.ends[1], message_descriptor);
    posix_spawn_file_actions_adddup2(&files, prints.ends[1], STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&files, prints.ends[1], STDERR_FILENO);
    for (int const lock : held_locks()) // onto itself: it stays open
      posix_spawn_file_actions_adddup2(&files, lock, lock);
    if (requests.ends[1] >= 0)
      posix_spawn_file_actions_adddup2(&files, requests.ends[1], STDIN_FILENO);
    else
      posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  }
  Actions(Actions const&) = delete;
  Actions& operator=(Actions const&) = delete;
  ~Actions() {
    posix_spawn_file_actions_destroy(&files);
    posix_spawnattr_destroy(&attributes);
  }
};

std::vector<std::string> environment_with(std::vector<std::string> const& variables) {
  std::vector<std::string> all = variables; // the first of two with one name counts
  for (char** entry = environ; *entry != nullptr; ++entry)
    all.emplace_back(*entry);
  return all;
}

double seconds(timeval const& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

std::vector<char*> pointers(std::vector<std::string>& words) {
  std::vector<char*> list;
  list.reserve(words.size() + 1);
  for (auto& word : words)
    list.push_back(word.data());
  list.push_back(nullptr);
  return list;
}

} // namespace

End end_of(int status, rusage const& usage) {
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status),
          seconds(usage.ru_utime) + seconds(usage.ru_stime), 1024.0 * static_cast<double>(usage.ru_maxrss)};
}

Process::Process(std::vector<std::string> words, std::vector<std::string> const& variables, bool asked) {
  core::expect(!words.empty(), "a program to start");
  Pipe messages, prints;
  Requests requests(asked);
  Actions const actions(messages, prints, requests);
  auto environment = environment_with(variables);
  int const failed = posix_spawnp(&id_, words[0].c_str(), &actions.files, &actions.attributes,
                                  pointers(words).data(), pointers(environment).data());
  if (failed != 0)
    throw core::RunError(fmt::format("cannot start {}: {}", words[0], std::strerror(failed)));
  messages_.descriptor = messages.take_reader();
  prints_.descriptor = prints.take_reader();
  requests_ = std::exchange(requests.ends[0], -1);
}

Process::~Process() {
  if (!end_) {
    signal(SIGKILL);
    waitpid(id_, nullptr, 0);
  }
  messages_.close();
  prints_.close();
  if (requests_ >= 0)
    close(requests_);
}

void Process::send(std::string const& request) const {
  core::expect(requests_ >= 0, "a process that takes requests");
  for (std::size_t sent = 0; sent < request.size();) {
    auto const count = ::send(requests_, request.data() + sent, request.size() - sent, MSG_NOSIGNAL);
    if (count < 0 && errno != EINTR)
      return;
    sent += count > 0 ? static_cast<std::size_t>(count) : 0;
  }
}

void Process::Stream::close() {
  if (descriptor >= 0)
    ::close(std::exchange(descriptor, -1));
}

void Process::Stream::read() {
  char buffer[4096];
  while (descriptor >= 0) {
    auto const count = ::read(descriptor, buffer, sizeof buffer);
    if (count > 0)
      text.append(buffer, static_cast<std::size_t>(count));
    else if (count == 0)
      close();
    else if (errno != EINTR)
      return; // nothing more for now
  }
}

void Process::collect() {
  int status = 0;
  rusage usage{};
  if (!end_ && wait4(id_, &status, WNOHANG, &usage) == id_)
    end_ = end_of(status, usage);
  messages_.read();
  prints_.read();
}

void Process::signal(int number) const {
  if (!end_) // who is not asked takes those with him that he started
    kill(number == SIGKILL ? -id_ : id_, number);
}

std::vector<int> Process::descriptors() const {
  std::vector<int> open;
  for (auto const* stream : {&messages_, &prints_})
    if (stream->descriptor >= 0)
      open.push_back(stream->descriptor);
  return open;
}

std::vector<std::string> Process::take_lines() {
  std::vector<std::string> lines;
  std::size_t start = 0;
  for (auto end = messages_.text.find('\n'); end != std::string::npos;
       end = messages_.text.find('\n', start)) {
    lines.push_back(messages_.text.substr(start, end - start));
    start = end + 1;
  }
  messages_.text.erase(0, start);
  return lines;
}

std::string Process::take_text() {
  return std::exchange(prints_.text, {});
}

} // namespace stiction::bind
