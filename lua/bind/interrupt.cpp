// Ctrl-C and SIGTERM: one flag that running scripts and the engine look at.
#include "bind/interrupt.hpp"

#include <csignal>
#include <sys/prctl.h>
#include <unistd.h>

#include "bind/trace.hpp"
#include "bind/wrap.hpp"

namespace stiction::bind {

namespace {

std::atomic<bool> stop{false};
static_assert(std::atomic<bool>::is_always_lock_free, "the flag is set from a signal handler");

void on_signal(int signal) {
  if (stop.exchange(true) && signal == SIGINT)
    _exit(1);
}

/// After the first stop every further instruction raises again, so that no pcall can hold the script alive.
void on_count(lua_State* lua, lua_Debug*) {
  if (!stop || user_place(lua).empty()) // our own library ends in its own, orderly way
    return;
  lua_sethook(lua, on_count, LUA_MASKCOUNT, 1);
  push_error(lua, "stopped", "stopped by the user while a script was running");
  lua_error(lua);
}

} // namespace

std::atomic<bool> const& stop_flag() {
  return stop;
}

void watch_signals() {
  struct sigaction action {};
  action.sa_handler = on_signal;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

void follow_parent() {
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  std::signal(SIGPIPE, SIG_IGN);
}

void watch_script(lua_State* lua) {
  lua_sethook(lua, on_count, LUA_MASKCOUNT, 10000);
}

} // namespace stiction::bind
