// A saved contact problem solved again, for `stiction solve`.
#include "scene/solve.hpp"
#include "bind/engine.hpp"
#include "bind/push.hpp"
#include "bind/wrap.hpp"

namespace stiction::bind {

namespace {

/// solve(path, solver, tolerance) -> report, whether the tolerance was reached
int solve(lua_State* lua) {
  auto const report = scene::solve_file(text_at(lua, 1), text_at(lua, 2), luaL_checknumber(lua, 3));
  push(lua, report.text);
  push(lua, report.converged);
  return 2;
}

} // namespace

void add_solve_functions(lua_State* lua) {
  add<solve>(lua, "solve");
}

} // namespace stiction::bind
