// Obstacles in space: planes and round shapes in closed form, the tangents, and the view of any shape.
#include <Eigen/Geometry>
#include <cmath>
#include <optional>

#include "contact/obstacle/obstacle.hpp"
#include "contact/obstacle/obstacle_view.hpp"
#include "core/error.hpp"

namespace stiction::contact {

namespace {

using RowVec3 = Eigen::RowVector3d;

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

/// From one normal to another by the shortest turn.
struct Turn {
  double cosine;              ///< of half of the angle
  Vec3 middle;                ///< normal half-way
  double excess, excess_by_k; ///< (arc / chord - 1) / (2 sin^2) of a circle, of half of the angle
};

/// Half the angle's cosine below which the way from a normal to its opposite is not told any more.
constexpr double opposite = 0.1;

Turn turn_between(Vec3 const& from, Vec3 const& to) {
  Vec3 const sum = from + to;
  double const k = sum.norm() / 2, sine = (to - from).norm() / 2, half = std::atan2(sine, k);
  Vec3 const middle = k > 0 ? Vec3(sum / (2 * k)) : to;
  if (half < 1e-2)
    return {k, middle, 1.0 / 12 + 3 * half * half / 80, -3.0 / 40};
  double const arc = half / sine, sine2 = sine * sine;
  return {k, middle, (arc - 1) / (2 * sine2), ((arc * k - 1) / 2 + (arc - 1) * k) / (sine2 * sine2)};
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

/// A step's way over a surface: from where, and the surface's normal there.
struct Way {
  Vec3 from, normal;

  /// None where there was no counterpart.
  static std::optional<Way> since(auto const& shape, Start const& start) {
    auto const normal = start.normal ? start.normal : normal_of(shape, start.foot);
    return normal ? std::optional(Way{place(start.foot), *normal}) : std::nullopt;
  }
  /// Components along the columns t1, t2 of the frame at its end. The part of the chord across the normal
  /// half-way, as long as its circle's arc in the plane of the turn, and turned to the end.
  [[nodiscard]] Local<2> slip(Vec3 const& to, Mat<3> const& frame) const {
    Vec3 const chord = to - from, n = frame.col(0);
    auto const turn = turn_between(normal, n);
    Local<2> const along = frame.rightCols<2>().transpose() * chord;
    if (turn.cosine < opposite)
      return along;
    double const risen = chord.dot(turn.middle + n) / (1 + turn.cosine) + turn.excess * chord.dot(n - normal);
    return along - risen * frame.rightCols<2>().transpose() * turn.middle;
  }
  /// Its derivative by the end, where the normal turns by dn.
  [[nodiscard]] Eigen::Matrix<double, 2, 3> slip_by_x(Vec3 const& to, Mat<3> const& frame, Mat<3> const& dn,
                                                      Vec3 const& direction) const {
    Vec3 const chord = to - from, n = frame.col(0);
    auto const [k, m, excess, excess_by_k] = turn_between(normal, n);
    RowVec3 const dk = normal.transpose() * dn / (4 * k);
    Mat<3> const dm = (dn - m * (m.transpose() * dn)) / (2 * k);
    double const back = chord.dot(m + n) / (1 + k), risen = back + excess * chord.dot(n - normal);
    RowVec3 const by_x = ((m + n).transpose() + chord.transpose() * (dm + dn) - back * dk) / (1 + k) +
                         excess * ((n - normal).transpose() + chord.transpose() * dn) +
                         excess_by_k * chord.dot(n - normal) * dk;
    Eigen::Matrix<double, 2, 3> rows;
    for (int a = 0; a < 2; ++a) {
      Vec3 const t = frame.col(a + 1);
      Mat<3> const dt = turn_of_frame(frame, dn, direction, Vec3::Unit(a + 1));
      rows.row(a) = t.transpose() + chord.transpose() * dt;
      if (k >= opposite)
        rows.row(a) -= risen * (m.transpose() * dt + t.transpose() * dm) + t.dot(m) * by_x;
    }
    return rows;
  }
};

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
    if (auto const way = Way::since(shape, start))
      result.slip = way->slip(point, result.frame);
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
    if (auto const way = Way::since(shape, start))
      rows.bottomRows<2>() = way->slip_by_x(point, frame, seen.normal_by_x, direction);
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
