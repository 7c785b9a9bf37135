// Interpolation of a path.
#include "dynamics/scheme/path.hpp"

#include <algorithm>
#include <cmath>

namespace stiction::dynamics {

namespace {
/// Part of the line before a knot by which sums of steps may overshoot it in rounding.
constexpr double overshoot = 1e-9;

/// Index of the line that holds (t - 0), so that a knot belongs to the line before it.
std::size_t line_before(std::vector<double> const& times, double t) {
  std::size_t k = 1;
  while (k + 1 < times.size() && t > times[k] + overshoot * (times[k] - times[k - 1]))
    ++k;
  return k - 1;
}
} // namespace

double Path::value(double t) const {
  if (constant() || t <= times.front())
    return values.front();
  if (t >= times.back())
    return values.back();
  std::size_t const k = line_before(times, t);
  return values[k] + (t - times[k]) * (values[k + 1] - values[k]) / (times[k + 1] - times[k]);
}

double Path::rate_before(double t) const {
  if (constant() || t > times.back() + overshoot * (times.back() - times[times.size() - 2]))
    return 0;
  std::size_t const k = line_before(times, t);
  return (values[k + 1] - values[k]) / (times[k + 1] - times[k]);
}

double Path::farthest() const {
  double most = 0;
  for (double const value : values)
    most = std::max(most, std::abs(value));
  return most;
}

double Path::fastest() const {
  double most = 0;
  for (std::size_t k = 1; k < times.size(); ++k)
    most = std::max(most, std::abs(values[k] - values[k - 1]) / (times[k] - times[k - 1]));
  return most;
}

} // namespace stiction::dynamics
