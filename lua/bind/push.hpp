// C++ values to Lua values and back.
#pragma once
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <lua.hpp>

namespace stiction::bind {

void push(lua_State* lua, bool value);
void push(lua_State* lua, double value);
void push(lua_State* lua, long value);
void push(lua_State* lua, int value);
void push(lua_State* lua, std::string_view value);
inline void push(lua_State* lua, std::string const& value) {
  push(lua, std::string_view(value));
}
inline void push(lua_State* lua, char const* value) {
  push(lua, std::string_view(value));
}

template<class T> void push(lua_State* lua, std::vector<T> const& values) {
  lua_createtable(lua, static_cast<int>(values.size()), 0);
  for (std::size_t i = 0; i < values.size(); ++i) {
    push(lua, values[i]);
    lua_rawseti(lua, -2, static_cast<lua_Integer>(i + 1));
  }
}

template<class T> void push(lua_State* lua, std::map<std::string, T> const& values) {
  lua_newtable(lua);
  for (auto const& [name, value] : values) {
    push(lua, value);
    lua_setfield(lua, -2, name.c_str());
  }
}

/// Sets field `name` of the table on top of the stack.
template<class T> void set(lua_State* lua, char const* name, T const& value) {
  push(lua, value);
  lua_setfield(lua, -2, name);
}

/// Argument `index` as text or a list of texts; raises a Lua error otherwise.
std::string text_at(lua_State* lua, int index);
std::vector<std::string> texts_at(lua_State* lua, int index);

} // namespace stiction::bind
