// Taking, telling and giving up locks (flock: the system ends them with their last process).
#include "bind/lock.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <fstream>
#include <new>
#include <sstream>
#include <sys/file.h>
#include <sys/vfs.h>
#include <thread>
#include <unistd.h>

#include "bind/engine.hpp"
#include "bind/push.hpp"
#include "bind/wrap.hpp"

namespace stiction::bind {

namespace {

constexpr char const* lock_metatable = "stiction.lock";
constexpr int first_descriptor = 10; // below: the streams of children

std::vector<int>& held() {
  static std::vector<int> descriptors;
  return descriptors;
}

std::string host() {
  char name[256] = "unknown";
  gethostname(name, sizeof name - 1);
  return name;
}

/// A lock, or nothing once it was given up or where the file system has none.
struct Lock {
  int descriptor = -1;
  void release() {
    if (descriptor < 0)
      return;
    std::erase(held(), descriptor);
    static_cast<void>(ftruncate(descriptor, 0)); // nobody holds it: nothing to tell
    close(descriptor);
    descriptor = -1;
  }
};

/// The holder's own words, as `write_holder` left them: process id, host, time, command.
struct Holder {
  long id = 0;
  std::string host, since, command;
};

Holder read_holder(std::string const& path) {
  Holder holder;
  std::ifstream file(path);
  file >> holder.id >> holder.host;
  std::getline(file >> std::ws, holder.since);
  std::getline(file, holder.command);
  return holder;
}

void write_holder(int descriptor, std::string const& command) {
  auto const now = fmt::localtime(std::chrono::system_clock::to_time_t(std::chrono::system_clock::now()));
  auto const text = fmt::format("{} {}\n{:%Y-%m-%d %H:%M:%S}\n{}\n", getpid(), host(), now, command);
  static_cast<void>(ftruncate(descriptor, 0));
  static_cast<void>(pwrite(descriptor, text.data(), text.size(), 0)); // only for others' messages
}

std::string words_on(Holder const& holder) {
  if (holder.id == 0)
    return "another process";
  bool const here = holder.host == host();
  bool const ended = here && kill(static_cast<pid_t>(holder.id), 0) != 0 && errno == ESRCH;
  return fmt::format("'{}' (process {}{}, since {}{})", holder.command, holder.id,
                     here ? "" : " on " + holder.host, holder.since,
                     ended ? "; it has ended, but cases that it started have not yet" : "");
}

int end_lock(lua_State* lua) {
  static_cast<Lock*>(luaL_checkudata(lua, 1, lock_metatable))->release();
  return 0;
}

void push_lock(lua_State* lua, int descriptor) {
  void* const room = lua_newuserdatauv(lua, sizeof(Lock), 0);
  new (room) Lock{descriptor};
  if (luaL_newmetatable(lua, lock_metatable) != 0)
    add<end_lock>(lua, "__gc");
  lua_setmetatable(lua, -2);
}

/// Opens out of the way of the streams that children get; -1 where that fails.
int open_high(std::string const& path) {
  constexpr int mode = 0666; // less the user's umask
  int const low = open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, mode);
  if (low < 0)
    return -1;
  int const high = fcntl(low, F_DUPFD_CLOEXEC, first_descriptor);
  close(low);
  return high;
}

/// Whether other machines may write to this file's system: NFS, SMB, Lustre, Ceph, GPFS, BeeGFS, AFS, FUSE.
/// Locks there may hold on this machine alone, or hang.
bool is_remote(int descriptor) {
  struct statfs system {};
  constexpr std::array<unsigned long, 9> remote{0x6969,     0xFF534D42, 0xFE534D42, 0x0BD00BD0, 0x00C36400,
                                                0x47504653, 0x19830326, 0x5346414F, 0x65735546};
  return fstatfs(descriptor, &system) == 0 &&
         std::ranges::find(remote, static_cast<unsigned long>(system.f_type) & 0xFFFFFFFFUL) != remote.end();
}

/// Takes the lock: 0, or errno, and who holds it. One that took it this moment has not said yet who it is,
/// one that gives it up says so no more: both get a second.
int wait_for_words(int descriptor, int kind, std::string const& path, Holder& holder) {
  constexpr int most_asked = 50;
  constexpr std::chrono::milliseconds between{20};
  for (int asked = 0; asked < most_asked; ++asked) {
    if (flock(descriptor, kind | LOCK_NB) == 0)
      return 0;
    int const failed = errno;
    if (failed != EWOULDBLOCK && failed != EINTR)
      return failed;
    holder = read_holder(path);
    if (holder.id != 0)
      return failed;
    std::this_thread::sleep_for(between);
  }
  return EWOULDBLOCK;
}

/// lock(path, command, shared) -> lock (and, where the file system has no locks, why), or nil and who holds
/// it; several may hold a shared one
int lock(lua_State* lua) {
  auto const path = text_at(lua, 1);
  int const descriptor = open_high(path);
  if (descriptor < 0)
    throw core::RunError(fmt::format("cannot open {}: {}", path, std::strerror(errno)));
  Holder holder;
  int const kind = lua_toboolean(lua, 3) != 0 ? LOCK_SH : LOCK_EX;
  int const failed = is_remote(descriptor) ? ENOLCK : wait_for_words(descriptor, kind, path, holder);
  if (failed == 0) {
    held().push_back(descriptor);
    write_holder(descriptor, text_at(lua, 2));
    push_lock(lua, descriptor);
    return 1;
  }
  close(descriptor);
  if (failed == EWOULDBLOCK || failed == EINTR) {
    lua_pushnil(lua);
    push(lua, words_on(holder));
    return 2;
  }
  push_lock(lua, -1);
  push(lua, std::strerror(failed));
  return 2;
}

/// unlock(lock)
int unlock(lua_State* lua) {
  return end_lock(lua);
}

} // namespace

std::vector<int> const& held_locks() {
  return held();
}

void add_lock_functions(lua_State* lua) {
  add<lock>(lua, "lock");
  add<unlock>(lua, "unlock");
}

} // namespace stiction::bind
