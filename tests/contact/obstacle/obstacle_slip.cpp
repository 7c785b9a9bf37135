// Slip on obstacles in space: the way along the surface, however far, and its derivatives.
#include <Eigen/Geometry>
#include <numbers>

#include "contact/obstacles.hpp"

using namespace stiction;
using namespace stiction::contact;
using namespace stiction::test;

namespace {

Vec3 const direction(1, 0.2, -0.3);

/// The way of a point over a shape, in space: along the surface at its end.
Vec3 way(Obstacle const& shape, Vec3 const& from, Vec3 const& to) {
  auto const start = view<3>(shape, from, {}, {}, direction);
  auto const end = view<3>(shape, to, start.foot, start.foot, direction);
  REQUIRE(start.found);
  REQUIRE(end.found);
  return end.frame.rightCols<2>() * end.slip;
}

Vec3 turned(Vec3 const& x, Vec3 const& axis, double angle) {
  return Eigen::AngleAxisd(angle, axis.normalized()) * x;
}

constexpr double angles[] = {1e-4, 0.009, 0.011, 0.3, 1.0, 2.5}; // both sides of where series take over

} // namespace

TEST_SUITE("contact") {
  TEST_CASE("slip round a ball is the arc, arriving along it") {
    Vec3 const centre(-0.4, 0.3, 0.2), e = Vec3(0.3, -0.2, 1).normalized(),
                                       axis = e.cross(Vec3(0.8, 0.5, -0.1));
    for (auto const side : {Side::outside, Side::inside})
      for (double const angle : angles)
        for (auto const& [start, end] : {std::pair(1.5, 1.5), std::pair(1.6, 1.45)}) {
          RigidSphere const ball{{centre.x(), centre.y(), centre.z()}, 1.5, side};
          Vec3 const to = turned(e, axis, angle), arc = angle * axis.normalized().cross(to);
          Vec3 const found = way(ball, centre + start * e, centre + end * to);
          CHECK((found - (start + end) / 2 * arc).norm() <
                1e-12 * angle); // of a point that sinks: on average
        }
  }

  TEST_CASE("slip round and along a cylinder is that of the cylinder unrolled") {
    Vec3 const a = Vec3(1, 0.5, -2).normalized(), e = a.cross(Vec3::UnitY()).normalized();
    for (auto const side : {Side::outside, Side::inside})
      for (double const angle : angles)
        for (double const along : {0.0, 0.7, -3.0}) {
          RigidCylinder const drum{{0.1, -0.2, 5}, {1, 0.5, -2}, 1.2, side};
          Vec3 const to = turned(e, a, angle), middle(0.1, -0.2, 5);
          Vec3 const found = way(drum, middle + 1.2 * e, middle + 1.2 * to + along * a);
          CHECK((found - (1.2 * angle * a.cross(to) + along * a)).norm() <
                1e-12 * (angle + std::abs(along)) + 1e-14);
        }
  }

  TEST_CASE("slip there and slip back are as long, and along curved lines of third order") {
    RigidTorus const ring{{0.1, 0.5, -0.2}, {0, 0, 1}, 2, 0.7};
    auto const at = [](double u, double v) {
      return Vec3(0.1 + (2 + 0.7 * std::cos(v)) * std::cos(u), 0.5 + (2 + 0.7 * std::cos(v)) * std::sin(u),
                  -0.2 + 0.7 * std::sin(v));
    };
    double last = 0;
    for (double const step : {0.4, 0.2, 0.1}) {
      Vec3 const a = at(0.3, 0.8), middle = at(0.3 + step / 2, 0.8 + step),
                 b = at(0.3 + step, 0.8 + 2 * step);
      CHECK(way(ring, a, b).norm() == doctest::Approx(way(ring, b, a).norm()).epsilon(1e-12));
      Vec3 const normal = view<3>(ring, b, {}, {}, direction).frame.col(0);
      Vec3 const first = way(ring, a, middle), second = way(ring, middle, b);
      Vec3 const carried =
          Eigen::Quaterniond::FromTwoVectors(view<3>(ring, middle, {}, {}, direction).frame.col(0), normal) *
          first;
      double const error = (carried + second - way(ring, a, b)).norm();
      CHECK(error < 0.4 * step * step * step);
      if (last > 0)
        CHECK(error < last / 6);
      last = error;
    }
  }

  TEST_CASE("between opposite sides of a ball slip is finite, and along the surface") {
    RigidSphere const ball{{}, 1};
    for (double const angle : {3.0, std::numbers::pi}) {
      Vec3 const to = turned(Vec3::UnitZ(), Vec3::UnitX(), angle), found = way(ball, Vec3::UnitZ(), to);
      CHECK(found.allFinite());
      CHECK(std::abs(found.dot(to)) < 1e-12);
    }
  }

  TEST_CASE("the motion of obstacles is the derivative of gap and slip, however long the way") {
    int found = 0;
    for (auto const& met : encounters(std::integral_constant<int, 3>{}))
      for (double const length : {0.0, 1e-3, 0.05, 0.9}) {
        Vec3 const from = met.point + length * Vec3(0.5, -0.7, 0.4);
        auto const start = view<3>(met.shape, from, {}, {}, direction);
        auto const at = view<3>(met.shape, met.point, start.foot, start.foot, direction);
        if (!start.found || !at.found)
          continue;
        ++found;
        auto const moves = [&](Vector const& x) {
          auto const seen = view<3>(met.shape, x, start.foot, at.foot, direction);
          return Vector(Vec3(seen.gap, seen.slip[0], seen.slip[1]));
        };
        Mat<3> const rows = motion_by_x(met.shape, at.foot, met.point, start.foot, direction);
        check_rate(rate(moves, Dense(rows), Vector(met.point), 1e-3, 1), "motion");
        if (length == 0)
          CHECK((rows - at.by_x).norm() < 1e-14);
      }
    CHECK(found > 150);
  }

  TEST_CASE("without a way the motion of obstacles is that of the forces") {
    RigidSphere const ball{{}, 1};
    auto const at = view<3>(ball, {0, 0.6, 0.8}, {}, {}, direction);
    CHECK(motion_by_x(ball, at.foot, {0, 0.6, 0.8}, {}, direction) == at.by_x);
  }
}
