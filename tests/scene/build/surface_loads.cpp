// Loads that follow a surface: what they are made of, what they cannot be, what explain and probes say of
// them.
#include <doctest/doctest.h>

#include "dynamics/marching.hpp"
#include "dynamics/space.hpp"
#include "scene/complaints.hpp"
#include "scene/explain/explain.hpp"
#include "scene/probes/probes.hpp"

using namespace stiction;

namespace {

using test::text, test::value, test::values, test::flag;

test::Input load(char const* kind, std::string set, core::Table entries) {
  entries["set"] = text(std::move(set));
  return test::make(std::string("load.") + kind, std::move(entries));
}

test::Input pressure(std::string set = "foot.right", core::Table entries = {}) {
  entries.try_emplace("times", values({0, 2}, "s"));
  entries.try_emplace("pressure", values({0, 10}, "Pa"));
  return load("pressure", std::move(set), std::move(entries));
}

/// Radii 1 m and 2 m, 0.2 m of it, held along its axis.
test::Input tube(core::Table gas) {
  auto table = test::make("scene");
  test::at(table, "kinematics") = text("axisymmetric");
  test::at(table, "bodies.tube") = test::block({{1, 0}, {1, 0.2}, {2, 1}}, test::linear_elastic(1000, 0.3));
  test::at(table, "motions") =
      test::list({test::make("motion.fix", {{"set", text("tube.all")}, {"y", flag(true)}})});
  gas.try_emplace("times", values({0, 2}, "s"));
  test::at(table, "loads") = test::list({load("gas", "tube.left", std::move(gas))});
  test::at(table, "scheme") = test::quasi_static();
  test::at(table, "schedule") = test::schedule({{2, 2}});
  return table;
}

test::Input foot(test::Input one) {
  auto table = test::foot_on_floor();
  test::at(table, "loads") = test::list({std::move(one)});
  return table;
}

void wrong(test::Input const& table, std::string const& words) {
  auto const all = test::complaints(table);
  CAPTURE(words);
  REQUIRE(all.size() == 1);
  INFO(all[0]);
  CHECK(all[0].find(words) != std::string::npos);
  CHECK(all[0].find("loads[1]") != std::string::npos);
}

std::string said(scene::Scene const& scene, std::string const& title) {
  std::string words;
  for (auto const& section : scene::explain(scene).sections)
    if (section.title == title)
      for (auto const& line : section.lines)
        words += line.name + ": " + line.words + "\n";
  return words;
}

} // namespace

TEST_SUITE_BEGIN("scene");

TEST_CASE("what a pressure or a surface stress cannot be is told once, with the remedy") {
  CHECK(test::complaints(foot(pressure())).empty());
  CHECK(test::complaints(foot(load("surface_stress", "foot.right", {{"gamma", value(1, "N/m")}}))).empty());
  wrong(foot(pressure("foot.rigt")), "did you mean \"foot.right\"");
  wrong(foot(pressure("floor")), "floor");
  wrong(foot(pressure("foot.right", {{"times", values({0, 1}, "s")}})), "before the run does");
  wrong(foot(pressure("foot.right", {{"pressure", values({0}, "Pa")}})), "pressure");
  wrong(foot(pressure("foot.right", {{"pressure", values({0, 1}, "N")}})), "Pa");
  wrong(foot(load("surface_stress", "foot.right", {{"gamma", value(0, "N/m")}})), "it must be > 0 N/m");
  wrong(foot(load("surface_stress", "foot.right", {{"gamma", value(1, "Pa")}})), "N/m");
}

