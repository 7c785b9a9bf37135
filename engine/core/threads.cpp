// Threads that wait for a loop, first by looking, then asleep.
#include "core/threads.hpp"

#include <atomic>
#include <csignal>
#include <exception>
#include <memory>
#include <mutex>
#include <thread>

#include "core/error.hpp"

namespace stiction::core {

namespace {

constexpr int looks = 4000;    // before a thread that has nothing to do goes to sleep, some 50 us
constexpr int patience = 1000; // looks of who waits for others, before it lets others have the processor

void pause() {
#if defined(__x86_64__)
  __builtin_ia32_pause();
#endif
}

/// Of a thread: is it within a loop that is shared?
thread_local bool sharing = false;

struct Loop {
  Index count;
  void (*call)(void const* act, Index i);
  void const* act;
  std::atomic<Index> next{0};
  std::mutex guard{};
  Index failed = -1; ///< the first that threw what is in `error`
  std::exception_ptr error{};

  void fail(Index i) {
    std::lock_guard const lock(guard);
    if (failed >= 0 && failed < i)
      return;
    failed = i;
    error = std::current_exception();
  }
  /// Calls what nobody has called yet, as long as nothing was thrown.
  void work() {
    sharing = true;
    for (Index i = next++; i < count; i = next++)
      try {
        call(act, i);
      } catch (...) {
        fail(i);
        next = count;
      }
    sharing = false;
  }
};

class Pool {
public:
  explicit Pool(int others) {
    sigset_t all, before;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before); // signals are the first thread's
    for (int k = 0; k < others; ++k)
      threads_.emplace_back([this] { serve(); });
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
  }
  Pool(Pool const&) = delete;
  Pool& operator=(Pool const&) = delete;
  ~Pool() {
    ends_ = true;
    wake();
    for (auto& thread : threads_)
      thread.join();
  }
  [[nodiscard]] int count() const { return 1 + static_cast<int>(threads_.size()); }

  void share(Loop& loop) {
    loop_ = &loop;
    wake();
    loop.work();
    loop_ = nullptr;
    for (int k = 0; inside_ != 0; ++k)
      k < patience ? pause() : std::this_thread::yield();
    if (loop.error)
      std::rethrow_exception(loop.error);
  }

private:
  void wake() {
    ++turn_;
    turn_.notify_all();
  }
  /// Who is inside has seen the loop before it was taken away, or none.
  void serve() {
    for (unsigned seen = 0; !ends_;) {
      for (int k = 0; turn_ == seen && k < looks; ++k)
        pause();
      turn_.wait(seen);
      seen = turn_;
      ++inside_;
      if (auto* const loop = loop_.load())
        loop->work();
      --inside_;
    }
  }

  std::atomic<unsigned> turn_{0}; ///< goes up with every loop
  std::atomic<Loop*> loop_{nullptr};
  std::atomic<int> inside_{0};
  std::atomic<bool> ends_{false};
  std::vector<std::thread> threads_;
};

std::unique_ptr<Pool> pool;

} // namespace

void use_threads(int count) {
  expect(count >= 1 && !sharing, "at least one thread, chosen outside of loops");
  if (count == threads())
    return;
  pool.reset();
  if (count > 1)
    pool = std::make_unique<Pool>(count - 1);
}

int threads() {
  return pool && !sharing ? pool->count() : 1;
}

void detail::share(Index count, void (*call)(void const* act, Index i), void const* act) {
  Loop loop{count, call, act};
  pool->share(loop);
}

} // namespace stiction::core
