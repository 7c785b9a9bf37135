// Sliding over a dent in space by steps of several facets: Newton's method and friction.
#include "dynamics/space.hpp"

using namespace stiction;
using test::Vec3;

namespace {

/// A ball pressed into a softer slab, then drawn 3 facets along x and 3 along y; both linear.
test::Input ball_on_slab() {
  auto mesh = test::make("mesh.half_ball", {{"centre", test::values({-0.3, -0.3, 1}, "m")},
                                            {"radius", test::value(1, "m")},
                                            {"part", test::text("full")},
                                            {"fine", test::values({0.4, 0.4}, "m")},
                                            {"fine_size", test::value(0.19, "m")},
                                            {"coarse_size", test::value(0.8, "m")}});
  auto table = test::make("scene");
  test::at(table, "kinematics") = test::text("three_dimensional");
  test::at(table, "bodies.ball") = test::make("body", {{"mesh", std::move(mesh)},
                                                       {"material", test::linear_elastic(1e4, 0.3)},
                                                       {"density", test::value(1, "kg/m^3")}});
  test::at(table, "bodies.slab") =
      test::box({{-1.1, -1.1, -0.5}, {2.2, 2.2, 0.5}, {11, 11, 2}}, test::linear_elastic(1e3, 0.3));
  test::at(table, "pairs.iron") = test::pair("ball.cap", "slab.top");
  test::at(table, "pairs.iron.friction") = test::coulomb(0.3);
  test::at(table, "motions") =
      test::list({test::fix("slab.bottom"),
                  test::drive("ball.flat", {0, 1, 2, 3},
                              {{{0, 0, 0.6, 0.6}, {0, 0, 0, 0.6}, {0, -0.15, -0.15, -0.15}}})});
  test::at(table, "scheme") = test::quasi_static();
  test::at(table, "schedule") = test::schedule({{3, 1}});
  return table;
}

} // namespace

TEST_CASE("in space a ball slides over its dent by steps of three facets in a few iterations") {
  auto const scene = scene::build(ball_on_slab());
  dynamics::Stepper stepper(*scene.model);
  auto state = test::march(stepper, stepper.initial(), 0.25, 4);
  test::State last;
  for (int const leg : {0, 1}) {
    auto outcome = stepper.step(state, 1);
    REQUIRE(outcome.converged());
    last = state;
    CAPTURE(leg);
    CHECK(outcome.iterations <= 7); // 8 with the rows of the forces alone, 13 without the turn of normals
    state = outcome.state;
  }
  // friction is against the way that was gone in the step, and is paid for along it
  double loss = 0;
  int slipping = 0;
  for (std::size_t i = 0; i < state.contacts[0].size(); ++i) {
    auto const& point = state.contacts[0][i];
    auto const& before = last.contacts[0][i];
    if (point.status != interface::Status::slip)
      continue;
    ++slipping;
    bool const slipped = before.status == interface::Status::slip;
    double const size = point.dry.tail<2>().norm(), size_before = before.dry.tail<2>().norm();
    loss += point.area * point.slip.norm() * (slipped ? 0.5 * (size + size_before) : size);
    CHECK(point.slip.norm() > 0.4); // two facets
    CHECK((point.dry.tail<2>() + 0.3 * point.dry[0] * point.slip.normalized()).norm() < 1e-6 * point.dry[0]);
  }
  CHECK(slipping > 10);
  CHECK(state.ledger.friction_loss - last.ledger.friction_loss == doctest::Approx(loss));
  Vec3 const force = test::contact_on(scene, state);
  CHECK(force.z() > 1);
  CHECK(force.y() < -0.28 * force.z());
}
