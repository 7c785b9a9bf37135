// Everything a script can make, as Lua tables: the constructors and `stiction help` are made from them.
#include "bind/engine.hpp"

#include "bind/push.hpp"
#include "bind/wrap.hpp"
#include "scene/description/catalog.hpp"

namespace stiction::bind {

namespace {

using bind::push;

char const* kind_word(core::Parameter::Kind kind) {
  using enum core::Parameter::Kind;
  switch (kind) {
  case flag:
    return "flag";
  case number:
    return "number";
  case integer:
    return "integer";
  case choice:
    return "choice";
  case text:
    return "text";
  case file:
    return "file";
  case numbers:
    return "numbers";
  case nested:
    return "nested";
  }
  throw core::Bug("a parameter of unknown kind");
}

void push(lua_State* lua, core::Schema const& schema, std::size_t index) {
  auto const& parameter = schema.parameters[index];
  bool const required = parameter.need == core::Need::required;
  lua_newtable(lua);
  set(lua, "name", parameter.name);
  set(lua, "kind", kind_word(parameter.kind));
  set(lua, "unit", parameter.unit);
  set(lua, "range", parameter.range.words(parameter.unit));
  set(lua, "required", required);
  set(lua, "meaning", parameter.meaning);
  set(lua, "choices", parameter.choices);
  if (!required && schema.fallback && parameter.kind != core::Parameter::Kind::nested)
    set(lua, "default", core::to_string(schema.fallback(index)));
}

void push(lua_State* lua, core::Schema const& schema) {
  lua_newtable(lua);
  set(lua, "name", schema.name);
  set(lua, "meaning", schema.meaning);
  set(lua, "source", schema.source);
  lua_newtable(lua);
  for (std::size_t i = 0; i < schema.parameters.size(); ++i) {
    push(lua, schema, i);
    lua_rawseti(lua, -2, static_cast<lua_Integer>(i + 1));
  }
  lua_setfield(lua, -2, "parameters");
}

void push(lua_State* lua, scene::Category const& category) {
  lua_newtable(lua);
  set(lua, "name", category.name);
  set(lua, "meaning", category.meaning);
  lua_newtable(lua);
  for (std::size_t i = 0; i < category.kinds.size(); ++i) {
    push(lua, category.kinds[i]);
    lua_rawseti(lua, -2, static_cast<lua_Integer>(i + 1));
  }
  lua_setfield(lua, -2, "kinds");
}

/// catalog() -> list of categories {name, meaning, kinds}
int catalog(lua_State* lua) {
  auto const& categories = scene::catalog();
  lua_newtable(lua);
  for (std::size_t i = 0; i < categories.size(); ++i) {
    push(lua, categories[i]);
    lua_rawseti(lua, -2, static_cast<lua_Integer>(i + 1));
  }
  return 1;
}

} // namespace

void add_catalog_functions(lua_State* lua) {
  add<catalog>(lua, "catalog");
}

} // namespace stiction::bind
