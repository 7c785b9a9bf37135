// Starting the mesher without a shell and waiting for it.
#include "mesh/gmsh/mesher_process.hpp"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <fstream>
#include <spawn.h>
#include <sstream>
#include <sys/wait.h>
#include <unistd.h>

#include "core/error.hpp"

#ifndef STICTION_MESHER_PATH
#define STICTION_MESHER_PATH ""
#endif

namespace stiction::mesh {

namespace fs = std::filesystem;

namespace {

bool runnable(fs::path const& program) {
  return !program.empty() && access(program.c_str(), X_OK) == 0;
}

/// Starts argv[0] with both outputs going to `log`; returns its process id.
pid_t start(char* const* argv, fs::path const& log) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, 1, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  posix_spawn_file_actions_adddup2(&actions, 1, 2);
  pid_t child = 0;
  int const failed = posix_spawn(&child, argv[0], &actions, nullptr, argv, environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failed != 0)
    throw core::RunError(fmt::format("cannot start the mesher {}: {}", argv[0], std::strerror(failed)));
  return child;
}

} // namespace

fs::path find_mesher() {
  if (char const* named = std::getenv("STICTION_MESHER"); named != nullptr && *named != '\0')
    return runnable(named) ? fs::path(named) : fs::path();
  std::error_code failed;
  fs::path const beside = fs::read_symlink("/proc/self/exe", failed).parent_path() / "stiction-mesher";
  if (!failed && runnable(beside))
    return beside;
  fs::path const built = STICTION_MESHER_PATH;
  return runnable(built) ? built : fs::path();
}

MesherOutcome run_mesher(fs::path const& mesher, fs::path const& request, fs::path const& output) {
  std::string program = mesher.string(), in = request.string(), out = output.string();
  char* const argv[] = {program.data(), in.data(), out.data(), nullptr};
  fs::path const log = out + ".log";
  pid_t const child = start(argv, log);
  int status = 0;
  while (waitpid(child, &status, 0) < 0)
    if (errno != EINTR)
      throw core::RunError(fmt::format("lost the mesher: {}", std::strerror(errno)));
  std::ostringstream text;
  text << std::ifstream(log).rdbuf();
  std::error_code ignored;
  fs::remove(log, ignored);
  std::string message = text.str();
  while (!message.empty() && message.back() == '\n')
    message.pop_back();
  bool const killed = WIFSIGNALED(status);
  return {killed ? 0 : WEXITSTATUS(status), killed ? WTERMSIG(status) : 0, message};
}

} // namespace stiction::mesh
