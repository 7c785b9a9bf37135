// Adds the time of a block to a phase.
#pragma once
#include <chrono>

namespace stiction::dynamics {

class Timer {
public:
  explicit Timer(double& seconds) : seconds_(&seconds) {}
  ~Timer() { *seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }
  Timer(Timer const&) = delete;
  Timer& operator=(Timer const&) = delete;

private:
  double* seconds_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

} // namespace stiction::dynamics
