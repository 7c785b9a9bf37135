// Formulas against published numbers and their limits.
#include <cmath>
#include <doctest/doctest.h>
#include <numbers>

#include "formula/ball.hpp"
#include "formula/follow.hpp"
#include "formula/line.hpp"
#include "formula/mindlin.hpp"
#include "formula/punch.hpp"
#include "formula/sphere.hpp"
#include "formula/wave.hpp"

namespace {

using namespace stiction::formula;
using std::numbers::pi;

using stiction::test::ball, stiction::test::near, stiction::test::traction;

constexpr double E = stiction::test::ball_modulus, R = stiction::test::ball_radius,
                 w = stiction::test::ball_work;

} // namespace

TEST_CASE("JKR pulls off at 3/2 pi w R, DMT at 2 pi w R, a line at its own, Hertz at nothing") {
  CHECK(largest_pull(Jkr(ball, w)).force == near(-1.5 * pi * w * R, 1e-12));
  CHECK(largest_pull(Jkr(ball, w)).area == near(pi * std::pow(9 * pi * w * R * R / (8 * E), 2.0 / 3), 1e-5));
  CHECK(largest_pull(Dmt(ball, w)).force == near(-2 * pi * w * R, 1e-12));
  CHECK(largest_pull(Line(E, R, w)).force == near(-3 * std::cbrt(pi * E * w * w * R / 16), 1e-12));
  CHECK(largest_pull(Hertz(ball)).force == 0);
  CHECK(largest_pull(Wave({E, 1e-5, 1e-3, 1e-3, 0}, 0)).force == 0);
}

TEST_CASE("waves that touch in part let go at the least they bear below that, whatever full contact does") {
  double const L = 1e-3, D = 1e-5;
  Wave const waves({E, D, L, L, 0}, 1e-3 * w);
  CHECK(largest_pull(waves).force < -10); // adhesion without a range holds where all touches
  double least = 0;
  for (int k = 0; k <= 100000; ++k)
    least = std::min(least, waves.at(0.5e-5 * k).force);
  CHECK(largest_pull(waves, 0.5).force == near(least, 1e-7));
  Line const crest(E, L * L / (4 * pi * pi * D),
                   1e-3 * w); // of which each wave is one while contacts are short
  CHECK(largest_pull(waves, 0.5).force == near(largest_pull(crest).force, 1e-3));
}

TEST_CASE("Maugis' pull-off has the published numbers and goes over into DMT and JKR") {
  auto const over = [](double lambda) {
    return -largest_pull(Maugis(ball, w, traction(lambda))).force / (pi * w * R);
  };
  CHECK(over(0.5) == near(1.718, 3e-4));
  CHECK(over(1) == near(1.601, 3e-4));
  double const soft = 2 - over(1e-3), softer = 2 - over(2.5e-4);
  CHECK(soft < 2e-2);
  CHECK(soft / softer > 2);
  CHECK(std::abs(over(100) - 1.5) < 1e-3);
  CHECK(over(10) > over(100));
  CHECK(Maugis(ball, w, traction(0.7)).lambda() == near(0.7, 1e-12));
}

TEST_CASE(
    "Maugis' states before the sphere touches go over into those where it does, and start at the range") {
  for (double const lambda : {0.05, 0.5, 3.0}) {
    Maugis const maugis(ball, w, traction(lambda));
    auto const before = maugis.at(1), after = maugis.at(1 + 1e-9);
    CHECK(after.depth == near(before.depth, 1e-6));
    CHECK(after.force == near(before.force, 1e-6));
    CHECK(maugis.at(0).depth == near(-w / traction(lambda), 1e-12));
    CHECK(maugis.at(0).force == 0);
  }
  auto const jkr = Jkr(ball, w).at(1.3);
  Maugis const steep(ball, w, traction(2000));
  Follower steeply(steep, Drive::force);
  REQUIRE(steeply.follow(0));
  auto const there = steeply.follow(jkr.force);
  REQUIRE(there);
  CHECK(there->depth == near(jkr.depth, 2e-3));
  CHECK(there->area == near(jkr.area, 2e-3));
  CHECK(there->peak == near(jkr.peak, 2e-3));
}

TEST_CASE("the energy of a punch and the pressure of a sphere are those of Boussinesq and Hertz") {
  Punch const punch(E, R);
  auto const at = punch.at(0.01);
  CHECK(at.force == near(2 * E * R * 0.01 * R, 1e-12));
  CHECK(at.depth == near(0.01 * R, 1e-12));
  CHECK_FALSE(punch.gives().peak);
  auto const sphere = Hertz(ball).at(0.1);
  CHECK(sphere.peak == near(1.5 * sphere.force / sphere.area, 1e-12));
  Line const cylinder(E, R, 0);
  auto const line = cylinder.at(0.1);
  CHECK(line.peak == near(4 / pi * line.force / line.area, 1e-12));
  CHECK_FALSE(cylinder.gives().depth);
}

