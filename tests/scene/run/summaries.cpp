// What probes sum up: means over a pair weighed with areas, the turn of an obstacle and the force on it.
#include <doctest/doctest.h>

#include "folder.hpp"
#include "record/series.hpp"
#include "scene/run/frame.hpp"
#include "scene/run/run.hpp"
#include "scene/scenes.hpp"

using namespace stiction;

namespace {

record::SeriesData run(test::Input const& table) {
  test::Folder const folder;
  scene::RunOptions options;
  options.out = folder / "case";
  options.case_id = "one";
  REQUIRE(scene::run(table, options).verdict == "finished");
  return record::read_series(folder / "case/series.h5");
}

} // namespace

TEST_CASE("the mean bond of a pair weighs its points with their areas") {
  auto table = test::foot_on_floor();
  test::at(table, "bodies.foot.mesh.grading") = test::values({4, 1});
  test::at(table, "pairs.sole.adhesion") = test::rcc(1, 1e3, 2);
  test::at(table, "pairs.sole.adhesion.beta0") = test::value(0.6);
  test::at(table, "probes.whole") = test::make("probe.contact", {{"pair", test::text("sole")}});
  CHECK(run(table).columns.at("whole/beta_mean").values.front() == doctest::Approx(0.6).epsilon(1e-12));
}

TEST_CASE("a turning obstacle tells its turn and the force on it") {
  double const turn = 0.02;
  auto table = test::foot_on_floor();
  test::at(table, "obstacles.floor.shape") =
      test::make("rigid.circle", {{"centre", test::values({0.5, -2}, "m")}, {"radius", test::value(2, "m")}});
  test::at(table, "obstacles.floor.times") = test::values({0, 1, 2}, "s");
  test::at(table, "obstacles.floor.angle") = test::values({0, 0, turn}, "rad");
  test::at(table, "pairs.sole.friction") = test::coulomb(0.3);
  test::at(table, "motions") = test::list(
      {test::fix("foot.all", true, false), test::drive("foot.top", {0, 1, 2}, {}, {0, -0.01, -0.01})});
  test::at(table, "probes.whole") = test::make("probe.contact", {{"pair", test::text("sole")}});
  test::at(table, "probes.wheel") = test::make("probe.rigid", {{"obstacle", test::text("floor")}});
  auto const series = run(table);
  auto const end = [&](char const* column) { return series.columns.at(column).values.back(); };
  CHECK(end("wheel/angle") == doctest::Approx(turn));
  CHECK(end("whole/force_y") > 0);
  for (char const* component : {"force_x", "force_y"}) {
    double const on_foot = end((std::string("whole/") + component).c_str());
    CHECK(std::abs(on_foot) > 1e-3);
    CHECK(end((std::string("wheel/") + component).c_str()) == doctest::Approx(-on_foot));
  }
}

TEST_CASE("of a pair's mortar only what faces the other side is closed") {
  auto table = test::two_blocks();
  test::at(table, "bodies.lower") = test::block({{-0.4, -1}, {1, 1}, {4, 4}}, test::linear_elastic(1000, 0));
  test::at(table, "pairs.joint.discretisation") = test::text("mortar");
  test::at(table, "motions") = test::list(
      {test::fix("lower.bottom"), test::drive("upper.top", {0, 1, 2}, {0, 0, 0}, {0, -0.01, -0.01})});
  test::at(table, "probes.whole") = test::make("probe.contact", {{"pair", test::text("joint")}});
  CHECK(run(table).columns.at("whole/closed_area").values.back() == doctest::Approx(0.6).epsilon(0.02));
}

TEST_CASE("friction and bonding are told apart, and a point's slip is that since the start") {
  auto table = test::foot_on_floor();
  test::at(table, "pairs.sole.friction") = test::coulomb(0.3);
  test::at(table, "probes.energy") = test::make("probe.energy");
  test::at(table, "probes.tip") = test::make(
      "probe.contact_point", {{"pair", test::text("sole")}, {"near", test::values({0.5, 0}, "m")}});
  auto const series = run(table);
  CHECK(series.columns.at("energy/friction_loss").values.back() > 0.1);
  CHECK(series.columns.at("energy/bonding_loss").values.back() == 0);
  CHECK(std::abs(series.columns.at("tip/slip").values.back()) > 0.08);
}

TEST_CASE("a frame holds displacements and velocities, each its own") {
  auto table = test::foot_on_floor();
  test::at(table, "scheme") = test::make("scheme.theta_xi");
  test::at(table, "bodies.foot.velocity") = test::values({3, 0}, "m/s");
  test::at(table, "motions") = test::list({});
  auto const scene = scene::build(table);
  auto const frame = scene::frame_of(scene, dynamics::Stepper(*scene.model).initial());
  for (auto const& array : frame.point_arrays)
    if (array.name == "displacement" || array.name == "velocity")
      for (std::size_t k = 0; k < array.values.size(); ++k)
        CHECK(array.values[k] == (array.name == "velocity" && k % 3 == 0 ? 3 : 0));
}
