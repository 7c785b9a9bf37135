// The sandboxed Lua state in which our library and the user's script run.
#include "bind/state.hpp"

#include <filesystem>
#include <new>

#include "bind/engine.hpp"
#include "bind/interrupt.hpp"
#include "bind/push.hpp"
#include "bind/wrap.hpp"

namespace stiction::bind {

namespace {

std::string find_library() {
  std::error_code failed;
  auto const program = std::filesystem::read_symlink("/proc/self/exe", failed);
  auto const installed = program.parent_path().parent_path() / "share/stiction/lua";
  return std::filesystem::exists(installed / "stiction/init.lua", failed) ? installed.string()
                                                                          : STICTION_LUA_SOURCE;
}

void open(lua_State* lua, char const* name, lua_CFunction function) {
  luaL_requiref(lua, name, function, 1);
  lua_pop(lua, 1);
}

void close_doors(lua_State* lua) {
  for (auto const* name : {"dofile", "load", "loadfile", "loadstring", "collectgarbage"}) {
    lua_pushnil(lua);
    lua_setglobal(lua, name);
  }
  lua_getglobal(lua, "package");
  set(lua, "path", library_root() + "/?.lua;" + library_root() + "/?/init.lua");
  set(lua, "cpath", "");
  lua_pushnil(lua);
  lua_setfield(lua, -2, "loadlib");
  lua_getfield(lua, -1, "searchers"); // the third and fourth load C libraries
  for (int i : {4, 3}) {
    lua_pushnil(lua);
    lua_rawseti(lua, -2, i);
  }
  lua_pop(lua, 2);
  lua_pushliteral(lua, ""); // strings: their metatable cannot be reached from a script
  lua_getmetatable(lua, -1);
  set(lua, "__metatable", false);
  lua_pop(lua, 2);
}

constexpr char const* randomseed = "stiction.randomseed";

void fix_randomness(lua_State* lua) {
  lua_getglobal(lua, "math");
  lua_getfield(lua, -1, "randomseed");
  lua_pushvalue(lua, -1);
  lua_setfield(lua, LUA_REGISTRYINDEX, randomseed);
  lua_pushinteger(lua, 1);
  lua_call(lua, 1, 0);
  lua_pushnil(lua); // a script that reseeds from the clock would not repeat
  lua_setfield(lua, -2, "randomseed");
  lua_pop(lua, 1);
}

/// reseed(): math.random begins anew
int reseed(lua_State* lua) {
  lua_getfield(lua, LUA_REGISTRYINDEX, randomseed);
  lua_pushinteger(lua, 1);
  lua_call(lua, 1, 0);
  return 0;
}

int open_engine(lua_State* lua) {
  push_engine(lua);
  add<reseed>(lua, "reseed");
  return 1;
}

void preload_engine(lua_State* lua) {
  lua_getglobal(lua, "package");
  lua_getfield(lua, -1, "preload");
  add<open_engine>(lua, "stiction.engine");
  lua_pop(lua, 2);
}

} // namespace

std::string const& library_root() {
  static std::string const root = find_library();
  return root;
}

State make_state(bool trust) {
  State state(luaL_newstate());
  lua_State* lua = state.get();
  if (lua == nullptr)
    throw std::bad_alloc();
  open(lua, LUA_GNAME, luaopen_base);
  open(lua, LUA_LOADLIBNAME, luaopen_package);
  open(lua, LUA_TABLIBNAME, luaopen_table);
  open(lua, LUA_STRLIBNAME, luaopen_string);
  open(lua, LUA_MATHLIBNAME, luaopen_math);
  open(lua, LUA_UTF8LIBNAME, luaopen_utf8);
  open(lua, LUA_COLIBNAME, luaopen_coroutine);
  if (trust) {
    open(lua, LUA_IOLIBNAME, luaopen_io);
    open(lua, LUA_OSLIBNAME, luaopen_os);
  }
  close_doors(lua);
  fix_randomness(lua);
  lua_gc(lua, LUA_GCINC, 400, 0, 0); // scripts are short: the library alone fills more than one round
  preload_engine(lua);
  watch_script(lua);
  return state;
}

} // namespace stiction::bind
