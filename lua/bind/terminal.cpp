// What the library may know of the terminal, the machine and the clock.
#include "bind/engine.hpp"

#include <chrono>
#include <cstdio>
#include <fmt/format.h>
#include <sys/ioctl.h>
#include <thread>
#include <unistd.h>

#include "bind/interrupt.hpp"
#include "bind/push.hpp"
#include "bind/wrap.hpp"
#include "record/manifest.hpp"

namespace stiction::bind {

namespace {

/// write(text), complain(text): to standard output and standard error, at once
int write_text(lua_State* lua) {
  auto const text = text_at(lua, 1);
  std::fwrite(text.data(), 1, text.size(), stdout);
  std::fflush(stdout);
  return 0;
}

int complain(lua_State* lua) {
  std::fflush(stdout);
  auto const text = text_at(lua, 1);
  std::fwrite(text.data(), 1, text.size(), stderr);
  return 0;
}

/// terminal_width() -> columns of the terminal on standard output, nil if there is none
int terminal_width(lua_State* lua) {
  winsize size{};
  if (isatty(STDOUT_FILENO) == 0)
    return 0;
  bool const known = ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  push(lua, known ? static_cast<int>(size.ws_col) : 80);
  return 1;
}

/// processor() -> its name, and for which one OpenBLAS computes on it
int processor(lua_State* lua) {
  push(lua, record::processor());
  return 1;
}

/// utc_now() -> "2026-01-31T12:00:00Z"
int utc_now(lua_State* lua) {
  push(lua, record::utc_now());
  return 1;
}

/// clock() -> seconds since an arbitrary start
int clock(lua_State* lua) {
  using namespace std::chrono;
  push(lua, duration<double>(steady_clock::now().time_since_epoch()).count());
  return 1;
}

/// cores() -> number of processors of this machine
int cores(lua_State* lua) {
  push(lua, static_cast<int>(std::max(1U, std::thread::hardware_concurrency())));
  return 1;
}

/// number_text(x) -> the shortest text that reads back as the same number
int number_text(lua_State* lua) {
  push(lua, fmt::format("{}", luaL_checknumber(lua, 1)));
  return 1;
}

/// stopped() -> whether the user asked to stop
int stopped(lua_State* lua) {
  push(lua, stop_flag().load());
  return 1;
}

} // namespace

void add_terminal_functions(lua_State* lua) {
  add<write_text>(lua, "write");
  add<complain>(lua, "complain");
  add<terminal_width>(lua, "terminal_width");
  add<processor>(lua, "processor");
  add<utc_now>(lua, "utc_now");
  add<clock>(lua, "clock");
  add<cores>(lua, "cores");
  add<number_text>(lua, "number_text");
  add<stopped>(lua, "stopped");
}

} // namespace stiction::bind
