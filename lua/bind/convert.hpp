// A script's tables to core::Input, the only form in which the engine sees them.
#pragma once
#include <lua.hpp>

#include "core/input.hpp"

namespace stiction::bind {

/// The value at `index`. A table made by a constructor has a metatable with fields tag and place; a quantity
/// has the quantity metatable. Throws InputError with every function, nan, cycle, mixed table or list with
/// holes found, each with its place and path.
core::Input to_input(lua_State* lua, int index);

} // namespace stiction::bind
