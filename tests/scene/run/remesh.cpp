// Meshes made anew: the target is met, where the stress asks for it, and only with meshes that gmsh makes.
#include "scene/run/remesh.hpp"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <numbers>

#include "folder.hpp"
#include "mesh/gmsh/mesher_process.hpp"
#include "scene/run/run.hpp"
#include "scene/scenes.hpp"

using namespace stiction;

namespace {

test::Input edge(double x, double y, std::string const& name) {
  return test::make("edge", {{"to", test::values({x, y}, "m")}, {"name", test::text(name)}});
}

/// The foot stands fixed and its top goes sideways: the corners below are bent.
test::Input bent(double target) {
  auto table = test::foot_on_floor();
  for (char const* part : {"pairs", "obstacles"})
    test::remove(table, part);
  test::at(table, "bodies.foot.mesh") =
      test::make("mesh.gmsh", {{"start", test::values({0, 0}, "m")},
                               {"size", test::value(0.25, "m")},
                               {"edges", test::list({edge(1, 0, "bottom"), edge(1, 1, "right"),
                                                     edge(0, 1, "top"), edge(0, 0, "left")})}});
  test::at(table, "bodies.foot.remesh") =
      test::make("remesh", {{"target", test::value(target)}, {"smallest", test::value(0.01, "m")}});
  test::at(table, "motions") =
      test::list({test::fix("foot.bottom"), test::drive("foot.top", {0, 1}, {0, 0.01}, {0, 0})});
  test::at(table, "schedule") = test::schedule({{1, 1}});
  return table;
}

scene::RunResult run(test::Input const& table) {
  test::Folder const folder;
  scene::RunOptions options;
  options.out = folder / "case";
  options.case_id = "one";
  return scene::run(table, options);
}

} // namespace

TEST_CASE("a mesh is made anew until the error of its stress is as small as asked") {
  if (mesh::find_mesher().empty()) {
    MESSAGE("the mesher was not built: nothing tested");
    return;
  }
  auto const loose = run(bent(0.9)), tight = run(bent(0.12));
  REQUIRE(tight.verdict == "finished");
  CHECK(loose.counters.at("mesh_passes") == 1);
  CHECK(tight.counters.at("mesh_passes") > 1);
  CHECK(loose.counters.at("mesh_error") > 0.12);
  CHECK(tight.counters.at("mesh_error") <= 0.12);
  CHECK(tight.remarks.empty());
  CHECK(tight.counters.at("cells") > loose.counters.at("cells"));
  CHECK(tight.counters.at("cells_evaluated_in_all_passes") > tight.counters.at("cells_evaluated"));
}

TEST_CASE("a mesh that is made anew has the same relief") {
  if (mesh::find_mesher().empty()) {
    MESSAGE("the mesher was not built: nothing tested");
    return;
  }
  auto table = bent(0.12);
  test::at(table, "bodies.foot.relief") = test::make(
      "relief", {{"set", test::text("right")},
                 {"surface", test::make("surface.wave", {{"amplitude", test::value(0.02, "m")},
                                                         {"wavelengths", test::values({1}, "m")}})},
                 {"size", test::values({1}, "m")},
                 {"points", test::values({64})}});
  auto const result = run(table);
  REQUIRE(result.verdict == "finished");
  CHECK(result.counters.at("mesh_passes") > 1);
  CHECK(result.counters.at("mesh_error") <= 0.12);
  auto const made = scene::build(scene::with_sizes(table, {{"foot", {0.5, 0.5, 0.05}}}));
  auto const& mesh = made.model->bodies.at(0)->mesh;
  CHECK(mesh.node_count() > scene::build(table).model->bodies.at(0)->mesh.node_count());
  for (Index const node : mesh.sets.at("right").nodes) {
    double const along = mesh.nodes(node, 1) - 0.5;
    CHECK(mesh.nodes(node, 0) ==
          doctest::Approx(1 - 0.02 * (1 - std::cos(2 * std::numbers::pi * along))).epsilon(1e-5));
  }
}

