// Limits, and the judgement of errors.
#include "fuzz/lua_state.hpp"

#include <cstdlib>
#include <fmt/format.h>

#include "bind/convert.hpp"
#include "bind/push.hpp"
#include "bind/state.hpp"
#include "bind/trace.hpp"
#include "bind/wrap.hpp"
#include "fuzz/small_scene.hpp"

namespace stiction::fuzz {

namespace {

constexpr int hook_every = 1000;
constexpr long most_hooks = 2000;
constexpr std::size_t most_memory = std::size_t{64} << 20U; // bytes
constexpr char const* spent = "the time of this script is spent";

struct Budget {
  long hooks = 0;
  std::size_t memory = 0;
};
Budget budget;

void on_count(lua_State* lua, lua_Debug* /*event*/) {
  if (++budget.hooks > most_hooks) {
    lua_sethook(lua, on_count, LUA_MASKCOUNT, 1);
    luaL_error(lua, "%s", spent);
  }
}

void* allocate(void* /*data*/, void* block, std::size_t old_size, std::size_t size) {
  std::size_t const old = block == nullptr ? 0 : old_size;
  if (size == 0) {
    budget.memory -= old;
    std::free(block); // NOLINT: Lua's own blocks
    return nullptr;
  }
  if (size > old && budget.memory + size - old > most_memory)
    return nullptr;
  void* const moved = std::realloc(block, size); // NOLINT
  if (moved != nullptr)
    budget.memory += size - old;
  return moved;
}

/// validate(scene) where that is a matter of milliseconds
int validate_small(lua_State* lua) {
  check_small_scene(bind::to_input(lua, 1));
  return 0;
}

std::string field(lua_State* lua, char const* name) {
  lua_getfield(lua, -1, name);
  std::string const text = lua_isstring(lua, -1) != 0 ? bind::text_at(lua, -1) : "";
  lua_pop(lua, 1);
  return text;
}

void judge(lua_State* lua) {
  if (!bind::is_error_value(lua, -1))
    return; // out of memory, within the handler perhaps
  auto const kind = field(lua, "kind"), message = field(lua, "message");
  bool const ours = kind == "script" && message.starts_with(bind::library_root());
  bool const limit = message.find(spent) != std::string::npos || message.find("memory") != std::string::npos;
  if ((kind == "bug" || kind == "run" || ours) && !limit)
    throw core::Bug(fmt::format("{}: {}{}", kind, message, field(lua, "trace")));
}

} // namespace

void run_lua(char const* chunk, std::string_view word) {
  auto const state = bind::make_state(false);
  lua_State* const lua = state.get();
  budget = {0, static_cast<std::size_t>(lua_gc(lua, LUA_GCCOUNT)) * 1024 +
                   static_cast<std::size_t>(lua_gc(lua, LUA_GCCOUNTB))};
  lua_setallocf(lua, allocate, nullptr);
  lua_sethook(lua, on_count, LUA_MASKCOUNT, hook_every);
  lua_pushcfunction(lua, bind::on_error);
  core::expect(luaL_loadbufferx(lua, chunk, std::string_view(chunk).size(), "=driver", "t") == LUA_OK,
               "the driver is Lua");
  bind::push(lua, word);
  lua_pushcfunction(lua, bind::guarded<validate_small>);
  if (lua_pcall(lua, 2, 0, 1) != LUA_OK)
    judge(lua);
}

} // namespace stiction::fuzz
