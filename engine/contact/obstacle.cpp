// Closed forms of the plane and the circle.
#include "contact/obstacle.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace stiction::contact {

core::Schema const& RigidPlane::schema() {
  using core::Need;
  static auto const made =
      core::Describe<RigidPlane>{"plane", "rigid half-plane", ""}
          .numbers("point", &RigidPlane::point, "m", Need::optional, "a point {x, y} of the line")
          .numbers("normal", &RigidPlane::normal, "1", Need::optional, "outward normal {x, y}, of any length")
          .build();
  return made;
}

core::Schema const& RigidCircle::schema() {
  using core::Need;
  static auto const made =
      core::Describe<RigidCircle>{"circle", "rigid disc (sphere when axisymmetric)", ""}
          .numbers("centre", &RigidCircle::centre, "m", Need::optional, "its centre {x, y}")
          .number("radius", &RigidCircle::radius, "m", core::positive, Need::required, "its radius")
          .build();
  return made;
}

namespace {

Vec2 right_of(Vec2 const& n) {
  return {n.y(), -n.x()};
}

ObstacleView look(RigidPlane const& plane, Vec2 const& x) {
  Vec2 const n = Vec2(plane.normal[0], plane.normal[1]).normalized(), t = right_of(n);
  Vec2 const d = x - Vec2(plane.point[0], plane.point[1]);
  return {n.dot(d), n, t, t.dot(d), t, Eigen::Matrix2d::Zero(), Eigen::Matrix2d::Zero()};
}

ObstacleView look(RigidCircle const& circle, Vec2 const& x) {
  Vec2 const d = x - Vec2(circle.centre[0], circle.centre[1]);
  double const distance = d.norm(), R = circle.radius;
  Vec2 const n = distance > 0 ? Vec2(d / distance) : Vec2(0, 1), t = right_of(n);
  ObstacleView seen;
  seen.gap = distance - R;
  seen.normal = n;
  seen.tangent = t;
  seen.coordinate = -R * std::atan2(d.y(), d.x());
  seen.coordinate_by_x = R / distance * t;
  seen.gap_by_xx = t * t.transpose() / distance;
  seen.coordinate_by_xx = -R / (distance * distance) * (n * t.transpose() + t * n.transpose());
  return seen;
}

} // namespace

ObstacleView view(Obstacle const& obstacle, Vec2 const& point, Vec2 const& offset) {
  return std::visit([&](auto const& shape) { return look(shape, point - offset); }, obstacle);
}

double coordinate_difference(Obstacle const& obstacle, double to, double from) {
  double const difference = to - from;
  auto const* circle = std::get_if<RigidCircle>(&obstacle);
  return circle == nullptr ? difference : std::remainder(difference, 2 * std::numbers::pi * circle->radius);
}

} // namespace stiction::contact
