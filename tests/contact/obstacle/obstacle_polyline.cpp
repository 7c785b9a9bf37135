// Rigid profiles: convergence to the shape they run through, corners, ends, and slip along them.
#include <numbers>

#include "contact/obstacles.hpp"

using namespace stiction;
using namespace stiction::contact;
using namespace stiction::test;

namespace {

ObstacleView<2> seen(Obstacle const& shape, Vec2 const& point, Foot start = {}) {
  return view<2>(shape, point, start, {}, Vec3::UnitX());
}

RigidPolyline square() {
  return polyline({-1, -1, 1, -1, 1, 1, -1, 1}, true, Smoothing::spline); // its corners stay corners
}

} // namespace

TEST_SUITE("contact") {
  TEST_CASE("a spline through points of a circle sees what the circle sees") {
    RigidCircle const circle{{}, 2};
    auto const line = polyline(ellipse(48, 2, 2), true, Smoothing::spline);
    for (double const angle : {0.1, 1.7, 3.1, 5.0})
      for (double const r : {1.9, 2.0, 2.6}) {
        Vec2 const p(r * std::cos(angle), r * std::sin(angle)),
            q(r * std::cos(angle - 0.3), r * std::sin(angle - 0.3));
        auto const one = seen(circle, p), other = seen(line, p);
        CHECK(other.gap == doctest::Approx(one.gap).epsilon(2e-5));
        CHECK((other.frame - one.frame).norm() < 2e-3);
        CHECK(seen(line, q, other.foot).slip[0] ==
              doctest::Approx(seen(circle, q, one.foot).slip[0]).epsilon(1e-3));
        Mat<2> const K = curvature_stiffness<2>(line, other.foot, p, {1, 0}, Vec3::UnitX());
        CHECK((K - curvature_stiffness<2>(circle, one.foot, p, {1, 0}, Vec3::UnitX())).norm() < 0.03 / r);
      }
  }

  TEST_CASE("the solid lies to the left of a profile") {
    auto const floor =
        polyline({2, 0, 0, 0, -2, 0}, false, Smoothing::polyline); // walking to -x, solid below
    auto const above = seen(floor, {0.5, 0.25});
    CHECK(above.gap == doctest::Approx(0.25));
    CHECK(above.frame.isApprox((Mat<2>() << 0, 1, 1, 0).finished())); // columns n = y and t = x
    auto const moved = seen(floor, {-1.5, 0.1}, above.foot);
    CHECK(moved.slip[0] == doctest::Approx(-2));
  }

  TEST_CASE("an open profile ends where its points end") {
    auto const floor = polyline({2, 0, 0, 0, -2, 0}, false, Smoothing::polyline);
    CHECK(seen(floor, {2, 0.1}).found);
    CHECK(seen(floor, {-2, 0.1}).found);
    CHECK_FALSE(seen(floor, {2.1, 0.1}).found);
    CHECK_FALSE(seen(floor, {-2.1, -0.1}).found);
  }

  TEST_CASE("corners of a profile: either side near them") {
    auto const box = square();
    auto const right = seen(box, {1.2, 0.9}), top = seen(box, {0.9, 1.2});
    CHECK(right.gap == doctest::Approx(0.2));
    CHECK(right.frame.col(0).isApprox(Vec2(1, 0)));
    CHECK(top.frame.col(0).isApprox(Vec2(0, 1)));
    CHECK(seen(box, {0.9, 0.95}).gap == doctest::Approx(-0.05)); // within: the nearer side
    // from the right side over the corner to the top: the length along both
    CHECK(seen(box, {0.9, 1.2}, right.foot).slip[0] == doctest::Approx(-0.2));
  }

  TEST_CASE("round a corner normals turn steadily from one side to the other, and slip goes on") {
    auto const box = square();
    double const quarter = std::numbers::pi / 2, r = std::hypot(0.2, 0.3), turned = std::atan2(0.3, 0.2);
    auto const wedge = seen(box, {1.2, 1.3});
    CHECK(wedge.gap == doctest::Approx(r));
    CHECK(wedge.frame.col(0).isApprox(Vec2(0.2, 0.3) / r));
    CHECK(wedge.frame.col(1).isApprox(Vec2(0.3, -0.2) / r));
    auto const right = seen(box, {1.2, 0.9}), top = seen(box, {0.9, 1.2});
    CHECK(seen(box, {1.2, 1.3}, right.foot).slip[0] == doctest::Approx(-0.1 - r * turned));
    CHECK(seen(box, {1.2, 1.3}, top.foot).slip[0] == doctest::Approx(0.1 + r * (quarter - turned)));
    CHECK(seen(box, {0.9, 1.2}, wedge.foot).slip[0] == doctest::Approx(-0.1 - r * (quarter - turned)));
    CHECK(seen(box, {1.2, 0.9}, wedge.foot).slip[0] == doctest::Approx(0.1 + r * turned));
    CHECK(seen(box, {1.3, 1.2}, wedge.foot).slip[0] == doctest::Approx(r * (turned - std::atan2(0.2, 0.3))));
    for (double const end : {-1e-9, 1e-9}) { // on either side of the wedge's borders
      CHECK(seen(box, {1.2, 1 + end}).gap == doctest::Approx(0.2));
      CHECK(seen(box, {1.2, 1 + end}).frame.col(0).isApprox(Vec2(1, 0), 1e-8));
      CHECK(seen(box, {1 + end, 1.2}).frame.col(0).isApprox(Vec2(0, 1), 1e-8));
      CHECK(seen(box, {1.2, 1 + end}, right.foot).slip[0] == doctest::Approx(-0.1));
    }
  }

  TEST_CASE("round a corner the derivatives of gap and slip are what differences tend to") {
    auto const box = square();
    Vec2 const at(1.2, 1.3), force(0.7, -0.4);
    auto const here = seen(box, at);
    Mat<2> const K = curvature_stiffness<2>(box, here.foot, at, force, Vec3::UnitX());
    std::array<double, 2> first{}, second{}, slip{};
    for (std::size_t k = 0; k < 2; ++k) {
      double const h = k == 0 ? 2e-3 : 1e-3;
      for (int c = 0; c < 2; ++c) {
        Vec2 const step = h * Vec2::Unit(c);
        auto const up = seen(box, at + step, here.foot), down = seen(box, at - step, here.foot);
        first[k] = std::max(first[k], std::abs((up.gap - down.gap) / (2 * h) - here.by_x(0, c)));
        slip[k] = std::max(slip[k], std::abs((up.slip[0] - down.slip[0]) / (2 * h) - here.by_x(1, c)));
        Vec2 const difference = (up.by_x - down.by_x).transpose() * force / (2 * h);
        second[k] = std::max(second[k], (difference - K.col(c)).norm());
      }
    }
    for (auto const& off : {first, slip, second}) {
      CHECK(off[1] < 1e-4);
      CHECK(std::log2(off[0] / off[1]) == doctest::Approx(2).epsilon(0.05));
    }
  }

  TEST_CASE("of sides of unlike lengths the nearest is found, from anywhere") {
    auto const plate = polyline({-6, 0, 6, 0, 6, 1, -6, 1}, true, Smoothing::polyline);
    for (double const x : {-5.9, -5.0, -4.5, -1.0, 0.0, 3.1, 4.9, 5.75})
      for (double const y : {0.0, 0.125, 0.4}) { // within, or on the side below
        CAPTURE(x);
        CAPTURE(y);
        CHECK(seen(plate, {x, y}).gap == doctest::Approx(-std::min(y, 6 - std::abs(x))).scale(1e-12));
      }
  }

  TEST_CASE("slip on a closed profile goes the short way round") {
    auto const box = square();
    auto const start = seen(box, {-0.5, -1.1}); // near the first point
    CHECK(seen(box, {-1.1, -0.5}, start.foot).slip[0] == doctest::Approx(1));
    CHECK(seen(box, {0.5, -1.1}, start.foot).slip[0] == doctest::Approx(-1));
  }
}
