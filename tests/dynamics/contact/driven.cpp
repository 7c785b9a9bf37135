// Models without a free unknown: the points of a law test, and cells whose every node is given.
#include <doctest/doctest.h>

#include "dynamics/marching.hpp"

using namespace stiction;

namespace {

/// One cell on the floor, bonded, every node lifted by `height` over a second.
test::Input lifted(double height) {
  auto table = test::foot_on_floor();
  test::at(table, "bodies.foot") = test::block({{0, 0}, {1, 1}, {1, 1}}, test::linear_elastic(1000, 0));
  auto adhesion = test::rcc(2, 200, 0); // sigma0 = 20 Pa, u0 = 0.1 m
  test::at(adhesion, "beta0") = test::value(1);
  test::at(table, "pairs.sole.adhesion") = std::move(adhesion);
  test::at(table, "motions") =
      test::list({test::drive("foot.top", {0, 1, 2}, {0, 0, 0}, {0, height, height}),
                  test::drive("foot.bottom", {0, 1, 2}, {0, 0, 0}, {0, height, height})});
  return table;
}

} // namespace

TEST_CASE("driven nodes alone show the law of their bonds") {
  for (auto const* solver : {"solver.newton", "solver.uzawa", "solver.gauss_seidel"}) {
    auto table = lifted(0.2);
    test::at(table, "solver") = test::make(solver);
    auto const scene = scene::build(table);
    dynamics::Stepper stepper(*scene.model);
    auto const half = test::march(stepper, stepper.initial(), 0.25, 1);
    CHECK(test::contact_force(scene, half).y() == doctest::Approx(-10).epsilon(1e-12)); // C x, x = u0/2
    auto const end = test::march(stepper, half, 0.25, 3);
    CHECK(test::contact_force(scene, end).y() ==
          doctest::Approx(-20.0 / 8).epsilon(1e-12)); // sigma0/s^3, s = 2
  }
}

TEST_CASE("driven nodes pressed into an obstacle have no answer and say so") {
  auto const scene = scene::build(lifted(-0.1));
  dynamics::Stepper stepper(*scene.model);
  auto const outcome = stepper.step(stepper.initial(), 1);
  CHECK(outcome.verdict == dynamics::StepVerdict::contact_failed);
  CHECK(outcome.reason.find("pivoting shows that its problem, linear about the last forces, has no answer") !=
        std::string::npos);
  CHECK(outcome.reason.find("nothing can give way") != std::string::npos);
}
