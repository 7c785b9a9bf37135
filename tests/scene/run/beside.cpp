// Runs beside a case's own: their differences are derivatives, the case's own numbers do not depend on them,
// and where there can be none that is said.
#include "scene/run/beside.hpp"

#include <cmath>
#include <doctest/doctest.h>

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
  std::get<core::Quantity>(test::at(table, path).value).si *= 1 + part;
  return table;
}

double number(test::Input table, std::string const& path) {
  return std::get<core::Quantity>(test::at(table, path).value).si;
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
    return record::read_series(folder / (beside.empty() ? "case/series.h5" : "case/derivatives/" + beside + "/series.h5"));
  }
};

std::vector<double> values(test::Input const& table, std::string const& column) {
  Case one;
  REQUIRE(one.run(table).verdict == "finished");
  return one.series().columns.at(column).values;
}

/// Largest entry of (a - b) / by - slope.
double error(std::vector<double> const& a, std::vector<double> const& b, double by, std::vector<double> const& slope) {
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
  for (std::string const path : {"bodies.foot.material.young", "pairs.sole.friction.mu", "pairs.sole.adhesion.w"}) {
    CAPTURE(path);
    auto const table = dragged();
    Case one;
    one.options.beside = {{"it", shifted(table, path, relative)}};
    auto const result = one.run(table);
    REQUIRE(result.verdict == "finished");
    REQUIRE(result.beside.size() == 1);
    CHECK(result.beside[0].ended.empty());
    CHECK(result.beside[0].steps == result.steps);
    double const p = number(table, path);
    auto const here = one.series().columns.at(column).values, there = one.series("it").columns.at(column).values;
    std::vector<double> slope(here.size());
    for (std::size_t i = 0; i < here.size(); ++i)
      slope[i] = (there[i] - here[i]) / (relative * p);
    REQUIRE(largest(slope) > 0);
    auto const one_sided = [&](double h) { return error(values(shifted(table, path, h), column), here, h * p, slope); };
    auto const central = [&](double h) {
      return error(values(shifted(table, path, h), column), values(shifted(table, path, -h), column), 2 * h * p, slope);
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
