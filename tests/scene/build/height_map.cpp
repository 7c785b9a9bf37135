// Height maps as obstacles of meshes: what they are sampled from, and what is said where that does not fit.
#include <doctest/doctest.h>

#include "scene/complaints.hpp"
#include "scene/scenes.hpp"

using namespace stiction;
using namespace stiction::test;

namespace {

Input foot_on_heights(Input surface) {
  Input table = foot_on_floor();
  at(table, "obstacles.floor") =
      make("obstacle", {{"shape", make("rigid.height_map", {{"surface", std::move(surface)},
                                                            {"size", values({4}, "m")},
                                                            {"points", values({32})}})}});
  return table;
}

Input rough(int seed) {
  return make("surface.rough", {{"hurst", value(0.8)},
                                {"shortest", value(0.5, "m")},
                                {"rms_slope", value(0.01)},
                                {"seed", value(seed)}});
}

contact::RigidHeights const& map_of(scene::Scene const& scene) {
  return std::get<contact::RigidHeights>(scene.model->rigids.at(0).shape);
}

/// One complaint of the scene, at the shape, that holds these words.
bool refused(Input const& table, std::string const& words) {
  auto const all = complaints(table);
  return all.size() == 1 && all[0].find("obstacles.floor.shape") != std::string::npos &&
         all[0].find(words) != std::string::npos;
}

} // namespace

TEST_SUITE("scene") {
  TEST_CASE("a height map under a mesh has the heights that a half space takes") {
    auto const scene = scene::build(foot_on_heights(rough(3)));
    halfspace::Grid grid{32, 1, 4, 1, true, true};
    halfspace::Rough waves;
    waves.hurst = 0.8;
    waves.shortest = 0.5;
    waves.rms_slope = 0.01;
    waves.seed = 3;
    Vector const wanted = halfspace::heights(waves, grid);
    auto const& given = map_of(scene).heights;
    REQUIRE(given.size() == ix(static_cast<Index>(wanted.size())));
    CHECK(Eigen::Map<Vector const>(given.data(), wanted.size()) == wanted);
    CHECK(map_of(scene::build(foot_on_heights(rough(4)))).heights != given);
    auto const profile = contact::profile(map_of(scene));
    CHECK(profile[0] == doctest::Approx(-2 + 0.0625));
    CHECK(profile[1] == doctest::Approx(-wanted[0]));
  }

  TEST_CASE("a height map under a mesh says what does not fit, once") {
    auto table = foot_on_heights(rough(1));
    at(table, "obstacles.floor.shape.points") = values({3});
    CHECK(refused(table, "points has 3; give whole numbers in [4, 2048]"));
    at(table, "obstacles.floor.shape.points") = values({4096});
    CHECK(refused(table, "points has 4096"));
    at(table, "obstacles.floor.shape.points") = values({32, 32});
    CHECK(refused(table, "points has 2 numbers; give one, {x}"));
    table = foot_on_heights(rough(1));
    at(table, "obstacles.floor.shape.size") = values({-1}, "m");
    CHECK(refused(table, "size has -1 m; give lengths > 0 m"));
    table = foot_on_heights(rough(1));
    at(table, "obstacles.floor.shape.surface.shortest") = value(0.1, "m");
    CHECK(refused(table, "surface.shortest"));
    table = foot_on_heights(make("surface.map", {{"heights", values({1, 2, 3})}}));
    CHECK(refused(table, "has 3 heights; there are 32 points (32 x 1)"));
    table = foot_on_heights(rough(1));
    remove(table, "obstacles.floor.shape.size");
    CHECK(refused(table, "size"));
    table = foot_on_heights(rough(1));
    remove(table, "obstacles.floor.shape.surface");
    CHECK(refused(table, "surface"));
  }
}