TEST_CASE("a mesh stays as fine as the first half of a run needs it") {
  if (mesh::find_mesher().empty()) {
    MESSAGE("the mesher was not built: nothing tested");
    return;
  }
  auto table = bent(0.15);
  test::at(table, "motions") = test::list( // sheared, then pressed evenly
      {test::fix("foot.bottom"), test::drive("foot.top", {0, 1, 2}, {0, 0.01, 0}, {0, 0, -0.01})});
  test::at(table, "schedule") = test::schedule({{1, 1}, {2, 1}});
  auto const result = run(table);
  REQUIRE(result.verdict == "finished");
  CHECK(result.counters.at("mesh_passes") > 1);
  CHECK(result.counters.at("mesh_error") <= 0.15);
  CHECK(result.remarks.empty());
}

TEST_CASE("a target that no allowed mesh meets is told, with what would help") {
  if (mesh::find_mesher().empty()) {
    MESSAGE("the mesher was not built: nothing tested");
    return;
  }
  auto table = bent(0.01);
  test::at(table, "bodies.foot.remesh.passes") = test::value(2);
  auto const result = run(table);
  CHECK(result.verdict == "finished");
  CHECK(result.counters.at("mesh_passes") == 2);
  REQUIRE(result.remarks.size() == 1);
  CHECK(result.remarks[0].find("body 'foot': the error of the stress is") != std::string::npos);
  CHECK(result.remarks[0].find("above the target 0.01; allow more passes") != std::string::npos);
}

TEST_CASE("a slender body gets no smaller cells than its mesher takes") {
  if (mesh::find_mesher().empty()) {
    MESSAGE("the mesher was not built: nothing tested");
    return;
  }
  auto table = bent(0.001);
  test::at(table, "bodies.foot.mesh.edges") =
      test::list({edge(200, 0, "bottom"), edge(200, 1, "right"), edge(0, 1, "top"), edge(0, 0, "left")});
  test::at(table, "bodies.foot.remesh") =
      test::make("remesh", {{"target", test::value(0.001)}, {"passes", test::value(2)}}); // a third of 0.25 m
  auto const result = run(table);
  CHECK(result.verdict == "finished");
  CHECK(result.counters.at("mesh_passes") == 2);
}

TEST_CASE("cells too large for their bonds are told, each pair by its own law") {
  if (mesh::find_mesher().empty()) {
    MESSAGE("the mesher was not built: nothing tested");
    return;
  }
  auto table = bent(0.9); // E* = 1000 Pa, cells of 0.25 m
  test::at(table, "bodies.foot.remesh.passes") = test::value(1);
  test::at(table, "bodies.foot.remesh.cohesive_cells") = test::value(3);
  test::at(table, "obstacles.floor") = test::floor();
  test::at(table, "obstacles.wall.shape") = test::make("rigid.plane", {{"normal", test::values({1, 0})}});
  test::at(table, "pairs.a") = test::pair("foot.bottom", "floor");
  test::at(table, "pairs.b") = test::pair("foot.left", "wall");
  auto const remarks = [&](double below, double beside) {
    test::at(table, "pairs.a.adhesion") = test::rcc(1, below, 1);
    test::at(table, "pairs.b.adhesion") = test::rcc(1, beside, 1);
    for (char const* pair : {"a", "b"})
      test::at(table, std::string("pairs.") + pair + ".adhesion.beta0") = test::value(0.5);
    auto const result = run(table);
    CHECK(result.verdict == "finished");
    return result.remarks;
  };
  auto const told = [](std::vector<std::string> const& texts) {
    return std::ranges::any_of(texts, [](auto const& text) {
      return text.find("body 'foot': bonded cells are") != std::string::npos;
    });
  };
  CHECK_FALSE(told(remarks(500, 500)));
  CHECK(told(remarks(4000, 500)));
  CHECK(told(remarks(500, 4000)));
}

TEST_CASE("only a mesh that gmsh makes from outlines can be made anew") {
  auto table = test::foot_on_floor();
  test::at(table, "bodies.foot.remesh") = test::make("remesh");
  CHECK_THROWS_WITH_AS(scene::validate(table), doctest::Contains("mesh.gmsh"), core::InputError);
}
