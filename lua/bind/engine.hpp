// The table of engine functions that the Lua library builds on, one adder per concept.
#pragma once
#include <lua.hpp>

namespace stiction::bind {

/// Pushes the table; scripts of users never see it.
void push_engine(lua_State* lua);

// Each adds its functions to the table on top of the stack; what they do stands in their .cpp.
void add_unit_functions(lua_State* lua);
void add_json_functions(lua_State* lua);
void add_file_functions(lua_State* lua);
void add_lock_functions(lua_State* lua);
void add_heart_functions(lua_State* lua);
void add_process_functions(lua_State* lua);
void add_terminal_functions(lua_State* lua);
void add_script_functions(lua_State* lua);
void add_catalog_functions(lua_State* lua);
void add_scene_functions(lua_State* lua);
void add_series_functions(lua_State* lua);
void add_table_functions(lua_State* lua);
void add_solve_functions(lua_State* lua);
void add_rank_functions(lua_State* lua);
void add_least_squares_functions(lua_State* lua);

} // namespace stiction::bind
