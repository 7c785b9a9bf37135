// Runs beside a case's own: their differences are derivatives, the case's own numbers do not depend on them,
// and where there can be none that is said.
#include "scene/run/beside.hpp"

#include <cmath>
#include <doctest/doctest.h>
#include <map>

#include "dynamics/space.hpp"
#include "folder.hpp"
#include "record/series.hpp"
#include "scene/random_scenes.hpp"
#include "scene/run/run.hpp"
#include "scene/scenes.hpp"

using namespace stiction;

namespace {

constexpr double relative = -1e-5;

/// A number of a scene times 1 + part.
test::Input shifted(test::Input table, std::string const& path, double part) {
  std::get<core::Quantity>(test::at(table, path).value).value *= 1 + part;
  return table;
}

double number(test::Input table, std::string const& path) {
  return std::get<core::Quantity>(test::at(table, path).value).value;
}

/// A sticky block that is pressed, rests and is dragged until it slides.
test::Input dragged() {
  auto table = test::foot_on_floor();
  test::at(table, "bodies.foot.material") =
      test::make("material.neo_hookean", {{"young", test::value(1000, "Pa")}, {"poisson", test::value(0.3)}});
  test::at(table, "pairs.sole.friction") = test::coulomb(0.3);
  test::at(table, "pairs.sole.adhesion") = test::rcc(1, 1e3, 2);
  test::at(table, "probes.whole") = test::make("probe.contact", {{"pair", test::text("sole")}});
  test::at(table, "control") = test::make("control", {{"force_tolerance", test::value(1e-13)}});
  return table;
}

struct Case {
  test::Folder folder;
  scene::RunOptions options;
  Case() { options.out = folder / "case"; }
  scene::RunResult run(test::Input const& table) { return scene::run(table, options); }
  [[nodiscard]] record::SeriesData series(std::string const& beside = "") const {
    return record::read_series(
        folder / (beside.empty() ? "case/series.h5" : "case/derivatives/" + beside + "/series.h5"));
  }
};

std::vector<double> values(test::Input const& table, std::string const& column) {
  Case one;
  REQUIRE(one.run(table).verdict == "finished");
  return one.series().columns.at(column).values;
}

/// Largest entry of (a - b) / by - slope.
double error(std::vector<double> const& a, std::vector<double> const& b, double by,
             std::vector<double> const& slope) {
  double largest = 0;
  REQUIRE(a.size() == slope.size());
  for (std::size_t i = 0; i < a.size(); ++i)
    largest = std::max(largest, std::abs((a[i] - b[i]) / by - slope[i]));
  return largest;
}

double largest(std::vector<double> const& all) {
  double most = 0;
  for (double const x : all)
    most = std::max(most, std::abs(x));
  return most;
}

} // namespace

TEST_CASE("derivatives from runs beside are what differences of runs tend to, at their rates") {
  std::string const column = "whole/force_x";
  for (auto const& [path, scheme] : {std::pair{"bodies.foot.material.young", "quasi_static"},
                                     {"pairs.sole.friction.mu", "quasi_static"},
                                     {"pairs.sole.adhesion.w", "quasi_static"},
                                     {"bodies.foot.material.young", "theta_xi"},
                                     {"pairs.sole.friction.mu", "theta_xi"}}) {
    CAPTURE(path);
    CAPTURE(scheme);
    auto table = dragged();
    test::at(table, "scheme") = test::make(std::string("scheme.") + scheme);
    Case one;
    one.options.beside = {{"it", shifted(table, path, relative)}};
    auto const result = one.run(table);
    REQUIRE(result.verdict == "finished");
    REQUIRE(result.beside.size() == 1);
    CHECK(result.beside[0].ended.empty());
    CHECK(result.beside[0].steps == result.steps);
    double const p = number(table, path);
    auto const here = one.series().columns.at(column).values,
               there = one.series("it").columns.at(column).values;
    std::vector<double> slope(here.size());
    for (std::size_t i = 0; i < here.size(); ++i)
      slope[i] = (there[i] - here[i]) / (relative * p);
    REQUIRE(largest(slope) > 0);
    auto const one_sided = [&, &path = path](double h) {
      return error(values(shifted(table, path, h), column), here, h * p, slope);
    };
    auto const central = [&, &path = path](double h) {
      return error(values(shifted(table, path, h), column), values(shifted(table, path, -h), column),
                   2 * h * p, slope);
    };
    double const coarse = one_sided(4e-3), fine = one_sided(2e-3);
    CAPTURE(coarse);
    CAPTURE(fine);
    CAPTURE(central(2e-3));
    CAPTURE(largest(slope));
    if (coarse > 1e-4 * largest(slope))
      CHECK(std::log2(coarse / fine) == doctest::Approx(1).epsilon(0.1));
    CHECK(central(2e-3) < 3e-5 * largest(slope));
  }
}