TEST_CASE("what gas cannot be is told once, with the remedy") {
  auto const volume = values({1, 2});
  auto const amount = values({0, 10}, "Pa");
  CHECK(test::complaints(tube({{"volume", volume}})).empty());
  CHECK(test::complaints(tube({{"pressure", amount}})).empty());
  wrong(tube({}), "wants one of `pressure`, its amount, and `volume`");
  wrong(tube({{"volume", volume}, {"pressure", amount}}), "wants one of");
  wrong(tube({{"volume", volume}, {"outside", value(1, "Pa")}}), "leave it out");
  wrong(tube({{"volume", values({1, 0})}}), "stays above 0");
  wrong(tube({{"pressure", values({0, -10}, "Pa")}, {"outside", value(5, "Pa")}}), "less than nothing");
  CHECK(test::complaints(tube({{"pressure", values({0, -5}, "Pa")}, {"outside", value(5, "Pa")}})).empty());
  wrong(tube({{"volume", values({2, 1})}}), "begin with 1");
  wrong(tube({{"pressure", amount}, {"exponent", value(11)}}), "exponent");
  wrong(tube({{"pressure", amount}, {"centre", values({0}, "m")}}), "two are wanted");
  auto table = tube({{"volume", volume}});
  test::at(table, "loads[1].set") = text("tube.right");
  wrong(table, "encloses no cavity: its volume is -");
  wrong(table, "m^3; name the wall");
  table = tube({{"volume", volume}});
  test::at(table, "motions") =
      test::list({test::make("motion.fix", {{"set", text("tube.bottom")}, {"y", flag(true)}})});
  wrong(table, "is open at (1, 0.2) m");
  table = tube({{"volume", volume}});
  test::at(table, "scheme") = test::make("scheme.central_difference");
  wrong(table, "which central differences cannot follow");
  table = tube({{"volume", volume}});
  test::at(table, "probes.gas") = test::make("probe.gas", {{"set", text("tube.lift")}});
  auto const all = test::complaints(table);
  REQUIRE(all.size() == 1);
  CHECK(all[0].find("did you mean \"tube.left\"") != std::string::npos);
}

TEST_CASE("in space too a cavity's wall is closed, or ends where it is held") {
  auto const room = [](bool kept) {
    auto table = test::cube_on_floor(); // what is under its top is as good as a cavity
    test::at(table, "loads") = test::list({load(
        "gas", "foot.top",
        {{"times", values({0, 2}, "s")}, {"volume", values({1, 1})}, {"centre", values({0, 0, 3}, "m")}})});
    if (!kept)
      test::at(table, "motions") = test::list({test::make("motion.fix", {{"set", text("foot.bottom")}})});
    else
      test::at(table, "motions") = test::list({test::make("motion.fix", {{"set", text("foot.all")}})});
    return test::complaints(table);
  };
  REQUIRE(room(false).size() == 1);
  CHECK(room(false)[0].find("is open at") != std::string::npos);
  CHECK(room(true).empty());
}

TEST_CASE("a cavity whose ends move apart, or off its seal, is told, and where") {
  auto const ended = [](test::Input left, test::Input right, core::Table more) {
    auto table = test::foot_on_floor(); // what is under its top is as good as a cavity
    more["times"] = values({0, 2}, "s");
    more["centre"] = values({0.5, 3}, "m");
    more["pressure"] = values({0, 0}, "Pa");
    test::at(table, "loads") = test::list({load("gas", "foot.top", std::move(more))});
    test::at(table, "motions") = test::list({std::move(left), std::move(right)});
    test::remove(table, "pairs");
    return table;
  };
  auto const moved = [](char const* set, double x) { return test::drive(set, {0, 2}, {0, x}, {0, 0}); };
  CHECK(test::complaints(ended(moved("foot.left", 0.1), moved("foot.right", 0.1), {})).empty());
  wrong(ended(moved("foot.left", 0.1), moved("foot.right", 0.2), {}),
        "ends where motions do not move it as one rigid body: at t = 2 s they take (1, 1) m by 0.1 m "
        "elsewhere");
  auto const seal = [](std::vector<double> const& normal) {
    return core::Table{{"seal", values(normal)}, {"leaks_at", value(0.1, "m")}};
  };
  auto sealed = ended(moved("foot.left", 0.1), test::fix("foot.right", false, true), seal({1, 0}));
  test::at(sealed, "loads[1].centre") = values({1, 3}, "m");
  wrong(sealed, "where motions take `centre` 0.1 m off it at t = 2 s");
  auto about_axis = tube({{"pressure", values({0, 0}, "Pa")}});
  test::at(about_axis, "loads[1].seal") = values({1, 0});
  test::at(about_axis, "loads[1].leaks_at") = value(0.1, "m");
  wrong(about_axis, "which about an axis is along it");
}

