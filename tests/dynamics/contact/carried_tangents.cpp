// Tangents on obstacles in space are carried along, so that what they are the components of goes on past any
// normal.
#include <doctest/doctest.h>
#include <numbers>

#include "dynamics/space.hpp"

using namespace stiction;

namespace {

/// A pad pressed on a drum, or a ball, about y that then turns backwards by an angle, rad, in `steps` steps.
test::Input pad_on(char const* kind, double angle, int steps) {
  auto table = test::space();
  auto const material = test::linear_elastic(1e6, 0.3);
  test::at(table, "bodies.pad") = test::box({{-1e-3, -1e-3, 0.02}, {2e-3, 2e-3, 1e-3}, {3, 2, 2}}, material);
  auto shape = test::make(kind, {{"radius", test::value(0.02, "m")}});
  if (std::string(kind) == "rigid.cylinder")
    test::at(shape, "axis") = test::values({0, 1, 0}, "1");
  test::at(table, "obstacles.drum") = test::make("obstacle", {{"shape", shape},
                                                              {"times", test::values({0, 1, 2}, "s")},
                                                              {"angle", test::values({0, 0, -angle}, "rad")},
                                                              {"axis", test::values({0, 1, 0}, "1")}});
  test::at(table, "pairs.pad") = test::pair("pad.bottom", "drum");
  test::at(table, "motions") =
      test::list({test::drive("pad.top", {0, 1, 2}, {{{0, 0, 0}, {0, 0, 0}, {0, -5e-5, -5e-5}}})});
  test::at(table, "schedule") = test::schedule({{1, 4}, {2, steps}});
  return table;
}

test::State end_of(test::Input const& table, int steps) {
  auto const scene = scene::build(table);
  test::Stepper stepper(*scene.model);
  auto const pressed = test::march(stepper, stepper.initial(), 0.25, 4);
  return test::march(stepper, pressed, 1.0 / steps, steps);
}

} // namespace

TEST_CASE("carried tangents: bonds pull alike whatever direction the first one is given") {
  for (std::string const cells : {"hex8", "hex20", "mortar"}) {
    CAPTURE(cells);
    double first = 0;
    for (double const direction : {0.0, 85.0, -95.0, 175.0}) {
      auto table = pad_on("rigid.cylinder", 10 * std::numbers::pi / 180, 20);
      test::at(table, "pairs.pad.adhesion") = test::rcc(1e6, 1e5, 0);
      test::at(table, "pairs.pad.adhesion.beta0") = test::value(1);
      double const a = direction * std::numbers::pi / 180;
      test::at(table, "pairs.pad.direction") = test::values({std::cos(a), 0, std::sin(a)}, "1");
      if (cells == "mortar")
        test::at(table, "pairs.pad.discretisation") = test::text("mortar");
      else
        test::at(table, "bodies.pad.mesh.kind") = test::text(cells);
      double const moment = end_of(table, 20).on_rigid[0].moment.y();
      if (direction == 0) // area 4 mm^2, C_t 1e5 N/m^3, arm and way R and R a
        CHECK(std::abs(moment) ==
              doctest::Approx(4e-6 * 1e5 * 0.02 * 0.02 * 10 * std::numbers::pi / 180).epsilon(0.02));
      first = direction == 0 ? moment : first;
      CHECK(moment == doctest::Approx(first).epsilon(1e-3));
    }
  }
}

TEST_CASE("carried tangents: slip round a drum and round a ball adds up to their girth") {
  for (auto const* kind : {"rigid.cylinder", "rigid.sphere"})
    for (bool const mortar : {false, true}) {
      CAPTURE(std::string(kind));
      auto table = pad_on(kind, 2 * std::numbers::pi, 36);
      test::at(table, "pairs.pad.friction") = test::coulomb(0.3);
      if (mortar)
        test::at(table, "pairs.pad.discretisation") = test::text("mortar");
      auto const state = end_of(table, 36);
      int closed = 0;
      for (auto const& point : state.contacts[0])
        if (point.status != interface::Status::open) {
          ++closed;
          CHECK(point.path.norm() == doctest::Approx(2 * std::numbers::pi * 0.02).epsilon(5e-3));
        }
      CHECK(closed > 0);
    }
}
