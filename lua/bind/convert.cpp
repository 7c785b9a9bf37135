// A script's tables to core::Input, the only form in which the engine sees them.
#include "bind/convert.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "bind/push.hpp"
#include "bind/wrap.hpp"

namespace stiction::bind {

namespace {

constexpr std::size_t deepest = 100; // tables in tables; a scene needs about ten

class Converter {
public:
  explicit Converter(lua_State* lua) : lua_(lua) {}
  core::Input convert(int index, std::string const& path, std::string const& place);
  core::Complaints complaints;

private:
  void table(core::Input& input, int index, std::string const& path);
  void named(core::Input& input, int index, std::string const& path);
  void list(core::Input& input, int index, std::string const& path);
  void number(core::Input& input, double value, core::Dimension dimension, std::string const& path);
  [[nodiscard]] bool is_quantity(int index) const;
  [[nodiscard]] core::Dimension dimension(int index) const;
  [[nodiscard]] std::string text_field(int index, char const* name) const;
  [[nodiscard]] double number_field(int index, char const* name) const;
  void complain(core::Input const& input, std::string const& path, std::string text) {
    complaints.push_back({input.place, path, std::move(text)});
  }

  lua_State* lua_;
  std::vector<void const*> open_; // tables being converted, outermost first
};

/// What of a table decides between list and named table.
struct Shape {
  lua_Integer integers = 0, largest = 0;
  bool names = false, others = false;
};

Shape shape_of(lua_State* lua, int index) {
  Shape shape;
  for (lua_pushnil(lua); lua_next(lua, index) != 0; lua_pop(lua, 1)) {
    if (lua_type(lua, -2) == LUA_TSTRING) {
      shape.names = true;
    } else if (lua_isinteger(lua, -2) != 0 && lua_tointeger(lua, -2) > 0) {
      ++shape.integers;
      shape.largest = std::max(shape.largest, lua_tointeger(lua, -2));
    } else {
      shape.others = true;
    }
  }
  return shape;
}

core::Input Converter::convert(int index, std::string const& path, std::string const& place) {
  core::Input input;
  input.place = place;
  switch (lua_type(lua_, index)) {
  case LUA_TNIL:
    break;
  case LUA_TBOOLEAN:
    input.value = lua_toboolean(lua_, index) != 0;
    break;
  case LUA_TNUMBER:
    number(input, lua_tonumber(lua_, index), {}, path);
    break;
  case LUA_TSTRING:
    input.value = text_at(lua_, index);
    break;
  case LUA_TTABLE:
    if (is_quantity(index))
      number(input, number_field(index, "si"), dimension(index), path);
    else
      table(input, index, path);
    break;
  default:
    complain(input, path,
             fmt::format("a {} cannot be part of a scene; give a value{}", luaL_typename(lua_, index),
                         lua_isfunction(lua_, index)
                             ? " (a constructor makes one with its table: kind{ ... })"
                             : ""));
  }
  return input;
}

void Converter::number(core::Input& input, double value, core::Dimension dimension, std::string const& path) {
  if (!std::isfinite(value))
    complain(input, path, fmt::format("{} is not a finite number", value));
  input.value = core::Quantity{value, dimension};
}

void Converter::table(core::Input& input, int index, std::string const& path) {
  void const* const identity = lua_topointer(lua_, index);
  if (std::find(open_.begin(), open_.end(), identity) != open_.end())
    return complain(input, path, "this table contains itself");
  if (open_.size() == deepest)
    return complain(input, path, fmt::format("tables are nested more than {} deep here", deepest));
  luaL_checkstack(lua_, 8, "scene");
  open_.push_back(identity);
  input.tag = text_field(index, "tag");
  if (auto place = text_field(index, "place"); !place.empty())
    input.place = place;
  auto const shape = shape_of(lua_, index);
  if (shape.others)
    complain(input, path, "a key of this table is neither a name nor a position 1, 2, ...");
  else if (shape.names && shape.integers > 0)
    complain(input, path, "this table mixes names and list elements; use one or the other");
  else if (shape.integers != shape.largest)
    complain(input, path,
             fmt::format("this list has holes: {} elements, but the last one is number {}", shape.integers,
                         shape.largest));
  else if (shape.integers > 0 || (!shape.names && input.tag.empty()))
    list(input, index, path);
  else
    named(input, index, path);
  open_.pop_back();
}

void Converter::named(core::Input& input, int index, std::string const& path) {
  core::Table table;
  for (lua_pushnil(lua_); lua_next(lua_, index) != 0; lua_pop(lua_, 1)) {
    std::string const key = text_at(lua_, -2);
    table.emplace(
        key, convert(lua_gettop(lua_), path.empty() ? key : fmt::format("{}.{}", path, key), input.place));
  }
  input.value = std::move(table);
}

void Converter::list(core::Input& input, int index, std::string const& path) {
  core::List list;
  auto const count = static_cast<lua_Integer>(lua_rawlen(lua_, index));
  for (lua_Integer i = 1; i <= count; ++i) {
    lua_rawgeti(lua_, index, i);
    list.push_back(convert(lua_gettop(lua_), fmt::format("{}[{}]", path, i), input.place));
    lua_pop(lua_, 1);
  }
  input.value = std::move(list);
}

bool Converter::is_quantity(int index) const {
  if (lua_getmetatable(lua_, index) == 0)
    return false;
  luaL_getmetatable(lua_, quantity_metatable);
  bool const same = lua_rawequal(lua_, -1, -2) != 0;
  lua_pop(lua_, 2);
  return same;
}

core::Dimension Converter::dimension(int index) const {
  auto exponent = [&](char const* name) { return static_cast<int>(number_field(index, name)); };
  return {exponent("metre"), exponent("kilogram"), exponent("second")};
}

double Converter::number_field(int index, char const* name) const {
  lua_pushstring(lua_, name);
  lua_rawget(lua_, index);
  double const value = lua_tonumber(lua_, -1);
  lua_pop(lua_, 1);
  return value;
}

std::string Converter::text_field(int index, char const* name) const {
  if (luaL_getmetafield(lua_, index, name) == LUA_TNIL)
    return "";
  auto text = text_at(lua_, -1);
  lua_pop(lua_, 1);
  return text;
}

} // namespace

core::Input to_input(lua_State* lua, int index) {
  Converter converter(lua);
  auto input = converter.convert(lua_absindex(lua, index), "", "");
  if (!converter.complaints.empty())
    throw core::InputError(converter.complaints);
  return input;
}

} // namespace stiction::bind
