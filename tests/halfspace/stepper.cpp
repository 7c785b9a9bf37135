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

} // namespace
