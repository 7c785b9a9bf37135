// JSON text from Lua values and back; keys are sorted, numbers keep every digit.
#include "bind/engine.hpp"

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "bind/push.hpp"
#include "bind/wrap.hpp"

namespace stiction::bind {

namespace {

using Json = nlohmann::json;
constexpr int most_nested = 100;

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
  if (depth > most_nested)
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

/// Makes Lua values of what a parser reads, without a tree in between. The table that is open stands on top
/// of the stack, with the name that waits for its value above it.
class Builder {
public:
  explicit Builder(lua_State* lua) : lua_(lua) {}

  bool null() {
    return put([&] { lua_pushnil(lua_); });
  }
  bool boolean(bool value) {
    return put([&] { bind::push(lua_, value); });
  }
  bool number_integer(std::int64_t value) {
    return put([&] { bind::push(lua_, static_cast<long>(value)); });
  }
  bool number_unsigned(std::uint64_t value) {
    constexpr auto most = static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
    return value > most ? number_float(static_cast<double>(value), "")
                        : number_integer(static_cast<std::int64_t>(value));
  }
  bool number_float(double value, std::string const& /*text*/) {
    return put([&] { bind::push(lua_, value); });
  }
  bool string(std::string const& value) {
    return put([&] { bind::push(lua_, value); });
  }
  bool binary(Json::binary_t const& /*value*/) { return false; }
  bool start_object(std::size_t /*count*/) { return open(in_object); }
  bool key(std::string const& name) {
    bind::push(lua_, name);
    return true;
  }
  bool end_object() { return close(); }
  bool start_array(std::size_t /*count*/) { return open(0); }
  bool end_array() { return close(); }
  static bool parse_error(std::size_t /*place*/, std::string const& /*word*/,
                          Json::exception const& /*why*/) {
    return false;
  }

private:
  static constexpr lua_Integer in_object = -1;

  bool open(lua_Integer kind) {
    if (open_.size() > most_nested)
      return false;
    luaL_checkstack(lua_, 4, "JSON");
    lua_newtable(lua_);
    open_.push_back(kind);
    return true;
  }
  bool close() {
    open_.pop_back();
    return store();
  }
  template<class Push> bool put(Push const& push) {
    push();
    return store();
  }
  /// The value on top goes into the table that it stands in.
  bool store() {
    if (open_.empty())
      return true;
    if (open_.back() == in_object)
      lua_rawset(lua_, -3);
    else
      lua_rawseti(lua_, -2, ++open_.back());
    return true;
  }

  lua_State* lua_;
  std::vector<lua_Integer> open_; ///< a table each: how many a list has so far, or that it is an object
};

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
  auto const text = text_at(lua, 1);
  int const before = lua_gettop(lua);
  Builder builder(lua);
  if (Json::sax_parse(text, &builder))
    return 1;
  lua_settop(lua, before);
  return 0;
}

} // namespace

void add_json_functions(lua_State* lua) {
  add<encode>(lua, "encode_json");
  add<decode>(lua, "decode_json");
}

} // namespace stiction::bind
