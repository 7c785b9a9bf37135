// The verbs of a scene for scripts: validate and run.
#include "bind/engine.hpp"

#include "bind/convert.hpp"
#include "bind/interrupt.hpp"
#include "bind/push.hpp"
#include "bind/wrap.hpp"
#include "scene/run.hpp"

namespace stiction::bind {

namespace {

/// validate(scene): an error of kind "input" with every complaint
int validate(lua_State* lua) {
  scene::validate(to_input(lua, 1));
  return 0;
}

void push(lua_State* lua, scene::Progress const& progress) {
  lua_newtable(lua);
  set(lua, "time", progress.time);
  set(lua, "end_time", progress.end_time);
  set(lua, "dt", progress.dt);
  set(lua, "step", progress.step);
  set(lua, "iterations", progress.iterations);
  set(lua, "open", progress.open);
  set(lua, "stick", progress.stick);
  set(lua, "slip", progress.slip);
  set(lua, "seconds", progress.seconds);
  set(lua, "seconds_left", progress.seconds_left);
}

void push(lua_State* lua, scene::RunResult const& result) {
  lua_newtable(lua);
  set(lua, "verdict", result.verdict);
  set(lua, "reason", result.reason);
  set(lua, "steps", result.steps);
  set(lua, "iterations", result.iterations);
  set(lua, "factorizations", result.factorizations);
  set(lua, "cuts", result.cuts);
  set(lua, "seconds", result.seconds);
  set(lua, "phases", result.phases);
  set(lua, "counters", result.counters);
}

std::string option(lua_State* lua, char const* name) {
  lua_getfield(lua, 2, name);
  auto text = text_at(lua, -1);
  lua_pop(lua, 1);
  return text;
}

/// run(scene, {out =, case_id =, manifest =}, progress) -> result; progress(snapshot) is called once a step
int run(lua_State* lua) {
  luaL_checktype(lua, 2, LUA_TTABLE);
  luaL_checktype(lua, 3, LUA_TFUNCTION);
  auto const input = to_input(lua, 1);
  scene::RunOptions options;
  options.out = option(lua, "out");
  options.case_id = option(lua, "case_id");
  options.manifest_json = option(lua, "manifest");
  options.stop = &stop_flag();
  options.progress = [lua](scene::Progress const& progress) {
    lua_pushvalue(lua, 3);
    push(lua, progress);
    lua_call(lua, 1, 0);
  };
  auto const result = scene::run(input, options);
  push(lua, result);
  return 1;
}

} // namespace

void add_scene_functions(lua_State* lua) {
  add<validate>(lua, "validate");
  add<run>(lua, "run");
}

} // namespace stiction::bind
