// The ledger against closed forms of quasi-static runs, and steps that are refused for what it says.
#include <doctest/doctest.h>

#include "dynamics/marching.hpp"

using namespace stiction;

namespace {

/// A bar above the floor that falls at 3 m/s; waves take 1/3 s from end to end.
test::Input falling_bar() {
  auto table = test::foot_on_floor();
  test::at(table, "bodies.foot") = test::block({{0, 0.5}, {0.5, 10}, {1, 20}}, test::linear_elastic(900, 0));
  test::at(table, "bodies.foot.velocity") = test::values({0, -3}, "m/s");
  test::at(table, "motions") = test::list({test::fix("foot.all", true, false)});
  test::at(table, "scheme") = test::make("scheme.theta_xi");
  return table;
}

/// A single light cell of great viscosity, 0.1 mm above the floor, which begins to fall.
test::Input light_and_viscous() {
  auto table = test::foot_on_floor();
  test::at(table, "bodies.foot") =
      test::block({{0, 1e-4}, {0.01, 0.01}, {1, 1}}, test::linear_elastic(1e5, 0.3), 1e-3);
  test::at(table, "bodies.foot.damping") =
      test::make("damping.kelvin_voigt",
                 {{"shear_viscosity", test::value(3, "Pa s")}, {"bulk_viscosity", test::value(3, "Pa s")}});
  test::at(table, "gravity") = test::values({0, -9.81}, "m/s^2");
  test::at(table, "motions") = test::list({});
  test::at(table, "scheme") = test::make("scheme.theta_xi");
  return table;
}

} // namespace

TEST_CASE("friction takes mu N along the path of a rigidly dragged block") {
  double const mu = 0.3, press = 1000 * 0.01;
  auto table = test::foot_on_floor();
  test::at(table, "pairs.sole.friction") = test::coulomb(mu);
  test::at(table, "motions") = test::list({test::drive("foot.all", {0, 1, 2}, {0, 0, 0.1}, {}),
                                           test::drive("foot.top", {0, 1, 2}, {}, {0, -0.01, -0.01})});
  auto const scene = scene::build(table);
  dynamics::Stepper stepper(*scene.model);
  auto const pressed = test::march(stepper, stepper.initial(), 0.25, 4);
  CHECK(pressed.ledger.friction_loss == doctest::Approx(0).epsilon(1e-12));
  auto const dragged = test::march(stepper, pressed, 0.1, 10);
  CHECK(dragged.ledger.friction_loss == doctest::Approx(mu * press * 0.1).epsilon(1e-6));
  CHECK(
      dragged.ledger.motion_work - pressed.ledger.motion_work ==
      doctest::Approx(mu * press * (0.1 - 0.5 * 0.01)).epsilon(1e-6)); // the first of ten steps began at rest
  CHECK(test::force_on(scene, dragged, "foot.all").x() == doctest::Approx(mu * press).epsilon(1e-6));
  CHECK(test::contact_force(scene, dragged).x() == doctest::Approx(-mu * press).epsilon(1e-6));
}

TEST_CASE("a floor pulled from under a held block gives the same friction loss") {
  auto table = test::foot_on_floor();
  test::at(table, "pairs.sole.friction") = test::coulomb(0.3);
  test::at(table, "obstacles.floor.times") = test::values({0, 1, 2}, "s");
  test::at(table, "obstacles.floor.x") = test::values({0, 0, -0.1}, "m");
  test::at(table, "motions") = test::list(
      {test::fix("foot.all", true, false), test::drive("foot.top", {0, 1, 2}, {}, {0, -0.01, -0.01})});
  auto const scene = scene::build(table);
  dynamics::Stepper stepper(*scene.model);
  auto const pressed = test::march(stepper, stepper.initial(), 0.25, 4);
  auto const dragged = test::march(stepper, pressed, 0.1, 10);
  CHECK(dragged.ledger.friction_loss == doctest::Approx(0.3).epsilon(1e-6));
  CHECK(dragged.ledger.motion_work - pressed.ledger.motion_work == doctest::Approx(0.285).epsilon(1e-6));
}

