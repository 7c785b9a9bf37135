// Where in the user's own files a call or an error came from.
#include "bind/trace.hpp"

#include <fmt/format.h>
#include <vector>

#include "bind/push.hpp"
#include "bind/state.hpp"
#include "bind/wrap.hpp"
#include "core/unit.hpp"

namespace stiction::bind {

namespace {

constexpr int deepest = 200;            ///< level looked at: each costs a walk down to it
constexpr std::size_t told_frames = 20; ///< of a function that calls itself for ever

lua_Debug last_line; ///< the user's line that ran last; currentline 0 before any

bool is_user_frame(lua_Debug const& frame) {
  std::string_view const source = frame.source;
  return source.starts_with('@') && !source.substr(1).starts_with(library_root());
}

std::string place_of(lua_Debug const& frame) {
  return fmt::format("{}:{}", frame.short_src, frame.currentline);
}

std::string name_of(lua_Debug const& frame) {
  if (*frame.what == 'm')
    return "in the script's main part";
  if (frame.name != nullptr)
    return fmt::format("in function '{}'", frame.name);
  return fmt::format("in the function that starts at line {}", frame.linedefined);
}

struct UserFrame {
  std::string place, name;
};

/// The user's frames, innermost first. Where a function ended in a tail call to our library, the line it
/// ended in stands for it.
std::vector<UserFrame> user_frames(lua_State* lua) {
  std::vector<UserFrame> frames;
  lua_Debug frame;
  for (int level = 0; lua_getstack(lua, level, &frame) != 0; ++level) {
    if (level == deepest || frames.size() == told_frames) {
      frames.push_back({"...", ""});
      break;
    }
    lua_getinfo(lua, "Slnt", &frame);
    if (is_user_frame(frame)) {
      UserFrame found{place_of(frame), ": " + name_of(frame)};
      if (!frames.empty() && frames.back().name.empty() && frames.back().place == found.place)
        frames.pop_back();
      frames.push_back(std::move(found));
    } else if (frames.empty() && frame.istailcall != 0 && last_line.currentline > 0) {
      frames.push_back({place_of(last_line), ""});
    }
  }
  return frames;
}

/// One line a frame; nothing if `message` starts with the place of the only one.
std::string trace_of(lua_State* lua, std::string const& message) {
  auto const frames = user_frames(lua);
  if (frames.size() == 1 && message.starts_with(frames[0].place))
    return "";
  std::string trace;
  for (auto const& [place, name] : frames)
    trace += fmt::format("\n  {}{}", place, name);
  return trace;
}

/// What to write where a word of the table of units was taken for a variable.
std::string unit_hint(std::string const& message) {
  constexpr std::string_view key = "(global '";
  auto const start = message.find(key);
  if (start == std::string::npos)
    return "";
  auto const word =
      message.substr(start + key.size(), message.find('\'', start + key.size()) - start - key.size());
  if (!core::parse_unit(word))
    return "";
  return fmt::format("; as a unit it wants a line before: local {0} = stiction.units.{0}", word);
}

/// The message of the error at 1; of a value without words, what it is and what to give instead.
std::string words_of(lua_State* lua) {
  bool const has_words = lua_type(lua, 1) == LUA_TSTRING || lua_isnumber(lua, 1) != 0 ||
                         luaL_getmetafield(lua, 1, "__tostring") != LUA_TNIL;
  if (!has_words)
    return fmt::format("{}: error(...) with a {} instead of words; error(\"what is wrong\") says it",
                       user_place(lua), luaL_typename(lua, 1));
  return luaL_tolstring(lua, 1, nullptr);
}

} // namespace

void note_line(lua_State* lua, lua_Debug* event) {
  lua_getinfo(lua, "S", event);
  if (is_user_frame(*event))
    last_line = *event;
}

void note_return(lua_State* lua, lua_Debug* event) {
  lua_getinfo(lua, "St", event);
  lua_Debug caller;
  if (!(is_user_frame(*event) || event->istailcall != 0) || lua_getstack(lua, 1, &caller) == 0)
    return;
  lua_getinfo(lua, "Sl", &caller);
  if (is_user_frame(caller))
    last_line = caller;
}

std::string user_place(lua_State* lua) {
  lua_Debug frame;
  for (int level = 0; lua_getstack(lua, level, &frame) != 0; ++level) {
    lua_getinfo(lua, "Slt", &frame);
    if (is_user_frame(frame))
      return place_of(frame);
    if (frame.istailcall != 0 && last_line.currentline > 0)
      return place_of(last_line);
  }
  return "";
}

bool in_user_code(lua_State* lua) {
  lua_Debug frame;
  for (int level = 0; lua_getstack(lua, level, &frame) != 0; ++level) {
    lua_getinfo(lua, "S", &frame);
    if (is_user_frame(frame))
      return true;
  }
  return false;
}

int on_error(lua_State* lua) {
  if (is_error_value(lua, 1)) {
    lua_settop(lua, 1);
    return 1;
  }
  std::string message = words_of(lua);
  message += unit_hint(message);
  std::string trace = trace_of(lua, message);
  if (trace.empty() &&
      user_place(lua).empty()) { // nothing of the user's is running: our own library is at fault
    luaL_traceback(lua, lua, nullptr, 1);
    trace = fmt::format("\n{}", text_at(lua, -1));
  }
  push_error(lua, "script", message.c_str());
  set(lua, "trace", trace);
  return 1;
}

} // namespace stiction::bind
