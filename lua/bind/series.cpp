// Histories of finished or running cases, column by column.
#include "bind/engine.hpp"

#include <cstring>
#include <fmt/format.h>
#include <new>

#include "bind/push.hpp"
#include "bind/wrap.hpp"
#include "record/series.hpp"

namespace stiction::bind {

namespace {

using record::SeriesData;
constexpr char const* series_metatable = "stiction.series";

SeriesData& series_at(lua_State* lua) {
  return *static_cast<SeriesData*>(luaL_checkudata(lua, 1, series_metatable));
}

int end_series(lua_State* lua) {
  series_at(lua).~SeriesData();
  return 0;
}

/// read_series(path) -> series
int read(lua_State* lua) {
  auto data = record::read_series(text_at(lua, 1));
  void* const room = lua_newuserdatauv(lua, sizeof(SeriesData), 0);
  new (room) SeriesData(std::move(data));
  if (luaL_newmetatable(lua, series_metatable) != 0)
    add<end_series>(lua, "__gc");
  lua_setmetatable(lua, -2);
  return 1;
}

/// series_time(series) -> list of times, s
int time(lua_State* lua) {
  push(lua, series_at(lua).time);
  return 1;
}

/// series_columns(series) -> sorted list of "group/name"
int columns(lua_State* lua) {
  std::vector<std::string> names;
  for (auto const& [name, column] : series_at(lua).columns)
    names.push_back(name);
  push(lua, names);
  return 1;
}

/// series_column(series, "group/name", component) -> list of values, unit; nil if there is no such column
int column(lua_State* lua) {
  auto const& all = series_at(lua).columns;
  auto const found = all.find(text_at(lua, 2));
  if (found == all.end())
    return 0;
  auto const& [unit, meaning, width, values] = found->second;
  auto const component = static_cast<std::size_t>(luaL_optinteger(lua, 3, 1));
  if (component < 1 || component > width)
    throw core::InputError(fmt::format("{} has components 1 to {}, not {}", found->first, width, component));
  std::vector<double> list;
  for (std::size_t i = component - 1; i < values.size(); i += width)
    list.push_back(values[i]);
  push(lua, list);
  push(lua, unit);
  return 2;
}

bool same(std::vector<double> const& a, std::vector<double> const& b) {
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), sizeof(double) * a.size()) == 0);
}

/// same_series(path, path) -> whether they say the same to the last bit, wherever their files have it
int same_series(lua_State* lua) {
  auto const a = record::read_series(text_at(lua, 1)), b = record::read_series(text_at(lua, 2));
  bool equal = same(a.time, b.time) && a.columns.size() == b.columns.size();
  for (auto const& [name, column] : a.columns) {
    auto const other = b.columns.find(name);
    equal = equal && other != b.columns.end() && column.unit == other->second.unit &&
            column.width == other->second.width && same(column.values, other->second.values);
  }
  push(lua, equal);
  return 1;
}

} // namespace

void add_series_functions(lua_State* lua) {
  add<read>(lua, "read_series");
  add<time>(lua, "series_time");
  add<columns>(lua, "series_columns");
  add<column>(lua, "series_column");
  add<same_series>(lua, "same_series");
}

} // namespace stiction::bind
