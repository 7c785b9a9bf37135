// Units and the search for misspelt words, for scripts.
#include "bind/engine.hpp"

#include "bind/push.hpp"
#include "bind/wrap.hpp"
#include "core/schema.hpp"
#include "core/unit.hpp"

namespace stiction::bind {

namespace {

/// parse_unit(text) -> factor to SI, exponents of metre, kilogram and second; or nil.
int parse_unit(lua_State* lua) {
  auto const unit = core::parse_unit(text_at(lua, 1));
  if (!unit)
    return 0;
  push(lua, unit->value);
  push(lua, unit->dimension.metre);
  push(lua, unit->dimension.kilogram);
  push(lua, unit->dimension.second);
  return 4;
}

/// dimension_text(metre, kilogram, second) -> "kg m^-1 s^-2"
int dimension_text(lua_State* lua) {
  auto exponent = [lua](int index) { return static_cast<int>(luaL_checkinteger(lua, index)); };
  push(lua, core::to_string(core::Dimension{exponent(1), exponent(2), exponent(3)}));
  return 1;
}

/// unit_words() -> list of every unit word
int unit_words(lua_State* lua) {
  push(lua, core::unit_words());
  return 1;
}

/// nearest(word, known) -> the word of the list that was perhaps meant, or nil
int nearest(lua_State* lua) {
  auto const word = core::nearest(text_at(lua, 1), texts_at(lua, 2));
  if (word.empty())
    return 0;
  push(lua, word);
  return 1;
}

} // namespace

void add_unit_functions(lua_State* lua) {
  add<parse_unit>(lua, "parse_unit");
  add<dimension_text>(lua, "dimension_text");
  add<unit_words>(lua, "unit_words");
  add<nearest>(lua, "nearest");
}

} // namespace stiction::bind