TEST_CASE("the case's own numbers do not depend on how many runs are beside it, nor on a stop") {
  auto const table = dragged();
  std::vector<scene::Shifted> const two = {{"mu", shifted(table, "pairs.sole.friction.mu", relative)},
                                           {"young", shifted(table, "bodies.foot.material.young", relative)}};
  Case alone, both, stopped;
  alone.options.beside = {two[0]};
  both.options.beside = two;
  REQUIRE(alone.run(table).verdict == "finished");
  REQUIRE(both.run(table).verdict == "finished");
  stopped.options.beside = two;
  stopped.options.keeping.file = stopped.folder / "checkpoint";
  stopped.options.keeping.owner = {"p", "s"};
  stopped.options.stop_after = 9;
  int pieces = 0;
  while (stopped.run(table).verdict == "stopped")
    ++pieces;
  CHECK(pieces > 3);
  auto const same = [](record::SeriesData const& a, record::SeriesData const& b) {
    REQUIRE(a.columns.size() == b.columns.size());
    CHECK(a.time == b.time);
    for (auto const& [name, column] : a.columns) {
      CAPTURE(name);
      CHECK(column.values == b.columns.at(name).values);
    }
  };
  same(alone.series(), both.series());
  same(alone.series("mu"), both.series("mu"));
  same(both.series(), stopped.series());
  same(both.series("mu"), stopped.series("mu"));
  same(both.series("young"), stopped.series("young"));
}

TEST_CASE("runs beside a case that has none any more are taken away") {
  auto const table = dragged();
  Case one;
  one.options.beside = {{"mu", shifted(table, "pairs.sole.friction.mu", relative)}};
  REQUIRE(one.run(table).verdict == "finished");
  REQUIRE(std::filesystem::exists(one.folder / "case/derivatives/mu/series.h5"));
  one.options.beside.clear();
  REQUIRE(one.run(table).verdict == "finished");
  CHECK_FALSE(std::filesystem::exists(one.folder / "case/derivatives"));
}

TEST_CASE("derivatives of random scenes are their differences, or are told to hang on a point") {
  constexpr double h = 1e-4;
  int held = 0, seen = 0;
  for (unsigned seed = 0; seed < 60; ++seed) {
    auto scene = test::RandomScenes(seed).draw();
    CAPTURE(seed);
    CAPTURE(scene.words);
    auto& bodies = std::get<core::Table>(std::get<core::Table>(scene.table.value).at("bodies").value);
    std::string path;
    for (auto const* name : {"young", "shear_modulus", "c10", "k"})
      for (auto const& [body, part] : bodies)
        if (path.empty() && part.table()->at("material").table()->contains(name))
          path = "bodies." + body + ".material." + name;
    if (path.empty())
      continue;
    double const end = scene.dt * scene.steps;
    test::at(scene.table, "schedule") = test::schedule({{end / 2, scene.steps}, {end, scene.steps}});
    test::at(scene.table, "output") = test::make("output", {{"frames", test::value(0)}});
    test::at(scene.table, "probes.energy") = test::make("probe.energy");
    test::at(scene.table, "probes.line") = test::make("probe.contact_line", {{"pair", test::text("joint")}});
    test::at(scene.table, "control") = test::make("control", {{"force_tolerance", test::value(1e-12)}});
    Case one, more, less, alone;
    one.options.beside = {{"it", shifted(scene.table, path, relative)}};
    scene::RunResult result;
    try {
      result = one.run(scene.table);
    } catch (core::InputError const& error) {
      CHECK(std::string(error.what()).find("no derivatives with respect to it: ") != std::string::npos);
      continue;
    }
    auto const without = alone.run(scene.table);
    CHECK(result.verdict == without.verdict);
    if (result.verdict != "finished" || more.run(shifted(scene.table, path, h)).verdict != "finished" ||
        less.run(shifted(scene.table, path, -h)).verdict != "finished" || result.cuts > 0)
      continue;
    ++seen;
    auto const a = one.series(), b = one.series("it"), up = more.series(), down = less.series();
    auto const status = [](auto const& series) { return series.columns.at("line/status").values; };
    if (!result.beside[0].ended.empty() || result.beside[0].turned > 0 || result.beside[0].rough > 0 ||
        up.time != a.time || down.time != a.time || status(up) != status(a) || status(down) != status(a))
      continue;
    ++held;
    std::map<std::string, double> scale; // by unit
    for (auto const& [name, column] : a.columns)
      scale[column.unit] = std::max(scale[column.unit], largest(column.values));
    for (auto const& [name, column] : a.columns) {
      if (name.starts_with("step/"))
        continue;
      auto const &low = down.columns.at(name).values, &high = up.columns.at(name).values;
      std::vector<double> slope(low.size());
      // contact at the level of rates, and energies of bodies at rest, are solved for to some 1e-9 of these
      double const rounding = 1e-8 * scale.at(column.unit) / std::abs(relative);
      for (std::size_t i = 0; i < low.size(); ++i)
        slope[i] = (b.columns.at(name).values[i] - column.values[i]) / relative;
      CAPTURE(name);
      CAPTURE(error(high, low, 2 * h, slope));
      CAPTURE(largest(slope));
      CHECK(error(high, low, 2 * h, slope) <= 1e-2 * largest(slope) + rounding);
    }
  }
  CHECK(seen > 20);
  CHECK(held > 0.7 * seen);
}

