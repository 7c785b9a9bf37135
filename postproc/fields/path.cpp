// Linear interpolation between the times of a path.
#include "fields/path.hpp"

#include <algorithm>

#include "core/error.hpp"

namespace stiction::postproc {

Pose pose_at(PathSpec const& path, std::optional<double> time) {
  auto const& times = path.times;
  Pose pose;
  if (times.empty())
    return pose;
  if (!time)
    throw core::RunError("a path needs the time of the field, and the file tells none; give a .pvd");
  auto const after = std::upper_bound(times.begin(), times.end(), *time) - times.begin();
  auto const right = static_cast<std::size_t>(std::min<std::ptrdiff_t>(after, std::ssize(times) - 1));
  std::size_t const left = after == 0 ? 0 : static_cast<std::size_t>(after - 1);
  double const weight =
      right == left || after == 0 ? 0 : (*time - times[left]) / (times[right] - times[left]);
  auto const value = [&](std::vector<double> const& values) {
    return values.empty() ? 0 : (1 - weight) * values[left] + weight * values[right];
  };
  for (std::size_t i = 0; i < 3; ++i)
    pose.move[i] = value(path.moves[i]);
  pose.angle = value(path.angle);
  return pose;
}

} // namespace stiction::postproc
