// Warnings of what a scene starts from: paths that leap, heights that do not fit where they are repeated.
#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <numbers>

#include "scene/explain/explain.hpp"
#include "scene/half_spaces.hpp"

using namespace stiction;
using namespace stiction::test;

namespace {

bool warns(Input const& input, std::string const& text) {
  return std::ranges::any_of(scene::explain(input).warnings, [&](auto const& warning) {
    return warning.text.find(text) != std::string::npos;
  });
}

} // namespace

TEST_CASE("heights of a script that have a step where a periodic half space repeats them") {
  auto table = half_line_scene();
  auto const told = [&](auto const& height) {
    std::vector<double> heights;
    for (int k = 0; k < 24; ++k)
      heights.push_back(height((k + 0.5) / 24));
    at(table, "obstacles.ball.surface") = make("surface.map", {{"heights", values(heights)}});
    return warns(table, "it is not periodic");
  };
  auto const ramp = [](double x) { return 1e-3 * x; };
  auto const wave = [](double x) { return 1e-3 * std::cos(2 * std::numbers::pi * x); };
  auto const ridge = [](double x) { return x < 0.5 ? 1e-3 * x : 1e-3 * (1 - x); };
  CHECK(!told(ramp)); // beyond a free surface's rim there is none
  at(table, "bodies.base.boundary") = text("periodic");
  at(table, "bodies.base.depth") = value(1, "m");
  CHECK(told(ramp));
  CHECK(!told(wave));
  CHECK(!told(ridge));
}

TEST_CASE("a path that begins elsewhere than where its set is") {
  auto input = foot_on_floor();
  at(input, "motions") = list({drive("foot.top", {0, 2}, {0, 0}, {-0.01, -0.02})});
  CHECK(warns(input, "foot.top: its path in y begins at -10 mm where the body is at rest"));
  at(input, "motions") = list({drive("foot.top", {0, 2}, {0, 0}, {0, -0.02})});
  CHECK_FALSE(warns(input, "where the body is at rest"));
}
