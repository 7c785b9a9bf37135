// C++ values to Lua values and back.
#include "bind/push.hpp"

namespace stiction::bind {

void push(lua_State* lua, bool value) {
  lua_pushboolean(lua, value ? 1 : 0);
}
void push(lua_State* lua, double value) {
  lua_pushnumber(lua, value);
}
void push(lua_State* lua, long value) {
  lua_pushinteger(lua, value);
}
void push(lua_State* lua, int value) {
  lua_pushinteger(lua, value);
}
void push(lua_State* lua, std::string_view value) {
  lua_pushlstring(lua, value.data(), value.size());
}

std::string text_at(lua_State* lua, int index) {
  std::size_t length = 0;
  char const* text = luaL_checklstring(lua, index, &length);
  return {text, length};
}

std::vector<std::string> texts_at(lua_State* lua, int index) {
  luaL_checktype(lua, index, LUA_TTABLE);
  std::vector<std::string> texts;
  auto const count = luaL_len(lua, index);
  for (lua_Integer i = 1; i <= count; ++i) {
    lua_geti(lua, index, i);
    texts.push_back(text_at(lua, -1));
    lua_pop(lua, 1);
  }
  return texts;
}

} // namespace stiction::bind
