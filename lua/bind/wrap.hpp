// The one wrapper every C++ function of the binding goes through: exceptions become Lua errors.
#pragma once
#include <lua.hpp>
#include <new>

#include "core/error.hpp"

namespace stiction::bind {

/// Names under which our metatables stand in the registry.
inline constexpr char const* error_metatable = "stiction.error";
inline constexpr char const* quantity_metatable = "stiction.quantity";

/// Pushes {kind =, message =}, the error value of everything that is not a plain script error.
/// Kinds: "input" (exit 2), "run" (exit 1), "bug" (exit 1), "stopped" (exit 1), "script" (exit 2).
void push_error(lua_State* lua, char const* kind, char const* message);

/// The same of kind "run" for memory that ran out; `error`: what it was asked for, if it knows.
void push_memory_error(lua_State* lua, std::bad_alloc const& error = {});

/// True if the value at index was made by push_error or carries its metatable.
bool is_error_value(lua_State* lua, int index);
void push_error_metatable(lua_State* lua);

using Function = int (*)(lua_State*);

/// Calls `Target`; a std::exception becomes a Lua error raised outside the catch block. Lua's own errors
/// are C++ throws of another type and pass through, running destructors on their way.
template<Function Target> int guarded(lua_State* lua) {
  try {
    return Target(lua);
  } catch (core::InputError const& error) {
    push_error(lua, "input", error.what());
  } catch (core::Bug const& error) {
    push_error(lua, "bug", error.what());
  } catch (std::bad_alloc const& error) {
    push_memory_error(lua, error);
  } catch (std::exception const& error) {
    push_error(lua, "run", error.what());
  }
  return lua_error(lua);
}

/// Sets field `name` of the table on top of the stack to the guarded function.
template<Function Target> void add(lua_State* lua, char const* name) {
  lua_pushcfunction(lua, guarded<Target>);
  lua_setfield(lua, -2, name);
}

} // namespace stiction::bind
