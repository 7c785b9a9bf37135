// Closed forms of the plane and the circle.
#include "contact/obstacle.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace stiction::contact {

core::Schema const& RigidPlane::schema() {
  using core::Need;
  static auto const made = core::Describe<RigidPlane>{"plane", "rigid half-space", ""}
                               .numbers("point", &RigidPlane::point, "m", Need::optional,
                                        "a point {x, y [, z]} of it; default the origin")
                               .numbers("normal", &RigidPlane::normal, "1", Need::optional,
                                        "outward normal {x, y [, z]}, of any length; default the last axis")
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

/// A shape of the plane with a coordinate along its surface, by which slip is measured.
struct View2 {
  double gap = 0;
  Vec2 normal;
  double coordinate = 0; ///< material arc length in the direction of the tangent, m
  Vec2 coordinate_by_x;
  Mat<2> gap_by_xx = Mat<2>::Zero(), coordinate_by_xx = Mat<2>::Zero();
  double circumference = 0; ///< of closed shapes: slip goes the short way round; 0 if open
};

View2 look(RigidPlane const& plane, Vec2 const& x) {
  Vec2 const n = Vec2(plane.normal[0], plane.normal[1]).normalized(), t = right_of(n);
  Vec2 const d = x - Vec2(plane.point[0], plane.point[1]);
  return {n.dot(d), n, t.dot(d), t};
}

View2 look(RigidCircle const& circle, Vec2 const& x) {
  Vec2 const d = x - Vec2(circle.centre[0], circle.centre[1]);
  double const distance = d.norm(), R = circle.radius;
  Vec2 const n = distance > 0 ? Vec2(d / distance) : Vec2(0, 1), t = right_of(n);
  View2 seen;
  seen.gap = distance - R;
  seen.normal = n;
  seen.coordinate = -R * std::atan2(d.y(), d.x());
  seen.coordinate_by_x = R / distance * t;
  seen.gap_by_xx = t * t.transpose() / distance;
  seen.coordinate_by_xx = -R / (distance * distance) * (n * t.transpose() + t * n.transpose());
  seen.circumference = 2 * std::numbers::pi * R;
  return seen;
}

} // namespace

template<>
ObstacleView<2> view(Obstacle const& obstacle, Vec2 const& point, Foot start, Foot /*guess*/,
                     Vec3 const& /*direction*/) {
  auto const seen = std::visit([&](auto const& shape) { return look(shape, point); }, obstacle);
  ObstacleView<2> result;
  result.found = true;
  result.foot = {0, seen.coordinate};
  result.gap = seen.gap;
  result.frame << seen.normal, right_of(seen.normal);
  if (start.found()) {
    double const slip = seen.coordinate - start.xi;
    result.slip[0] = seen.circumference > 0 ? std::remainder(slip, seen.circumference) : slip;
  }
  result.by_x << seen.normal.transpose(), seen.coordinate_by_x.transpose();
  return result;
}

template<>
Mat<2> curvature_stiffness(Obstacle const& obstacle, ObstacleView<2> const& /*seen*/, Vec2 const& point,
                           Local<2> const& force, Vec3 const& /*direction*/) {
  auto const seen = std::visit([&](auto const& shape) { return look(shape, point); }, obstacle);
  return force[0] * seen.gap_by_xx + force[1] * seen.coordinate_by_xx;
}

} // namespace stiction::contact