TEST_CASE("a slow stretch costs its strain energy, whatever its steps") {
  auto table = test::foot_on_floor();
  test::remove(table, "pairs");
  test::at(table, "motions") =
      test::list({test::fix("foot.bottom"), test::drive("foot.top", {0, 2}, {0, 0}, {0, 0.02})});
  auto const scene = scene::build(table);
  for (int const steps : {1, 5, 50}) {
    dynamics::Stepper stepper(*scene.model);
    auto const state = test::march(stepper, stepper.initial(), 1.0 / steps, steps);
    double const strain = 0.5 * 1000 * 0.01 * 0.01;
    CHECK(state.ledger.strain == doctest::Approx(strain).epsilon(1e-9));
    CHECK(state.ledger.motion_work == doctest::Approx(strain).epsilon(1e-9));
    CHECK(std::abs(state.ledger.scheme_loss()) < 1e-9 * strain);
    CHECK(test::force_on(scene, state, "foot.top").y() == doctest::Approx(10).epsilon(1e-9));
    CHECK(test::force_on(scene, state, "foot.bottom").y() == doctest::Approx(-10).epsilon(1e-9));
  }
}

TEST_CASE("gravity: a falling block turns potential into kinetic energy") {
  auto table = test::foot_on_floor();
  for (char const* part : {"pairs", "obstacles", "motions", "scheme"})
    test::remove(table, part);
  test::at(table, "gravity") = test::values({0, -10}, "m/s^2");
  test::at(table, "bodies.foot.density") = test::value(2, "kg/m^3");
  test::at(table, "bodies.foot.velocity") = test::values({3, 1}, "m/s");
  auto const scene = scene::build(table);
  dynamics::Stepper stepper(*scene.model);
  auto const state = test::march(stepper, stepper.initial(), 0.05, 20);
  double const fall = 1 - 0.5 * 10; // t = 1
  CHECK(state.u[1] == doctest::Approx(fall).epsilon(1e-9));
  CHECK(state.v[1] == doctest::Approx(-9).epsilon(1e-9));
  CHECK(state.ledger.potential == doctest::Approx(2 * 10 * fall).epsilon(1e-9));
  CHECK(state.ledger.kinetic == doctest::Approx(0.5 * 2 * (9 + 81)).epsilon(1e-9));
  CHECK(std::abs(state.ledger.scheme_loss()) < 1e-8);
}

TEST_CASE("a step whose time scheme makes more energy than there was is refused, and none that does not") {
  auto const scene = scene::build(falling_bar());
  dynamics::Stepper stepper(*scene.model);
  for (double const dt : {1.0, 10.0, 1e2, 1e4}) {
    INFO("dt = " << dt);
    auto const landed = test::march(stepper, stepper.initial(), dt, 1);
    auto const outcome = stepper.step(landed, dt);
    CHECK(outcome.verdict == dynamics::StepVerdict::unstable);
    CHECK(outcome.reason == "the time scheme made more energy than there was");
    CHECK(outcome.state.ledger.kinetic > 2 * landed.ledger.start);
  }
  for (double const dt : {0.01, 0.1, 0.2, 0.5})
    test::march(stepper, stepper.initial(), dt, 10, [](test::State const& old, test::State const& next) {
      CHECK(next.ledger.kinetic + next.ledger.strain < 2 * (old.ledger.kinetic + old.ledger.strain));
    });
}

TEST_CASE("a step with which a viscosity too stiff for the mass makes energy is refused, and its loss is "
          "none of it") {
  auto const scene = scene::build(light_and_viscous());
  dynamics::Stepper stepper(*scene.model);
  for (double const dt : {1e-4, 1e-3}) {
    INFO("dt = " << dt);
    auto const outcome = stepper.step(stepper.initial(), dt);
    CHECK(outcome.verdict == dynamics::StepVerdict::unstable);
    CHECK(outcome.reason == "the time scheme made more energy than there was");
    auto const& ledger = outcome.state.ledger;
    CHECK(ledger.damping_loss >= 0);
    CHECK(-ledger.scheme_loss() > ledger.start); // all of what was made is the scheme's
  }
  CHECK(stepper.step(stepper.initial(), 1e-6).converged());
}
