// Ctrl-C and SIGTERM: one flag that running scripts and the engine look at.
#pragma once
#include <atomic>
#include <csignal>

#include <lua.hpp>
#include <sys/types.h>

namespace stiction::bind {

/// True once SIGINT, SIGTERM or stops_ranks has arrived.
std::atomic<bool> const& stop_flag();

/// Installs the handlers; a second SIGINT ends the process at once with exit code 1.
void watch_signals();

/// While one of these lives, a signal ends this process at once: for long work that leaves nothing half done.
/// Exit code 1; that of the signal in a process that follows its parent, which tells the two apart.
class EndsAtOnce {
public:
  EndsAtOnce();
  ~EndsAtOnce();
  EndsAtOnce(EndsAtOnce const&) = delete;
  EndsAtOnce& operator=(EndsAtOnce const&) = delete;
};

/// What tells ranks to stop: mpirun hands it on at once, whereas it ends them itself at SIGINT and SIGTERM.
inline constexpr int stops_ranks = SIGUSR1;

/// Signals to stop also go to this process from now on, as they are or as the one given; 0: to none.
void hand_signals_on(pid_t child, int as = 0);

/// Makes this process end with its parent and outlive a closed pipe, as a case of a sweep should. `at_once`:
/// by a signal that cannot be caught, from now on whoever calls this again; the parent waits for it unless
/// killed.
void follow_parent(bool at_once = false);

/// Lets the user's functions end by an error once they have taken so many instructions (to ten thousand), of
/// kind "script"; 0: without limit.
void limit_script(lua_State* lua, long instructions);

/// Lets the user's functions end by an error of kind "stopped" once the flag is set. `lines`: also notes
/// every line, which takes a third of a script's time, so that an error behind a tail call knows its place.
void watch_script(lua_State* lua, bool lines = true);

/// Where lines are watched, functions that end are from now on, too, so that a table is of the line that its
/// constructor is called in; calls cost half as much again.
void watch_returns(lua_State* lua, bool on);

} // namespace stiction::bind
