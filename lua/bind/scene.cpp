// The verbs of a scene for scripts: validate, explain and run.
#include "bind/engine.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "bind/convert.hpp"
#include "bind/interrupt.hpp"
#include "bind/push.hpp"
#include "bind/ranks.hpp"
#include "bind/wrap.hpp"
#include "record/manifest.hpp"
#include "scene/explain/preview.hpp"
#include "scene/probes/half_space_probes.hpp"
#include "scene/run/beside.hpp"
#include "scene/run/run.hpp"

namespace stiction::bind {

namespace {

using bind::push;

void push(lua_State* lua, scene::Line const& line) {
  lua_newtable(lua);
  set(lua, "name", line.name);
  set(lua, "words", line.words);
  set(lua, "meaning", line.meaning);
  if (!std::isfinite(line.value))
    return;
  set(lua, "value", line.value);
  set(lua, "unit", line.unit);
}

/// Sets field `name` of the table on top of the stack to a list.
template<class T> void set_list(lua_State* lua, char const* name, std::vector<T> const& values);

void push(lua_State* lua, scene::Section const& section) {
  lua_newtable(lua);
  set(lua, "title", section.title);
  set_list(lua, "lines", section.lines);
}

void push(lua_State* lua, scene::Warning const& warning) {
  lua_newtable(lua);
  set(lua, "text", warning.text);
  set(lua, "change", warning.change);
}

void push(lua_State* lua, scene::BesideResult const& beside) {
  lua_newtable(lua);
  set(lua, "name", beside.name);
  set(lua, "steps", beside.steps);
  set(lua, "turned", beside.turned);
  set(lua, "rough", beside.rough);
  set(lua, "iterations", beside.iterations);
  set(lua, "ended", beside.ended);
}

template<class T> void set_list(lua_State* lua, char const* name, std::vector<T> const& values) {
  lua_newtable(lua);
  for (std::size_t i = 0; i < values.size(); ++i) {
    push(lua, values[i]);
    lua_rawseti(lua, -2, static_cast<lua_Integer>(i + 1));
  }
  lua_setfield(lua, -2, name);
}

/// preview(scene) -> {columns = {"group/name" = width}, end_time =, warnings = {{text =, change =}},
/// unfit_for_ranks = why several ranks cannot share it, or nil}, or an error of kind "input" with every
/// complaint
int preview(lua_State* lua) {
  auto const input = to_input(lua, 1);
  EndsAtOnce const now;
  auto const preview = scene::preview(input);
  std::map<std::string, int> columns;
  for (auto const& [name, width] : preview.columns)
    columns[name] = width;
  lua_newtable(lua);
  set(lua, "columns", columns);
  set(lua, "end_time", preview.end);
  set_list(lua, "warnings", preview.warnings);
  if (!preview.unfit_for_ranks.empty())
    set(lua, "unfit_for_ranks", preview.unfit_for_ranks);
  return 1;
}

/// validate(scene): an error of kind "input" with every complaint
int validate(lua_State* lua) {
  auto const input = to_input(lua, 1);
  EndsAtOnce const now;
  scene::validate(input);
  return 0;
}

/// Scenes to run beside another one: the list on top of the stack, {{name =, scene =}}, or nil; taken off it.
std::vector<scene::Shifted> beside(lua_State* lua) {
  std::vector<scene::Shifted> all;
  bool const listed = lua_istable(lua, -1);
  for (lua_Integer i = 1; listed && lua_geti(lua, -1, i) != LUA_TNIL; ++i) {
    lua_getfield(lua, -1, "name");
    lua_getfield(lua, -2, "scene");
    all.push_back({text_at(lua, -2), to_input(lua, -1)});
    lua_pop(lua, 3);
  }
  lua_pop(lua, listed ? 2 : 1);
  return all;
}

/// check_beside(scene, {{name =, scene =}}): an error of kind "input" where they cannot run beside it
int check_beside(lua_State* lua) {
  auto const input = to_input(lua, 1);
  lua_settop(lua, 2);
  auto const asked = beside(lua);
  EndsAtOnce const now;
  scene::check_beside(input, asked);
  return 0;
}

/// explain(scene) -> {sections = {{title =, lines =}}, warnings = {{text =, change =}}}
int explain(lua_State* lua) {
  auto const input = to_input(lua, 1);
  EndsAtOnce const now;
  auto const explanation = scene::explain(input);
  lua_newtable(lua);
  set_list(lua, "sections", explanation.sections);
  set_list(lua, "warnings", explanation.warnings);
  return 1;
}

/// What made each table as a value in it, under a name that no parameter has.
void name_makers(core::Input& input) {
  if (auto* const list = std::get_if<core::List>(&input.value))
    for (auto& part : *list)
      name_makers(part);
  auto* const table = std::get_if<core::Table>(&input.value);
  if (table == nullptr)
    return;
  for (auto& [name, part] : *table)
    name_makers(part);
  if (!input.tag.empty())
    (*table)["(made by)"].value = std::exchange(input.tag, {});
}

/// scene_text(scene) -> all that it says, in SI, as JSON: the same for the same scene, wherever it was
/// written
int scene_text(lua_State* lua) {
  auto input = to_input(lua, 1);
  name_makers(input);
  bind::push(lua, record::to_json(input).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
  return 1;
}

/// probe_columns(scene) -> list of {probe =, name =, unit =, meaning =} of all that its probes record
int probe_columns(lua_State* lua) {
  auto const built = scene::build(to_input(lua, 1));
  lua_newtable(lua);
  lua_Integer count = 0;
  scene::Columns const columns{
      [&](auto const& probe, auto const& name, auto const& unit, auto const& meaning, int) {
        lua_newtable(lua);
        set(lua, "probe", probe);
        set(lua, "name", name);
        set(lua, "unit", unit);
        set(lua, "meaning", meaning);
        lua_rawseti(lua, -2, ++count);
      },
      [](auto const&, auto const&, double) {}};
  scene::add_columns(built, columns);
  return 1;
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
  set(lua, "goes_on", result.goes_on);
  set(lua, "continued", result.continued);
  set_list(lua, "warnings", result.warnings);
  set(lua, "remarks", result.remarks);
  set(lua, "steps", result.steps);
  set(lua, "iterations", result.iterations);
  set(lua, "factorizations", result.factorizations);
  set(lua, "cuts", result.cuts);
  set(lua, "contact", result.contact);
  set(lua, "seconds", result.seconds);
  set(lua, "phases", result.phases);
  set(lua, "counters", result.counters);
  if (!result.beside.empty())
    set_list(lua, "beside", result.beside);
}

std::string option(lua_State* lua, char const* name) {
  lua_getfield(lua, 2, name);
  auto text = text_at(lua, -1);
  lua_pop(lua, 1);
  return text;
}

double number(lua_State* lua, char const* name) {
  lua_getfield(lua, 2, name);
  double const value = lua_tonumber(lua, -1);
  lua_pop(lua, 1);
  return value;
}

bool is_set(lua_State* lua, char const* name) {
  lua_getfield(lua, 2, name);
  bool const value = lua_toboolean(lua, -1) != 0;
  lua_pop(lua, 1);
  return value;
}

/// Of the case's own options, where `checkpoint` names a file.
scene::Keeping keeping(lua_State* lua) {
  scene::Keeping keeping;
  if (!is_set(lua, "checkpoint"))
    return keeping;
  keeping.file = option(lua, "checkpoint");
  keeping.owner = {option(lua, "program"), option(lua, "fingerprint")};
  keeping.every = number(lua, "every");
  keeping.anew = is_set(lua, "anew");
  keeping.tell = [lua](std::string const& words) {
    lua_pushvalue(lua, 4);
    bind::push(lua, words);
    lua_call(lua, 1, 0);
  };
  return keeping;
}

/// run(scene, {out =, case_id =, manifest =, threads =, rehearse =, alone =, stop_after =, beside = {{name =,
/// scene =}} for derivatives, checkpoint = file to keep where the case stands, every = (s), program =,
/// fingerprint = whose that is, anew = take none up}, progress, tell) -> result; progress(snapshot) is called
/// once a step, tell(text) with a line on the checkpoint
int run(lua_State* lua) {
  luaL_checktype(lua, 2, LUA_TTABLE);
  luaL_checktype(lua, 3, LUA_TFUNCTION);
  auto const input = to_input(lua, 1);
  scene::RunOptions options;
  options.out = option(lua, "out");
  options.case_id = option(lua, "case_id");
  options.manifest_json = option(lua, "manifest");
  options.threads = std::max(1, static_cast<int>(number(lua, "threads")));
  options.rehearse = static_cast<int>(number(lua, "rehearse"));
  options.stop_after = static_cast<long>(number(lua, "stop_after"));
  options.alone = is_set(lua, "alone");
  options.keeping = keeping(lua);
  lua_getfield(lua, 2, "beside");
  options.beside = beside(lua);
  options.stop = &stop_flag();
  options.ranks = ranks();
  std::optional<EndsAtOnce> now(std::in_place); // until the first step is done
  options.progress = [lua, &now](scene::Progress const& progress) {
    now.reset();
    lua_pushvalue(lua, 3);
    push(lua, progress);
    lua_call(lua, 1, 0);
  };
  auto const result = scene::run(input, options);
  now.reset();
  push(lua, result);
  return 1;
}

} // namespace

void add_scene_functions(lua_State* lua) {
  add<preview>(lua, "preview");
  add<validate>(lua, "validate");
  add<check_beside>(lua, "check_beside");
  add<explain>(lua, "explain");
  add<scene_text>(lua, "scene_text");
  add<probe_columns>(lua, "probe_columns");
  add<run>(lua, "run");
}

} // namespace stiction::bind
