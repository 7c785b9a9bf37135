// A prescribed value over time: straight lines between knots.
#pragma once
#include <vector>

namespace stiction::dynamics {

/// Knots (time, value), times ascending; a single knot is a constant.
struct Path {
  std::vector<double> times{0};
  std::vector<double> values{0};
  [[nodiscard]] double value(double t) const;
  /// Rate just before t, so that a step ending on a knot sees its own line; 0 outside the knots.
  [[nodiscard]] double rate_before(double t) const;
  [[nodiscard]] bool constant() const { return times.size() == 1; }
  [[nodiscard]] double farthest() const; ///< largest |value|
  [[nodiscard]] double fastest() const;  ///< largest |rate|
};

} // namespace stiction::dynamics
