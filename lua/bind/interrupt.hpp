// Ctrl-C and SIGTERM: one flag that running scripts and the engine look at.
#pragma once
#include <atomic>

#include <lua.hpp>

namespace stiction::bind {

/// True once SIGINT or SIGTERM has arrived.
std::atomic<bool> const& stop_flag();

/// Installs the handlers; a second SIGINT ends the process at once with exit code 1.
void watch_signals();

/// Makes this process end with its parent and outlive a closed pipe, as a case of a sweep should.
void follow_parent();

/// Lets the user's functions end by an error of kind "stopped" once the flag is set.
void watch_script(lua_State* lua);

} // namespace stiction::bind
