// The error value of the binding.
#include "bind/wrap.hpp"

#include "bind/push.hpp"

namespace stiction::bind {

namespace {
int error_text(lua_State* lua) {
  lua_getfield(lua, 1, "message");
  return 1;
}
} // namespace

void push_error_metatable(lua_State* lua) {
  if (luaL_newmetatable(lua, error_metatable) != 0)
    add<error_text>(lua, "__tostring");
}

void push_error(lua_State* lua, char const* kind, char const* message) {
  lua_createtable(lua, 0, 3);
  set(lua, "kind", kind);
  set(lua, "message", message);
  push_error_metatable(lua);
  lua_setmetatable(lua, -2);
}

bool is_error_value(lua_State* lua, int index) {
  if (lua_getmetatable(lua, index) == 0)
    return false;
  push_error_metatable(lua);
  bool const same = lua_rawequal(lua, -1, -2) != 0;
  lua_pop(lua, 2);
  return same;
}

} // namespace stiction::bind
