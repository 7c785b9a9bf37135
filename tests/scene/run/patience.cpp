// Hopeless cases end at the limits of their schedule and say which it was.
#include <cmath>
#include <doctest/doctest.h>

#include "folder.hpp"
#include "scene/run/patience.hpp"
#include "scene/run/run.hpp"
#include "scene/scenes.hpp"

using namespace stiction;

namespace {

/// Pressed faster than one Newton iteration can follow, at any step that is allowed.
test::Input hopeless() {
  auto table = test::foot_on_floor();
  test::at(table, "bodies.foot.material") =
      test::make("material.neo_hookean", {{"young", test::value(1000, "Pa")}, {"poisson", test::value(0.3)}});
  test::at(table, "control") =
      test::make("control", {{"iterations", test::value(1)}, {"force_tolerance", test::value(1e-14)}});
  return table;
}

/// A column under more than it bears, E / (3 sqrt 3) if it is of St Venant and Kirchhoff: beyond t = 1 no
/// step has an answer, however small.
test::Input crushed() {
  auto table = test::foot_on_floor();
  test::at(table, "bodies.foot.material") = test::make(
      "material.st_venant_kirchhoff", {{"young", test::value(1000, "Pa")}, {"poisson", test::value(0)}});
  test::at(table, "motions") = test::list({test::fix("foot.bottom")});
  test::at(table, "loads") = test::list(
      {test::make("load.traction", {{"set", test::text("foot.top")},
                                    {"times", test::values({0, 2}, "s")},
                                    {"y", test::values({0, -2 * 1000 / (3 * std::sqrt(3.0))}, "Pa")}})});
  test::at(table, "schedule.halvings") = test::value(20);
  test::at(table, "control") = test::make("control", {{"iterations", test::value(500)}});
  test::at(table, "schedule.work") = test::value(1e-9);
  return table;
}

/// A soft block pressed on another and, in one step, far over its edge, by mortar: its points go to and fro
/// between faces for ever; linear bodies, so that nothing else ends it.
test::Input overhung(double work) {
  auto table = test::two_blocks();
  for (char const* body : {"lower", "upper"})
    test::at(table, std::string("bodies.") + body + ".material") = test::linear_elastic(1000, 0.3);
  test::at(table, "pairs.joint.discretisation") = test::text("mortar");
  test::at(table, "motions") = test::list(
      {test::fix("lower.bottom"), test::drive("upper.top", {0, 1, 2}, {0, 0, 0.9}, {0, -0.2, -0.2})});
  test::at(table, "schedule") = test::schedule({{1, 4}, {2, 1}});
  test::at(table, "schedule.halvings") = test::value(0);
  test::at(table, "schedule.work") = test::value(work);
  test::at(table, "control") = test::make("control", {{"iterations", test::value(1000)}});
  return table;
}

scene::RunResult run(test::Input const& table) {
  test::Folder const folder;
  scene::RunOptions options;
  options.out = folder / "case";
  options.case_id = "one";
  return scene::run(table, options);
}

bool says(std::string const& text, char const* part) {
  return text.find(part) != std::string::npos;
}

} // namespace

TEST_CASE("without other limits a hopeless case ends when its step has been halved so often") {
  auto const result = run(hopeless());
  CHECK(result.verdict == "not converged");
  CHECK(result.cuts == 11);
  CHECK_FALSE(says(result.reason, "schedule."));
}

TEST_CASE("a case ends after so many cuts of one step") {
  auto table = hopeless();
  test::at(table, "schedule.cuts") = test::value(4);
  auto const result = run(table);
  CHECK(result.verdict == "not converged");
  CHECK(result.cuts == 5);
  CHECK(says(result.reason, "5 attempts from t = 0 s on failed, more than schedule.cuts"));
}

TEST_CASE("a case ends when the attempts at one step have lost so many operations") {
  auto table = hopeless();
  test::at(table, "schedule.work") = test::value(1e-9);
  auto const all = run(table);
  CHECK(all.cuts == 11); // a thousand factorizations are more
  auto const result = run(crushed());
  CHECK(result.verdict == "not converged");
  CHECK(says(result.reason, "more than schedule.work"));
}

TEST_CASE("one attempt that takes more than may be lost does not end the run: six do") {
  scene::SchedulePart limits;
  limits.work = 1;
  double done = 0;
  scene::Patience patience(limits, {[&] { return done; }, [] { return 1.0; }});
  patience.begin(1);
  int failed = 0;
  for (std::string why; why.empty() && failed < 20; ++failed) {
    patience.begin_attempt();
    done += 5e9;
    CHECK_FALSE(patience.spent());
    why = patience.lost();
  }
  CHECK(failed == 7);
  patience.reached(1);
  patience.begin_attempt();
  done += 200e9; // as good as lost: so many of these are not tried
  CHECK(patience.spent());
  CHECK(says(patience.lost(), "more than schedule.work = 1 allows"));
}

TEST_CASE("a single attempt that loses too many operations is left off before its iterations end") {
  auto const result = run(overhung(1e-9));
  CAPTURE(result.reason);
  CHECK(result.verdict == "not converged");
  CHECK(result.steps == 4);
  CHECK(result.cuts == 1);
  CHECK(says(result.reason, "left off after"));
  CHECK(says(result.reason, "more than schedule.work"));
  CHECK(result.iterations < 1000);
}

TEST_CASE("an attempt that has taken more than may be lost may yet succeed, and goes on") {
  auto const result = run(overhung(0.02));
  CAPTURE(result.reason);
  CHECK(result.counters.at("work") > 2 * 0.02e9);
  CHECK_FALSE(says(result.reason, "left off"));
}

TEST_CASE("a case that is given seconds is stopped after them") {
  auto table = test::foot_on_floor();
  test::at(table, "schedule.seconds") = test::value(1e-9, "s");
  auto const result = run(table);
  CHECK(result.verdict == "stopped");
  CHECK(says(result.reason, "longer than schedule.seconds"));
  CHECK(result.steps == 0);
}
