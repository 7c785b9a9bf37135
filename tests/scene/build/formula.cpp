// Which formula a scene has, and what keeps it from any: one complaint each.
#include <doctest/doctest.h>

#include "scene/complaints.hpp"
#include "scene/formulas.hpp"

using namespace stiction;

namespace {

using test::value, test::values, test::text, test::make;

void check_refused(char const* path, test::Input part, char const* words, test::Input table) {
  test::at(table, path) = std::move(part);
  auto const told = test::complaints(table);
  CAPTURE(std::string(path));
  REQUIRE(told.size() == 1);
  CHECK_MESSAGE(told[0].find(words) != std::string::npos, told[0]);
}

std::string name_of(test::Input const& table) {
  return std::string(scene::build(table).formula->normal->name());
}

TEST_CASE("each shape and law has its formula") {
  auto sphere = test::formula_scene();
  CHECK(name_of(sphere) == "Hertz");
  CHECK(name_of(test::formula_scene(true)) == "Hertz of a line");
  CHECK(name_of(test::wave_scene()) == "Westergaard");
  auto punch = sphere;
  test::at(punch, "obstacles.ball.surface") =
      make("surface.punch", {{"radius", value(0.1, "m")}, {"clearance", value(0.1, "m")}});
  CHECK(name_of(punch) == "flat punch");
  test::at(sphere, "pairs.joint.adhesion") = test::dugdale(100, 5e-3);
  CHECK(name_of(sphere) == "Maugis");
  auto const potential = [](double delta) {
    return make("adhesion.potential", {{"w", value(0.5, "J/m^2")}, {"delta", value(delta, "m")}});
  };
  test::at(sphere, "pairs.joint.adhesion") = potential(1e-5);
  CHECK(name_of(sphere) == "JKR");
  test::at(sphere, "pairs.joint.adhesion") = potential(0.05);
  CHECK(name_of(sphere) == "Maugis");
  test::remove(sphere, "obstacles.ball.z");
  test::at(sphere, "obstacles.ball.force") = values({0, 1, 1}, "N");
  check_refused("probes.energy", make("probe.energy"), "that of a range, which it leaves out", sphere);
  test::remove(sphere, "probes.energy");
  CHECK(name_of(sphere) == "DMT");
  for (bool const wave : {false, true}) {
    auto line = wave ? test::wave_scene() : test::formula_scene(true);
    test::at(line, "pairs.joint.adhesion") = potential(1e-5);
    CHECK(name_of(line) == (wave ? "Johnson's adhesive wave" : "JKR of a line"));
  }
}

TEST_CASE("half spaces that no formula answers say why and what does") {
  auto const sphere = test::formula_scene(), line = test::formula_scene(true), wave = test::wave_scene();
  check_refused("bodies.base", test::block({}, test::linear_elastic(1, 0)),
                "which a half space under a height map", sphere);
  check_refused("pairs.joint.friction", test::coulomb(0.3), "coupling 0.571", sphere);
  check_refused("pairs.joint.friction",
                make("friction.tresca", {{"mu", value(0.3)}, {"tau_max", value(1, "Pa")}}),
                "constant coefficient", sphere);
  check_refused("pairs.joint.adhesion", test::rcc(0.5, 2e4, 0.1), "a memory, a rate", sphere);
  check_refused("bodies.base.boundary", text("periodic"), "has neighbours", sphere);
  check_refused("obstacles.ball.surface", make("surface.cylinder", {{"radius", value(1, "m")}}),
                "ends at the edge", sphere);
  check_refused("obstacles.ball.surface", make("surface.sphere", {{"radius", value(1, "m")}}),
                "is a cylinder", line);
  check_refused("obstacles.ball.surface",
                make("surface.map", {{"heights", values(std::vector<double>(192, 1e-3))}}),
                "no sphere, cylinder", sphere);
  check_refused("obstacles.ball.surface",
                make("surface.punch", {{"radius", value(0.1, "m")}, {"clearance", value(1e-3, "m")}}),
                "more than its clearance", sphere);
  check_refused("bodies.base.boundary", text("free"), "of one that is repeated", wave);
  check_refused("bodies.base.size", values({0.3}, "m"), "goes 1.5 times into the period", wave);
  check_refused("pairs.joint.adhesion", test::dugdale(10, 5e-2), "no short range", wave);
  check_refused("pairs.joint.adhesion", test::dugdale(10, 5e-2), "no short range", line);
  check_refused("probes.energy", make("probe.energy"), "with the bodies' size, as their depth does", line);
  auto deep = line;
  test::remove(deep, "obstacles.ball.force");
  check_refused("obstacles.ball.y", values({0, -1e-3, -1e-3}, "m"), "is not defined in a half plane", deep);
}

TEST_CASE("a sphere with friction is moved along under constant pressure, or has no formula") {
  auto table = test::formula_scene();
  test::at(table, "bodies.base.poisson") = value(0.5);
  test::at(table, "pairs.joint.friction") = test::coulomb(0.3);
  test::at(table, "obstacles.ball.x") = values({0, 0, 1e-3}, "m");
  for (char const* probe : {"probes.energy", "probes.middle"}) {
    auto one = table;
    test::remove(one, std::string(probe) == "probes.energy" ? "probes.middle" : "probes.energy");
    check_refused(probe, test::at(one, probe), "is not what Mindlin's formula gives of a motion along", one);
    test::remove(table, probe);
  }
  check_refused("obstacles.ball.z", values({0, -5e-3, -6e-3}, "m"), "while what presses changes", table);
  CHECK(scene::build(table).formula->along.has_value());
  check_refused("obstacles.ball.y", values({0, 0, 1e-3}, "m"), "moved along x and y", table);
  check_refused("pairs.joint.adhesion", test::dugdale(100, 5e-3), "both adhesion and friction", table);
}

TEST_CASE("a model that bodies have to be of is what they are") {
  auto table = test::half_space_scene();
  for (char const* word : {"bodies", "half_space"}) {
    test::at(table, "model") = text(word);
    CHECK(test::complaints(table).empty());
  }
  check_refused("model", text("section"), "kinematics = \"axisymmetric\"", table);
  check_refused("model", text("space"), "bodies with cells", table);
  check_refused("model", text("half_space"), "no body is one", test::foot_on_floor());
}

} // namespace
