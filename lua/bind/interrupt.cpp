// Ctrl-C and SIGTERM: one flag that running scripts and the engine look at.
#include "bind/interrupt.hpp"

#include <csignal>
#include <fmt/format.h>
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

/// After the first stop every further instruction of the user's raises again, so that no pcall of theirs
/// holds the script alive. Our own library ends in its own, orderly way.
void on_event(lua_State* lua, lua_Debug* event) {
  if (event->event == LUA_HOOKLINE)
    note_line(lua, event);
  if (!stop || !in_user_code(lua))
    return;
  lua_sethook(lua, on_event, LUA_MASKCOUNT, 1);
  auto const message = fmt::format("stopped by the user while a script was running, in {}", user_place(lua));
  push_error(lua, "stopped", message.c_str());
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
  lua_sethook(lua, on_event, LUA_MASKCOUNT | LUA_MASKLINE, 10000);
}

} // namespace stiction::bind
