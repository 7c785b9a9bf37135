// The sandboxed Lua state in which our library and the user's script run.
#pragma once
#include <memory>
#include <string>

#include <lua.hpp>

namespace stiction::bind {

struct CloseState {
  void operator()(lua_State* lua) const { lua_close(lua); }
};
using State = std::unique_ptr<lua_State, CloseState>;

/// Folder that holds stiction/init.lua: beside an installed program, else in the source tree.
std::string const& library_root();

/// A state with base, package, table, string, math, utf8 and coroutine; nothing that loads text, reads
/// files or sees the clock. `trust` opens io and os. The engine's functions stand in
/// package.preload["stiction.engine"], for the library only.
State make_state(bool trust);

} // namespace stiction::bind
