// A half space from where it starts, and bonds that part along it.
#include "halfspace/stepper.hpp"

#include <cmath>
#include <doctest/doctest.h>

namespace {

using namespace stiction;

halfspace::Model lowest_at(double height) {
  halfspace::Model model;
  model.grid = {8, 8, 1, 1, false, true};
  model.body = {1e4, 0.2, 0.1};
  model.heights = Vector::LinSpaced(64, height, height + 1e-3);
  return model;
}

TEST_CASE("what a force presses on starts where it just touches, or where it was put above") {
  for (double const height : {-3e-4, 2e-4}) {
    auto model = lowest_at(height);
    model.force = dynamics::Path{};
    auto const state = halfspace::Stepper(model).initial();
    CHECK(state.lift == doctest::Approx(std::max(0.0, -height)).epsilon(1e-12));
    CHECK(state.gap.minCoeff() == doctest::Approx(std::max(0.0, height)).scale(1e-6).epsilon(1e-12));
    model.force.reset();
    CHECK(halfspace::Stepper(model).initial().lift == 0);
  }
}

/// Under a flat strip, pressed on and drawn off, bonds part from its edges inwards, several a step.
TEST_CASE("stiff bonds part behind a front that passes many points in a step") {
  constexpr double half = 1e-4, strength = 5e4, work = 0.1; // m, Pa, J/m^2
  halfspace::Model model;
  model.grid = {128, 1, 3 * half, 1, true, false};
  model.body = {3e6, 0.5, 0};
  model.heights = Vector::Zero(128);
  for (Index i = 0; i < 128; ++i)
    model.heights[i] = std::abs(model.grid.x(i)) < half ? 0 : 1e-3;
  model.shift[2] = dynamics::Path{{0, 1, 2}, {0, -1e-6, 1.3e-5}};
  interface::Bilinear law;
  law.K = 1e4 * strength * strength / work;
  law.sigma_n = law.sigma_t = strength;
  law.G_I = law.G_II = work;
  model.law.adhesion = law;
  halfspace::Stepper stepper(model);
  auto state = stepper.initial();
  double strongest = 0;
  for (int k = 0; k < 28; ++k) {
    auto outcome = stepper.step(state, state.t < 1 ? 0.25 : 1.0 / 24);
    REQUIRE_MESSAGE(outcome.converged, outcome.reason);
    state = std::move(outcome.state);
    strongest = std::max(strongest, -state.force(Eigen::seq(0, Eigen::last, 2)).sum());
  }
  CHECK(strongest < strength * 2 * half);
  CHECK(strongest > 0.8 * strength * 2 * half);
}

/// A flat strip drawn off by a displacement, m, in so many steps: the largest pull, N/m.
double pull_of_strip(Index points, int steps) {
  constexpr double half = 3e-4, strength = 6e4, work = 0.05; // m, Pa, J/m^2
  halfspace::Model model;
  model.grid = {points, 1, 1e-3, 1, true, false};
  model.body = {2.3e6, 0.31, 0};
  model.heights = Vector::Zero(points);
  for (Index i = 0; i < points; ++i)
    model.heights[i] = std::abs(model.grid.x(i)) < half ? 0 : 5e-4;
  model.shift[2] = dynamics::Path{{0, 1, 2}, {0, -1e-7, 1.2e-5}};
  interface::Dugdale law;
  law.sigma0 = strength;
  law.h0 = work / strength;
  law.ramp = 0.2;
  model.law.adhesion = law;
  halfspace::Stepper stepper(model);
  auto state = stepper.initial();
  double strongest = 0;
  while (state.t < 2 - 1e-9) {
    double dt = state.t < 1 - 1e-9 ? 0.5 : 1.0 / steps;
    auto outcome = stepper.step(state, dt);
    for (int halved = 0; !outcome.converged && halved < 8; ++halved)
      outcome = stepper.step(state, dt /= 2);
    REQUIRE_MESSAGE(outcome.converged, outcome.reason);
    state = std::move(outcome.state);
    strongest = std::max(strongest, -state.force.sum());
  }
  return strongest;
}

/// What it bears is that of the same strip followed along the arc of its path, with which a force lets go,
/// too.
TEST_CASE("a displacement does not tear what a barrier of energy holds") {
  for (auto const& [points, bears] :
       {std::pair(192, 16.0553), std::pair(256, 15.695), std::pair(320, 15.4658)})
    for (int const steps : {40, 80, 320}) {
      CAPTURE(points);
      CAPTURE(steps);
      double const pull = pull_of_strip(points, steps), of_step = 2.06e6 * 1.21e-5 / steps; // N/m
      CHECK(pull <= bears * (1 + 1e-4));
      CHECK(pull >= 0.97 * bears - of_step);
    }
}

} // namespace
