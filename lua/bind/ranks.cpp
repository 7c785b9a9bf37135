// Starting ranks by OpenMPI's mpirun, loading the component that they need, ending them together.
#include "bind/ranks.hpp"

#include <cstdlib>
#include <cstring>
#include <dlfcn.h>
#include <fcntl.h>
#include <filesystem>
#include <fmt/format.h>
#include <iostream>
#include <unistd.h>

#include "bind/engine.hpp"
#include "bind/push.hpp"
#include "bind/wrap.hpp"
#include "core/error.hpp"

#ifndef STICTION_RANKS_PATH
#define STICTION_RANKS_PATH ""
#endif

namespace stiction::bind {

namespace {

namespace fs = std::filesystem;

/// s that mpirun waits, where a rank has died or it is told to end, before it tells the others, and once more
/// before it kills them.
constexpr int grace = 0;
constexpr double patience = 10;           ///< s that one which fails, or the first, waits for the others
constexpr char record_separator = '\x1e'; ///< before a line that is no text (RFC 7464)

linear::Ranks const* joined = nullptr;
std::string last_words;
int told_to = STDOUT_FILENO; ///< descriptor

fs::path own_path() {
  return fs::read_symlink("/proc/self/exe");
}

fs::path component() {
  std::error_code missing;
  for (fs::path const& path :
       {own_path().parent_path() / "../lib/stiction/stiction-ranks.so", fs::path(STICTION_RANKS_PATH)})
    if (!path.empty() && fs::exists(path, missing))
      return path;
  return {};
}

bool has_program(std::string const& name) {
  char const* const given = std::getenv("PATH");
  std::string const path = given != nullptr ? given : "";
  for (std::size_t from = 0; from <= path.size();) {
    auto const to = std::min(path.find(':', from), path.size());
    if (access((path.substr(from, to - from) + "/" + name).c_str(), X_OK) == 0)
      return true;
    from = to + 1;
  }
  return false;
}

void write_line(std::string const& line) {
  auto const text = fmt::format("{}{}\n", record_separator, line);
  static_cast<void>(!write(told_to, text.data(), text.size()));
}

} // namespace

std::string why_no_ranks() {
  if (component().empty() && *STICTION_RANKS_PATH != 0)
    return "what they load is not here; install the package stiction-ranks, which is made together with "
           "that of stiction";
  if (component().empty())
    return "this program was built without PETSc; install Debian's petsc-dev and build again: "
           "apt-get install petsc-dev && " STICTION_BUILD_AGAIN;
  if (!has_program("mpirun"))
    return "there is no mpirun to start them; install Debian's openmpi-bin: apt-get install openmpi-bin";
  return "";
}

bool starts_ranks(CommandLine const& line) {
  return line.command == "case" && line.options.contains("ranks") && !line.options.contains("member");
}

void become_ranks(CommandLine const& line, std::vector<std::string> words) {
  if (auto const why = why_no_ranks(); !why.empty())
    throw core::RunError("--ranks: " + why);
  words[0] = own_path().string();
  std::vector<std::string> all = {"mpirun",
                                  "-q",
                                  "-n",
                                  fmt::format("{:.0f}", std::get<double>(line.options.at("ranks"))),
                                  "--oversubscribe",
                                  "--bind-to",
                                  "none",
                                  "--mca",
                                  "odls_base_sigkill_timeout",
                                  std::to_string(grace),
                                  "--mca",
                                  "btl_base_warn_component_unused",
                                  "0",
                                  "--mca",
                                  "mpi_yield_when_idle",
                                  "1"};
  if (geteuid() == 0)
    all.emplace_back("--allow-run-as-root");
  all.insert(all.end(), words.begin(), words.end());
  all.emplace_back("--member");
  std::vector<char*> pointers;
  pointers.reserve(all.size() + 1);
  for (auto& word : all)
    pointers.push_back(word.data());
  pointers.push_back(nullptr);
  execvp(pointers[0], pointers.data());
  throw core::RunError(fmt::format("cannot start mpirun: {}", std::strerror(errno)));
}

void join_ranks(CommandLine const& line) {
  if (!line.options.contains("member"))
    return;
  auto const path = component();
  void* const loaded = path.empty() ? nullptr : dlopen(path.c_str(), RTLD_NOW | RTLD_GLOBAL);
  void* const join = loaded != nullptr ? dlsym(loaded, linear::join_ranks_name) : nullptr;
  if (join == nullptr)
    throw core::RunError(
        fmt::format("cannot load what ranks need ({})", path.empty() ? why_no_ranks() : dlerror()));
  joined = &reinterpret_cast<linear::JoinRanks>(join)();
  told_to = dup(STDOUT_FILENO);
  fcntl(told_to, F_SETFD, FD_CLOEXEC);
  if (joined->rank() == 0)
    return;
  int const nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
  dup2(nowhere, STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);
}

linear::Ranks const* ranks() {
  return joined;
}

void tell_of_ranks(std::string const& line) {
  if (joined->rank() == 0)
    write_line(line);
  else
    last_words = line;
}

int leave_ranks(int code) {
  if (joined == nullptr)
    return code;
  std::cout.flush();
  bool const first = joined->rank() == 0, failed = code != 0;
  constexpr double forever = 1e9;
  if (joined->part(first || failed ? patience : forever))
    return first ? code : 0;
  if (!first)
    write_line(last_words);
  joined->abort(failed ? code : 1);
  std::abort(); // GCC does not know that a virtual function does not return
}

namespace {

/// rank() -> number of this process among the ranks of its case, from 0; 0 where it has none beside it
int rank(lua_State* lua) {
  push(lua, joined != nullptr ? joined->rank() : 0);
  return 1;
}

/// why_no_ranks() -> why this program cannot start ranks, or nil
int why_none(lua_State* lua) {
  auto const why = why_no_ranks();
  if (why.empty())
    return 0;
  push(lua, why);
  return 1;
}

} // namespace

void add_rank_functions(lua_State* lua) {
  add<rank>(lua, "rank");
  add<why_none>(lua, "why_no_ranks");
}

} // namespace stiction::bind
