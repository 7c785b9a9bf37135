// Prescribed tractions: they come to traction times area, shared as the cells' functions share it.
#include <doctest/doctest.h>
#include <numbers>

#include "scene/scenes.hpp"

using namespace stiction;

namespace {

/// Nodal forces along y of a traction of 1 Pa on the top of a block of 2 m by 1 m that begins at x = 1 m.
Vector lifted(char const* kinematics, char const* kind, double cells, scene::Scene& scene) {
  auto table = test::foot_on_floor();
  test::at(table, "kinematics") = test::text(kinematics);
  test::at(table, "bodies.foot") = test::block({{1, 0}, {2, 1}, {cells, 1}}, test::linear_elastic(1000, 0));
  test::at(table, "bodies.foot.mesh.kind") = test::text(kind);
  test::at(table, "motions") = test::list({test::fix("foot.bottom")});
  test::at(table, "loads") = test::list({test::make("load.traction", {{"set", test::text("foot.top")},
                                                                      {"times", test::values({0, 2}, "s")},
                                                                      {"y", test::values({1, 1}, "Pa")}})});
  scene = scene::build(table);
  REQUIRE(scene.model->loads.size() == 1);
  return scene.model->loads[0].force;
}

} // namespace

TEST_SUITE_BEGIN("scene");

TEST_CASE("a traction comes to traction times area, about an axis too, with its moment") {
  for (bool const revolved : {false, true})
    for (char const* kind : {"quad4", "quad8", "tri6"}) {
      CAPTURE(revolved);
      CAPTURE(std::string(kind));
      scene::Scene scene;
      Vector const force = lifted(revolved ? "axisymmetric" : "plane_strain", kind, 3, scene);
      double sum = 0, moment = 0;
      for (Index i = 0; i < scene.model->node_count(); ++i) {
        sum += force[2 * i + 1];
        moment += scene.model->reference(i, 0) * force[2 * i + 1];
        CHECK(force[2 * i] == 0);
      }
      double const turn = 2 * std::numbers::pi; // from x = 1 to 3
      CHECK(sum == doctest::Approx(revolved ? turn * (9 - 1) / 2 : 2));
      CHECK(moment == doctest::Approx(revolved ? turn * (27 - 1) / 3 : (9 - 1) / 2.0));
    }
}

TEST_CASE("a node between two cells bears the traction on half of each") {
  scene::Scene scene;
  Vector const force = lifted("plane_strain", "quad4", 4, scene);
  for (double const x : {1.0, 1.5, 2.0, 2.5, 3.0}) {
    Index const node = scene.nearest(*scene.nodes_of("foot.top"), {x, 1});
    CHECK(force[2 * node + 1] == doctest::Approx(x == 1 || x == 3 ? 0.25 : 0.5));
  }
}

TEST_CASE("a set fixed in named components is free in the others, and held in all where none is named true") {
  auto const held = [](std::vector<std::pair<std::string, bool>> const& named) {
    auto table = test::foot_on_floor();
    auto motion = test::make("motion.fix", {{"set", test::text("foot.top")}});
    for (auto const& [name, value] : named)
      test::at(motion, name) = test::flag(value);
    test::at(table, "motions") = test::list({motion, test::fix("foot.left")});
    std::string components;
    auto const scene = scene::build(table);
    for (auto const& other : scene.model->motions)
      if (other.set == "foot.top")
        components += "xyz"[other.component];
    return components;
  };
  CHECK(held({}) == "xy");
  CHECK(held({{"x", true}}) == "x");
  CHECK(held({{"y", true}}) == "y");
  CHECK(held({{"x", true}, {"y", true}}) == "xy");
  CHECK(held({{"x", false}}) == "y");
  CHECK(held({{"x", false}, {"y", true}}) == "y");
}

TEST_SUITE_END();
