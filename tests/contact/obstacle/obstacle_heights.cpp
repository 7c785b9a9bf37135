// Rigid height maps: the shapes they run through, nearest points, derivatives, periods and rims.
#include <numbers>

#include "contact/obstacles.hpp"

using namespace stiction;
using namespace stiction::contact;
using namespace stiction::test;

namespace {

Vec3 const direction(1, 0.2, -0.3);
double const pi = std::numbers::pi;

template<int D> ObstacleView<D> seen(Obstacle const& shape, Vec<D> const& point, Foot start = {}) {
  return view<D>(shape, point, start, {}, direction);
}

RigidHeights ball(double radius, int points, Vec3 const& normal = Vec3::UnitZ()) {
  return height_map({2, 2}, points, RigidHeights::Rim::free,
                    [&](double x, double y) { return radius - std::sqrt(radius * radius - x * x - y * y); },
                    {normal.x(), normal.y(), normal.z()});
}

double egg_box(double x, double y) {
  return 0.05 * (2 - std::cos(pi * x) - std::cos(pi * y));
}

RigidHeights waves(int points) {
  return height_map({2, 2}, points, RigidHeights::Rim::periodic, egg_box);
}

/// Sums of differences from the ball of radius 3 whose apex is the origin.
struct Off {
  double gap = 0, normal = 0, stiffness = 0;
};
Off off_ball(int points) {
  RigidHeights const map = ball(3, points);
  RigidSphere const sphere{{0, 0, -3}, 3};
  Off sum;
  for (int k = 0; k < 81; ++k) {
    Vec3 const p(-0.41 + 0.1 * (k % 9), -0.38 + 0.1 * (k / 9), 0.05 * (k % 5) - 0.2);
    auto const one = seen<3>(sphere, p), other = seen<3>(map, p);
    REQUIRE(other.found);
    Local<3> const force(1, 0.3, -0.2);
    Mat<3> const K = curvature_stiffness<3>(sphere, one.foot, p, force, direction),
                 L = curvature_stiffness<3>(map, other.foot, p, force, direction);
    sum.gap += std::abs(one.gap - other.gap);
    sum.normal += (one.frame - other.frame).norm();
    sum.stiffness += (K - L).norm();
  }
  return sum;
}

/// The nearest of many points of a surface, by looking at all of them.
template<class Height> double nearest_of_all(Height const& height, Vec3 const& p, double reach) {
  constexpr int count = 801;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < count; ++i)
    for (int j = 0; j < count; ++j) {
      double const x = p.x() + reach * (2.0 * i / (count - 1) - 1);
      double const y = p.y() + reach * (2.0 * j / (count - 1) - 1);
      least = std::min(least, (Vec3(x, y, -height(x, y)) - p).norm());
    }
  return least;
}

} // namespace

