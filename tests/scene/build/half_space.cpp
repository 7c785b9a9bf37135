// What does not go with a half space: one complaint each, with its place.
#include <doctest/doctest.h>

#include "scene/complaints.hpp"
#include "scene/half_spaces.hpp"

using namespace stiction;

namespace {

void check_refused(char const* path, test::Input value, char const* words,
                   test::Input table = test::half_space_scene()) {
  CAPTURE(path);
  test::at(table, path) = std::move(value);
  auto const told = test::complaints(table);
  REQUIRE(told.size() == 1);
  CHECK_MESSAGE(told[0].find(words) != std::string::npos, told[0]);
}

TEST_CASE("sound half spaces are built") {
  CHECK(test::complaints(test::half_space_scene()).empty());
  CHECK(test::complaints(test::half_line_scene()).empty());
}

TEST_CASE("what does not go with a half space is refused") {
  using test::value, test::values, test::text, test::make;
  check_refused("kinematics", text("axisymmetric"), "a half space wants \"three_dimensional\"");
  check_refused("bodies.other", test::block({}, test::linear_elastic(1, 0)), "1 bodies beside a half space");
  check_refused("obstacles.floor", test::floor(), "wants one stiction.obstacle.height_map");
  check_refused("pairs.second", test::pair("base.surface", "ball"), "wants one, with its height map");
  check_refused("gravity", values({0, 0, -9.8}, "m/s^2"), "leave it out");
  check_refused("scheme", make("scheme.newmark"), "has inertia");
  check_refused("solver", make("solver.gauss_seidel"), "stiction.solver.newton");
  check_refused("control", make("control"), "leave it out");
  check_refused("output.problems_every", value(1), "matrices");
  check_refused("bodies.base.points", values({16}), "has 1 numbers");
  check_refused("bodies.base.points", values({16, 4096}), "in [2, 2048]");
  check_refused("bodies.base.size", values({0.4, 0}, "m"), "lengths > 0 m");
  check_refused("bodies.base.depth", value(1, "m"), "periodic");
  check_refused("bodies.base.poisson", value(0.6), "in (-1, 0.5]");
  check_refused("obstacles.ball.young", value(1, "Pa"), "give both");
  check_refused("obstacles.ball.force", values({0, 1, 1}, "N"), "cannot both be given");
  check_refused("obstacles.ball.surface", make("surface.map", {{"heights", values({1, 2})}}),
                "has 2 heights");
  check_refused("pairs.joint.secondary", text("base.top"), "base.surface");
  check_refused("pairs.joint.primary", text("bal"), "ball");
  check_refused("pairs.joint.discretisation", text("mortar"), "is not for half spaces");
  check_refused("probes.joint.set", text("base.surface"), "is not for half spaces");
  check_refused("probes.force", make("probe.force", {{"set", text("base.surface")}}),
                "contact_line, rigid and energy");
  check_refused("probes.line", make("probe.contact_line", {{"pair", text("joint")}}),
                "is for lines, in plane strain");
  check_refused("probes.energy.audit", test::flag(true), "is not for half spaces");
}

test::Input rough(std::initializer_list<std::pair<std::string const, test::Input>> more) {
  auto table = test::make("surface.rough", {{"hurst", test::value(0.8)}, {"rms_slope", test::value(0.1)}});
  for (auto const& [key, input] : more)
    test::at(table, key) = input;
  return table;
}

TEST_CASE("rough and measured surfaces that do not fit are told at their own keys") {
  using test::value, test::text, test::make;
  auto table = test::half_space_scene();
  test::at(table, "obstacles.ball.surface") = rough({{"shortest", value(0.1, "m")}});
  CHECK(test::complaints(table).empty());
  char const* const at = "obstacles.ball.surface";
  check_refused(at, rough({{"shortest", value(0.03, "m")}}),
                "surface.shortest: is 0.03 m; points 0.025 m apart");
  check_refused(at, rough({{"shortest", value(0.1, "m")}, {"longest", value(1, "m")}}),
                "surface.longest: is 1 m");
  check_refused(at, rough({{"shortest", value(0.1, "m")}, {"rms_height", value(1, "m")}}), "leave one out");
  check_refused(at, rough({{"shortest", value(0.1, "m")}, {"seed", value(0.5)}}), "seed");
  check_refused(at, make("surface.measured", {{"file", text("/none.csv")}}),
                "surface.file: /none.csv: cannot be read");
}

TEST_CASE("a height map wants a half space, and a pull something that adheres") {
  auto table = test::half_space_scene();
  test::at(table, "bodies.base") = test::block({}, test::linear_elastic(1, 0));
  CHECK(test::complaints(table).at(0).find("is pressed onto a half space only") != std::string::npos);
  table = test::half_space_scene();
  test::remove(table, "obstacles.ball.z");
  check_refused("obstacles.ball.force", test::values({0, -1, 1}, "N"), "nothing adheres", table);
}

TEST_CASE("a periodic surface is not pushed below where it is flat") {
  auto table = test::half_space_scene();
  test::at(table, "obstacles.ball.z") = test::values({0, -0.1, 0}, "m");
  check_refused("bodies.base.boundary", test::text("periodic"), "no force is enough", table);
  test::at(table, "bodies.base.depth") = test::value(1, "m");
  test::at(table, "bodies.base.boundary") = test::text("periodic");
  CHECK(test::complaints(table).empty());
  check_refused("bodies.base.poisson", test::value(0.5), "an incompressible layer cannot be squeezed", table);
}

TEST_CASE("waves that points cannot follow, or that do not fit the period, are refused") {
  auto const wave = [](std::vector<double> const& lengths) {
    return test::make("surface.wave",
                      {{"amplitude", test::value(1e-3, "m")}, {"wavelengths", test::values(lengths, "m")}});
  };
  auto const* const at = "obstacles.ball.surface";
  check_refused(
      at, wave({0.4, 0.04}),
      "along y of 0.04 m has 1.6 points, and looks like a longer wave; give at least 23 points along y");
  auto table = test::half_space_scene();
  test::at(table, at) = wave({0.3}); // beyond a free surface's rim there is no seam
  CHECK(test::complaints(table).empty());
  test::at(table, "bodies.base.boundary") = test::text("periodic");
  check_refused(at, wave({0.3}), "goes 1.333 times into the period of 0.4 m", table);
  check_refused(at, wave({0.4, 0.2}), "goes 1.5 times into the period of 0.3 m", table);
  test::at(table, at) = wave({0.2, 0.15});
  test::at(table, "bodies.base.depth") = test::value(1, "m"); // or it would be pushed lower than flat
  CHECK(test::complaints(table).empty());
}

} // namespace
