// JSON text from Lua values and back; keys are sorted, numbers keep every digit.
#include "bind/engine.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "bind/push.hpp"
#include "bind/wrap.hpp"

namespace stiction::bind {

namespace {

using Json = nlohmann::json;
constexpr int deepest = 100;

Json to_json(lua_State* lua, int index, int depth);

Json list_to_json(lua_State* lua, int index, int depth) {
  Json list = Json::array();
  auto const count = static_cast<lua_Integer>(lua_rawlen(lua, index));
  for (lua_Integer i = 1; i <= count; ++i) {
    lua_rawgeti(lua, index, i);
    list.push_back(to_json(lua, lua_gettop(lua), depth + 1));
    lua_pop(lua, 1);
  }
  return list;
}

Json object_to_json(lua_State* lua, int index, int depth) {
  Json object = Json::object();
  for (lua_pushnil(lua); lua_next(lua, index) != 0; lua_pop(lua, 1)) {
    if (lua_type(lua, -2) != LUA_TSTRING)
      throw core::RunError("JSON: a table must be a list or have names only");
    object[lua_tostring(lua, -2)] = to_json(lua, lua_gettop(lua), depth + 1);
  }
  return object;
}

/// A table with a first element, or an empty one, is a list unless its metatable says `json = "object"`.
Json table_to_json(lua_State* lua, int index, int depth) {
  if (depth > deepest)
    throw core::RunError("JSON: tables nested too deeply, perhaps in a cycle");
  luaL_checkstack(lua, 4, "JSON");
  bool object = luaL_getmetafield(lua, index, "json") != LUA_TNIL;
  if (object)
    lua_pop(lua, 1);
  lua_pushnil(lua);
  bool const empty = lua_next(lua, index) == 0;
  if (!empty)
    lua_pop(lua, 2);
  object = object || (!empty && lua_rawlen(lua, index) == 0);
  return object ? object_to_json(lua, index, depth) : list_to_json(lua, index, depth);
}

Json number_to_json(lua_State* lua, int index) {
  if (lua_isinteger(lua, index) != 0)
    return lua_tointeger(lua, index);
  double const value = lua_tonumber(lua, index);
  return std::isfinite(value) ? Json(value) : Json(); // JSON has neither nan nor inf
}

Json to_json(lua_State* lua, int index, int depth) {
  switch (lua_type(lua, index)) {
  case LUA_TNIL:
    return {};
  case LUA_TBOOLEAN:
    return lua_toboolean(lua, index) != 0;
  case LUA_TNUMBER:
    return number_to_json(lua, index);
  case LUA_TSTRING:
    return text_at(lua, index);
  case LUA_TTABLE:
    return table_to_json(lua, index, depth);
  default:
    throw core::RunError(std::string("JSON: cannot write a ") + luaL_typename(lua, index));
  }
}

/// Whole, but more than an integer of Lua's holds.
bool beyond_integers(Json const& json) {
  return json.is_number_unsigned() && json.get<std::uint64_t>() > std::numeric_limits<std::int64_t>::max();
}

bool nests_deeper(Json const& json, int depth) {
  return depth < 0 || (json.is_structured() && std::any_of(json.begin(), json.end(), [&](Json const& part) {
                         return nests_deeper(part, depth - 1);
                       }));
}

void push(lua_State* lua, Json const& json) {
  luaL_checkstack(lua, 4, "JSON");
  if (json.is_object()) {
    lua_newtable(lua);
    for (auto const& [name, value] : json.items()) {
      push(lua, value);
      lua_setfield(lua, -2, name.c_str());
    }
  } else if (json.is_array()) {
    lua_newtable(lua);
    for (std::size_t i = 0; i < json.size(); ++i) {
      push(lua, json[i]);
      lua_rawseti(lua, -2, static_cast<lua_Integer>(i + 1));
    }
  } else if (json.is_string()) {
    bind::push(lua, json.get_ref<std::string const&>());
  } else if (json.is_boolean()) {
    bind::push(lua, json.get<bool>());
  } else if (json.is_number_integer() && !beyond_integers(json)) {
    bind::push(lua, json.get<long>());
  } else if (json.is_number()) {
    bind::push(lua, json.get<double>());
  } else {
    lua_pushnil(lua);
  }
}

/// encode(value, indent) -> text; without indent on one line
int encode(lua_State* lua) {
  auto const indent = static_cast<int>(luaL_optinteger(lua, 2, -1));
  auto const json = to_json(lua, 1, 0);
  bind::push(lua, json.dump(indent, ' ', false, Json::error_handler_t::replace));
  return 1;
}

/// decode(text) -> value; nil if the text is not JSON, as a file cut short is not, or nests too deeply to be
/// ours
int decode(lua_State* lua) {
  auto const json = Json::parse(text_at(lua, 1), nullptr, false);
  if (json.is_discarded() || nests_deeper(json, deepest))
    return 0;
  push(lua, json);
  return 1;
}

} // namespace

void add_json_functions(lua_State* lua) {
  add<encode>(lua, "encode_json");
  add<decode>(lua, "decode_json");
}

} // namespace stiction::bind
