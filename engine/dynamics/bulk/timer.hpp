// Adds the processor time of a block to a phase.
#pragma once
#include <ctime>

namespace stiction::dynamics {

class Timer {
public:
  explicit Timer(double& seconds) : seconds_(&seconds) {}
  ~Timer() { *seconds_ += now() - start_; }
  Timer(Timer const&) = delete;
  Timer& operator=(Timer const&) = delete;

private:
  /// Of all threads so far, s.
  [[nodiscard]] static double now() {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  }

  double* seconds_;
  double start_ = now();
};

} // namespace stiction::dynamics
