// Where in the user's own files a call or an error came from.
#pragma once
#include <string>

#include <lua.hpp>

namespace stiction::bind {

/// Notes the line about to run if it is the user's; a tail call leaves no other trace of its caller.
void note_line(lua_State* lua, lua_Debug* event);

/// Notes the line that goes on where one of the user's functions has been called from it and ends.
void note_return(lua_State* lua, lua_Debug* event);

/// "study.lua:12" of the innermost call in the user's files, or "" if none of theirs is under way.
std::string user_place(lua_State* lua);

/// True if one of the user's functions stands on the stack.
bool in_user_code(lua_State* lua);

/// Message handler: turns a plain error into {kind = "script", message, trace} with the user's frames.
int on_error(lua_State* lua);

} // namespace stiction::bind