TEST_CASE("what can have no run beside it is told") {
  auto const refused = [](test::Input const& table, test::Input const& other) {
    Case one;
    one.options.beside = {{"mu", other}};
    try {
      static_cast<void>(one.run(table));
    } catch (core::InputError const& error) {
      return std::string(error.what());
    }
    return std::string("nothing");
  };
  auto const changed = [&](std::string const& path, test::Input const& part) {
    auto table = dragged();
    test::at(table, path) = part;
    return table;
  };
  auto const says = [](std::string const& text, char const* words) {
    CAPTURE(text);
    CHECK(text.find("no derivatives with respect to mu: ") != std::string::npos);
    CHECK(text.find(words) != std::string::npos);
  };
  auto const table = dragged();
  says(refused(table, changed("schedule", test::schedule({{1, 4}, {1.5, 10}}))), "the schedule's times");
  says(refused(table, changed("motions", test::list({test::drive("foot.top", {0, 2}, {0, 0}, {0, -0.01}),
                                                     test::fix("foot.left", true, false)}))),
       "what is driven");
  says(refused(table,
               changed("bodies.foot", test::block({{0, 0}, {1, 1}, {5, 4}}, test::linear_elastic(1000, 0)))),
       "the mesh");
  says(refused(table, changed("scheme", test::make("scheme.theta_xi"))), "the time scheme");
  auto const controlled =
      changed("schedule.accuracy", test::make("accuracy", {{"tolerance", test::value(0.02)}}));
  says(refused(controlled, controlled), "steps follow from their error");
}

TEST_CASE("derivatives of bodies that are solved for by multigrid are those of a factor") {
  auto table = test::dragged_cube(test::make(
      "material.neo_hookean", {{"young", test::value(1000, "Pa")}, {"poisson", test::value(0.3)}}));
  test::at(table, "probes.whole") = test::make("probe.contact", {{"pair", test::text("sole")}});
  auto const slopes = [&](char const* bulk) {
    test::at(table, "control") = test::make("control", {{"bulk", test::text(bulk)}});
    Case one;
    one.options.beside = {{"young", shifted(table, "bodies.foot.material.young", relative)}};
    auto const result = one.run(table);
    REQUIRE(result.verdict == "finished");
    CHECK(result.beside[0].ended.empty());
    CHECK(result.beside[0].rough == 0);
    auto list = one.series("young").columns.at("whole/force_x").values;
    auto const own = one.series().columns.at("whole/force_x").values;
    for (std::size_t i = 0; i < list.size(); ++i)
      list[i] = (list[i] - own[i]) / relative;
    return list;
  };
  auto const direct = slopes("direct"), iterated = slopes("multigrid");
  CHECK(error(iterated, std::vector<double>(iterated.size(), 0.0), 1, direct) < 1e-3 * largest(direct));
}
