// Displacements about an axis.
#include "dynamics/model/motion.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stiction::dynamics {

double Turn::value(double t) const {
  double const a = angle->value(t), half = std::sin(0.5 * a);
  return -2 * across * half * half + along * std::sin(a);
}

double Turn::rate_before(double t) const {
  double const a = angle->value(t);
  return angle->rate_before(t) * (along * std::cos(a) - across * std::sin(a));
}

double Turn::farthest() const {
  return 2 * std::hypot(across, along) * std::sin(0.5 * std::min(angle->farthest(), std::numbers::pi));
}

double Turn::fastest() const {
  return angle->fastest() * std::hypot(across, along);
}

} // namespace stiction::dynamics