TEST_CASE("explain says what acts on surfaces, how large a cavity is and what surface stress rounds") {
  auto table = tube({{"volume", values({1, 2})}});
  auto& loads = std::get<core::List>(test::at(table, "loads").value);
  loads.push_back(
      load("pressure", "tube.right", {{"times", values({0, 2}, "s")}, {"pressure", values({0, 10}, "Pa")}}));
  loads.push_back(load("surface_stress", "tube.right", {{"gamma", value(2, "N/m")}}));
  auto const words = said(scene::build(table), "Loads");
  INFO(words);
  CHECK(words.find("tube.left: gas of volume 1 at 0 s, 2 at 2 s; cavity of 0.6283 m^3") != std::string::npos);
  CHECK(words.find("tube.right: following pressure 0 Pa at 0 s, 10 Pa at 2 s") != std::string::npos);
  CHECK(words.find("surface stress 2 N/m: rounds what is finer than gamma / E = 2 mm") != std::string::npos);
}

TEST_CASE("explain warns of gas over the pressure outside that a seal lets out") {
  auto const told = [](double late, bool sealed) {
    auto table = test::foot_on_floor();
    core::Table gas{{"times", values({0, 2}, "s")},
                    {"pressure", values({-5, late}, "Pa")},
                    {"outside", value(100, "Pa")},
                    {"centre", values({-0.5, 0}, "m")}};
    if (sealed)
      gas.insert({{"seal", values({0, 1})}, {"leaks_at", value(0.1, "m")}});
    test::at(table, "loads") = test::list({load("gas", "foot.left", std::move(gas))});
    test::at(table, "motions") = test::list({test::make("motion.fix", {{"set", text("foot.all")}})});
    auto const warnings = scene::explain(scene::build(table)).warnings;
    return std::ranges::any_of(warnings, [](auto const& one) {
      return one.text.find("its pressure is 5 Pa at 2 s, and under a seal gas goes out") != std::string::npos;
    });
  };
  CHECK(told(5, true));
  CHECK(!told(-5, true));
  CHECK(!told(5, false));
}

TEST_CASE("explain warns of a given volume where the scheme damps nothing") {
  auto const warned = [](test::Input scheme) {
    auto table = tube({{"volume", values({1, 1.1})}});
    test::at(table, "scheme") = std::move(scheme);
    return std::ranges::any_of(scene::explain(scene::build(table)).warnings, [](auto const& one) {
      return one.text.find("its pressure swings at every step") != std::string::npos;
    });
  };
  CHECK(warned(test::make("scheme.theta_xi")));
  CHECK(!warned(test::theta_xi(0.6, 0.6)));
  CHECK(!warned(test::make("scheme.hht")));
  CHECK(!warned(test::quasi_static()));
}

TEST_CASE("a probe shows pressure and volume of a cavity, that of energy what surfaces store") {
  auto table = tube({{"volume", values({1, 1.1})}});
  std::get<core::List>(test::at(table, "loads").value)
      .push_back(load("surface_stress", "tube.right", {{"gamma", value(2, "N/m")}}));
  test::at(table, "probes.gas") = test::make("probe.gas", {{"set", text("tube.left")}});
  test::at(table, "probes.energy") = test::make("probe.energy");
  auto const scene = scene::build(table);
  std::vector<std::string> names;
  auto const samplers =
      scene::add_probes(scene, scene::Columns{[&](auto const&, auto const& column, auto const&, auto const&,
                                                  int) { names.push_back(column); },
                                              [](auto const&, auto const&, double) {}});
  dynamics::Stepper stepper(*scene.model);
  auto const end = test::march(stepper, stepper.initial(), 0.5, 4);
  std::vector<double> row;
  for (auto const& sampler : samplers)
    sampler(end, row);
  REQUIRE(row.size() == names.size());
  auto const of = [&](std::string const& name) {
    return row[static_cast<std::size_t>(std::ranges::find(names, name) - names.begin())];
  };
  CHECK(of("volume") == doctest::Approx(1.1 * 0.2 * 3.14159265).epsilon(1e-6));
  CHECK(of("pressure") == end.gas[0].pressure);
  CHECK(of("pressure") > 1);
  CHECK(of("surface") == end.ledger.surface);
  CHECK(of("surface") > 2 * 2 * 3.14159265 * 2 * 0.2);
}

TEST_SUITE_END();
