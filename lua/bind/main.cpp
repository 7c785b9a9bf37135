// The program: command line to Lua, error values to exit codes.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fmt/format.h>
#include <iostream>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include "bind/case_server.hpp"
#include "bind/command_line.hpp"
#include "bind/interrupt.hpp"
#include "bind/kernels.hpp"
#include "bind/push.hpp"
#include "bind/ranks.hpp"
#include "bind/state.hpp"
#include "bind/trace.hpp"
#include "bind/wrap.hpp"
#include "linear/blocking.hpp"

namespace {

using namespace stiction;

void push_options(lua_State* lua, bind::CommandLine const& line) {
  lua_newtable(lua);
  for (auto const& option : line.options)
    std::visit([&](auto const& value) { bind::set(lua, option.first.c_str(), value); }, option.second);
}

std::string field(lua_State* lua, char const* name) {
  lua_getfield(lua, -1, name);
  std::string const text = lua_isstring(lua, -1) != 0 ? bind::text_at(lua, -1) : "";
  lua_pop(lua, 1);
  return text;
}

/// Prints the error value on top of the stack; its exit code.
int report(lua_State* lua, int status) {
  if (status == LUA_ERRMEM)
    bind::push_memory_error(lua);
  auto const kind = field(lua, "kind");
  std::cerr << fmt::format("stiction: {}{}\n", field(lua, "message"), field(lua, "trace"));
  return kind == "input" || kind == "script" ? 2 : 1;
}

/// Calls require("stiction.cli")(command, options), which returns the exit code.
int call_library(lua_State* lua, bind::CommandLine const& line) {
  lua_pushcfunction(lua, bind::on_error);
  lua_getglobal(lua, "require");
  lua_pushliteral(lua, "stiction.cli");
  if (int const status = lua_pcall(lua, 1, 1, 1); status != LUA_OK)
    return report(lua, status);
  bind::push(lua, line.command);
  push_options(lua, line);
  if (int const status = lua_pcall(lua, 2, 1, 1); status != LUA_OK)
    return report(lua, status);
  return static_cast<int>(lua_tointeger(lua, -1));
}

void load(lua_State* lua, char const* module) {
  lua_getglobal(lua, "require");
  lua_pushstring(lua, module);
  lua_call(lua, 1, 0);
}

lua_State* serving = nullptr; ///< the state from which children run their cases

int run_words(std::vector<std::string> const& words) {
  std::vector<char const*> pointers;
  pointers.reserve(words.size());
  for (auto const& word : words)
    pointers.push_back(word.c_str());
  auto const line = bind::parse_command_line(static_cast<int>(words.size()), pointers.data());
  if (bind::starts_ranks(line))
    bind::become_ranks(line, words);
  return line.command.empty() ? line.code : call_library(serving, line);
}

/// Cases that the parent names, each in a child that has the library already.
int serve(lua_State* lua) {
  bind::follow_parent();
  for (auto const* module : {"stiction", "stiction.cli", "stiction.cli.case"})
    load(lua, module);
  serving = lua;
  return bind::serve_cases(run_words);
}

int run(int count, char** words) {
  try {
    bind::take_kernels_of_processor(words);
    setenv("OPENBLAS_NUM_THREADS", "1", 1);
    linear::fix_blocking();
    auto const line = bind::parse_command_line(count, words);
    if (line.command.empty())
      return line.code;
    if (bind::starts_ranks(line))
      bind::become_ranks(line, {words, words + count});
    bind::watch_signals();
    bind::join_ranks(line);
    auto const state = bind::make_state(line.options.contains("trust"));
    return bind::leave_ranks(line.command == "cases" ? serve(state.get()) : call_library(state.get(), line));
  } catch (std::exception const& error) {
    std::cerr << "stiction: " << error.what() << "\n";
    return 1;
  }
}

/// Did a file or device not take all that was printed, as a full disk? Readers of pipes may leave early.
bool lost_output() {
  std::cout.flush();
  bool const failed = std::fflush(stdout) != 0 || std::ferror(stdout) != 0 || !std::cout;
  struct stat out {};
  return failed && fstat(STDOUT_FILENO, &out) == 0 && !S_ISFIFO(out.st_mode) && !S_ISSOCK(out.st_mode);
}

} // namespace

int main(int count, char** words) {
  int code = run(count, words);
  if (lost_output()) {
    std::cerr << "stiction: standard output took not all that was printed; is there room where it goes?\n";
    code = std::max(code, 1);
  }
  rlimit memory{};
  if (getrlimit(RLIMIT_AS, &memory) == 0 && memory.rlim_cur != RLIM_INFINITY) {
    std::cout.flush();
    std::fflush(nullptr);
    std::_Exit(code); // else OpenBLAS waits for threads that try for ever to get memory
  }
  return code;
}
