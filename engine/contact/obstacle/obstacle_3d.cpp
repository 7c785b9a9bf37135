// Obstacles in space: planes and round shapes in closed form, the tangents, and the view of any shape.
#include <Eigen/Geometry>
#include <cmath>
#include <optional>

#include "contact/obstacle/obstacle.hpp"
#include "contact/obstacle/obstacle_view.hpp"
#include "contact/surface/way.hpp"
#include "core/error.hpp"

namespace stiction::contact {

namespace {

View3d view_3d(RigidPlane const& plane, Vec3 const& x, Foot /*guess*/) {
  Vec3 const n = unit_or_last_axis<3>(plane.normal);
  return {0, n.dot(x - point_or_origin<3>(plane.point)), n};
}

/// Distance from the skeleton of a round shape (centre, axis or middle circle), with two derivatives.
struct Away {
  double distance = 0; ///< m; 0 also where the nearest point of the skeleton is not unique
  Vec3 direction = Vec3::Zero();
  Mat<3> by_xx = Mat<3>::Zero(); ///< 1/m
};

Away away_from(RigidSphere const& sphere, Vec3 const& x) {
  Vec3 const d = x - point_or_origin<3>(sphere.centre);
  double const distance = d.norm();
  if (distance == 0)
    return {};
  Vec3 const e = d / distance;
  return {distance, e, (Mat<3>::Identity() - e * e.transpose()) / distance};
}

Away away_from(RigidCylinder const& cylinder, Vec3 const& x) {
  Vec3 const a = unit_or_last_axis<3>(cylinder.axis), d = x - point_or_origin<3>(cylinder.centre);
  Vec3 const across = d - a * a.dot(d);
  double const distance = across.norm();
  if (distance == 0)
    return {};
  Vec3 const e = across / distance, around = a.cross(e);
  return {distance, e, around * around.transpose() / distance};
}

Away away_from(RigidTorus const& torus, Vec3 const& x) {
  Vec3 const a = unit_or_last_axis<3>(torus.axis), d = x - point_or_origin<3>(torus.centre);
  double const height = a.dot(d), rho = (d - a * height).norm(), out = rho - torus.major_radius;
  double const distance = std::hypot(out, height);
  if (rho == 0 || distance == 0)
    return {};
  Vec3 const e = (d - a * height) / rho, around = a.cross(e);
  Vec3 const direction = (out * e + height * a) / distance, along = around.cross(direction);
  return {distance, direction,
          (along * along.transpose() + out / rho * around * around.transpose()) / distance};
}

double thickness(RigidTorus const& torus) {
  return torus.minor_radius;
}
double thickness(auto const& shape) {
  return shape.radius;
}

template<class Shape>
concept RoundBody = requires(Shape const& shape, Vec3 const& x) {
  away_from(shape, x);
};

View3d view_3d(RoundBody auto const& shape, Vec3 const& x, Foot /*guess*/) {
  auto const away = away_from(shape, x);
  double const sign = sign_of(shape.side);
  return {away.distance > 0 ? 0 : -1, sign * (away.distance - thickness(shape)), sign * away.direction,
          sign * away.by_xx};
}

/// The axis whose part along the surface is t1: `direction`, or if n is parallel to it the axis after that
/// which it is nearest to.
Vec3 leading(Vec3 const& direction, Vec3 const& n) {
  Vec3 const a = direction.normalized();
  if ((a - n * n.dot(a)).norm() > 1e-3)
    return a;
  Eigen::Index largest = 0;
  a.cwiseAbs().maxCoeff(&largest);
  return Vec3::Unit((largest + 1) % 3);
}

/// Columns n, t1, t2.
Mat<3> frame_of(Vec3 const& n, Vec3 const& direction) {
  Vec3 const a = leading(direction, n);
  Vec3 const t1 = (a - n * n.dot(a)).normalized();
  Mat<3> frame;
  frame << n, t1, n.cross(t1);
  return frame;
}

/// Derivative of frame_of(n) force by the point's position, given that of n.
Mat<3> turn_of_frame(Mat<3> const& frame, Mat<3> const& dn, Vec3 const& direction, Local<3> const& force) {
  Vec3 const n = frame.col(0), t1 = frame.col(1), a = leading(direction, n);
  double const length = t1.dot(a); // of the part of a along the surface
  Mat<3> const along = n.dot(a) * dn + n * (a.transpose() * dn);
  Mat<3> const dt1 = -(along - t1 * (t1.transpose() * along)) / length;
  Mat<3> const dt2 = dn.colwise().cross(t1) - dt1.colwise().cross(n);
  return force[0] * dn + force[1] * dt1 + force[2] * dt2;
}

Vec3 place(Foot start) {
  return {start.xi, start.eta, start.zeta};
}

/// Where a step found a point; none if it found none.
std::optional<Vec3> normal_of(auto const& shape, Foot start) {
  if constexpr (requires { view_3d(shape, Vec3(), start); }) {
    if (!start.found())
      return {};
    auto const seen = view_3d(shape, place(start), start);
    return seen.segment >= 0 ? std::optional(seen.normal) : std::nullopt;
  } else {
    core::fail_expectation("the obstacle has a form in space", std::source_location::current());
  }
}

/// The way over a shape to a point with that normal; none where there was no counterpart.
std::optional<Way<3>> way_to(auto const& shape, Start const& start, Vec3 const& to, Vec3 const& normal) {
  auto const before = start.normal ? start.normal : normal_of(shape, start.foot);
  return before ? std::optional(Way<3>(to - place(start.foot), *before, normal, ChordEnds::over_surface))
                : std::nullopt;
}

ObstacleView<3> view_of(auto const& shape, Vec3 const& point, Start const& start, Foot guess,
                        Vec3 const& direction) {
  if constexpr (requires { view_3d(shape, point, guess); }) {
    auto const seen = view_3d(shape, point, guess);
    ObstacleView<3> result;
    result.found = seen.segment >= 0;
    if (!result.found)
      return result;
    result.foot = {seen.segment, point.x(), point.y(), point.z()};
    result.gap = seen.gap;
    result.frame = frame_of(seen.normal, direction);
    result.by_x = result.frame.transpose();
    if (auto const way = way_to(shape, start, point, seen.normal))
      result.slip = {way->along(result.frame.col(1)), way->along(result.frame.col(2))};
    return result;
  } else {
    core::fail_expectation("the obstacle has a form in space", std::source_location::current());
  }
}

Mat<3> stiffness_of(auto const& shape, Foot foot, Vec3 const& point, Local<3> const& force,
                    Vec3 const& direction) {
  if constexpr (requires { view_3d(shape, point, foot); }) {
    auto const seen = view_3d(shape, point, foot);
    return turn_of_frame(frame_of(seen.normal, direction), seen.normal_by_x, direction, force);
  } else {
    core::fail_expectation("the obstacle has a form in space", std::source_location::current());
  }
}

Mat<3> motion_of(auto const& shape, Foot foot, Vec3 const& point, Start const& start, Vec3 const& direction) {
  if constexpr (requires { view_3d(shape, point, foot); }) {
    auto const seen = view_3d(shape, point, foot);
    auto const frame = frame_of(seen.normal, direction);
    Mat<3> rows = frame.transpose();
    auto const way = way_to(shape, start, point, seen.normal);
    for (int a = 1; way && a < 3; ++a) {
      auto const by = way->by(frame.col(a));
      rows.row(a) = by.chord.transpose() + by.to.transpose() * seen.normal_by_x +
                    by.tangent.transpose() * turn_of_frame(frame, seen.normal_by_x, direction, Vec3::Unit(a));
    }
    return rows;
  } else {
    core::fail_expectation("the obstacle has a form in space", std::source_location::current());
  }
}

} // namespace

template<>
ObstacleView<3> view(Obstacle const& obstacle, Vec3 const& point, Start const& start, Foot guess,
                     Vec3 const& direction) {
  return std::visit([&](auto const& shape) { return view_of(shape, point, start, guess, direction); },
                    obstacle);
}

template<>
Mat<3> curvature_stiffness(Obstacle const& obstacle, Foot foot, Vec3 const& point, Local<3> const& force,
                           Vec3 const& direction) {
  return std::visit([&](auto const& shape) { return stiffness_of(shape, foot, point, force, direction); },
                    obstacle);
}

Mat<3> motion_by_x(Obstacle const& obstacle, Foot foot, Vec3 const& point, Start const& start,
                   Vec3 const& direction) {
  return std::visit([&](auto const& shape) { return motion_of(shape, foot, point, start, direction); },
                    obstacle);
}

std::optional<Vec3> normal_at(Obstacle const& obstacle, Foot start) {
  return std::visit([&](auto const& shape) { return normal_of(shape, start); }, obstacle);
}

} // namespace stiction::contact
