// Where in the user's own files a call or an error came from.
#include "bind/trace.hpp"

#include <fmt/format.h>
#include <optional>

#include "bind/push.hpp"
#include "bind/state.hpp"
#include "bind/wrap.hpp"

namespace stiction::bind {

namespace {

bool is_user_frame(lua_Debug const& frame) {
  std::string_view const source = frame.source;
  return source.starts_with('@') && !source.substr(1).starts_with(library_root());
}

/// "  study.lua:12: in function 'load'"
std::string line_of(lua_Debug const& frame) {
  std::string what = "in the script's main part";
  if (frame.name != nullptr)
    what = fmt::format("in {} '{}'", *frame.namewhat == '\0' ? "function" : frame.namewhat, frame.name);
  else if (*frame.what != 'm')
    what = fmt::format("in the function that starts at line {}", frame.linedefined);
  return fmt::format("\n  {}:{}: {}", frame.short_src, frame.currentline, what);
}

std::string user_frames(lua_State* lua) {
  std::string text;
  lua_Debug frame;
  for (int level = 0; lua_getstack(lua, level, &frame) != 0; ++level) {
    lua_getinfo(lua, "Slnt", &frame);
    if (is_user_frame(frame))
      text += line_of(frame) + (frame.istailcall != 0 ? " (called by a tail call)" : "");
  }
  return text;
}

} // namespace

std::string user_place(lua_State* lua) {
  lua_Debug frame;
  for (int level = 0; lua_getstack(lua, level, &frame) != 0; ++level) {
    lua_getinfo(lua, "Sl", &frame);
    if (is_user_frame(frame))
      return fmt::format("{}:{}", frame.short_src, frame.currentline);
  }
  return "";
}

int on_error(lua_State* lua) {
  if (is_error_value(lua, 1)) {
    lua_settop(lua, 1);
    return 1;
  }
  std::string const message = luaL_tolstring(lua, 1, nullptr);
  std::string trace = user_frames(lua);
  if (trace.empty()) { // nothing of the user's is running: our own library is at fault
    luaL_traceback(lua, lua, nullptr, 1);
    trace = fmt::format("\n{}", text_at(lua, -1));
  }
  push_error(lua, "script", message.c_str());
  set(lua, "trace", trace);
  return 1;
}

} // namespace stiction::bind
