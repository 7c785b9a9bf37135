// Interpolation of a path.
#include "dynamics/path.hpp"

#include <algorithm>

namespace stiction::dynamics {

namespace {
/// Index of the line that holds (t - 0), so that a knot belongs to the line before it.
std::size_t line_before(std::vector<double> const& times, double t) {
  auto const after = std::lower_bound(times.begin() + 1, times.end() - 1, t);
  return static_cast<std::size_t>(after - times.begin()) - 1;
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
  if (constant() || t > times.back())
    return 0;
  std::size_t const k = line_before(times, t);
  return (values[k + 1] - values[k]) / (times[k + 1] - times[k]);
}

} // namespace stiction::dynamics
