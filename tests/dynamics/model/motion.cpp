// Motions about an axis: the circle, its rate, and how far they lead.
#include "dynamics/model/motion.hpp"

#include <cmath>
#include <doctest/doctest.h>
#include <numbers>

using namespace stiction;

namespace {

/// From (3, 4) m about the origin, by 0.5 rad/s for 2 s, then by -1.5 rad/s for 2 s.
dynamics::Motion about_origin(int component) {
  auto const angle = std::make_shared<dynamics::Path const>(dynamics::Path{{0, 2, 4}, {0, 1, -2}});
  std::array const arm{3.0, 4.0}, along{-4.0, 3.0};
  auto const c = static_cast<std::size_t>(component);
  return {{0}, component, {{0, 4}, {0, 8}}, "", dynamics::Turn{angle, arm[c], along[c]}};
}

} // namespace

TEST_SUITE_BEGIN("dynamics");

TEST_CASE("what turns stays on its circle, which is carried along") {
  auto const x = about_origin(0), y = about_origin(1);
  for (double const t : {0.0, 0.7, 2.0, 3.1, 4.0}) {
    double const X = 3 + x.value(t) - 2 * t, Y = 4 + y.value(t) - 2 * t;
    double const angle = std::atan2(4, 3) + (t <= 2 ? 0.5 * t : 1 - 1.5 * (t - 2));
    CHECK(X == doctest::Approx(5 * std::cos(angle)).epsilon(1e-13));
    CHECK(Y == doctest::Approx(5 * std::sin(angle)).epsilon(1e-13));
  }
}

TEST_CASE("the rate of a turn is its derivative: differences come to it at their order") {
  for (int const component : {0, 1}) {
    auto const motion = about_origin(component);
    for (double const t : {0.9, 2.9}) {
      auto const error = [&](double h) {
        return std::abs((motion.value(t + h) - motion.value(t - h)) / (2 * h) - motion.rate_before(t));
      };
      CHECK(error(1e-3) < 1e-5);
      CHECK(std::log2(error(2e-2) / error(1e-2)) == doctest::Approx(2).epsilon(0.02));
    }
    CHECK(motion.rate_before(2) == doctest::Approx(motion.rate_before(2 - 1e-7)).epsilon(1e-5));
  }
}

TEST_CASE("how far and how fast a turn leads at most") {
  auto const x = about_origin(0), y = about_origin(1);
  CHECK(x.farthest() >= 8);
  for (double t = 0; t <= 4; t += 0.05) {
    CHECK(std::abs(x.value(t)) <= x.farthest());
    CHECK(std::abs(y.rate_before(t)) <= y.fastest());
  }
  CHECK(x.turn->fastest() == 7.5);
  CHECK(x.turn->farthest() == doctest::Approx(10 * std::sin(1)));
}

TEST_SUITE_END();
