// The table of engine functions that the Lua library builds on.
#include "bind/engine.hpp"

#include "bind/push.hpp"
#include "bind/wrap.hpp"

namespace stiction::bind {

void push_engine(lua_State* lua) {
  lua_newtable(lua);
  set(lua, "version", STICTION_VERSION);
  push_error_metatable(lua);
  lua_setfield(lua, -2, "error_metatable");
  luaL_newmetatable(lua, quantity_metatable);
  lua_setfield(lua, -2, "quantity_metatable");
  for (auto const adder :
       {add_unit_functions, add_json_functions, add_file_functions, add_lock_functions, add_heart_functions,
        add_process_functions, add_terminal_functions, add_rank_functions, add_script_functions,
        add_catalog_functions, add_scene_functions, add_series_functions, add_table_functions,
        add_solve_functions, add_least_squares_functions})
    adder(lua);
}

} // namespace stiction::bind
