// Child processes for the Lua library: spawn, wait for news, stop; and the child's own side.
#include "bind/engine.hpp"

#include <cmath>
#include <csignal>
#include <new>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include "bind/case_server.hpp"
#include "bind/interrupt.hpp"
#include "bind/process.hpp"
#include "bind/push.hpp"
#include "bind/ranks.hpp"
#include "bind/wrap.hpp"

namespace stiction::bind {

namespace {

constexpr char const* process_metatable = "stiction.process";

Process& process_at(lua_State* lua, int index) {
  return *static_cast<Process*>(luaL_checkudata(lua, index, process_metatable));
}

int end_process(lua_State* lua) {
  process_at(lua, 1).~Process();
  return 0;
}

/// spawn(words, variables, asked) -> process; it dies with its value. asked: requests can be sent to it
int spawn(lua_State* lua) {
  auto const words = texts_at(lua, 1);
  auto const variables = texts_at(lua, 2);
  void* const room = lua_newuserdatauv(lua, sizeof(Process), 0);
  new (room) Process(words, variables, lua_toboolean(lua, 3) != 0);
  if (luaL_newmetatable(lua, process_metatable) != 0)
    add<end_process>(lua, "__gc");
  lua_setmetatable(lua, -2);
  return 1;
}

/// await(processes, seconds): returns when one of them has news, or when the time is up
int await(lua_State* lua) {
  luaL_checktype(lua, 1, LUA_TTABLE);
  std::vector<pollfd> polls;
  auto const count = luaL_len(lua, 1);
  for (lua_Integer i = 1; i <= count; ++i) {
    lua_geti(lua, 1, i);
    for (int const descriptor : process_at(lua, -1).descriptors())
      polls.push_back({descriptor, POLLIN, 0});
    lua_pop(lua, 1);
  }
  poll(polls.data(), polls.size(), static_cast<int>(std::ceil(1000 * luaL_checknumber(lua, 2))));
  return 0;
}

/// collect(process) -> messages (list of lines), what it printed, exit code or nil; once it has ended also
/// its processor time, s, and its peak memory, bytes, of those that it started too
int collect(lua_State* lua) {
  auto& process = process_at(lua, 1);
  process.collect();
  push(lua, process.take_lines());
  push(lua, process.take_text());
  if (!process.code()) {
    lua_pushnil(lua);
    return 3;
  }
  push(lua, *process.code());
  push(lua, process.cpu_seconds());
  push(lua, process.peak_memory());
  return 5;
}

/// request(process, words): a case for one that serves cases
int request(lua_State* lua) {
  process_at(lua, 1).send(case_request(texts_at(lua, 2)));
  return 0;
}

/// terminate(process), kill(process)
int terminate(lua_State* lua) {
  process_at(lua, 1).signal(SIGTERM);
  return 0;
}

int kill_process(lua_State* lua) {
  process_at(lua, 1).signal(SIGKILL);
  return 0;
}

/// Whether somebody listens to this process; without, 3 is the number of the next file it opens.
bool& heard() {
  static bool listening = false;
  return listening;
}

/// Whether the process at the other end of the pipe 3 is gone.
bool is_orphan() {
  pollfd end{3, 0, 0};
  return poll(&end, 1, 0) == 1 && (end.revents & POLLERR) != 0;
}

/// follow_parent() -> whether one listens: this process ends with the one that started it, and what that one
/// left open is not handed on; call before any file is opened
int follow(lua_State* lua) {
  if (ranks() != nullptr) { // who started them hears the first one, by another way
    follow_parent(true);
    push(lua, true);
    return 1;
  }
  struct stat status {};
  heard() = fstat(3, &status) == 0 && !S_ISREG(status.st_mode);
  follow_parent();
  close_range(3, ~0U, CLOSE_RANGE_CLOEXEC);
  if (heard() && is_orphan()) // it ended before it could be followed
    std::raise(SIGTERM);
  push(lua, heard());
  return 1;
}

/// tell_parent(line) -> true if the process that started this one took the message
int tell_parent(lua_State* lua) {
  if (ranks() != nullptr) {
    tell_of_ranks(text_at(lua, 1));
    push(lua, true);
    return 1;
  }
  if (!heard())
    return 0; // the case is run by hand
  auto const line = text_at(lua, 1) + "\n";
  for (std::size_t sent = 0; sent < line.size();) {
    auto const count = ::write(3, line.data() + sent, line.size() - sent);
    if (count > 0)
      sent += static_cast<std::size_t>(count);
    else if (errno != EINTR)
      return 0; // nobody listens any more
  }
  push(lua, true);
  return 1;
}

} // namespace

void add_process_functions(lua_State* lua) {
  add<spawn>(lua, "spawn");
  add<await>(lua, "await");
  add<collect>(lua, "collect");
  add<request>(lua, "request");
  add<terminate>(lua, "terminate");
  add<kill_process>(lua, "kill");
  add<follow>(lua, "follow_parent");
  add<tell_parent>(lua, "tell_parent");
}

} // namespace stiction::bind
