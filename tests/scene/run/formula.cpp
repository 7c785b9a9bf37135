// Runs of closed formulas: known answers at every time, the files of other runs, and the points of half
// spaces.
#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <random>

#include "folder.hpp"
#include "record/series.hpp"
#include "scene/complaints.hpp"
#include "scene/explain/explain.hpp"
#include "scene/explain/preview.hpp"
#include "scene/formulas.hpp"
#include "scene/run/run.hpp"

using namespace stiction;

namespace {

using std::numbers::pi;
using test::value, test::values;

/// Within a part of the number, however small that is.
doctest::Approx near(double number, double part) {
  return doctest::Approx(number).epsilon(part).scale(1e-30);
}

struct FormulaCase {
  test::Folder folder;
  scene::RunResult run(test::Input const& table, long stop_after = 0) const {
    scene::RunOptions options;
    options.out = folder / "case";
    options.stop_after = stop_after;
    return scene::run(table, options);
  }
  [[nodiscard]] std::vector<double> column(std::string const& name) const {
    return record::read_series(folder / "case/series.h5").columns.at(name).values;
  }
};

/// Everywhere, within a part of the largest.
void check_close(std::vector<double> const& found, std::vector<double> const& wanted, double part) {
  REQUIRE(found.size() == wanted.size());
  double most = 1e-14, off = 0;
  for (std::size_t k = 0; k < found.size(); ++k) {
    most = std::max(most, std::abs(wanted[k]));
    off = std::max(off, std::abs(found[k] - wanted[k]));
  }
  CHECK(off <= part * most);
}

TEST_CASE("a formula takes the stages' steps where an accuracy is asked for, and says so") {
  auto table = test::formula_scene();
  test::at(table, "schedule.accuracy") = test::make("accuracy");
  FormulaCase const one, plain;
  auto const result = one.run(table);
  REQUIRE(result.remarks.size() == plain.run(test::formula_scene()).remarks.size() + 1);
  CHECK(result.remarks.front().find("exact at any step") != std::string::npos);
  CHECK(one.column("ball/force_z") == plain.column("ball/force_z"));
  CHECK(one.column("step/error_beta") == std::vector<double>(8, 0.0));
}

TEST_CASE("derivatives of a formula are those of the formula, and of another one there are none") {
  auto const table = test::formula_scene();
  FormulaCase const one;
  scene::RunOptions options;
  options.out = one.folder / "case";
  auto softer = table, other = table;
  std::get<core::Quantity>(test::at(softer, "bodies.base.young").value).value *= 1 - 1e-5;
  options.beside = {{"young", softer}};
  auto const result = scene::run(table, options);
  REQUIRE(result.beside.size() == 1);
  CHECK(result.beside[0].steps == result.steps);
  CHECK(result.beside[0].ended.empty());
  auto const here = one.column("ball/force_z"),
             there = record::read_series(one.folder / "case/derivatives/young/series.h5")
                         .columns.at("ball/force_z")
                         .values;
  REQUIRE(there.size() == here.size());
  for (std::size_t k = 1; k < here.size(); ++k)
    CHECK((there[k] / here[k] - 1) / -1e-5 == doctest::Approx(1).epsilon(1e-6));
  test::at(other, "pairs.joint.adhesion") = test::dugdale(1e9, 1e-9);
  options.beside = {{"young", other}};
  try {
    static_cast<void>(scene::run(table, options));
    FAIL("another formula ran beside");
  } catch (core::InputError const& error) {
    CHECK(std::string(error.what()).find("young: it changes the formula") != std::string::npos);
  }
}

TEST_CASE("Hertz's sphere is recorded at every time of the schedule, by displacement and by force") {
  double const E = 1e4 / 0.91, depth = 5e-3, force = 4.0 / 3 * E * std::pow(depth, 1.5);
  FormulaCase const one;
  auto const result = one.run(test::formula_scene());
  CHECK(result.verdict == "finished");
  CHECK(result.steps == 7);
  auto const forces = one.column("ball/force_z"), areas = one.column("joint/closed_area");
  REQUIRE(forces.size() == 8);
  for (std::size_t k = 0; k < 8; ++k) {
    double const part = std::min(1.0, static_cast<double>(k) / 3);
    CHECK(forces[k] == near(force * std::pow(part, 1.5), 1e-9));
    CHECK(areas[k] == near(pi * depth * part, 1e-9));
  }
  CHECK(one.column("joint/force_z").back() == near(-force, 1e-10));
  CHECK(one.column("joint/pressure_max").back() == near(1.5 * force / (pi * depth), 1e-9));
  auto forced = test::formula_scene();
  test::remove(forced, "obstacles.ball.z");
  test::at(forced, "obstacles.ball.force") = values({0, force, 0}, "N");
  CHECK(one.run(forced).verdict == "finished");
  CHECK(one.column("ball/u_z")[3] == near(-depth, 1e-9));
  CHECK(one.column("ball/u_z").back() == 0);
}

TEST_CASE("the points of a half space come near the formula, in the same columns") {
  auto layer = test::wave_scene();
  test::at(layer, "bodies.base.depth") = value(0.1, "m");
  test::at(layer, "obstacles.ball.young") = value(2e4, "Pa");
  test::at(layer, "obstacles.ball.poisson") = value(0.2);
  for (auto table : {test::formula_scene(), test::wave_scene(), layer}) {
    FormulaCase const formula, points;
    bool const line = test::at(table, "kinematics").text() != nullptr &&
                      *test::at(table, "kinematics").text() == "plane_strain";
    test::at(table, "bodies.base.points") = line ? values({200}) : values({40, 30});
    CHECK(formula.run(table).verdict == "finished");
    test::at(table, "model") = test::text("half_space");
    CHECK(points.run(table).verdict == "finished");
    auto const there = record::read_series(points.folder / "case/series.h5");
    for (auto const& [name, column] : record::read_series(formula.folder / "case/series.h5").columns) {
      CAPTURE(name);
      REQUIRE(there.columns.contains(name));
      CHECK(there.columns.at(name).unit == column.unit);
      if (name == "step/iterations" || name == "energy/scheme_loss" || name == "line/status")
        continue;
      check_close(there.columns.at(name).values, column.values,
                  name == "joint/closed_area" ? 0.1
                  : name == "line/pressure"   ? 0.05
                                              : 0.02);
    }
    double const work =
        line ? points.column("energy/load_work").back() : points.column("energy/motion_work").back();
    CHECK(std::abs(formula.column("energy/scheme_loss").back()) < 0.05 * work);
    CHECK(formula.column("energy/scheme_loss").back() ==
          near(points.column("energy/scheme_loss").back(), 0.25));
  }
}

TEST_CASE("a formula's points have the grip of the law where they touch, and its pull beside") {
  auto table = test::formula_scene();
  test::at(table, "bodies.base.points") = values({40, 30});
  test::at(table, "probes.rim") =
      test::make("probe.contact_point", {{"pair", test::text("joint")}, {"near", values({0.09, 0, 0}, "m")}});
  auto const compare = [&](test::Input law, std::initializer_list<char const*> names) {
    test::at(table, "pairs.joint.adhesion") = std::move(law);
    FormulaCase const formula, points;
    test::at(table, "model") = test::text("formula");
    CHECK(formula.run(table).verdict == "finished");
    test::at(table, "model") = test::text("half_space");
    CHECK(points.run(table).verdict == "finished");
    for (std::string const name : names) {
      CAPTURE(name);
      CHECK(formula.column(name).back() == near(points.column(name).back(), 0.02));
    }
  };
  compare(test::dugdale(30, 5e-3), {"ball/force_z", "joint/pressure_max", "middle/pressure",
                                    "middle/adhesion_n", "rim/gap", "rim/adhesion_n", "energy/strain"});
  compare(test::make("adhesion.attraction", {{"w", value(0.15, "J/m^2")}, {"range", value(5e-3, "m")}}),
          {"joint/pressure_max", "middle/pressure", "middle/adhesion_n"});
}

TEST_CASE("a pull that is more than adhesion holds ends the run and says how much that is") {
  auto table = test::formula_scene();
  test::at(table, "pairs.joint.adhesion") =
      test::make("adhesion.potential", {{"w", value(0.5, "J/m^2")}, {"delta", value(1e-5, "m")}});
  test::remove(table, "obstacles.ball.z");
  double const most = 1.5 * pi * 0.5;
  test::at(table, "obstacles.ball.force") = values({0, most, -1.2 * most}, "N");
  FormulaCase const one;
  auto const result = one.run(table);
  CHECK(result.verdict == "not converged");
  CHECK_MESSAGE(result.reason.find("pull-off 2.35619") != std::string::npos, result.reason);
  auto const forces = one.column("joint/force_z");
  CHECK(*std::ranges::max_element(forces) <= most);
  CHECK(one.column("joint/closed_area")[0] ==
        near(pi * std::pow(4.5 * pi * 0.5 * 0.91 / 1e4, 2.0 / 3), 1e-9));
  test::at(table, "obstacles.ball.force") = values({-1.2 * most, -1.2 * most, -1.2 * most}, "N");
  auto const never = one.run(table); // nothing touched before
  CHECK_MESSAGE(never.reason.find("pull-off 2.35619") != std::string::npos, never.reason);
}

TEST_CASE(
    "the manifest names the formula, its source and what it leaves out, and no field of before is left") {
  auto const frames = [](FormulaCase const& one) {
    std::ifstream file(one.folder / "case/fields.pvd");
    std::string const text{std::istreambuf_iterator<char>(file), {}};
    int count = 0;
    for (auto at = text.find("<DataSet"); at != std::string::npos; at = text.find("<DataSet", at + 1))
      ++count;
    return count;
  };
  FormulaCase const one;
  auto points = test::half_space_scene();
  CHECK(one.run(points).verdict == "finished");
  auto table = test::formula_scene();
  test::at(table, "pairs.joint.adhesion") = test::dugdale(100, 5e-3);
  auto const result = one.run(table);
  REQUIRE(result.remarks.size() == 1);
  CHECK(result.remarks[0] == "the formula (Maugis) leaves out the ramps of the traction");
  std::ifstream file(one.folder / "case/manifest.json");
  auto const told = nlohmann::json::parse(file)["settings"]["formula"];
  CHECK(told["name"] == "Maugis");
  CHECK(told["source"] == "Maugis 1992; Johnson and Greenwood 1997");
  CHECK(told["fits"].get<std::string>().find("lambda = ") != std::string::npos);
  CHECK(frames(one) == 1 + 2 + 2);
  test::at(table, "output.frames") = value(0);
  CHECK(one.run(table).verdict == "finished");
  CHECK_FALSE(std::filesystem::exists(one.folder / "case/fields.pvd"));
  CHECK_FALSE(std::filesystem::exists(one.folder / "case/steps.csv"));
}

TEST_CASE("explain says which formula answers a half space, would, or why none does") {
  auto const model = [](test::Input const& table) {
    auto const told = scene::explain(table);
    auto const& lines = told.sections.at(0).lines;
    auto const found = std::ranges::find(lines, "model", &scene::Line::name);
    REQUIRE(found != lines.end());
    return found->words + ": " + found->meaning;
  };
  auto table = test::formula_scene();
  CHECK(model(table) ==
        "formula: Hertz (Hertz 1882; Johnson 1985, 4.2), a sphere without adhesion, a/R at most 0.071");
  CHECK(scene::explain(table).warnings.empty());
  CHECK(scene::preview(table).columns.size() == 2 + 5 + 6 + 5 + 14);
  test::at(table, "model") = test::text("half_space");
  CHECK(model(table).starts_with("half space: model = \"formula\" would do: Hertz ("));
  test::at(table, "bodies.base.boundary") = test::text("periodic");
  CHECK(model(table).starts_with("half space: no formula: a sphere over a periodic half space"));
}

TEST_CASE("a formula's run stops when it is asked to, and repeats to the last bit") {
  FormulaCase const one, two;
  CHECK(one.run(test::formula_scene(), 3).verdict == "stopped");
  CHECK(one.run(test::formula_scene()).verdict == "finished");
  CHECK(two.run(test::formula_scene()).verdict == "finished");
  CHECK(one.column("ball/force_z") == two.column("ball/force_z"));
}

TEST_CASE("a sphere is moved along from where it starts, by Mindlin's law, and pulls the half space along") {
  auto table = test::formula_scene();
  test::at(table, "bodies.base.poisson") = value(0.5);
  test::at(table, "pairs.joint.friction") = test::coulomb(0.3);
  for (char const* probe : {"probes.energy", "probes.middle"})
    test::remove(table, probe);
  double const E = 1e4 / 0.75, G = 1e4 / 3, a = std::sqrt(5e-3), P = 4.0 / 3 * E * std::pow(5e-3, 1.5);
  double const range = 3 * 0.3 * P * 1.5 / G / (16 * a);
  for (double const start : {0.0, 0.02})
    for (std::string const axis : {"x", "y"}) {
      auto moved = table;
      test::at(moved, "obstacles.ball." + axis) = values({start, start, start + 0.5 * range}, "m");
      FormulaCase const one;
      CHECK(one.run(moved).verdict == "finished");
      CHECK(one.column("joint/force_" + axis).back() == near(0.3 * P * (1 - std::pow(0.5, 1.5)), 1e-9));
      CHECK(one.column("joint/force_" + std::string(axis == "x" ? "y" : "x")).back() == 0);
      CHECK(one.column("ball/force_" + axis).back() == -one.column("joint/force_" + axis).back());
      CHECK(one.column("ball/u_" + axis).back() == near(start + 0.5 * range, 1e-10));
    }
}

/// Any shape, law, drive and way.
test::Input random_formula(unsigned seed) {
  std::mt19937 dice(seed);
  auto const pick = [&](int n) { return static_cast<int>(dice() % static_cast<unsigned>(n)); };
  auto const between = [&](double low, double high) {
    return low * std::pow(high / low, std::uniform_real_distribution<double>(0, 1)(dice));
  };
  auto table = pick(3) == 0 ? test::wave_scene() : test::formula_scene(pick(2) == 0);
  if (pick(2) == 0)
    test::at(table, "bodies.base.poisson") = value(0.5);
  if (int const law = pick(4); law == 0)
    test::at(table, "pairs.joint.adhesion") = test::dugdale(between(1, 1e5), between(1e-6, 1e-2));
  else if (law == 1)
    test::at(table, "pairs.joint.adhesion") =
        test::make("adhesion.potential",
                   {{"w", value(between(1e-3, 10), "J/m^2")}, {"delta", value(between(1e-7, 1e-2), "m")}});
  else if (law == 2)
    test::at(table, "pairs.joint.friction") = test::coulomb(between(0.01, 2));
  if (pick(2) == 0)
    test::at(table, "obstacles.ball.x") = values({0, 0, between(1e-6, 1e-2)}, "m");
  if (pick(2) == 0) // with friction and a motion along they would be refused one by one
    test::remove(table, "probes.middle");
  else if (test::at(table, "probes").table()->contains("energy"))
    test::remove(table, "probes.energy");
  return table;
}

TEST_CASE("whatever the scene, a formula answers it in finite numbers or says in one complaint why not") {
  int answered = 0;
  for (unsigned seed = 5000; seed < 5200; ++seed) {
    CAPTURE(seed);
    auto const table = random_formula(seed);
    auto const told = test::complaints(table);
    CHECK(told.size() <= 1);
    if (!told.empty())
      continue;
    FormulaCase const one;
    CHECK(one.run(table).verdict == "finished");
    for (auto const& [name, column] : record::read_series(one.folder / "case/series.h5").columns)
      CHECK(std::ranges::all_of(column.values, [](double number) { return std::isfinite(number); }));
    ++answered;
  }
  CHECK(answered > 80);
}

} // namespace
