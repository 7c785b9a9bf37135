// Ctrl-C and SIGTERM: one flag that running scripts and the engine look at.
#include "bind/interrupt.hpp"

#include <chrono>
#include <csignal>
#include <fmt/format.h>
#include <iostream>
#include <string_view>
#include <sys/prctl.h>
#include <unistd.h>

#include "bind/trace.hpp"
#include "bind/wrap.hpp"

namespace stiction::bind {

namespace {

std::atomic<bool> stop{false};
static_assert(std::atomic<bool>::is_always_lock_free, "the flag is set from a signal handler");

std::atomic<int> at_once{0}; ///< how many EndsAtOnce live
std::atomic<pid_t> child_to_tell{0};
std::atomic<int> told_by{0}; ///< signal; 0: the one that came
bool follows = false, ends_outright = false;
void on_event(lua_State* lua, lua_Debug* event);
constexpr int instructions_per_look = 10000;
long looks_left = -1; ///< before a limited script ends; -1: without limit

[[noreturn]] void end_at_once(int signal) {
  constexpr std::string_view words = "stiction: stopped by the user\n";
  if (!follows)
    static_cast<void>(!write(STDERR_FILENO, words.data(), words.size()));
  _exit(follows ? 128 + signal : 1);
}

void on_signal(int signal) {
  if (pid_t const child = child_to_tell; child > 0)
    kill(child, told_by != 0 ? told_by.load() : signal);
  if (at_once > 0)
    end_at_once(signal);
  if (stop.exchange(true) && signal == SIGINT)
    _exit(1);
}

[[noreturn]] void raise(lua_State* lua, char const* kind, std::string const& message) {
  lua_sethook(lua, on_event, LUA_MASKCOUNT, 1);
  push_error(lua, kind, message.c_str());
  lua_error(lua);
  throw core::Bug("lua_error returned");
}

/// How long the user's code has been running, by the time between looks; a pause longer than the longest that
/// a script makes between two is no work of its.
void tell_of_long_work(lua_State* lua) {
  using Clock = std::chrono::steady_clock;
  using std::chrono::seconds;
  static auto last = Clock::now();
  static Clock::duration busy{}, next = seconds(5);
  auto const now = Clock::now();
  busy = in_user_code(lua) ? busy + std::min<Clock::duration>(now - last, seconds(1)) : Clock::duration{};
  last = now;
  if (busy < next) {
    next = busy == Clock::duration{} ? seconds(5) : next;
    return;
  }
  std::cerr << fmt::format(
      "stiction: {} is still running after {} s of the script's own work; Ctrl-C stops it\n", user_place(lua),
      std::chrono::duration_cast<seconds>(busy).count());
  next = 2 * busy;
}

/// After the first stop every further instruction of the user's raises again, so that no pcall of theirs
/// holds the script alive. Our own library ends in its own, orderly way.
void on_event(lua_State* lua, lua_Debug* event) {
  if (event->event == LUA_HOOKRET)
    return note_return(lua, event);
  if (event->event == LUA_HOOKLINE)
    note_line(lua, event);
  else
    tell_of_long_work(lua);
  if (looks_left > 0 && event->event == LUA_HOOKCOUNT)
    --looks_left;
  if ((!stop && looks_left != 0) || !in_user_code(lua))
    return;
  if (stop)
    raise(lua, "stopped",
          fmt::format("stopped by the user while a script was running, in {}", user_place(lua)));
  raise(lua, "script", fmt::format("no end in sight, in {}", user_place(lua)));
}

} // namespace

std::atomic<bool> const& stop_flag() {
  return stop;
}

EndsAtOnce::EndsAtOnce() {
  ++at_once;
  if (stop)
    end_at_once(SIGTERM);
}

EndsAtOnce::~EndsAtOnce() {
  --at_once;
}

void watch_signals() {
  struct sigaction action {};
  action.sa_handler = on_signal;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  sigaction(stops_ranks, &action, nullptr);
  std::signal(SIGXFSZ, SIG_IGN); // a file that may grow no more is a failed write, with its reason
}

void hand_signals_on(pid_t child, int as) {
  told_by = as;
  child_to_tell = child;
}

void follow_parent(bool at_once) {
  follows = true;
  ends_outright = ends_outright || at_once;
  prctl(PR_SET_PDEATHSIG, ends_outright ? SIGKILL : SIGTERM);
  std::signal(SIGPIPE, SIG_IGN);
}

void watch_script(lua_State* lua, bool lines) {
  lua_sethook(lua, on_event, lines ? LUA_MASKCOUNT | LUA_MASKLINE : LUA_MASKCOUNT, instructions_per_look);
}

void watch_returns(lua_State* lua, bool on) {
  constexpr int lines = LUA_MASKCOUNT | LUA_MASKLINE;
  if ((lua_gethookmask(lua) & LUA_MASKLINE) != 0)
    lua_sethook(lua, on_event, on ? lines | LUA_MASKRET : lines, instructions_per_look);
}

void limit_script(lua_State* lua, long instructions) {
  looks_left = instructions > 0 ? instructions / instructions_per_look + 1 : -1;
  watch_script(lua);
}

} // namespace stiction::bind
