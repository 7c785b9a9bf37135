// The error value of the binding.
#include "bind/wrap.hpp"

#include <fmt/format.h>
#include <sys/resource.h>

#include "bind/push.hpp"
#include "core/memory.hpp"

namespace stiction::bind {

namespace {
int error_text(lua_State* lua) {
  lua_getfield(lua, 1, "message");
  return 1;
}
} // namespace

void push_error_metatable(lua_State* lua) {
  if (luaL_newmetatable(lua, error_metatable) != 0)
    add<error_text>(lua, "__tostring");
}

void push_error(lua_State* lua, char const* kind, char const* message) {
  lua_createtable(lua, 0, 3);
  set(lua, "kind", kind);
  set(lua, "message", message);
  push_error_metatable(lua);
  lua_setmetatable(lua, -2);
}

void push_memory_error(lua_State* lua, std::bad_alloc const& error) {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  rlimit limit{};
  getrlimit(RLIMIT_AS, &limit);
  auto const* const asked = dynamic_cast<core::OutOfMemory const*>(&error);
  auto const allowed =
      limit.rlim_cur == RLIM_INFINITY
          ? ""
          : fmt::format(" of the {:.3g} GB that it may take", 1e-9 * static_cast<double>(limit.rlim_cur));
  auto const words = fmt::format("memory ran out{}{}: the process held {:.3g} GB{}; a coarser mesh or fewer "
                                 "cases at a time (--jobs) take "
                                 "less, and 'stiction explain STUDY' says what a case takes",
                                 asked != nullptr ? " " : "", asked != nullptr ? asked->what() : "",
                                 1e-9 * 1024 * static_cast<double>(usage.ru_maxrss), allowed);
  push_error(lua, "run", words.c_str());
}

bool is_error_value(lua_State* lua, int index) {
  if (lua_getmetatable(lua, index) == 0)
    return false;
  push_error_metatable(lua);
  bool const same = lua_rawequal(lua, -1, -2) != 0;
  lua_pop(lua, 2);
  return same;
}

} // namespace stiction::bind
