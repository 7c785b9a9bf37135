// What probes sum up: means over a pair weighed with areas, the turn of an obstacle and the force on it.
#include <doctest/doctest.h>

#include "folder.hpp"
#include "record/series.hpp"
#include "scene/run.hpp"
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
