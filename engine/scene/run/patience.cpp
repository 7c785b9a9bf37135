// Compares what was lost with the limits.
#include "scene/run/patience.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <utility>

namespace stiction::scene {

namespace {
constexpr double factorizations = 1000; ///< whose work may be lost where it is more than the limit
constexpr double hopeless = 100;        ///< times the limit, in one attempt
constexpr double tries = 6;             ///< steps cut in half may cost far less: so many are tried at least
} // namespace

Patience::Patience(SchedulePart const& limits, Work work) : limits_(&limits), work_(std::move(work)) {}

void Patience::begin_attempt() {
  before_ = work_.so_far();
}

/// Operations that may be lost on one step.
double Patience::most() const {
  return std::max(1e9 * limits_->work, factorizations * work_.once());
}

bool Patience::spent() const {
  double const limit = std::max(hopeless * 1e9 * limits_->work, most());
  return work_.so_far() - before_ > limit;
}

std::string Patience::lost() {
  double const attempt = work_.so_far() - before_;
  lost_ += spent() ? attempt : std::min(attempt, most() / tries);
  if (++cuts_ > limits_->cuts)
    return fmt::format("{} attempts from t = {:g} s on failed, more than schedule.cuts", cuts_, since_);
  if (lost_ > most())
    return fmt::format(
        "{} failed attempts from t = {:g} s on took more than schedule.work = {:g} allows; shorter steps may "
        "need none, a larger work more of them",
        cuts_, since_, limits_->work);
  return "";
}

void Patience::reached(double t) {
  if (t - since_ < nominal_ * (1 - 1e-9))
    return;
  since_ = t;
  cuts_ = 0;
  lost_ = 0;
}

std::string Patience::late(double seconds) const {
  if (limits_->seconds == 0 || seconds <= limits_->seconds)
    return "";
  return fmt::format("longer than schedule.seconds = {:g} s", limits_->seconds);
}

} // namespace stiction::scene
