// Obstacles in the plane: lines and discs in closed form, and the view of any shape.
#include <cmath>
#include <numbers>

#include "contact/obstacle/obstacle.hpp"
#include "contact/obstacle/obstacle_view.hpp"
#include "core/error.hpp"

namespace stiction::contact {

namespace {

Vec2 from_point(RigidPlane const& plane, Vec2 const& x) {
  return x - point_or_origin<2>(plane.point);
}

Foot foot_2d(RigidPlane const& plane, Vec2 const& x, Foot /*guess*/) {
  return {0, right_of(unit_or_last_axis<2>(plane.normal)).dot(from_point(plane, x))};
}

double slip_2d(RigidPlane const& /*plane*/, Foot from, Foot to) {
  return to.xi - from.xi;
}

View2d view_2d(RigidPlane const& plane, Vec2 const& x, Foot /*foot*/) {
  Vec2 const n = unit_or_last_axis<2>(plane.normal);
  View2d seen;
  seen.gap = n.dot(from_point(plane, x));
  seen.normal = n;
  seen.slip_by_x = right_of(n);
  return seen;
}

/// What a round shape is in the plane.
struct Disc {
  Vec2 centre;
  double radius, sign;
};

Disc disc_of(RigidCircle const& circle) {
  return {point_or_origin<2>(circle.centre), circle.radius, sign_of(circle.side)};
}

Disc disc_of(RigidSphere const& sphere) {
  return {point_or_origin<2>(sphere.centre), sphere.radius, sign_of(sphere.side)};
}

Disc disc_of(RigidTorus const& torus) {
  return {point_or_origin<2>(torus.centre) + Vec2(torus.major_radius, 0), torus.minor_radius,
          sign_of(torus.side)};
}

template<class Shape>
concept Round = requires(Shape const& shape) {
  disc_of(shape);
};

/// xi is the arc length along the circle, in the direction of the tangent.
Foot foot_2d(Round auto const& shape, Vec2 const& x, Foot /*guess*/) {
  auto const disc = disc_of(shape);
  Vec2 const d = x - disc.centre;
  if (d.isZero(0))
    return {};
  return {0, -disc.sign * disc.radius * std::atan2(d.y(), d.x())};
}

/// The short way round.
double slip_2d(Round auto const& shape, Foot from, Foot to) {
  return std::remainder(to.xi - from.xi, 2 * std::numbers::pi * disc_of(shape).radius);
}

View2d view_2d(Round auto const& shape, Vec2 const& x, Foot /*foot*/) {
  auto const [centre, R, sign] = disc_of(shape);
  Vec2 const d = x - centre;
  double const distance = d.norm();
  Vec2 const n = sign * d / distance, t = right_of(n);
  View2d seen;
  seen.gap = sign * (distance - R);
  seen.normal = n;
  seen.slip_by_x = R / distance * t;
  seen.gap_by_xx = sign / distance * t * t.transpose();
  seen.slip_by_xx = -sign * R / (distance * distance) * (n * t.transpose() + t * n.transpose());
  return seen;
}

ObstacleView<2> view_of(auto const& shape, Vec2 const& point, Foot start, Foot guess) {
  if constexpr (requires { foot_2d(shape, point, guess); }) {
    ObstacleView<2> result;
    result.foot = foot_2d(shape, point, guess);
    result.found = result.foot.found();
    if (!result.found)
      return result;
    auto const seen = view_2d(shape, point, result.foot);
    result.gap = seen.gap;
    result.frame << seen.normal, right_of(seen.normal);
    if (start.found())
      result.slip[0] = slip_2d(shape, start, result.foot);
    result.by_x << seen.normal.transpose(), seen.slip_by_x.transpose();
    return result;
  } else {
    core::fail_expectation("the obstacle has a form in the plane", std::source_location::current());
  }
}

Mat<2> stiffness_of(auto const& shape, Foot foot, Vec2 const& point, Local<2> const& force) {
  if constexpr (requires { view_2d(shape, point, foot); }) {
    auto const seen = view_2d(shape, point, foot);
    return force[0] * seen.gap_by_xx + force[1] * seen.slip_by_xx;
  } else {
    core::fail_expectation("the obstacle has a form in the plane", std::source_location::current());
  }
}

} // namespace

template<>
ObstacleView<2> view(Obstacle const& obstacle, Vec2 const& point, Start const& start, Foot guess,
                     Vec3 const& /*direction*/) {
  return std::visit([&](auto const& shape) { return view_of(shape, point, start.foot, guess); }, obstacle);
}

template<>
Mat<2> curvature_stiffness(Obstacle const& obstacle, Foot foot, Vec2 const& point, Local<2> const& force,
                           Vec3 const& /*direction*/) {
  return std::visit([&](auto const& shape) { return stiffness_of(shape, foot, point, force); }, obstacle);
}

} // namespace stiction::contact
