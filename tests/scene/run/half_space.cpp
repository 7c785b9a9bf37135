// Runs of half spaces: known answers, energies, and the same bits however they are run.
#include "scene/half_spaces.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <doctest/doctest.h>
#include <limits>
#include <numbers>
#include <tuple>

#include "folder.hpp"
#include "record/series.hpp"
#include "scene/explain/explain.hpp"
#include "scene/explain/preview.hpp"
#include "scene/random_scenes.hpp"
#include "scene/run/manifest.hpp"
#include "scene/run/run.hpp"
#include "threads.hpp"

using namespace stiction;

namespace {

struct Case {
  test::Folder folder;
  scene::RunResult run(test::Input const& table, long stop_after = 0, int threads = 1) const {
    scene::RunOptions options;
    options.out = folder / "case";
    options.stop_after = stop_after;
    options.threads = threads;
    options.keeping.file = folder / "checkpoint";
    options.keeping.owner = {"p", "s"};
    auto result = scene::run(table, options);
    core::use_threads(1);
    return result;
  }
  [[nodiscard]] record::SeriesData series() const { return record::read_series(folder / "case/series.h5"); }
};

record::SeriesData series_of(test::Input const& table) {
  Case const one;
  auto const result = one.run(table);
  CHECK_MESSAGE(result.verdict == "finished", result.reason);
  return one.series();
}

double last(record::SeriesData const& series, std::string const& column) {
  return series.columns.at(column).values.back();
}

void check_same(record::SeriesData const& a, record::SeriesData const& b) {
  REQUIRE(a.columns.size() == b.columns.size());
  for (auto const& [name, column] : a.columns) {
    CAPTURE(name);
    auto const& other = b.columns.at(name).values;
    REQUIRE(column.values.size() == other.size());
    CHECK(std::memcmp(column.values.data(), other.data(), other.size() * sizeof(double)) == 0);
  }
}

test::Input with(test::Input table, test::Input friction, test::Input adhesion) {
  if (!friction.tag.empty())
    test::at(table, "pairs.joint.friction") = std::move(friction);
  if (!adhesion.tag.empty())
    test::at(table, "pairs.joint.adhesion") = std::move(adhesion);
  return table;
}

TEST_CASE("the work on a half space without friction is all stored") {
  for (auto const& table : {test::half_space_scene(), test::half_line_scene()}) {
    auto fine = table;
    test::at(fine, "schedule") = test::schedule({{1, 80}, {2, 1}});
    auto const series = series_of(fine);
    double const work = last(series, "energy/motion_work");
    CHECK(last(series, "energy/strain") == doctest::Approx(work).epsilon(2e-3));
    CHECK(last(series, "energy/strain") + last(series, "energy/scheme_loss") ==
          doctest::Approx(work).epsilon(1e-12));
  }
}

TEST_CASE("pressures of a half space are told by their root mean square about the mean") {
  auto const series = series_of(test::half_line_scene());
  auto const& all = series.columns.at("line/pressure").values;
  auto const points = Eigen::Map<Vector const>(all.data() + all.size() - 24, 24);
  double const mean = points.mean();
  REQUIRE(mean > 0);
  CHECK(last(series, "joint/pressure_rms") ==
        doctest::Approx(std::sqrt((points.array() - mean).square().mean())).epsilon(1e-12));
}

TEST_CASE("a force sinks a sphere into a half space as deep as that depth takes force") {
  auto table = test::half_space_scene();
  double const force = last(series_of(table), "ball/force_z");
  test::at(table, "obstacles.ball.force") = test::values({0, force, force}, "N");
  test::remove(table, "obstacles.ball.z");
  auto const series = series_of(table);
  CHECK(last(series, "ball/u_z") == doctest::Approx(-5e-3).epsilon(1e-8));
  CHECK(last(series, "joint/force_z") == doctest::Approx(-force).epsilon(1e-9));
  CHECK(last(series, "energy/load_work") > 0);
}

TEST_CASE("a half space of two elastic sides is that of their common modulus") {
  auto both = test::half_space_scene(), one = both;
  for (char const* key : {"bodies.base", "obstacles.ball"}) {
    test::at(both, std::string(key) + ".young") = test::value(2e4, "Pa");
    test::at(both, std::string(key) + ".poisson") = test::value(0.3);
  }
  CHECK(last(series_of(both), "ball/force_z") ==
        doctest::Approx(last(series_of(one), "ball/force_z")).epsilon(1e-9));
}

TEST_CASE("what slides on a half space loses what friction takes, and no more than that") {
  auto const table = with(test::half_line_scene(), test::coulomb(0.2), {});
  auto fine = table;
  test::at(fine, "schedule") = test::schedule({{1, 40}, {2, 400}});
  test::at(fine, "obstacles.ball.x") = test::values({0, 0, 0.05}, "m");
  auto const series = series_of(fine);
  double const normal = -last(series, "joint/force_y");
  CHECK(last(series, "joint/force_x") == doctest::Approx(0.2 * normal).epsilon(1e-8));
  CHECK(last(series, "joint/stick") == 0);
  double const loss = last(series, "energy/friction_loss");
  CHECK(loss > 0.8 * 0.2 * normal * 0.05);
  CHECK(std::abs(last(series, "energy/scheme_loss")) < 2e-3 * loss);
}

TEST_CASE("bonds of a half space form where it touches, in the time of the law, and hold it") {
  auto law = test::rcc(0.5, 2e6, 0.1);
  test::at(law, "beta0") = test::value(0);
  auto table = with(test::half_space_scene(), {}, law);
  test::at(table, "schedule") = test::schedule({{1, 10}, {2, 20}});
  test::at(table, "obstacles.ball.x") = test::values({0, 0, 0}, "m");
  auto const series = series_of(table);
  CHECK(last(series, "joint/beta_max") > 0.9);
  CHECK(last(series, "joint/bonds") ==
        doctest::Approx(last(series, "joint/closed_area") / (0.4 * 0.3 / 192)));
  test::at(table, "obstacles.ball.times") = test::values({0, 1, 2, 2.2}, "s");
  test::at(table, "obstacles.ball.x") = test::values({0, 0, 0, 0}, "m");
  test::at(table, "obstacles.ball.z") = test::values({0, -5e-3, -5e-3, 5e-4}, "m");
  test::at(table, "schedule") = test::schedule({{1, 10}, {2, 20}, {2.2, 20}});
  CHECK(last(series_of(table), "ball/force_z") < 0);
}

/// A ball that bonds and is lifted off, in steps that follow from the error of the bonds.
test::Input paced(double tolerance) {
  auto law = test::rcc(0.5, 2e6, 0.1);
  test::at(law, "beta0") = test::value(0);
  auto table = with(test::half_space_scene(), {}, law);
  test::at(table, "obstacles.ball.x") = test::values({0, 0, 0}, "m");
  test::at(table, "obstacles.ball.z") = test::values({0, -5e-3, -4e-3}, "m");
  test::at(table, "schedule") = test::schedule({{1, 10}, {2, 20}});
  test::at(table, "schedule.accuracy") = test::make("accuracy", {{"tolerance", test::value(tolerance)},
                                                                 {"beta_change", test::value(0.5)},
                                                                 {"smallest", test::value(1e-7, "s")}});
  return table;
}

std::vector<test::Input> cases() {
  return {with(test::half_space_scene(), {}, {}),
          with(test::half_space_scene(), test::coulomb(0.3), test::rcc(0.5, 2e4, 0.1)),
          with(test::half_line_scene(), test::coulomb(0.3), {}), paced(1e-2)};
}

TEST_CASE("steps of a half space follow from the error of its bonds where an accuracy is asked for") {
  auto const end = [](double tolerance) {
    Case const one;
    auto const result = one.run(paced(tolerance));
    CHECK_MESSAGE(result.verdict == "finished", result.reason);
    auto const series = one.series();
    CHECK(std::ranges::max(series.columns.at("step/error_beta").values) <= tolerance);
    CHECK(std::ranges::max(series.columns.at("step/beta_change").values) <= 0.5);
    CHECK(series.time.back() == 2);
    CHECK(std::ranges::count(series.time, 1.0) == 1);
    auto const cuts = result.counters.at("cut_error") + result.counters.at("cut_beta_change");
    CHECK(static_cast<double>(result.cuts) == cuts);
    return std::tuple(last(series, "joint/beta_mean"), result.steps);
  };
  auto const [loose_beta, few] = end(1e-2);
  auto const [beta, many] = end(1e-3);
  auto const [exact_beta, most] = end(1e-5);
  CHECK(few < many);
  CHECK(many < most);
  CHECK(std::abs(beta - exact_beta) < 1e-3);
  CHECK(std::abs(beta - exact_beta) < 0.3 * std::abs(loose_beta - exact_beta));
}

TEST_CASE("runs of half spaces are the same to the last bit, whatever the threads") {
  for (auto const& table : cases()) {
    Case const alone, again, several;
    CHECK(alone.run(table).verdict == "finished");
    CHECK(again.run(table).verdict == "finished");
    CHECK(several.run(table, 0, 3).verdict == "finished");
    check_same(alone.series(), again.series());
    check_same(alone.series(), several.series());
  }
}

TEST_CASE("a half space that is stopped and taken up is the one that was left alone") {
  for (auto const& table : cases()) {
    Case const whole, pieces;
    auto const left_alone = whole.run(table);
    scene::RunResult result;
    int count = 0;
    do
      result = pieces.run(table, 5 + 7 * (count % 4));
    while (result.goes_on && ++count < 200);
    CHECK(count > 2);
    CHECK(result.verdict == "finished");
    CHECK(result.steps == left_alone.steps);
    CHECK(result.iterations == left_alone.iterations);
    CHECK(result.counters.at("products") == left_alone.counters.at("products"));
    check_same(whole.series(), pieces.series());
    CHECK(std::filesystem::exists(pieces.folder / "case/fields/000004.vti"));
  }
}

TEST_CASE("steps of a half space that lead nowhere end at the limits of the schedule") {
  auto law = test::rcc(0.1, 1e6, 0);
  test::at(law, "beta0") = test::value(1);
  auto table = with(test::half_space_scene(), {}, law);
  test::remove(table, "obstacles.ball.z");
  test::at(table, "obstacles.ball.force") = test::values({0, -1e3, -1e3}, "N"); // more than all bonds hold
  test::at(table, "schedule.halvings") = test::value(20);
  for (auto const& [limit, value, words] : {std::tuple{"cuts", 2.0, "more than schedule.cuts"},
                                            std::tuple{"work", 1e-9, "more than schedule.work"}}) {
    auto limited = table;
    test::at(limited, std::string("schedule.") + limit) = test::value(value);
    auto const result = Case{}.run(limited);
    CHECK(result.verdict == "not converged");
    CHECK_MESSAGE(result.reason.find(words) != std::string::npos, result.reason);
    CHECK(result.counters.at("work") > 0);
  }
}

TEST_CASE(
    "explain and the manifest tell what rough heights are, and explain what points do not show of them") {
  auto table = test::half_space_scene();
  test::at(table, "obstacles.ball.surface") = test::make(
      "surface.rough",
      {{"hurst", test::value(0.8)}, {"rms_slope", test::value(0.1)}, {"shortest", test::value(0.1, "m")}});
  test::at(table, "bodies.base.boundary") = test::text("periodic");
  auto const told = scene::explain(table).warnings;
  REQUIRE(told.size() == 1);
  CHECK(told[0].text.find("have 4 points (< 8)") != std::string::npos);
  CHECK(told[0].change.find("give 32 points along x") != std::string::npos);
  auto const scene = scene::build(table);
  auto const settings = scene::manifest_of(table, scene, {})["settings"];
  CHECK(settings["heights"]["rms_slope"]["value"].get<double>() == doctest::Approx(0.1).epsilon(1e-12));
  CHECK(settings["obstacles"]["ball"]["surface"]["rough"]["seed"]["value"] == 1);
}

TEST_CASE("explain tells what a bond takes and how far it comes in a step of a half space") {
  auto const number = [](scene::Explanation const& told, std::string const& name) {
    for (auto const& section : told.sections)
      for (auto const& line : section.lines)
        if (line.name == name)
          return line.value;
    return std::numeric_limits<double>::quiet_NaN();
  };
  auto const told =
      scene::explain(paced(1e-2)); // rcc of w 0.5 J/m^2, C 2e6 N/m^3, b 0.1 N s/m; 10 and 20 steps of 1 s
  CHECK(number(told, "sigma0") == doctest::Approx(1e3));
  CHECK(number(told, "u0") == doctest::Approx(5e-4));
  CHECK(number(told, "bonding time") == doctest::Approx(0.2));
  CHECK(number(told, "bonding per step") == doctest::Approx(0.5));
  CHECK(std::isnan(number(scene::explain(test::half_space_scene()), "sigma0")));
}

TEST_CASE("explain says what points of a half space cannot follow") {
  auto const warnings = [](test::Input const& table) { return scene::explain(table).warnings; };
  auto const law = [](double sigma0) {
    return test::make(
        "adhesion.dugdale",
        {{"sigma0", test::value(sigma0, "Pa")}, {"h0", test::value(1e-3, "m")}, {"ramp", test::value(0.2)}});
  };
  CHECK(warnings(test::half_space_scene()).empty());
  CHECK(warnings(with(test::half_space_scene(), {}, law(50))).empty());
  auto const told = warnings(with(test::half_space_scene(), {}, law(5000)));
  REQUIRE(told.size() == 2); // such bonds draw the ball in as far as the rim
  CHECK(told[0].text.find("past the last points") != std::string::npos);
  CHECK(told[1].text.find("each point snaps by itself") != std::string::npos);
  CHECK(scene::preview(test::half_space_scene()).columns.size() > 20);
}

test::Input random_law(test::Dice& dice) {
  switch (dice.below(4)) {
  case 0:
    return test::rcc(dice.between(0.1, 1), dice.between(1e3, 1e5), dice.between(0, 0.2));
  case 1:
    return test::make("adhesion.potential", {{"w", test::value(dice.between(0.01, 0.05), "J/m^2")},
                                             {"delta", test::value(dice.between(2e-4, 1e-3), "m")}});
  case 2:
    return test::make("adhesion.dugdale", {{"sigma0", test::value(dice.between(10, 100), "Pa")},
                                           {"h0", test::value(dice.between(2e-4, 1e-3), "m")},
                                           {"ramp", test::value(0.3)}});
  default:
    return {};
  }
}

TEST_CASE("random half spaces run, and their energies add up to numbers") {
  for (unsigned seed = 8100; seed < 8116; ++seed) {
    CAPTURE(seed);
    test::Dice dice(seed);
    bool const line = dice.below(2) == 0;
    auto table = line ? test::half_line_scene() : test::half_space_scene();
    test::at(table, "bodies.base.poisson") = test::value(dice.between(-0.5, 0.5));
    if (dice.below(2) == 0) {
      test::at(table, "bodies.base.boundary") = test::text("periodic");
      test::at(table, "bodies.base.depth") = test::value(dice.between(0.1, 1), "m");
    }
    auto const count = [&] { return static_cast<double>(5 + dice.below(20)); };
    test::at(table, "bodies.base.points") = line ? test::values({count()}) : test::values({count(), count()});
    if (dice.below(3) > 0)
      test::at(table, "pairs.joint.friction") = test::coulomb(dice.between(0, 0.8));
    if (auto law = random_law(dice); !law.tag.empty())
      test::at(table, "pairs.joint.adhesion") = std::move(law);
    if (dice.below(2) == 0)
      test::at(table, "schedule.accuracy") = test::make(
          "accuracy", {{"tolerance", test::value(0.01)}, {"events", test::value(dice.below(2) * 0.01, "s")}});
    Case const one;
    auto const result = one.run(table);
    CHECK_MESSAGE(result.verdict == "finished", result.reason);
    auto const series = one.series();
    for (auto const& column : series.columns)
      CHECK_MESSAGE(
          std::ranges::all_of(column.second.values, [](double value) { return std::isfinite(value); }),
          column.first);
  }
}

} // namespace