TEST_SUITE("contact") {
  TEST_CASE("a height map of a ball approaches the ball with the fourth power of its spacing") {
    auto const coarse = off_ball(20), fine = off_ball(40);
    CHECK(coarse.gap < 1e-5);
    CHECK(coarse.gap / fine.gap == doctest::Approx(16).epsilon(0.5));
    CHECK(coarse.normal / fine.normal > 6);       // third
    CHECK(coarse.stiffness / fine.stiffness > 3); // second
  }

  TEST_CASE("a height map of a parabola is the parabola, up to its free rim") {
    auto const parabola = [](double x, double y) { return 0.1 * x * x + 0.07 * y * y - 0.03 * x * y; };
    auto const map = height_map({2, 3}, 6, RigidHeights::Rim::free, parabola);
    for (auto const& place : {Vec2(0, 0), Vec2(0.97, 1.49), Vec2(-0.95, 1.3)}) {
      Vec3 const on(place.x(), place.y(), -parabola(place.x(), place.y()));
      Vec3 const n = Vec3(0.2 * on.x() - 0.03 * on.y(), 0.14 * on.y() - 0.03 * on.x(), 1).normalized();
      for (double const gap : {-0.02, 0.01, 0.03}) {
        auto const at = seen<3>(map, on + gap * n);
        REQUIRE(at.found);
        CHECK(at.gap == doctest::Approx(gap).epsilon(1e-10));
        CHECK((at.frame.col(0) - n).norm() < 1e-10);
      }
    }
  }

  TEST_CASE("the foot on a height map is the nearest of all its points") {
    auto const map = waves(32);
    for (auto const& p : {Vec3(1, 1, 0.3), Vec3(0.9, 0.15, -0.05), Vec3(0.4, 1.2, 2.5),
                          Vec3(0.02, 0.01, -0.4), Vec3(7.3, -8.8, 1.1), Vec3(1.02, 0.96, 0.6)}) {
      auto const at = seen<3>(map, p);
      REQUIRE(at.found);
      double const wanted = nearest_of_all(egg_box, p, std::abs(at.gap) + 0.1);
      CHECK(std::abs(at.gap) <= wanted + 1e-6);
      CHECK(std::abs(at.gap) == doctest::Approx(wanted).epsilon(2e-3));
      CHECK((at.gap < 0) == (p.z() < -egg_box(p.x(), p.y())));
    }
  }

  TEST_CASE(
      "the flank of a peak is nearer than the ground below a point, though both are nearest around them") {
    auto const peak = [](double x, double y) { return 0.3 * (1 - std::exp(-(x * x + y * y) / 0.02)); };
    auto const map = height_map({2, 2}, 64, RigidHeights::Rim::periodic, peak);
    Vec3 const p(0.4, 0.02, 0.1);
    auto const at = seen<3>(map, p);
    REQUIRE(at.found);
    CHECK(at.gap == doctest::Approx(nearest_of_all(peak, p, 0.45)).epsilon(1e-2));
    CHECK(at.gap < 0.39); // 0.4 down
    CHECK(at.frame(0, 0) > 0.5);
  }

  TEST_CASE("a periodic height map goes on for ever, across its seam too") {
    auto const map = waves(12);
    auto const line = height_map({2}, 12, RigidHeights::Rim::periodic, egg_box);
    for (double const x : {0.3, 0.999, 1.001}) {
      auto const here = seen<3>(map, {x, -0.7, 0.04}), there = seen<3>(map, {x + 6, -0.7 - 2e3, 0.04});
      CHECK(here.gap == doctest::Approx(there.gap).epsilon(1e-9));
      CHECK((here.frame - there.frame).norm() < 1e-9);
      auto const flat = seen<2>(line, {x, 0.04}), far = seen<2>(line, {x + 6, 0.04});
      CHECK(flat.gap == doctest::Approx(far.gap).epsilon(1e-9));
      CHECK(seen<2>(line, {x + 6, 0.04}, flat.foot).slip[0] > 6); // longer than straight on
      CHECK(seen<2>(line, {x + 6, 0.04}, flat.foot).slip[0] < 6.2);
    }
  }

  TEST_CASE("past the rim of a free height map there is nothing") {
    auto const map = ball(3, 8); // rims at 1, points 0.25 apart
    CHECK(seen<3>(map, {1, 0, -0.1}).found);
    CHECK(seen<3>(map, {0.99, -0.99, -0.3}).found);
    CHECK_FALSE(seen<3>(map, {1.3, 0, -0.1}).found);
    CHECK_FALSE(seen<3>(map, {0, -5, 0.1}).found);
    auto const line = height_map({2}, 8, RigidHeights::Rim::free, egg_box);
    CHECK(seen<2>(line, {-0.99, 0}).found);
    CHECK_FALSE(seen<2>(line, {-1.3, 0}).found);
  }

  TEST_CASE("a height map lies where its point, normal and direction say") {
    auto const ramp = [](double x, double y) { return 0.1 * x + 0.02 * y; };
    core::Numbers const sizes{2, 2};
    auto const free = RigidHeights::Rim::free;
    auto const place = [&](core::Numbers normal, core::Numbers along, Vec3 const& point) {
      auto map = height_map(sizes, 6, free, ramp, std::move(normal));
      map.point = {0.5, 0.25, 2};
      map.along = std::move(along);
      prepare(map);
      return seen<3>(map, point).gap * std::sqrt(1 + 0.1 * 0.1 + 0.02 * 0.02);
    };
    // solid below, and as over a half space: solid above, x and y as they are
    CHECK(place({}, {}, {0.8, 0.35, 2.1}) == doctest::Approx(0.1 + 0.03 + 0.002));
    CHECK(place({0, 0, -1}, {}, {0.8, 0.35, 1.9}) == doctest::Approx(0.1 + 0.03 + 0.002));
    CHECK(place({0, 0, -1}, {-1, 0, 0}, {0.8, 0.35, 1.9}) == doctest::Approx(0.1 - 0.03 - 0.002));
    CHECK(place({0, 0, 3}, {0, 1, 0.5}, {0.8, 0.35, 2.1}) == doctest::Approx(0.1 + 0.01 - 0.006));
    CHECK(place({2, 0, 0}, {}, {0.6, 0.35, 2.3}) == doctest::Approx(0.1 + 0.01 + 0.006));
    CHECK(place({0, -1, 0}, {}, {0.8, 0.15, 2.3}) == doctest::Approx(0.1 + 0.03 + 0.006));
  }

  TEST_CASE("a height map of one row is that of many alike rows, cut") {
    auto const ridge = [](double x, double) {
      return 0.05 * (1 - std::cos(pi * x)) + 0.01 * std::sin(2 * pi * x);
    };
    auto const line = height_map({2}, 16, RigidHeights::Rim::periodic, ridge),
               map = height_map({2, 2}, 16, RigidHeights::Rim::periodic, ridge);
    for (double const up : {1.0, -1.0}) {
      auto cut = line;
      auto whole = map;
      cut.normal = {0, up};
      whole.normal = {0, 0, up};
      prepare(cut);
      prepare(whole);
      for (double const x : {0.3, -0.45, 1.7}) {
        auto const one = seen<2>(cut, {x, up * 0.03});
        auto const other = seen<3>(whole, {x, 0.4, up * 0.03});
        CHECK(one.gap == doctest::Approx(other.gap).epsilon(1e-10));
        CHECK(one.frame(0, 0) == doctest::Approx(other.frame(0, 0)).epsilon(1e-9));
        CHECK(one.frame(1, 0) == doctest::Approx(other.frame(2, 0)).epsilon(1e-9));
      }
    }
  }

  TEST_CASE("the sharpest peak of a height map") {
    CHECK(sharpest_peak(ball(3, 40)) == doctest::Approx(3).epsilon(1e-2));
    double const by_hand = 1 / (0.05 * pi * pi);
    auto crest = [](double x, double y) { return egg_box(x - 0.015625, y - 0.015625); }; // at a point
    CHECK(sharpest_peak(height_map({2, 2}, 64, RigidHeights::Rim::periodic, crest)) ==
          doctest::Approx(by_hand).epsilon(1e-3));
    auto const valley = [](double x, double y) { return -0.1 * (x * x + y * y); };
    CHECK(std::isinf(sharpest_peak(height_map({2, 2}, 8, RigidHeights::Rim::free, valley))));
  }
}
