// A saved contact problem solved again, for `stiction solve` and for studies of such problems.
#include "scene/run/solve.hpp"
#include "bind/engine.hpp"
#include "bind/interrupt.hpp"
#include "bind/push.hpp"
#include "bind/wrap.hpp"

namespace stiction::bind {

namespace {

using bind::push;

void set_vector(lua_State* lua, char const* name, Vector const& values) {
  set(lua, name, std::vector<double>(values.begin(), values.end()));
}

void push(lua_State* lua, scene::SolverAnswer const& answer) {
  lua_newtable(lua);
  set(lua, "converged", answer.converged);
  set(lua, "method", answer.method);
  set(lua, "iterations", answer.iterations);
  set(lua, "work", answer.work);
  set(lua, "residual", answer.residual);
  set(lua, "relative", answer.relative);
  if (answer.cone_error)
    set(lua, "cone_error", *answer.cone_error);
  set(lua, "seconds", answer.seconds);
  set_vector(lua, "force", answer.force);
  set_vector(lua, "displacement", answer.displacement);
}

/// solve(path, solver, tolerance) -> {text =, converged =, contacts =, components =, doubts = {texts}, free =
/// {}, answers = {solver = {converged =, method =, iterations =, work =, residual =, relative =, cone_error =
/// (of plain ones), seconds =, force =, ...}}}
int solve(lua_State* lua) {
  EndsAtOnce const now; // nothing is written
  auto const report = scene::solve_file(text_at(lua, 1), text_at(lua, 2), luaL_checknumber(lua, 3));
  lua_newtable(lua);
  set(lua, "text", report.text);
  set(lua, "converged", report.converged);
  set(lua, "contacts", static_cast<long>(report.contacts));
  set(lua, "components", report.components);
  set(lua, "doubts", report.doubts);
  set_vector(lua, "free", report.free);
  lua_newtable(lua);
  for (auto const& answer : report.answers) {
    push(lua, answer);
    lua_setfield(lua, -2, answer.solver.c_str());
  }
  lua_setfield(lua, -2, "answers");
  return 1;
}

} // namespace

void add_solve_functions(lua_State* lua) {
  add<solve>(lua, "solve");
}

} // namespace stiction::bind
