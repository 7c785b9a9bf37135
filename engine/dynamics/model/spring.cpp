// Energy, force and tangent of one spring.
#include "dynamics/model/spring.hpp"

#include <Eigen/Geometry>

namespace stiction::dynamics {

namespace {

/// The line from end to end; that of the start where both meet.
Eigen::Vector3d line_of(Spring const& spring, Eigen::Vector3d const& apart) {
  double const length = apart.norm();
  return length > 0 ? Eigen::Vector3d(apart / length) : spring.direction;
}

/// E = k/2 (l - l0)^2: the force turns with the line, which is the second part of the tangent.
SpringPull pull_along_line(Spring const& spring, Eigen::Vector3d const& apart) {
  SpringPull pull;
  double const length = apart.norm(), k = spring.stiffness;
  Eigen::Vector3d const n = line_of(spring, apart);
  pull.elongation = length - spring.start().norm() + spring.stretch;
  pull.energy = 0.5 * k * pull.elongation * pull.elongation;
  pull.force = k * pull.elongation * n;
  pull.tangent = k * n * n.transpose();
  if (length > 0)
    pull.tangent += (k * pull.elongation / length) * (Eigen::Matrix3d::Identity() - n * n.transpose());
  return pull;
}

} // namespace

SpringPull pull_of(Spring const& spring, Eigen::Vector3d const& apart) {
  if (spring.along == SpringAlong::line)
    return pull_along_line(spring, apart);
  SpringPull pull;
  Eigen::Vector3d const moved = apart - spring.start();
  if (spring.along == SpringAlong::axes) {
    pull.tangent = (spring.stiffness * spring.axes).asDiagonal();
    pull.force = pull.tangent * moved;
    pull.elongation = moved.norm();
    pull.energy = 0.5 * pull.force.dot(moved);
    return pull;
  }
  auto const& d = spring.direction;
  pull.elongation = d.dot(moved) + spring.stretch;
  pull.energy = 0.5 * spring.stiffness * pull.elongation * pull.elongation;
  pull.force = spring.stiffness * pull.elongation * d;
  pull.tangent = spring.stiffness * d * d.transpose();
  return pull;
}

Eigen::Matrix3d drag_of(Spring const& spring, Eigen::Vector3d const& apart) {
  if (spring.along == SpringAlong::axes)
    return (spring.damping * spring.axes).asDiagonal();
  Eigen::Vector3d const n = spring.along == SpringAlong::line ? line_of(spring, apart) : spring.direction;
  return spring.damping * n * n.transpose();
}

} // namespace stiction::dynamics
