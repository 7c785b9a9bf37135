// Where in the user's own files a call or an error came from.
#pragma once
#include <string>

#include <lua.hpp>

namespace stiction::bind {

/// "study.lua:12" of the innermost running function that is the user's, or "".
std::string user_place(lua_State* lua);

/// Message handler: turns a plain error into {kind = "script", message, trace} with the user's frames.
int on_error(lua_State* lua);

} // namespace stiction::bind
