// A sign of life: a file that a thread rewrites every few seconds as long as this process lives.
#include "bind/engine.hpp"

#include <cerrno>
#include <condition_variable>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <mutex>
#include <new>
#include <thread>
#include <unistd.h>
#include <utility>

#include "bind/push.hpp"
#include "bind/wrap.hpp"

namespace stiction::bind {

namespace {

constexpr char const* heart_metatable = "stiction.heart";

/// The file: a name, how often it was written, and what it tells. It is rewritten in place, so that a full
/// disk stops it last, and is never made anew: who took it away has taken this process for dead.
class Heart {
public:
  Heart(std::string path, std::string name, double between)
      : path_(std::move(path)), name_(std::move(name)), between_(between) {
    if (int const failed = write(O_CREAT | O_TRUNC); failed != 0)
      throw core::RunError(fmt::format("cannot write {}: {}; make room, or choose another folder with --out",
                                       path_, std::strerror(failed)));
    sigset_t all, before;
    sigfillset(&all); // signals are the main thread's
    pthread_sigmask(SIG_SETMASK, &all, &before);
    thread_ = std::thread([this] { beat(); });
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
  }
  Heart(Heart const&) = delete;
  Heart& operator=(Heart const&) = delete;
  ~Heart() { stop(); }
  void stop() {
    if (!thread_.joinable())
      return;
    {
      std::lock_guard const guard(mutex_);
      over_ = true;
    }
    news_.notify_all();
    thread_.join();
  }
  void tell(std::string told) {
    std::lock_guard const guard(mutex_);
    told_ = std::move(told);
  }

private:
  void beat() {
    std::unique_lock guard(mutex_);
    while (!news_.wait_for(guard, std::chrono::duration<double>(between_), [this] { return over_; }))
      static_cast<void>(write(0)); // the next one may succeed
  }
  /// Writes the whole file; 0, or errno.
  int write(int flags) {
    auto text = fmt::format("{}\n{:012d}\n{}", name_, ++beats_, told_);
    constexpr std::size_t block = 512;
    size_ = std::max(size_, (text.size() / block + 1) * block);
    text.resize(size_, ' ');
    constexpr int mode = 0666; // less the user's umask
    int const file = open(path_.c_str(), O_WRONLY | O_CLOEXEC | flags, mode);
    if (file < 0)
      return errno;
    errno = EIO;
    bool const whole = pwrite(file, text.data(), text.size(), 0) == static_cast<ssize_t>(text.size());
    int const failed = whole ? 0 : errno;
    return close(file) != 0 && whole ? errno : failed;
  }

  std::string path_, name_, told_;
  double between_;
  std::mutex mutex_;
  std::condition_variable news_;
  bool over_ = false;
  long beats_ = 0;
  std::size_t size_ = 0;
  std::thread thread_;
};

Heart& heart_at(lua_State* lua) {
  return *static_cast<Heart*>(luaL_checkudata(lua, 1, heart_metatable));
}

int end_heart(lua_State* lua) {
  heart_at(lua).~Heart();
  return 0;
}

/// heart(path, name, seconds) -> one that rewrites the file that often: its name, a count, what it tells
int heart(lua_State* lua) {
  auto const path = text_at(lua, 1), name = text_at(lua, 2);
  auto const between = luaL_checknumber(lua, 3);
  void* const room = lua_newuserdatauv(lua, sizeof(Heart), 0);
  new (room) Heart(path, name, between);
  if (luaL_newmetatable(lua, heart_metatable) != 0)
    add<end_heart>(lua, "__gc");
  lua_setmetatable(lua, -2);
  return 1;
}

/// tell_heart(heart, text): from its next beat on
int tell_heart(lua_State* lua) {
  heart_at(lua).tell(text_at(lua, 2));
  return 0;
}

/// stop_heart(heart): it beats no more
int stop_heart(lua_State* lua) {
  heart_at(lua).stop();
  return 0;
}

} // namespace

void add_heart_functions(lua_State* lua) {
  add<heart>(lua, "heart");
  add<tell_heart>(lua, "tell_heart");
  add<stop_heart>(lua, "stop_heart");
}

} // namespace stiction::bind
