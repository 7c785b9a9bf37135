// A half space from where it starts.
#include "halfspace/stepper.hpp"

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

} // namespace
