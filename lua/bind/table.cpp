// Tables of many cases as HDF5, for other programs.
#include "record/table_file.hpp"

#include "bind/engine.hpp"
#include "bind/push.hpp"
#include "bind/wrap.hpp"

namespace stiction::bind {

namespace {

std::string field(lua_State* lua, char const* name) {
  lua_getfield(lua, -1, name);
  auto text = text_at(lua, -1);
  lua_pop(lua, 1);
  return text;
}

/// The column on top of the stack: {name =, unit =, meaning =, numbers = list | texts = list}.
record::TableColumn read_column(lua_State* lua) {
  record::TableColumn own{field(lua, "name"), field(lua, "unit"), field(lua, "meaning"), {}, {}};
  if (lua_getfield(lua, -1, "texts") == LUA_TTABLE) {
    own.texts = texts_at(lua, lua_gettop(lua));
    lua_pop(lua, 1);
    return own;
  }
  lua_pop(lua, 1);
  lua_getfield(lua, -1, "numbers");
  luaL_checktype(lua, -1, LUA_TTABLE);
  for (lua_Integer i = 1; i <= static_cast<lua_Integer>(lua_rawlen(lua, -1)); ++i) {
    lua_rawgeti(lua, -1, i);
    own.numbers.push_back(luaL_checknumber(lua, -1));
    lua_pop(lua, 1);
  }
  lua_pop(lua, 1);
  return own;
}

/// write_table(path, name, rows, list of columns). Fails with kind "run".
int write(lua_State* lua) {
  auto const path = text_at(lua, 1), name = text_at(lua, 2);
  auto const rows = static_cast<std::size_t>(luaL_checkinteger(lua, 3));
  luaL_checktype(lua, 4, LUA_TTABLE);
  std::vector<record::TableColumn> columns;
  for (lua_Integer i = 1; i <= static_cast<lua_Integer>(lua_rawlen(lua, 4)); ++i) {
    lua_rawgeti(lua, 4, i);
    columns.push_back(read_column(lua));
    lua_pop(lua, 1);
  }
  record::write_table(path, name, rows, columns);
  return 0;
}

} // namespace

void add_table_functions(lua_State* lua) {
  add<write>(lua, "write_table");
}

} // namespace stiction::bind
