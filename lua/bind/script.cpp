// Loading the user's files and telling where their calls come from.
#include "bind/engine.hpp"

#include <fmt/format.h>

#include "bind/interrupt.hpp"
#include "bind/push.hpp"
#include "bind/state.hpp"
#include "bind/trace.hpp"
#include "bind/wrap.hpp"

namespace stiction::bind {

namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF"; // that some editors put first

/// load_script(text, name, environment) -> function, or nil and the reason; messages call the file `name`.
/// Text only, no bytecode.
int load_script(lua_State* lua) {
  auto text = text_at(lua, 1);
  if (text.starts_with(byte_order_mark))
    text.erase(0, byte_order_mark.size());
  auto const name = fmt::format("@{}", text_at(lua, 2));
  if (luaL_loadbufferx(lua, text.data(), text.size(), name.c_str(), "t") != LUA_OK) {
    lua_pushnil(lua);
    lua_insert(lua, -2);
    return 2;
  }
  lua_pushvalue(lua, 3);
  lua_setupvalue(lua, -2, 1);
  return 1;
}

/// where() -> "study.lua:12" of the innermost function of the user's, or ""
int where(lua_State* lua) {
  push(lua, user_place(lua));
  return 1;
}

/// call(function, ...) -> true and results, or false and an error value with its trace
int call(lua_State* lua) {
  lua_pushcfunction(lua, on_error);
  lua_insert(lua, 1);
  int const status = lua_pcall(lua, lua_gettop(lua) - 2, LUA_MULTRET, 1);
  bool const held = status == LUA_OK;
  if (status == LUA_ERRMEM) { // which no message handler has seen
    lua_settop(lua, 1);
    push_memory_error(lua);
  }
  push(lua, held);
  lua_replace(lua, 1);
  return lua_gettop(lua);
}

/// call_within(instructions, function, ...) -> as call; the user's functions end by an error after so many
int call_within(lua_State* lua) {
  auto const instructions = static_cast<long>(luaL_checkinteger(lua, 1));
  lua_remove(lua, 1);
  limit_script(lua, instructions);
  int const count = call(lua);
  limit_script(lua, 0);
  return count;
}

/// watch_lines(flag): whether errors behind the user's tail calls know their place from now on, for a third
/// of the time
int watch_lines(lua_State* lua) {
  watch_script(lua, lua_toboolean(lua, 1) != 0);
  return 0;
}

/// watch_returns(flag): whether that place is right behind calls in the same line as well, from now on
int note_returns(lua_State* lua) {
  watch_returns(lua, lua_toboolean(lua, 1) != 0);
  return 0;
}

/// part(table) -> "material.blatz_ko" of what a constructor made, or ""
int part(lua_State* lua) {
  luaL_checktype(lua, 1, LUA_TTABLE);
  if (luaL_getmetafield(lua, 1, "tag") == LUA_TNIL)
    push(lua, "");
  return 1;
}

/// library_root() -> folder of the Lua library
int root(lua_State* lua) {
  push(lua, library_root());
  return 1;
}

} // namespace

void add_script_functions(lua_State* lua) {
  add<load_script>(lua, "load_script");
  add<where>(lua, "where");
  add<call>(lua, "call");
  add<call_within>(lua, "call_within");
  add<watch_lines>(lua, "watch_lines");
  add<note_returns>(lua, "watch_returns");
  add<part>(lua, "part");
  add<root>(lua, "library_root");
}

} // namespace stiction::bind
