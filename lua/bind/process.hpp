// A child process with its two streams: messages on descriptor 3, whatever it prints on 1 and 2.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include <sys/resource.h>
#include <sys/types.h>

namespace stiction::bind {

inline constexpr int message_descriptor = 3; ///< of a child

/// Of a child that has ended, by what wait4 says of it.
struct End {
  int code = 0;           ///< exit code, or 128 + signal number
  double cpu_seconds = 0; ///< of it and of those it waited for
  double peak_memory = 0; ///< of the largest of them, bytes
};
End end_of(int status, rusage const& usage);

class Process {
public:
  /// Starts `words` in its own process group with `variables` ("NAME=value") added to the environment.
  /// Throws RunError if it cannot be started.
  /// `asked`: it reads requests from its standard input, which is empty otherwise.
  Process(std::vector<std::string> words, std::vector<std::string> const& variables, bool asked = false);
  Process(Process const&) = delete;
  Process& operator=(Process const&) = delete;
  ~Process();

  /// Reads what has come, without waiting; notes the end of the process.
  void collect();
  /// One that has ended takes nothing: its code tells.
  void send(std::string const& request) const;
  void signal(int number) const;
  [[nodiscard]] std::vector<int> descriptors() const;  ///< still open, for poll
  [[nodiscard]] std::vector<std::string> take_lines(); ///< complete messages since the last call
  [[nodiscard]] std::string take_text();               ///< what it printed since the last call
  /// Exit code, or 128 + signal number; nothing while it runs.
  [[nodiscard]] std::optional<int> code() const { return end_ ? std::optional(end_->code) : std::nullopt; }
  /// Processor time of it and of those it waited for, s, and the memory of the largest of them, bytes; once
  /// it has ended.
  [[nodiscard]] double cpu_seconds() const { return end_ ? end_->cpu_seconds : 0; }
  [[nodiscard]] double peak_memory() const { return end_ ? end_->peak_memory : 0; }

private:
  struct Stream {
    int descriptor = -1;
    std::string text;
    void read();
    void close();
  };
  pid_t id_ = 0;
  Stream messages_, prints_;
  int requests_ = -1; ///< descriptor
  std::optional<End> end_;
};

} // namespace stiction::bind