TEST_CASE(
    "a wave touches everywhere from Westergaard's pressure on, and one that adheres is never parted again") {
  Waves const waves{E, 1e-5, 1e-3, 4e-3, 2e-12};
  Wave const dry(waves, 0);
  double const most = pi * E * 1e-5 / 1e-3;
  CHECK(dry.at(1).force == near(most * 4e-3, 1e-12));
  CHECK(dry.at(1).depth == near(1e-5 + 2e-12 * most, 1e-12));
  Follower by_force(dry, Drive::force);
  CHECK(by_force.follow(0.25 * most * 4e-3)->area == near(4e-3 / 3, 1e-12));
  CHECK(by_force.follow(1.5 * most * 4e-3)->area == near(4e-3, 1e-12));
  CHECK(by_force.follow(1.5 * most * 4e-3)->peak == near(2.5 * most, 1e-12));
  Wave const sticky(waves, 0.002);
  Follower down(sticky, Drive::force);
  auto const first = down.follow(0);
  REQUIRE(first);
  CHECK(first->area < 4e-3);
  CHECK(first->area > 0);
  CHECK(down.follow(2 * most * 4e-3)->area == near(4e-3, 1e-12));
  auto const pulled = down.follow(-50 * most * 4e-3);
  CHECK(pulled->area == near(4e-3, 1e-12));
  CHECK(pulled->force == near(-50 * most * 4e-3, 1e-9));
}

TEST_CASE(
    "a follower jumps into contact where it begins and off where it ends, and back along the same states") {
  Jkr const jkr(ball, w);
  Follower follower(jkr, Drive::depth);
  double const unit = std::cbrt(pi * pi * w * w * R / (16.0 / 9 * E * E)); // Maugis' of depth
  CHECK(follower.follow(-1e-3 * unit)->area == 0);
  auto const jumped = follower.follow(0);
  double const zero = std::cbrt(2 * pi * w * R * R / E); // a where d = 0: a^2 / R = sqrt(2 pi w a / E*)
  CHECK(jumped->area == near(pi * zero * zero, 1e-10));
  double const fold = -0.75 * std::cbrt(pi * pi * w * w * R / (E * E)); // where d turns round
  CHECK(follower.follow(0.999 * fold)->area > 0);
  CHECK(follower.follow(1.001 * fold)->area == 0);
  CHECK(follower.follow(1.001 * fold)->force == 0);
  CHECK(follower.follow(-0.1 * unit)->area == 0);
  Follower forced(jkr, Drive::force);
  CHECK(forced.follow(0)->area == near(pi * std::pow(4.5 * pi * w * R * R / E, 2.0 / 3), 1e-10));
  CHECK(forced.follow(-0.999 * 1.5 * pi * w * R).has_value());
  CHECK_FALSE(forced.follow(-1.001 * 1.5 * pi * w * R).has_value());
  Hertz const hertz(ball);
  Follower dry(hertz, Drive::depth);
  CHECK(dry.follow(0)->force == 0);
  CHECK(dry.follow(1e-4 * R)->area == near(pi * 1e-4 * R * R, 1e-12));
  CHECK(dry.follow(-1e-4 * R)->depth == -1e-4 * R);
}

TEST_CASE("a sphere moved along slips from the edge, loses what Mindlin and Deresiewicz say, and slides in "
          "the end") {
  constexpr double mu = 0.4, P = 2, a = 1e-4, yield = 1.5 / 1e6;
  double const range = 3 * mu * P * yield / (16 * a);
  Mindlin mindlin(yield, mu);
  CHECK(mindlin.move(1e-6 * range, P, a) == near(8 * a / yield * 1e-6 * range, 1e-6));
  CHECK(mindlin.move(2 * range, P, a) == near(mu * P, 1e-12));
  Mindlin loop(yield, mu);
  double const most = 0.5 * range, q = 1 - std::pow(0.5, 1.5);
  double loss = 0, before = loop.move(most, P, a), u = most;
  CHECK(before == near(mu * P * q, 1e-12));
  constexpr int steps = 4000;
  for (int k = 1; k <= 2 * steps; ++k) {
    double const to = most * (k <= steps ? 1 - 2.0 * k / steps : 2.0 * (k - steps) / steps - 1);
    double const now = loop.move(to, P, a);
    loss += 0.5 * (before + now) * (to - u);
    before = now;
    u = to;
    if (k == steps)
      CHECK(now == near(-mu * P * q, 1e-12));
  }
  double const shape = 1 - std::pow(1 - q, 5.0 / 3) - 5 * q / 6 * (1 + std::pow(1 - q, 2.0 / 3));
  CHECK(loss == near(0.9 * mu * mu * P * P / a * yield * shape, 1e-5));
  CHECK(loop.move(0.7 * range, P, a) == near(mu * P * (1 - std::pow(0.3, 1.5)), 1e-12));
}
